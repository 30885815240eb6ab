import type { Point2 } from "../data/contract";
import { formatForce, formatLength, roundDown125 } from "../data/format";
import type { Theme } from "../planar/theme";
import type { Painter } from "../planar/painter";
import { AXIS_COLORS } from "./axis-lines";

/** A text at a place of the picture. */
export interface Label {
  readonly text: string;
  readonly at: Point2;
}

/** What is written over the picture in space. */
export interface OverlayContent {
  readonly width: number;
  readonly height: number;
  readonly labels: readonly Label[];
  /** Width of a cell of the grid [m]. */
  readonly cell: number;
  /** Directions of x, y, z on the screen, in parts of their length; the third number is towards the eye. */
  readonly axes: readonly (readonly [number, number, number])[];
  /** Newtons, and newton metres, a pixel, where arrows are shown. */
  readonly scales: readonly { readonly part: "force" | "moment"; readonly perPixel: number }[];
}

const GIZMO = 30;
const LONGEST_BAR = 110;

/** Draws names, the legend and the directions of the ground axes. */
export function drawOverlay(painter: Painter, theme: Theme, content: OverlayContent): void {
  const { height, labels, scales } = content;
  for (const { text, at } of labels) painter.text(at, text, { color: theme.ink, size: 13, bold: true, align: "center", halo: theme.background });
  painter.text([16, height - 16], `grid ${formatLength(content.cell)}`, { color: theme.quiet, size: 12, halo: theme.background });
  scales.forEach(({ part, perPixel }, i) => {
    const value = roundDown125(LONGEST_BAR * perPixel);
    const y = height - 42 - 28 * i;
    bar(painter, y, value / perPixel, theme.ink, part === "moment" ? 2 : 1);
    painter.text([16, y - 11], formatForce(value, part === "moment" ? "N m" : "N"), { color: theme.ink, size: 12, halo: theme.background });
  });
  gizmo(painter, theme, content);
}

function bar(painter: Painter, y: number, length: number, color: string, heads: number): void {
  const size = Math.min(9, length / 3);
  painter.path([[[16, y], [16 + length - 0.8 * size, y]]], false, { stroke: color, width: 2.2 });
  for (let i = 0; i < heads; i++) {
    const tip = 16 + length - 0.75 * i * size;
    painter.path([[[tip, y], [tip - size, y - 0.42 * size], [tip - size, y + 0.42 * size]]], true, { fill: color });
  }
}

/** The ground axes in the lower right corner, the nearest drawn last. */
function gizmo(painter: Painter, theme: Theme, { width, height, axes }: OverlayContent): void {
  const centre: Point2 = [width - 52, height - 50];
  const order = [0, 1, 2].sort((a, b) => axes[a]![2] - axes[b]![2]);
  for (const k of order) {
    const [x, y] = axes[k]!;
    const color = AXIS_COLORS[k]!;
    painter.path([[centre, [centre[0] + GIZMO * x, centre[1] - GIZMO * y]]], false, { stroke: color, width: 2.2 });
    painter.text([centre[0] + (GIZMO + 10) * x, centre[1] - (GIZMO + 10) * y], "xyz"[k]!, { color, size: 12, bold: true, align: "center", halo: theme.background });
  }
}
