import assert from "node:assert/strict";
import { test } from "node:test";
import type { Point2, Shape, ShapeForm } from "../src/data/contract";
import { readAnimation } from "../src/data/read";
import { Bounds } from "../src/planar/bounds";
import { Camera } from "../src/planar/camera";
import { Figure } from "../src/planar/figure";
import { gridStep } from "../src/planar/grid";
import { chord } from "../src/planar/guide";
import { bodyParts, formLoops, inside } from "../src/planar/outline";
import { SvgPainter } from "../src/planar/svg-painter";
import { DARK, LIGHT } from "../src/planar/theme";
// The samples are plain JavaScript, shared with the pages that people look at.
// @ts-expect-error they have no types
import * as mechanisms from "../samples/mechanisms.mjs";

const shape = (form: ShapeForm, cut = false, at: Point2 = [0, 0]): Shape => ({ form, cut, position: [...at, 0], quaternion: [1, 0, 0, 0], color: null });
const sample = (name: string) => readAnimation(JSON.stringify(mechanisms[name]()));
const first = { index: 0, share: 0 };

test("outlines have the sizes of their forms", () => {
  const size = (form: ShapeForm) => {
    const box = new Bounds();
    formLoops(form).forEach((loop) => box.addAll(loop));
    return [box.width, box.height].map((v) => Number(v.toFixed(6)));
  };
  assert.deepEqual(size({ kind: "bar", length: 2, width: 0.5 }), [2.5, 0.5]);
  assert.deepEqual(size({ kind: "rectangle", width: 3, height: 1 }), [3, 1]);
  assert.deepEqual(size({ kind: "circle", radius: 2 }), [4, 4]);
  assert.deepEqual(size({ kind: "ring", outer: 2, inner: 1 }), [4, 4]);
  assert.deepEqual(formLoops({ kind: "lump" }), []);
});

test("rings and cuts are hollow", () => {
  assert.ok(!inside(formLoops({ kind: "ring", outer: 2, inner: 1 }), 0, 0));
  assert.ok(inside(formLoops({ kind: "ring", outer: 2, inner: 1 }), 1.5, 0));
  const parts = bodyParts([shape({ kind: "rectangle", width: 4, height: 4 }), shape({ kind: "circle", radius: 0.5 }, true, [1, 1])]);
  assert.equal(parts.length, 1);
  assert.ok(!inside(parts[0]!.loops, 1, 1));
  assert.ok(inside(parts[0]!.loops, -1, -1));
});

test("a chord reaches to the two sides of the body", () => {
  const parts = bodyParts([shape({ kind: "rectangle", width: 4, height: 2 })]);
  assert.deepEqual(chord(parts, [1, 0], [1, 0]), [-3, 1]);
  assert.deepEqual(chord(parts, [1, 0.5], [0, 1]), [-1.5, 0.5]);
  assert.equal(chord(parts, [5, 0], [1, 0]), null);
});

test("the camera shows the whole box and keeps the point under the pointer", () => {
  const camera = new Camera();
  camera.resize(800, 600);
  camera.fit(new Bounds().add(-1, 2).add(3, 4), 50);
  for (const corner of [[-1, 2], [3, 4]] as const) {
    const [x, y] = camera.toScreen(corner);
    assert.ok(x >= 49.999 && x <= 750.001 && y >= 49.999 && y <= 550.001);
  }
  const before = camera.toWorld([123, 456]);
  camera.zoomAt([123, 456], 3);
  const after = camera.toWorld([123, 456]);
  assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-12);
  camera.fit(new Bounds().add(7, 8), 50);
  assert.deepEqual(camera.toScreen([7, 8]), [400, 300]);
});

test("cells of the grid are between 44 and 110 pixels wide", () => {
  for (let scale = 1e-3; scale < 1e6; scale *= 1.37) {
    const cell = gridStep(scale) * scale;
    assert.ok(cell > 43.9 && cell < 110.1, `${cell} pixels at ${scale}`);
  }
});

test("the slider runs between rails as long as its stroke, the follower in a sleeve", () => {
  const rails = new Figure(sample("sliderCrank")).layout.guides[0]!;
  // The stroke of a crank of 0.15 m, and the block of 0.08 m.
  assert.ok(rails.to - rails.from > 0.3 + 0.08 - 0.01 && rails.to - rails.from < 0.3 + 0.08 + 0.05);
  assert.ok(rails.left > 0.025 && rails.left < 0.03 && rails.right < -0.025);
  const sleeve = new Figure(sample("cam")).layout.guides[0]!;
  assert.ok(sleeve.to - sleeve.from < 0.1);
});

test("a wheel without a shape gets the radius that it keeps to its line", () => {
  const look = new Figure(sample("bare")).layout.looks.find((l) => l.body.name === "wheel")!;
  const [[centre, rim]] = look.marks as [[Point2, Point2]];
  assert.ok(Math.abs(rim[0] - centre[0] - 0.05) < 1e-12);
});

test("the curves of joints are the forms of bodies that have none", () => {
  const look = new Figure(sample("catalogue")).layout.looks.find((l) => l.body.name === "pinion")!;
  assert.equal(look.parts.length, 1);
  assert.ok(inside(look.parts[0]!.loops, 0.05, 0) && !inside(look.parts[0]!.loops, 0.07, 0));
});

test("a chain hangs from a ceiling, a crank stands on the ground", () => {
  assert.ok(new Figure(sample("chain")).layout.supports[0]!.toward[1] < -0.6);
  assert.ok(Math.abs(new Figure(sample("fourBar")).layout.supports[0]!.toward[1]) < 0.1);
});

test("the body under the pointer is found where it is now", () => {
  const animation = sample("sliderCrank");
  const figure = new Figure(animation);
  const [x, y] = animation.bodies[1]!.track.position;
  assert.equal(figure.bodyAt([x!, y!], first, 0)?.name, "rod");
  assert.equal(figure.bodyAt([5, 5], first, 0.01), null);
});

test("every planar sample becomes a clean SVG at any frame", () => {
  for (const name of Object.keys(mechanisms)) {
    const animation = sample(name);
    const figure = new Figure(animation);
    const camera = new Camera();
    camera.resize(800, 600);
    camera.fit(figure.layout.bounds, 40);
    for (const theme of [LIGHT, DARK]) {
      const painter = new SvgPainter(800, 600, 'a <b> & "c"');
      const last = { index: animation.time.length - 1, share: 0 };
      figure.draw(painter, camera, last, { theme, traces: "whole", names: true, forces: 0, highlighted: null });
      const svg = painter.finish();
      assert.doesNotMatch(svg, /NaN|undefined|Infinity/, name);
      assert.match(svg, /<title>a &lt;b&gt; &amp; &quot;c&quot;<\/title>/);
      for (const body of animation.bodies) assert.ok(svg.includes(`>${body.name}</text>`), `${name}: ${body.name}`);
    }
  }
});

test("a body without a pose at a frame is left out, the others stay", () => {
  const data = mechanisms.sliderCrank();
  data.bodies[1].position[0] = null;
  const animation = readAnimation(JSON.stringify(data));
  const figure = new Figure(animation);
  const camera = new Camera();
  camera.resize(800, 600);
  camera.fit(figure.layout.bounds, 40);
  const painter = new SvgPainter(800, 600, "t");
  figure.draw(painter, camera, first, { theme: LIGHT, traces: "growing", names: true, forces: 0, highlighted: null });
  const svg = painter.finish();
  assert.doesNotMatch(svg, /NaN/);
  assert.ok(svg.includes(">crank</text>") && !svg.includes(">rod</text>"));
});
