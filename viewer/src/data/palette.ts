/**
 * Colours that people with colour blindness can tell apart
 * (Paul Tol, "Colour Schemes", scheme "bright", without its grey).
 */
export const PALETTE: readonly string[] = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377"];

export function paletteColor(index: number): string {
  return PALETTE[index % PALETTE.length] as string;
}

/** Mixes two "#rrggbb" colours: 0 gives `a`, 1 gives `b`. */
export function mix(a: string, b: string, share: number): string {
  const channel = (hex: string, i: number) => parseInt(hex.slice(1 + 2 * i, 3 + 2 * i), 16);
  let out = "#";
  for (let i = 0; i < 3; i++) {
    const value = Math.round(channel(a, i) * (1 - share) + channel(b, i) * share);
    out += value.toString(16).padStart(2, "0");
  }
  return out;
}

/** "#rgb" and "#rrggbb" as "#rrggbb" in small letters; null for anything else. */
export function normalColor(text: unknown): string | null {
  if (typeof text !== "string") return null;
  const short = /^#([0-9a-f])([0-9a-f])([0-9a-f])$/i.exec(text);
  if (short) return `#${short[1]}${short[1]}${short[2]}${short[2]}${short[3]}${short[3]}`.toLowerCase();
  return /^#[0-9a-f]{6}$/i.test(text) ? text.toLowerCase() : null;
}
