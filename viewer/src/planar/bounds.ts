import type { Point2 } from "../data/contract";

/** The smallest box, sides along the axes, around the points that it was shown. */
export class Bounds {
  xMin = Infinity;
  xMax = -Infinity;
  yMin = Infinity;
  yMax = -Infinity;

  add(x: number, y: number): this {
    if (Number.isFinite(x) && Number.isFinite(y)) {
      this.xMin = Math.min(this.xMin, x);
      this.xMax = Math.max(this.xMax, x);
      this.yMin = Math.min(this.yMin, y);
      this.yMax = Math.max(this.yMax, y);
    }
    return this;
  }

  addAll(points: readonly Point2[]): this {
    for (const [x, y] of points) this.add(x, y);
    return this;
  }

  get empty(): boolean {
    return this.xMin > this.xMax;
  }

  get width(): number {
    return this.empty ? 0 : this.xMax - this.xMin;
  }

  get height(): number {
    return this.empty ? 0 : this.yMax - this.yMin;
  }

  /** Length of the diagonal. */
  get size(): number {
    return Math.hypot(this.width, this.height);
  }
}
