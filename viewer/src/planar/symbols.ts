import type { Point2 } from "../data/contract";
import type { Painter } from "./painter";
import type { Theme } from "./theme";

/** Supports stay readable where pins may be dots [pixels]. */
const SMALLEST_SUPPORT = 4;

/** Draws the signs of mechanical drawing; all places and sizes are pixels. */
export class Symbols {
  constructor(
    private readonly painter: Painter,
    private readonly theme: Theme,
    /** Radius of a pin. */
    private readonly unit: number,
  ) {}

  private get line(): number {
    return Math.min(1.6, Math.max(0.8, this.unit / 4));
  }

  pin(at: Point2): void {
    this.painter.circle(at, this.unit, { fill: this.theme.background, stroke: this.theme.ink, width: this.line });
  }

  lump(at: Point2, color: string): void {
    this.painter.circle(at, 1.9 * this.unit, { fill: color, stroke: this.theme.ink, width: this.line });
  }

  weld(at: Point2): void {
    const h = 0.9 * this.unit;
    const [x, y] = at;
    this.painter.path([[[x - h, y - h], [x + h, y - h], [x + h, y + h], [x - h, y + h]]], true, { fill: this.theme.ink });
  }

  /** A line of the ground from a to b, hatched on its right (+1) or left (-1), as seen on the screen. */
  hatched(a: Point2, b: Point2, side: 1 | -1): void {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 0)) return;
    const d: Point2 = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const n: Point2 = [-d[1] * side, d[0] * side];
    const depth = Math.min(9, Math.max(3.5, 1.5 * this.unit));
    const count = Math.max(2, Math.floor(length / (0.85 * depth)));
    const gap = length / count;
    const strokes: Point2[][] = [];
    for (let i = 0; i < count; i++) {
      const s = (i + 0.85) * gap;
      const p: Point2 = [a[0] + s * d[0], a[1] + s * d[1]];
      const back = Math.min(depth, s);
      strokes.push([p, [p[0] - back * d[0] + back * n[0], p[1] - back * d[1] + back * n[1]]]);
    }
    this.painter.path(strokes, false, { stroke: this.theme.quiet, width: 0.75 * this.line });
    this.painter.path([[a, b]], false, { stroke: this.theme.ink, width: this.line });
  }

  /** A pinned support: a triangle below the pin (side 1) or above it (side -1), on hatched ground. */
  support([x, y]: Point2, side: 1 | -1): void {
    const u = Math.max(this.unit, SMALLEST_SUPPORT);
    const base = y + side * 3.6 * u;
    this.painter.path([[[x, y], [x - 2.3 * u, base], [x + 2.3 * u, base]]], true, { fill: this.theme.background, stroke: this.theme.ink, width: this.line });
    this.hatched([x - 3.5 * u, base], [x + 3.5 * u, base], side);
  }

  /** A wall that faces the direction, through the point. */
  wall([x, y]: Point2, toward: Point2): void {
    const length = Math.hypot(toward[0] - x, toward[1] - y);
    const d: Point2 = length > 0 ? [(toward[0] - x) / length, (toward[1] - y) / length] : [0, -1];
    const h = 3.4 * Math.max(this.unit, SMALLEST_SUPPORT);
    this.hatched([x - d[1] * h, y + d[0] * h], [x + d[1] * h, y - d[0] * h], -1);
  }

  /** A coil spring as a zigzag with straight ends. */
  spring(a: Point2, b: Point2, turns: number): void {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 0)) return;
    const d: Point2 = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const half = 2 * this.unit;
    const end = Math.min(3 * this.unit, 0.15 * length);
    const coil = length - 2 * end;
    const at = (s: number, n: number): Point2 => [a[0] + s * d[0] - n * d[1], a[1] + s * d[1] + n * d[0]];
    const points: Point2[] = [a, at(end, 0)];
    for (let i = 0; i < 2 * turns; i++) points.push(at(end + (coil * (i + 0.5)) / (2 * turns), i % 2 === 0 ? half : -half));
    points.push(at(length - end, 0), b);
    this.painter.path([points], false, { stroke: this.theme.ink, width: Math.max(1, this.line) });
    for (const point of [a, b]) this.painter.circle(point, 0.45 * this.unit, { fill: this.theme.ink });
  }

  /** Number of turns that suits a spring of this length. */
  turns(length: number): number {
    return Math.min(14, Math.max(4, Math.round(length / (3.2 * this.unit))));
  }

  rod(a: Point2, b: Point2): void {
    this.painter.path([[a, b]], false, { stroke: this.theme.ink, width: Math.max(1.4, 0.5 * this.unit) });
  }
}
