import type { Animation, Attachment, Body, Joint, Point2, Vec3 } from "../data/contract";
import type { Frame } from "../motion/frame";
import { planarPose, toBody, toGround } from "../motion/pose";
import { inside, type Part } from "./outline";

/** A straight line fixed to a body (or to the ground) along which another body moves, in that body's frame. */
export interface Guide {
  readonly host: Body | null;
  readonly form: "rails" | "slot" | "line";
  readonly origin: Point2;
  readonly direction: Point2;
  /** Range along the direction. */
  readonly from: number;
  readonly to: number;
  /** Distances of the two rails from the line, to the right (negative) and to the left. */
  readonly right: number;
  readonly left: number;
  /** Side without the moving body (+1 left, -1 right): there a line on the ground is hatched. */
  readonly free: 1 | -1;
}

/** Gap between a body and its rails, in pin radii. */
const CLEARANCE = 0.2;

/** A body much longer than it is thick runs in a short sleeve instead of between long rails. */
const SLEEVE_RATIO = 3;

export function guides(animation: Animation, parts: ReadonlyMap<Body, readonly Part[]>, frames: readonly Frame[], unit: number): Guide[] {
  const out: Guide[] = [];
  for (const joint of animation.joints) {
    const guide = guideOf(joint, parts, frames, unit);
    if (guide) out.push(guide);
  }
  return out;
}

function guideOf(joint: Joint, parts: ReadonlyMap<Body, readonly Part[]>, frames: readonly Frame[], unit: number): Guide | null {
  switch (joint.kind) {
    case "prismatic":
      return slide(joint, parts, frames, unit);
    case "pin-slot": {
      const run = travel(joint.first, joint.second, frames);
      return run && { ...run.line, form: "slot", from: run.from, to: run.to, right: 0, left: 0, free: 1 };
    }
    case "rolling-on-line":
      return rolled(joint.first, joint.second, frames, unit);
    case "rack":
      return rolled(joint.second, joint.first, frames, unit);
    default:
      return null;
  }
}

function slide(joint: Joint, parts: ReadonlyMap<Body, readonly Part[]>, frames: readonly Frame[], unit: number): Guide | null {
  const run = travel(joint.first, joint.second, frames);
  if (!run) return null;
  const along = joint.second.direction;
  const body = joint.second.body;
  const at: Point2 = [joint.second.at[0], joint.second.at[1]];
  const own = (body && parts.get(body)) ?? [];
  const d: Point2 = along ? [along[0], along[1]] : [1, 0];
  const length = along && chord(own, at, d);
  const thickness = along && chord(own, at, [-d[1], d[0]]);
  const [back, front] = length ?? [-3 * unit, 3 * unit];
  const [right, left] = thickness ?? [-2 * unit, 2 * unit];
  const base = { ...run.line, form: "rails" as const, right: run.offset + right - CLEARANCE * unit, left: run.offset + left + CLEARANCE * unit, free: 1 as const };
  // The part of the line that the body covers all the time.
  const covered = [run.to + back, run.from + front] as const;
  if (front - back > SLEEVE_RATIO * (left - right) && covered[1] - covered[0] > 4 * unit) {
    const half = Math.min(5 * unit, (covered[1] - covered[0]) / 2);
    const centre = Math.min(covered[1] - half, Math.max(covered[0] + half, 0));
    return { ...base, from: centre - half, to: centre + half };
  }
  return { ...base, from: run.from + back - 2 * unit, to: run.to + front + 2 * unit };
}

function rolled(lineSide: Attachment, circleSide: Attachment, frames: readonly Frame[], unit: number): Guide | null {
  const run = travel(lineSide, circleSide, frames);
  if (!run) return null;
  const radius = Math.abs(run.offset);
  return { ...run.line, form: "line", from: run.from - radius - 4 * unit, to: run.to + radius + 4 * unit, right: 0, left: 0, free: run.offset > 0 ? -1 : 1 };
}

interface Travel {
  readonly line: { readonly host: Body | null; readonly origin: Point2; readonly direction: Point2 };
  readonly from: number;
  readonly to: number;
  /** Mean distance to the left of the line. */
  readonly offset: number;
}

/** Where the point of `moving` goes along the line of `fixed`. */
function travel(fixed: Attachment, moving: Attachment, frames: readonly Frame[]): Travel | null {
  if (!fixed.direction) return null;
  const size = Math.hypot(fixed.direction[0], fixed.direction[1]);
  if (size < 1e-9) return null;
  const direction: Point2 = [fixed.direction[0] / size, fixed.direction[1] / size];
  let from = Infinity;
  let to = -Infinity;
  let sum = 0;
  let count = 0;
  for (const frame of frames) {
    const ground = toGround(planarPose(moving.body, frame), moving.at[0], moving.at[1]);
    const [x, y] = toBody(planarPose(fixed.body, frame), ground[0], ground[1]);
    const dx = x - fixed.at[0];
    const dy = y - fixed.at[1];
    const s = dx * direction[0] + dy * direction[1];
    if (!Number.isFinite(s)) continue;
    from = Math.min(from, s);
    to = Math.max(to, s);
    sum += dy * direction[0] - dx * direction[1];
    count += 1;
  }
  if (count === 0) return null;
  return { line: { host: fixed.body, origin: [fixed.at[0], fixed.at[1]], direction }, from, to, offset: sum / count };
}

/** How far a body reaches from a point inside it, backwards and forwards along a direction; null for a point outside. */
export function chord(parts: readonly Part[], at: Point2, direction: Point2): readonly [number, number] | null {
  let back = 0;
  let front = 0;
  for (const { loops } of parts) {
    if (!inside(loops, at[0], at[1])) continue;
    const crossings = loops.flatMap((loop) => loop.flatMap((p, i) => crossing(at, direction, p, loop[(i + 1) % loop.length]!)));
    const before = crossings.filter((t) => t < 0);
    const after = crossings.filter((t) => t > 0);
    if (before.length > 0) back = Math.min(back, Math.max(...before));
    if (after.length > 0) front = Math.max(front, Math.min(...after));
  }
  return back < 0 && front > 0 ? [back, front] : null;
}

/** Parameter t where at + t d meets the segment p q. */
function crossing(at: Point2, d: Point2, p: Point2, q: Point2): number[] {
  const side = (point: Point2) => d[0] * (point[1] - at[1]) - d[1] * (point[0] - at[0]);
  const a = side(p);
  const b = side(q);
  if (a > 0 === b > 0) return [];
  const share = a / (a - b);
  const x = p[0] + share * (q[0] - p[0]) - at[0];
  const y = p[1] + share * (q[1] - p[1]) - at[1];
  return [x * d[0] + y * d[1]];
}

/** Circles that follow from joints: the roller of each body that rolls on a line, with the radius that it keeps to it. */
export function rollers(animation: Animation): Map<Body, { at: Vec3; radius: number }> {
  const out = new Map<Body, { at: Vec3; radius: number }>();
  for (const joint of animation.joints) {
    const pair = joint.kind === "rolling-on-line" ? [joint.first, joint.second] : joint.kind === "rack" ? [joint.second, joint.first] : null;
    if (!pair) continue;
    const [line, round] = pair as [Attachment, Attachment];
    const run = travel(line, round, [{ index: 0, share: 0 }]);
    if (round.body && run && run.offset !== 0) out.set(round.body, { at: round.at, radius: Math.abs(run.offset) });
  }
  return out;
}
