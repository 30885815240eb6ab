import { Vector3, type BufferGeometry } from "three";
import type { Animation, Body, Shape, Vec3 } from "../data/contract";
import { strutGeometry } from "./geometry/coil";
import { ball } from "./geometry/solid";
import { norm, subtract } from "./vectors";

/** Joints whose points say nothing of the form of a body. */
const FORMLESS_KINDS = new Set(["gear"]);

/** The shapes of a body; without any, the curves of its joints (a pitch circle, a cam's profile) as plates. */
export function shapesOf(animation: Animation, body: Body): readonly Shape[] {
  if (body.shapes.length > 0) return body.shapes;
  const ends = animation.joints.flatMap(({ first, second }) => [first, second]).filter((side) => side.body === body);
  return ends.flatMap(({ outline, at }): Shape[] =>
    outline ? [{ form: { kind: "polygon", points: outline }, position: [0, 0, at[2]], quaternion: [1, 0, 0, 0], color: null, cut: false }] : [],
  );
}

/** Rods between the points of a body that has no shapes; a ball where there is only one. */
export function struts(animation: Animation, body: Body, unit: number): readonly BufferGeometry[] {
  const points = distinctPoints(animation, body);
  // One point alone is no rod: the origin of the body is the other end.
  if (points.length === 1 && norm(points[0]!) > 0) points.push([0, 0, 0]);
  if (points.length < 2) {
    const [x, y, z] = points[0] ?? [0, 0, 0];
    return [ball(2 * unit).translate(x, y, z)];
  }
  const ends = points.map((p) => new Vector3(...p));
  if (ends.length === 2) return [strutGeometry(ends[0]!, ends[1]!, 1.1 * unit)];
  // More than two: a star from their middle.
  const centre = ends.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(ends.length);
  return [ball(1.1 * unit).translate(centre.x, centre.y, centre.z), ...ends.filter((p) => p.distanceTo(centre) > 0).map((p) => strutGeometry(centre, p, 1.1 * unit))];
}

/** The points at which a body without shapes is held, and its traced points. */
export function distinctPoints(animation: Animation, body: Body): Vec3[] {
  const elements = [...animation.joints.filter(({ kind }) => !FORMLESS_KINDS.has(kind)), ...animation.springs];
  const held = elements.flatMap(({ first, second }) => [first, second]).filter((side) => side.body === body);
  const all = [...held.map(({ at }) => at), ...animation.traces.filter((trace) => trace.body === body).map(({ at }) => at)];
  const size = Math.max(0, ...all.map(norm));
  const out: Vec3[] = [];
  for (const at of all) if (!out.some((other) => norm(subtract(at, other)) <= 1e-6 * size)) out.push(at);
  return out;
}
