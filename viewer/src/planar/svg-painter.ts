import type { Point2 } from "../data/contract";
import { FONT } from "./canvas-painter";
import type { Ink, Painter, TextInk } from "./painter";

/** Writes the picture as an SVG document. */
export class SvgPainter implements Painter {
  private readonly elements: string[] = [];

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly title: string,
  ) {}

  path(lines: readonly (readonly Point2[])[], closed: boolean, ink: Ink): void {
    const d = lines
      .filter((line) => line.length > 0)
      .map((line) => `M${line.map((p) => `${short(p[0])} ${short(p[1])}`).join("L")}${closed ? "Z" : ""}`)
      .join("");
    if (d !== "") this.elements.push(`<path d="${d}"${attributes(ink)}/>`);
  }

  circle([x, y]: Point2, radius: number, ink: Ink): void {
    this.elements.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(Math.max(0, radius))}"${attributes(ink)}/>`);
  }

  text([x, y]: Point2, text: string, ink: TextInk): void {
    const anchor = { left: "start", center: "middle", right: "end" }[ink.align ?? "left"];
    const halo = ink.halo === undefined ? "" : ` stroke="${ink.halo}" stroke-width="4" paint-order="stroke"`;
    const weight = ink.bold ? ' font-weight="600"' : "";
    this.elements.push(
      `<text x="${short(x)}" y="${short(y)}" font-size="${ink.size}" text-anchor="${anchor}" dominant-baseline="central" fill="${ink.color}"${halo}${weight}>${escapeXml(text)}</text>`,
    );
  }

  finish(): string {
    const { width, height } = this;
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="${FONT.replace(/"/g, "'")}" stroke-linejoin="round" stroke-linecap="round">`,
      `<title>${escapeXml(this.title)}</title>`,
      ...this.elements,
      "</svg>",
      "",
    ].join("\n");
  }
}

function attributes(ink: Ink): string {
  let out = ` fill="${ink.fill ?? "none"}"`;
  if (ink.fill !== undefined) out += ' fill-rule="evenodd"';
  if (ink.stroke !== undefined) out += ` stroke="${ink.stroke}" stroke-width="${short(ink.width ?? 1)}"`;
  if (ink.dash !== undefined) out += ` stroke-dasharray="${ink.dash.join(" ")}"`;
  if (ink.opacity !== undefined) out += ` opacity="${ink.opacity}"`;
  return out;
}

function short(value: number): string {
  return String(Math.round(value * 100) / 100);
}

export function escapeXml(text: string): string {
  const names: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
  return text.replace(/[&<>"]/g, (sign) => names[sign] as string);
}
