import { Box3, Vector3, type Quaternion } from "three";
import type { Animation, Body, Vec3 } from "../data/contract";
import { bodyPose, place } from "../motion/pose";
import { sampleFrames } from "../motion/samples";
import { surfaceOf, placement } from "./body-solid";
import { shapesOf } from "./struts";
import { isFinite3 } from "./vectors";

/** Frames that are looked at to find where the machine goes. */
const SAMPLES = 200;
/** A machine whose parts have no size at all is shown as if it were this large [m]. */
const SMALLEST = 1e-6;

/** The box around everything at every instant, in axes that are turned by `up` from those of the ground. */
export function measure(animation: Animation, up: Quaternion): Box3 {
  const box = new Box3();
  const frames = sampleFrames(animation.time.length, SAMPLES);
  const p = new Vector3();
  const add = (body: Body | null, points: readonly Vec3[]) => {
    for (const frame of body === null ? frames.slice(0, 1) : frames) {
      const pose = bodyPose(body, frame);
      for (const point of points) {
        const at = place(pose, point);
        if (isFinite3(at)) box.expandByPoint(p.set(...at).applyQuaternion(up));
      }
    }
  };
  for (const element of [...animation.joints, ...animation.springs]) {
    for (const side of [element.first, element.second]) add(side.body, [side.at]);
  }
  for (const trace of animation.traces) add(trace.body, [trace.at]);
  for (const body of animation.bodies) {
    const shapes = shapesOf(animation, body);
    add(body, shapes.length > 0 ? corners(shapes) : [[0, 0, 0]]);
  }
  add(null, corners(animation.groundShapes));
  if (box.isEmpty()) box.expandByPoint(p.set(0, 0, 0));
  if (box.getSize(p).length() < SMALLEST) box.expandByScalar(0.5);
  return box;
}

/** Corners of the box around shapes in the frame of their body; flat forms count as infinitely thin. */
export function corners(shapes: Body["shapes"]): readonly Vec3[] {
  const box = new Box3();
  for (const shape of shapes.filter((one) => !one.cut)) {
    if (shape.form.kind === "curve") {
      const { points } = shape.form;
      for (let i = 0; i < points.length; i += 3) box.expandByPoint(new Vector3(points[i]!, points[i + 1]!, points[i + 2]!).applyMatrix4(placement(shape)));
      continue;
    }
    const geometry = surfaceOf(shape, [], 0)?.applyMatrix4(placement(shape));
    geometry?.computeBoundingBox();
    if (geometry?.boundingBox) box.union(geometry.boundingBox);
    geometry?.dispose();
  }
  if (box.isEmpty()) return [];
  const { min, max } = box;
  return [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z): Vec3 => [x, y, z])));
}

/** Middle of what is drawn of a body, in its own frame. */
export function middle(points: readonly Vec3[]): Vec3 {
  if (points.length === 0) return [0, 0, 0];
  const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k]!)));
  const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k]!)));
  return [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2, (low[2]! + high[2]!) / 2];
}
