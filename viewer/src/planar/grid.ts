import type { Point2 } from "../data/contract";
import { formatLength, roundDown125 } from "../data/format";
import type { Camera } from "./camera";
import type { Painter } from "./painter";
import type { Theme } from "./theme";

const WIDEST_CELL = 110;

/** Distance of the grid lines [m] at this scale. */
export function gridStep(scale: number): number {
  return roundDown125(WIDEST_CELL / scale);
}

/** Soft lines at round distances, the two axes a little stronger. */
export function drawGrid(painter: Painter, camera: Camera, theme: Theme): void {
  const step = gridStep(camera.scale);
  const [left, top] = camera.toWorld([0, 0]);
  const [right, bottom] = camera.toWorld([camera.width, camera.height]);
  const lines: Point2[][] = [];
  for (let i = Math.ceil(left / step); i * step <= right; i++) {
    const [x] = camera.toScreen([i * step, 0]);
    lines.push([[x, 0], [x, camera.height]]);
  }
  for (let i = Math.ceil(bottom / step); i * step <= top; i++) {
    const [, y] = camera.toScreen([0, i * step]);
    lines.push([[0, y], [camera.width, y]]);
  }
  painter.path(lines, false, { stroke: theme.grid, width: 1 });
  const [x, y] = camera.toScreen([0, 0]);
  painter.path([[[x, 0], [x, camera.height]], [[0, y], [camera.width, y]]], false, { stroke: theme.axis, width: 1 });
}

/** A bar in the corner that says how long a cell of the grid is. */
export function drawScale(painter: Painter, camera: Camera, theme: Theme): void {
  const step = gridStep(camera.scale);
  const length = step * camera.scale;
  const x = 16;
  const y = camera.height - 16;
  painter.path([[[x, y - 4], [x, y + 4]], [[x, y], [x + length, y]], [[x + length, y - 4], [x + length, y + 4]]], false, { stroke: theme.quiet, width: 1.4 });
  painter.text([x + length / 2, y - 10], formatLength(step), { color: theme.quiet, size: 12, align: "center", halo: theme.background });
}
