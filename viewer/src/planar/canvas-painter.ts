import type { Point2 } from "../data/contract";
import type { Ink, Painter, TextInk } from "./painter";

export const FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";

/** Draws on a canvas. */
export class CanvasPainter implements Painter {
  constructor(private readonly context: CanvasRenderingContext2D) {
    context.lineJoin = "round";
    context.lineCap = "round";
  }

  path(lines: readonly (readonly Point2[])[], closed: boolean, ink: Ink): void {
    const c = this.context;
    c.beginPath();
    for (const line of lines) {
      line.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
      if (closed) c.closePath();
    }
    this.apply(ink);
  }

  circle([x, y]: Point2, radius: number, ink: Ink): void {
    this.context.beginPath();
    this.context.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI);
    this.apply(ink);
  }

  text([x, y]: Point2, text: string, ink: TextInk): void {
    const c = this.context;
    c.font = `${ink.bold ? "600 " : ""}${ink.size}px ${FONT}`;
    c.textAlign = ink.align ?? "left";
    c.textBaseline = "middle";
    if (ink.halo !== undefined) {
      c.strokeStyle = ink.halo;
      c.lineWidth = 4;
      c.setLineDash([]);
      c.strokeText(text, x, y);
    }
    c.fillStyle = ink.color;
    c.fillText(text, x, y);
  }

  private apply(ink: Ink): void {
    const c = this.context;
    c.globalAlpha = ink.opacity ?? 1;
    if (ink.fill !== undefined) {
      c.fillStyle = ink.fill;
      c.fill("evenodd");
    }
    if (ink.stroke !== undefined) {
      c.strokeStyle = ink.stroke;
      c.lineWidth = ink.width ?? 1;
      c.setLineDash([...(ink.dash ?? [])]);
      c.stroke();
    }
    c.globalAlpha = 1;
  }
}
