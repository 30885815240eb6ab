/** Numbers as people read them. */

/** Five significant digits, powers of ten only where they are needed; a true minus sign. */
export function formatNumber(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0) return "0";
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(3) : value.toPrecision(5);
  return text.replace(/e\+/, "e").replace(/-/g, "−");
}

/** A time with as many decimals as the step needs, so that its width does not jump. */
export function formatTime(time: number, step: number): string {
  const decimals = step > 0 && Number.isFinite(step) ? Math.min(9, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9))) : 3;
  return time.toFixed(decimals).replace(/-/g, "−");
}

/** Decimals with which multiples of the step can be told from each other and read: 0.01 gives 2, 0.25 gives 2. */
export function decimalsFor(step: number): number {
  if (!(step > 0) || !Number.isFinite(step)) return 3;
  return Math.min(9, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9) + (isRoundStep(step) ? 0 : 1)));
}

function isRoundStep(step: number): boolean {
  const digits = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
  return Math.abs(digits - Math.round(digits)) < 1e-6;
}

/** The largest of 1, 2, 5 times a power of ten that is not above `limit`. */
export function roundDown125(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit) + 1e-12);
  const digits = limit / power;
  return (digits >= 5 - 1e-9 ? 5 : digits >= 2 - 1e-9 ? 2 : 1) * power;
}

/** A length in metres with the unit that makes it readable. */
export function formatLength(metres: number): string {
  const size = Math.abs(metres);
  const [factor, unit] = size >= 1000 ? [1e-3, "km"] : size >= 0.99999 ? [1, "m"] : size >= 0.00099999 ? [1e3, "mm"] : [1e6, "µm"];
  return `${Number((metres * factor).toPrecision(4))} ${unit}`;
}

/** "2 kN", "500 mN m" */
export function formatForce(value: number, unit: "N" | "N m" = "N"): string {
  const [factor, prefix] = value >= 1e6 ? [1e-6, "M"] : value >= 1e3 ? [1e-3, "k"] : value >= 1 ? [1, ""] : [1e3, "m"];
  const size = Number((value * factor).toPrecision(4));
  return `${size >= 1e-3 && size < 1e6 ? size : formatNumber(size)} ${prefix}${unit}`;
}
