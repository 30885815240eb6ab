import assert from "node:assert/strict";
import { test } from "node:test";
import { findForces, typicalForce } from "../src/data/forces";
import { formatForce } from "../src/data/format";
import { readAnimation } from "../src/data/read";
import { Camera } from "../src/planar/camera";
import { Figure } from "../src/planar/figure";
import type { Ink, Painter } from "../src/planar/painter";
import type { Point2 } from "../src/data/contract";
import { LIGHT } from "../src/planar/theme";
// @ts-expect-error the samples have no types
import * as mechanisms from "../samples/mechanisms.mjs";

const first = { index: 0, share: 0 };

/** Keeps the lines of one colour. */
class Lines implements Painter {
  readonly lines: (readonly Point2[])[] = [];
  readonly texts: string[] = [];
  constructor(private readonly color: string) {}
  path(lines: readonly (readonly Point2[])[], _closed: boolean, ink: Ink): void {
    if (ink.stroke === this.color) this.lines.push(...lines);
  }
  circle(): void {}
  text(_at: Point2, text: string): void {
    this.texts.push(text);
  }
}

function drawn(data: unknown, color: string, factor: number): Lines {
  const animation = readAnimation(JSON.stringify(data));
  const figure = new Figure(animation);
  const camera = new Camera();
  camera.resize(800, 600);
  camera.fit(figure.layout.bounds, 40);
  const painter = new Lines(color);
  figure.draw(painter, camera, first, { theme: LIGHT, traces: "off", names: false, forces: factor, highlighted: null });
  return painter;
}

test("forces are found where their place is known", () => {
  const data = mechanisms.equilibrium();
  data.channels.push({ name: "nobody.force_x", unit: "N", meaning: "", values: [1] }, { name: "nobody.force_y", unit: "N", meaning: "", values: [1] });
  const forces = findForces(readAnimation(JSON.stringify(data)));
  assert.deepEqual(forces.map(({ name, kind }) => `${kind} ${name}`), ["reaction wall", "reaction foot", "load weight"]);
  assert.ok(Math.abs(typicalForce(forces) - Math.hypot(228.7, 981)) < 1e-9);
});

test("a short peak does not set the scale", () => {
  const values = (peak: number) => Array.from({ length: 100 }, (_, i) => (i === 50 ? peak : 3));
  const data = mechanisms.equilibrium();
  data.time = values(0).map((_, i) => i);
  data.bodies[0].position = data.time.flatMap(() => [0, 0, 0]);
  data.bodies[0].quaternion = data.time.flatMap(() => [1, 0, 0, 0]);
  data.channels = ["x", "y"].map((axis) => ({ name: `foot.force_${axis}`, unit: "N", meaning: "", values: values(axis === "x" ? 1e6 : 0).map((v) => (axis === "x" ? v : 0)) }));
  assert.equal(typicalForce(findForces(readAnimation(JSON.stringify(data)))), 3);
});

test("arrows point along the forces on the bodies, in one scale", () => {
  const reactions = drawn(mechanisms.equilibrium(), LIGHT.reaction, 1);
  // Wall, foot, and the bar of the scale.
  assert.equal(reactions.lines.length, 3);
  const [wall, foot] = reactions.lines.map(([from, to]) => [to![0] - from![0], to![1] - from![1]] as const) as [Point2, Point2];
  assert.ok(wall[0] > 0 && Math.abs(wall[1]) < 1e-9);
  assert.ok(foot[0] < 0 && foot[1] < 0, "up and to the left on the screen");
  assert.ok(Math.abs(foot[0] / foot[1] - 228.7 / 981) < 1e-3);
  const [weight] = drawn(mechanisms.equilibrium(), LIGHT.load, 1).lines;
  assert.ok(weight![1]![1] > weight![0]![1], "down on the screen");
  assert.equal(drawn(mechanisms.equilibrium(), LIGHT.reaction, 0).lines.length, 0);
  assert.ok(reactions.texts.some((text) => text.endsWith(" N")));
});

test("a stretched spring pulls its second end to its first", () => {
  const data = mechanisms.springMass();
  data.channels.push({ name: "spring.force", unit: "N", meaning: "", values: data.time.map(() => 5) });
  const [pull] = drawn(data, LIGHT.load, 1).lines;
  assert.ok(pull![1]![1] < pull![0]![1] && Math.abs(pull![1]![0] - pull![0]![0]) < 1e-9, "up, to the ceiling");
});

test("without forces there is nothing to show", () => {
  const figure = new Figure(readAnimation(JSON.stringify(mechanisms.sliderCrank())));
  assert.ok(figure.forces.empty);
  assert.deepEqual(drawn(mechanisms.sliderCrank(), LIGHT.reaction, 1).lines, []);
});

test("sizes of forces are readable", () => {
  assert.deepEqual([0.002, 0.5, 20, 5000, 2e6].map((value) => formatForce(value)), ["2 mN", "500 mN", "20 N", "5 kN", "2 MN"]);
  assert.equal(formatForce(1500, "N m"), "1.5 kN m");
});
