import type { Animation, Attachment, Body, Point2 } from "../data/contract";
import type { Frame } from "../motion/frame";
import { planarPose, toGround } from "../motion/pose";

/** A fixed point that is drawn as standing on the ground or hanging from it. */
export interface Support {
  readonly at: Point2;
  readonly form: "pin" | "wall";
  /** Where the held thing is, as a mean over the run: a unit vector, shorter if it goes around. */
  readonly toward: Point2;
}

/** One support for each point of the ground that holds a pin, a rod, a weld or a spring. */
export function supports(animation: Animation, centres: ReadonlyMap<Body, Point2>, frames: readonly Frame[]): Support[] {
  const out: Support[] = [];
  const add = (held: Attachment, form: "pin" | "wall", seen: readonly Frame[], body: Body | null, point: Point2) => {
    const at: Point2 = [held.at[0], held.at[1]];
    if (!out.some((other) => other.at[0] === at[0] && other.at[1] === at[1])) out.push({ at, form, toward: meanDirection(at, body, point, seen) });
  };
  for (const joint of animation.joints) {
    for (const [side, other] of [[joint.first, joint.second], [joint.second, joint.first]] as const) {
      if (side.body !== null) continue;
      const end: Point2 = [other.at[0], other.at[1]];
      const centre = (other.body && centres.get(other.body)) ?? end;
      if (joint.kind === "revolute") add(side, "pin", frames, other.body, centre);
      else if (joint.kind === "distance") add(side, "pin", frames, other.body, end);
      else if (joint.kind === "weld") add(side, "wall", frames.slice(0, 1), other.body, centre);
    }
  }
  for (const spring of animation.springs) {
    for (const [side, other] of [[spring.first, spring.second], [spring.second, spring.first]] as const) {
      // The wall keeps the direction that it had at the start.
      if (side.body === null) add(side, "wall", frames.slice(0, 1), other.body, [other.at[0], other.at[1]]);
    }
  }
  return out;
}

function meanDirection(at: Point2, body: Body | null, point: Point2, frames: readonly Frame[]): Point2 {
  let [x, y, count] = [0, 0, 0];
  for (const frame of frames) {
    const [px, py] = toGround(planarPose(body, frame), point[0], point[1]);
    const length = Math.hypot(px - at[0], py - at[1]);
    if (!(length > 0)) continue;
    x += (px - at[0]) / length;
    y += (py - at[1]) / length;
    count += 1;
  }
  return count === 0 ? [0, 0] : [x / count, y / count];
}
