import type { Animation, Attachment, Point2 } from "../data/contract";
import { findForces, typicalForce, typicalMoment, type ForceHistory } from "../data/forces";
import { formatForce, roundDown125 } from "../data/format";
import { valueAt, type Frame } from "../motion/frame";
import type { Camera } from "./camera";
import type { Painter } from "./painter";
import type { Theme } from "./theme";

/** Length of a typical arrow, as a part of the size of the picture. */
const TYPICAL_LENGTH = 0.18;
/** Arrows shorter than this cannot be seen [pixels]. */
const SHORTEST = 1.5;
/** Moments below this part of the typical one are rounding, or belong to joints that cannot hold one. */
const SMALLEST_MOMENT = 1e-3;
/** Angle of the arc of a typical moment [rad]. */
const TYPICAL_ARC = 0.75 * Math.PI;
const LARGEST_ARC = 1.8 * Math.PI;
const LONGEST_BAR = 110;

/** The forces of a machine as arrows, all in one scale. */
export class ForceArrows {
  readonly forces: readonly ForceHistory[];
  private readonly force: number;
  private readonly moment: number;

  constructor(
    animation: Animation,
    /** Size of the machine [m]. */
    private readonly size: number,
  ) {
    this.forces = findForces(animation);
    this.force = typicalForce(this.forces);
    this.moment = typicalMoment(this.forces);
  }

  get empty(): boolean {
    return !(this.force > 0);
  }

  /** Draws the arrows at a frame, `factor` times as long as they are by themselves. */
  draw(painter: Painter, camera: Camera, frame: Frame, theme: Theme, factor: number, place: (side: Attachment) => Point2, unit: number): void {
    if (this.empty) return;
    const pixels = this.pixelsPerNewton(camera, factor);
    for (const force of this.forces) {
      const at = place(force.at);
      const [x, y] = components(force, frame, at, place);
      if (!Number.isFinite(at[0] + at[1] + x + y)) continue;
      const color = force.kind === "reaction" ? theme.reaction : theme.load;
      arrow(painter, at, [at[0] + x * pixels, at[1] - y * pixels], color);
      if (force.moment) this.arc(painter, at, valueAt(force.moment, frame) * factor, color, unit);
    }
    this.scale(painter, camera, theme, pixels);
  }

  private pixelsPerNewton(camera: Camera, factor: number): number {
    const size = this.size > 0 ? this.size : 1;
    return (factor * TYPICAL_LENGTH * size * camera.scale) / this.force;
  }

  /** A moment as an arc around its point, counter-clockwise where it is positive. */
  private arc(painter: Painter, [x, y]: Point2, moment: number, color: string, unit: number): void {
    const share = moment / this.moment;
    if (!(Math.abs(share) > SMALLEST_MOMENT)) return;
    const angle = Math.sign(share) * Math.min(LARGEST_ARC, Math.abs(share) * TYPICAL_ARC);
    const radius = Math.max(12, 3.2 * unit);
    const count = 24;
    const at = (i: number): Point2 => {
      const a = (angle * i) / count;
      return [x + radius * Math.cos(a), y - radius * Math.sin(a)];
    };
    painter.path([Array.from({ length: count + 1 }, (_, i) => at(i))], false, { stroke: color, width: 2 });
    if (Math.abs(angle) * radius > 6) head(painter, at(count - 2), at(count), color, 7);
  }

  /** A bar in the corner that says how large the forces are. */
  private scale(painter: Painter, camera: Camera, theme: Theme, pixels: number): void {
    const value = roundDown125(LONGEST_BAR / pixels);
    const x = 16;
    const y = camera.height - 52;
    const end: Point2 = [x + value * pixels, y];
    arrow(painter, [x, y], end, theme.reaction);
    painter.text([(x + end[0]) / 2, y - 11], formatForce(value), { color: theme.reaction, size: 12, align: "center", halo: theme.background });
  }
}

function components(force: ForceHistory, frame: Frame, at: Point2, place: (side: Attachment) => Point2): Point2 {
  const [x, y] = [valueAt(force.x, frame), valueAt(force.y, frame)];
  if (!force.toward) return [x, y];
  const to = place(force.toward);
  const length = Math.hypot(to[0] - at[0], to[1] - at[1]);
  // Coincident points have no direction. The screen's y points down.
  return length > 0 ? [(x * (to[0] - at[0])) / length, (-x * (to[1] - at[1])) / length] : [0, 0];
}

function arrow(painter: Painter, from: Point2, to: Point2, color: string): void {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > SHORTEST)) return;
  const size = Math.min(11, 0.6 * length);
  const back = 1 - (0.8 * size) / length;
  const neck: Point2 = [from[0] + back * (to[0] - from[0]), from[1] + back * (to[1] - from[1])];
  painter.path([[from, neck]], false, { stroke: color, width: 2.2 });
  head(painter, from, to, color, size);
}

function head(painter: Painter, from: Point2, tip: Point2, color: string, size: number): void {
  const length = Math.hypot(tip[0] - from[0], tip[1] - from[1]);
  const d: Point2 = [(tip[0] - from[0]) / length, (tip[1] - from[1]) / length];
  const corner = (side: number): Point2 => [tip[0] - size * d[0] - side * 0.42 * size * d[1], tip[1] - size * d[1] + side * 0.42 * size * d[0]];
  painter.path([[tip, corner(1), corner(-1)]], true, { fill: color });
}
