import assert from "node:assert/strict";
import { test } from "node:test";
import { ContractError } from "../src/data/contract";
import { readAnimation } from "../src/data/read";

const minimal = () => ({
  format: "dalembert-animation/1",
  title: "t",
  space: "planar",
  analysis: "kinematics",
  time: [0, 1],
  bodies: [{ name: "a", color: null, position: [0, 0, 0, 1, 0, 0], quaternion: [1, 0, 0, 0, 1, 0, 0, 0], shapes: [] as object[] }],
  ground: { shapes: [] },
  joints: [{ name: "j", kind: "revolute", first: { body: "ground", at: [0, 0, 0], direction: null as number[] | null }, second: { body: "a", at: [1, 2, 0], direction: null } }],
  springs: [],
  traces: [{ name: "p", body: "a", at: [0, 0, 0] }],
  channels: [{ name: "a.x", unit: "m", meaning: "", values: [0, null as number | null] }],
  notes: ["n"],
  summary: [["k", "v"]],
});

const problems = (data: unknown): readonly string[] => {
  try {
    readAnimation(typeof data === "string" ? data : JSON.stringify(data));
  } catch (error) {
    assert.ok(error instanceof ContractError);
    return error.problems;
  }
  return [];
};

test("a whole animation is read, with names resolved", () => {
  const animation = readAnimation(JSON.stringify(minimal()));
  assert.equal(animation.joints[0]?.first.body, null);
  assert.equal(animation.joints[0]?.second.body, animation.bodies[0]);
  assert.equal(animation.bodies[0]?.color, "#4477aa");
  assert.ok(Number.isNaN(animation.channels[0]?.values[1]));
  assert.deepEqual(animation.summary, [["k", "v"]]);
});

test("directions become unit vectors", () => {
  const data = minimal();
  data.joints[0]!.first.direction = [3, 4, 0];
  assert.deepEqual(readAnimation(JSON.stringify(data)).joints[0]?.first.direction, [0.6, 0.8, 0]);
});

test("an unknown shape is skipped with a note", () => {
  const data = minimal();
  data.bodies[0]!.shapes.push({ kind: "torus" }, { kind: "circle", radius: 1 });
  const animation = readAnimation(JSON.stringify(data));
  assert.equal(animation.bodies[0]?.shapes.length, 1);
  assert.match(animation.skipped[0] ?? "", /torus.*"a"/);
});

test("every mistake is named, not the first one only", () => {
  const data = minimal();
  data.bodies[0]!.position.pop();
  data.traces[0]!.body = "nobody";
  data.time = [1, 0];
  const found = problems(data);
  assert.equal(found.length, 3);
  assert.ok(found.some((text) => text.includes("must not fall")));
  assert.ok(found.some((text) => text.includes("6 numbers, it has 5")));
  assert.ok(found.some((text) => text.includes('no body "nobody"')));
});

test("no data, broken data and another format each say so", () => {
  assert.match(problems("  ")[0] ?? "", /no animation/);
  assert.match(problems("{")[0] ?? "", /not JSON/);
  assert.match(problems({ format: "dalembert-animation/2" })[0] ?? "", /dalembert-animation\/2/);
  assert.ok(problems([]).length > 0);
});

/** The minimal animation in space with one shape. */
const withShape = (shape: object) => {
  const data = { ...minimal(), space: "spatial" };
  data.bodies[0]!.shapes = [shape];
  return data;
};

test("forms of space are read with their sizes", () => {
  const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  for (const [shape, form] of [
    [{ kind: "box", size: [1, 2, 3] }, { kind: "box", size: [1, 2, 3] }],
    [{ kind: "tube", outer: 2, inner: 1, length: 3 }, { kind: "tube", outer: 2, inner: 1, length: 3 }],
    [{ kind: "ellipsoid", semi_axes: [1, 2, 3] }, { kind: "ellipsoid", semiAxes: [1, 2, 3] }],
    [{ kind: "mesh", vertices: corners, triangles: [0, 1, 2] }, { kind: "mesh", vertices: Float32Array.from(corners), triangles: Uint32Array.from([0, 1, 2]) }],
    [{ kind: "revolved", profile: [[0, 0], [1, 1]] }, { kind: "revolved", profile: [[0, 0], [1, 1]] }],
    [{ kind: "surface", nu: 2, nv: 2, points: [...corners, 1, 1, 1] }, { kind: "surface", nu: 2, nv: 2, points: Float32Array.from([...corners, 1, 1, 1]) }],
    [{ kind: "curve", points: corners }, { kind: "curve", points: Float32Array.from(corners) }],
  ]) {
    assert.deepEqual(readAnimation(JSON.stringify(withShape(shape!))).bodies[0]?.shapes[0]?.form, form);
  }
});

test("forms of space without sense are refused, each by its place", () => {
  const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  for (const [shape, text] of [
    [{ kind: "sphere", radius: 0 }, /shapes\[0\]\.radius must be a positive number/],
    [{ kind: "cylinder", radius: 1 }, /length must be a positive number/],
    [{ kind: "box", size: [1, -2, 3] }, /size\[1\] must be a positive number/],
    [{ kind: "tube", outer: 1, inner: 1, length: 1 }, /inner must be smaller/],
    [{ kind: "mesh", vertices: corners, triangles: [0, 1, 3] }, /corner 3 of 3/],
    [{ kind: "mesh", vertices: corners.slice(1), triangles: [0, 1, 2] }, /vertices must have three numbers/],
    [{ kind: "revolved", profile: [[-1, 0], [1, 0]] }, /negative radii/],
    [{ kind: "surface", nu: 2, nv: 3, points: corners }, /18 numbers, it has 9/],
    [{ kind: "surface", nu: 1, nv: 3, points: corners }, /nu must be a whole number, at least 2/],
    [{ kind: "curve", points: [0, 0, 0] }, /at least 2/],
  ] as const) {
    assert.ok(problems(withShape(shape)).some((problem) => text.test(problem)), `${JSON.stringify(shape)}: ${problems(withShape(shape)).join(" ")}`);
  }
});

test("joint frames, lines of loads and the upward direction are read as unit vectors", () => {
  const data = {
    ...minimal(),
    space: "spatial",
    up: [0, 2, 0],
    joints: [{ name: "j", kind: "revolute", first: { body: "ground", at: [0, 0, 0], direction: [0, 0, 2], reference: [3, 0, 5] }, second: { body: "a", at: [0, 0, 0] } }],
    loads: [{ name: "l", on: { body: "a", at: [0, 0, 0] }, along: { body: "ground", direction: [0, -4, 0] } }],
  };
  const animation = readAnimation(JSON.stringify(data));
  assert.deepEqual(animation.up, [0, 1, 0]);
  assert.deepEqual(animation.joints[0]?.first.reference, [1, 0, 0]);
  assert.deepEqual(animation.loads[0]?.along, { body: null, direction: [0, -1, 0] });
  assert.deepEqual(readAnimation(JSON.stringify(minimal())).up, [0, 0, 1]);
  data.loads[0]!.along.direction = [0, 0, 0];
  assert.match(problems(data)[0] ?? "", /must not be zero/);
});
