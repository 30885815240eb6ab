import type { Point2 } from "../data/contract";
import type { Bounds } from "./bounds";

/** Map from the plane (metres, y up) to the picture (pixels, y down). */
export class Camera {
  width = 1;
  height = 1;
  /** Pixels a metre. */
  scale = 100;
  x = 0;
  y = 0;

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  /** Shows the whole box with a margin in pixels around it. */
  fit(box: Bounds, margin: number): void {
    if (box.empty) return;
    const room = (size: number) => Math.max(size - 2 * margin, size / 4);
    const scale = Math.min(room(this.width) / box.width, room(this.height) / box.height);
    // A single point has no size: any scale shows it.
    this.scale = Number.isFinite(scale) ? scale : 100;
    this.x = (box.xMin + box.xMax) / 2;
    this.y = (box.yMin + box.yMax) / 2;
  }

  toScreen([x, y]: Point2): Point2 {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  toWorld([px, py]: Point2): Point2 {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  panBy(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Zooms so that the point under the pointer stays there. */
  zoomAt(pixel: Point2, factor: number): void {
    const [x, y] = this.toWorld(pixel);
    this.scale = Math.min(1e9, Math.max(1e-6, this.scale * factor));
    const [px, py] = this.toScreen([x, y]);
    this.panBy(pixel[0] - px, pixel[1] - py);
  }
}
