import type { Animation, Joint } from "../data/contract";
import { bodyPose, place, rotate } from "../motion/pose";
import type { Frame } from "../motion/frame";
import { dot, isFinite3, subtract } from "./vectors";

/** Where the second end of a joint goes along the axis of its first, from the first's point [m]. */
export interface Travel {
  readonly from: number;
  readonly to: number;
}

/** The travel of a joint over some frames; null for a joint without an axis on its first body. */
export function travel(joint: Joint, frames: readonly Frame[]): Travel | null {
  const { first, second } = joint;
  if (first.direction === null) return null;
  let [from, to] = [Infinity, -Infinity];
  for (const frame of frames) {
    const pose = bodyPose(first.body, frame);
    const axis = rotate(pose.quaternion, first.direction);
    const offset = subtract(place(bodyPose(second.body, frame), second.at), place(pose, first.at));
    if (!isFinite3(offset)) continue;
    from = Math.min(from, dot(offset, axis));
    to = Math.max(to, dot(offset, axis));
  }
  return from <= to ? { from, to } : null;
}

/** Mean distance of the two ends of an element over some frames [m]. */
export function meanLength({ first, second }: Animation["springs"][number], frames: readonly Frame[]): number {
  let [sum, count] = [0, 0];
  for (const frame of frames) {
    const d = subtract(place(bodyPose(second.body, frame), second.at), place(bodyPose(first.body, frame), first.at));
    const length = Math.hypot(...d);
    if (!Number.isFinite(length)) continue;
    sum += length;
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}
