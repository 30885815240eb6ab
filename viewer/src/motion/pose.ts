import type { Body, Point2, Quaternion, Track, Vec3 } from "../data/contract";
import type { Frame } from "./frame";

/** Position of a body frame and its unit quaternion (w, x, y, z). */
export interface Pose {
  readonly position: Vec3;
  readonly quaternion: Quaternion;
}

export const GROUND: Pose = { position: [0, 0, 0], quaternion: [1, 0, 0, 0] };

/** Pose of a body at a place in its history: straight lines and shortest great circles between frames. */
export function poseAt(track: Track, frame: Frame): Pose {
  const { index, share } = frame;
  const p = 3 * index;
  const q = 4 * index;
  const position: Vec3 = [track.position[p]!, track.position[p + 1]!, track.position[p + 2]!];
  const quaternion: Quaternion = [track.quaternion[q]!, track.quaternion[q + 1]!, track.quaternion[q + 2]!, track.quaternion[q + 3]!];
  if (share === 0) return { position, quaternion };
  const next: Quaternion = [track.quaternion[q + 4]!, track.quaternion[q + 5]!, track.quaternion[q + 6]!, track.quaternion[q + 7]!];
  return {
    position: [
      position[0] + share * (track.position[p + 3]! - position[0]),
      position[1] + share * (track.position[p + 4]! - position[1]),
      position[2] + share * (track.position[p + 5]! - position[2]),
    ],
    quaternion: slerp(quaternion, next, share),
  };
}

export function bodyPose(body: Body | null, frame: Frame): Pose {
  return body === null ? GROUND : poseAt(body.track, frame);
}

/** Turns evenly from one orientation to another, the short way; q and -q are the same orientation. */
export function slerp(a: Quaternion, b: Quaternion, share: number): Quaternion {
  let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = dot < 0 ? -1 : 1;
  dot = Math.min(1, Math.abs(dot));
  const angle = Math.acos(dot);
  // Below this angle the sines cancel; the straight line is as exact.
  const small = angle < 1e-4;
  const wa = small ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const wb = sign * (small ? share : Math.sin(share * angle) / Math.sin(angle));
  const q: Quaternion = [wa * a[0] + wb * b[0], wa * a[1] + wb * b[1], wa * a[2] + wb * b[2], wa * a[3] + wb * b[3]];
  const norm = Math.hypot(...q);
  return [q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm];
}

/** Turns a vector by a unit quaternion: v + 2 w (u x v) + 2 u x (u x v). */
export function rotate([w, x, y, z]: Quaternion, v: Vec3): Vec3 {
  const cx = 2 * (y * v[2] - z * v[1]);
  const cy = 2 * (z * v[0] - x * v[2]);
  const cz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * cx + y * cz - z * cy, v[1] + w * cy + z * cx - x * cz, v[2] + w * cz + x * cy - y * cx];
}

/** A point of the body in ground axes. */
export function place(pose: Pose, at: Vec3): Vec3 {
  const r = rotate(pose.quaternion, at);
  return [pose.position[0] + r[0], pose.position[1] + r[1], pose.position[2] + r[2]];
}

/** A planar pose as the 2 x 3 map (x, y) -> (x0 + c x - s y, y0 + s x + c y). */
export interface PlanarPose {
  readonly x: number;
  readonly y: number;
  readonly c: number;
  readonly s: number;
}

export const PLANAR_GROUND: PlanarPose = { x: 0, y: 0, c: 1, s: 0 };

export function planar({ position, quaternion }: Pose): PlanarPose {
  const [c, s] = rotate(quaternion, [1, 0, 0]);
  return { x: position[0], y: position[1], c, s };
}

export function planarPose(body: Body | null, frame: Frame): PlanarPose {
  return body === null ? PLANAR_GROUND : planar(poseAt(body.track, frame));
}

export function toGround(pose: PlanarPose, x: number, y: number): Point2 {
  return [pose.x + pose.c * x - pose.s * y, pose.y + pose.s * x + pose.c * y];
}

export function toBody(pose: PlanarPose, x: number, y: number): Point2 {
  const dx = x - pose.x;
  const dy = y - pose.y;
  return [pose.c * dx + pose.s * dy, -pose.s * dx + pose.c * dy];
}

/** Angle of the planar body's x axis in (-pi, pi]. */
export function planarAngle(pose: PlanarPose): number {
  return Math.atan2(pose.s, pose.c);
}
