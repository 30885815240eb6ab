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
