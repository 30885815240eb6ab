import type { Animation, Attachment, Channel, Spring, Vec3 } from "../data/contract";
import { TENSIONED, typical } from "../data/forces";
import { valueAt, type Frame } from "../motion/frame";
import { bodyPose, place, rotate } from "../motion/pose";
import { norm, scaled, subtract } from "./vectors";

/** A vector over time, in ground axes. */
export type VectorAt = (frame: Frame) => Vec3;

/** A force and a moment on a body over time. */
export interface Wrench {
  readonly name: string;
  /** A joint's reaction on its second body, or what an element applies. */
  readonly kind: "reaction" | "load";
  readonly at: Attachment;
  readonly force: VectorAt | null;
  readonly moment: VectorAt | null;
}

/**
 * The forces of a run whose place is known: NAME.force_x, _y, _z and NAME.moment_x, _y, _z in ground axes;
 * NAME.force and NAME.moment along the line of a load; NAME.force of springs along their two points.
 */
export function findWrenches(animation: Animation): readonly Wrench[] {
  const channels = new Map(animation.channels.map((channel) => [channel.name, channel]));
  const of = (name: string, unit: string): Channel | null => {
    const channel = channels.get(name);
    return channel && channel.unit === unit ? channel : null;
  };
  const vector = (name: string, unit: string): VectorAt | null => {
    const [x, y, z] = ["x", "y", "z"].map((axis) => of(`${name}_${axis}`, unit)?.values ?? null);
    // Planar runs have no z.
    return x && y ? (frame) => [valueAt(x, frame), valueAt(y, frame), z ? valueAt(z, frame) : 0] : null;
  };
  const out: Wrench[] = [];
  const add = (name: string, kind: Wrench["kind"], at: Attachment, line: VectorAt | null) => {
    const along = (channel: Channel | null): VectorAt | null => (channel && line ? (frame) => scaled(line(frame), valueAt(channel.values, frame)) : null);
    const force = vector(`${name}.force`, "N") ?? along(of(`${name}.force`, "N"));
    const moment = vector(`${name}.moment`, "N m") ?? along(of(`${name}.moment`, "N m"));
    if (force || moment) out.push({ name, kind, at, force, moment });
  };
  for (const joint of animation.joints) add(joint.name, "reaction", joint.second, null);
  for (const { name, at, along } of animation.loads) {
    add(name, "load", at, along ? (frame) => rotate(bodyPose(along.body, frame).quaternion, along.direction) : null);
  }
  for (const spring of animation.springs) add(spring.name, "load", spring.second, TENSIONED.has(spring.kind) ? pull(spring) : null);
  return out;
}

/** The direction from the second end of a spring to its first; coincident points have none. */
function pull({ first, second }: Spring): VectorAt {
  return (frame) => {
    const d = subtract(place(bodyPose(first.body, frame), first.at), place(bodyPose(second.body, frame), second.at));
    const length = norm(d);
    return length > 0 ? scaled(d, 1 / length) : [0, 0, 0];
  };
}

/** The size that arrows of forces or moments are scaled by; 0 if there are none. */
export function typicalSize(wrenches: readonly Wrench[], part: "force" | "moment", frames: readonly Frame[]): number {
  return Math.max(0, ...wrenches.map((wrench) => {
    const vector = wrench[part];
    return vector ? typical(frames.length, (i) => norm(vector(frames[i]!))) : 0;
  }));
}
