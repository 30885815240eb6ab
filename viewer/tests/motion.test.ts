import assert from "node:assert/strict";
import { test } from "node:test";
import type { Quaternion, Vec3 } from "../src/data/contract";
import { locate, nearestFrame, valueAt } from "../src/motion/frame";
import { place, planar, planarAngle, poseAt, rotate, slerp, toBody, toGround } from "../src/motion/pose";
import { sampleFrames } from "../src/motion/samples";

const near = (a: number, b: number, tolerance = 1e-14) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);
const about = (axis: Vec3, angle: number): Quaternion => [Math.cos(angle / 2), ...axis.map((c) => c * Math.sin(angle / 2))] as unknown as Quaternion;

test("a time is found between its frames and never outside", () => {
  const time = Float64Array.of(0, 1, 3, 3, 4);
  assert.deepEqual(locate(time, -5), { index: 0, share: 0 });
  assert.deepEqual(locate(time, 2), { index: 1, share: 0.5 });
  assert.deepEqual(locate(time, 3), { index: 3, share: 0 });
  assert.deepEqual(locate(time, 9), { index: 4, share: 0 });
  assert.deepEqual(locate(time, NaN), { index: 0, share: 0 });
  assert.deepEqual(locate(Float64Array.of(7), 7), { index: 0, share: 0 });
  assert.equal(nearestFrame(time, 1.9), 1);
  assert.equal(nearestFrame(time, 2.1), 2);
  near(valueAt(Float64Array.of(0, 2, 8, 8, 8), locate(time, 1.5)), 3.5);
});

test("slerp turns evenly, the short way, whatever the sign of the quaternion", () => {
  const a = about([0, 0, 1], 0.2);
  const b = about([0, 0, 1], 1.4);
  const flipped = b.map((c) => -c) as unknown as Quaternion;
  for (const end of [b, flipped]) {
    const q = slerp(a, end, 0.25);
    near(2 * Math.atan2(q[3], q[0]), 0.5);
  }
  assert.deepEqual(slerp(a, a, 0.3).map((c) => Number(c.toFixed(14))), a.map((c) => Number(c.toFixed(14))));
});

test("rotation agrees with the matrix of a turn about each axis", () => {
  const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
  const expected: [Vec3, Vec3, Vec3][] = [
    [[1, 0, 0], [0, 1, 0], [0, c, s]],
    [[0, 1, 0], [0, 0, 1], [s, 0, c]],
    [[0, 0, 1], [1, 0, 0], [c, s, 0]],
  ];
  for (const [axis, vector, result] of expected) rotate(about(axis, 0.7), vector).forEach((value, i) => near(value, result[i]!));
});

test("planar and spatial poses put a point at the same place, and back", () => {
  const pose = { position: [1, -2, 0] as Vec3, quaternion: about([0, 0, 1], 2.1) };
  const flat = planar(pose);
  const [x, y] = toGround(flat, 0.3, 0.4);
  const whole = place(pose, [0.3, 0.4, 0]);
  near(x, whole[0]);
  near(y, whole[1]);
  const back = toBody(flat, x, y);
  near(back[0], 0.3);
  near(back[1], 0.4);
  near(planarAngle(flat), 2.1);
});

test("a pose between frames lies between them", () => {
  const track = { position: Float64Array.of(0, 0, 0, 2, 4, 0), quaternion: Float64Array.from([...about([0, 0, 1], 0), ...about([0, 0, 1], 1)]) };
  const pose = poseAt(track, { index: 0, share: 0.5 });
  assert.deepEqual(pose.position, [1, 2, 0]);
  near(planarAngle(planar(pose)), 0.5);
});

test("samples hold the first and the last frame", () => {
  const frames = sampleFrames(1000, 7).map((f) => f.index);
  assert.equal(frames.length, 7);
  assert.equal(frames[0], 0);
  assert.equal(frames[6], 999);
  assert.deepEqual(sampleFrames(3, 10).map((f) => f.index), [0, 1, 2]);
  assert.deepEqual(sampleFrames(1, 10), [{ index: 0, share: 0 }]);
});
