import assert from "node:assert/strict";
import { test } from "node:test";
import { Box3, Mesh, Vector3, type Object3D } from "three";
import type { Animation, Vec3 } from "../src/data/contract";
import { readAnimation } from "../src/data/read";
import { DARK, LIGHT } from "../src/planar/theme";
import { fitDistance } from "../src/spatial/fit-distance";
import { floorHeight } from "../src/spatial/floor";
import { JointSymbols } from "../src/spatial/joint-symbols";
import { Machine } from "../src/spatial/machine";
import { Materials } from "../src/spatial/materials";
import { pathPieces } from "../src/spatial/path-pieces";
import { describe } from "../src/spatial/spatial-view";
import { travel } from "../src/spatial/travel";
import { findWrenches, typicalSize } from "../src/spatial/wrench";
import type { ViewOptions } from "../src/view";
// The samples are plain JavaScript, shared with the pages that people look at.
// @ts-expect-error they have no types
import * as samples from "../samples/spatial.mjs";

const sample = (name: string): Animation => readAnimation(JSON.stringify(samples[name]()));
const options: ViewOptions = { theme: LIGHT, traces: "growing", names: true, forces: 1, frames: true, axes: true };
const first = { index: 0, share: 0 };
const close = (a: readonly number[], b: readonly number[], tolerance = 1e-12) => a.forEach((v, i) => assert.ok(Math.abs(v - b[i]!) <= tolerance, `${a} is not ${b}`));

function everything(machine: Machine): Object3D[] {
  const out: Object3D[] = [];
  machine.group.updateMatrixWorld(true);
  machine.group.traverse((object) => out.push(object));
  return out;
}

test("every sample is built without a problem and keeps finite places in its box", () => {
  for (const name of Object.keys(samples)) {
    const animation = sample(name);
    assert.deepEqual(animation.skipped, [], name);
    const machine = new Machine(animation, new Materials());
    assert.ok(!machine.box.isEmpty(), name);
    const room = machine.box.clone().expandByScalar(0.25 * machine.box.getSize(new Vector3()).length());
    for (const frame of [first, { index: 3, share: 0.5 }, { index: animation.time.length - 1, share: 0 }]) {
      machine.show(frame, options);
      for (const object of everything(machine)) {
        assert.ok(object.matrixWorld.elements.every(Number.isFinite), `${name}: ${object.type}`);
        if (object instanceof Mesh && object.visible && object.geometry.boundingBox === null) object.geometry.computeBoundingBox();
      }
      for (const { group } of machine.bodies) assert.ok(room.containsPoint(group.getWorldPosition(new Vector3())), name);
    }
  }
});

test("a mesh of fifty thousand sharp triangles is drawn", () => {
  const data = samples.bareLoop();
  const count = 50_000;
  const corners = Array.from({ length: count }, (_, i) => [i, 0, 0, i + 0.5, 1, 0, i + 0.5, 0, 1].map((v) => v / count)).flat();
  data.bodies[0].shapes = [{ kind: "mesh", vertices: corners, triangles: Array.from({ length: 3 * count }, (_, i) => i) }];
  const machine = new Machine(readAnimation(JSON.stringify(data)), new Materials());
  assert.equal(machine.bodies[0]!.solid.surfaces[0]!.mesh.geometry.getAttribute("position").count, 3 * count);
});

test("geometry is built once: frames only move it", () => {
  const machine = new Machine(sample("sliderCrankInSpace"), new Materials());
  const geometries = () => everything(machine).flatMap((object) => (object instanceof Mesh ? [object.geometry.uuid] : []));
  machine.show(first, options);
  const before = geometries();
  machine.show({ index: 100, share: 0.5 }, options);
  assert.deepEqual(geometries(), before);
});

test("two hundred bodies share materials and few geometries of symbols, and move in time", () => {
  const animation = sample("crowd");
  const machine = new Machine(animation, new Materials());
  const meshes = everything(machine).filter((object): object is Mesh => object instanceof Mesh && object.parent?.type === "Group");
  assert.ok(new Set(meshes.map((mesh) => mesh.material)).size < 30);
  const options200 = { ...options, frames: false, axes: false };
  const start = performance.now();
  const rounds = 20;
  for (let i = 0; i < rounds; i++) {
    machine.show({ index: i, share: 0.3 }, options200);
    machine.group.updateMatrixWorld();
  }
  const each = (performance.now() - start) / rounds;
  // A sixtieth of a second has room for drawing too, and test machines are slow.
  assert.ok(each < 16, `${each} ms a frame`);
});

test("bodies, hinges and springs are where the motion puts them", () => {
  const animation = sample("sliderCrankInSpace");
  const machine = new Machine(animation, new Materials());
  const frame = { index: 40, share: 0 };
  machine.show(frame, options);
  machine.bodies.forEach(({ group }, i) => close(group.position.toArray(), [...animation.bodies[i]!.track.position.slice(120, 123)]));
  const pendulum = sample("ballPendulum");
  const hanging = new Machine(pendulum, new Materials());
  hanging.show(first, options);
  // y is up in this sample: the picture's z.
  const [x, y, z] = pendulum.bodies[0]!.track.position;
  hanging.group.updateMatrixWorld(true);
  close(hanging.bodies[0]!.group.getWorldPosition(new Vector3()).toArray(), [x!, -z!, y!], 1e-9);
  const coil = [...hanging.pointables].find(([, { joint }]) => joint?.name === "spring")![0] as Mesh;
  const ends = new Box3().setFromObject(coil, true);
  assert.ok(ends.distanceToPoint(new Vector3(0.5, 0, -0.2)) < 0.02, "at the wall");
});

test("a body without a pose at a frame vanishes, the others stay", () => {
  const data = samples.sliderCrankInSpace();
  data.bodies[1].position[0] = null;
  const machine = new Machine(readAnimation(JSON.stringify(data)), new Materials());
  machine.show(first, options);
  assert.deepEqual(machine.bodies.map(({ group }) => group.visible), [true, false, true]);
});

test("the curves of joints are the forms of bodies that have none", () => {
  const ring = Array.from({ length: 24 }, (_, i) => [0.2 * Math.cos((i * Math.PI) / 12), 0.2 * Math.sin((i * Math.PI) / 12)]);
  const data = samples.bareLoop();
  data.joints[0].second.outline = ring;
  const machine = new Machine(readAnimation(JSON.stringify(data)), new Materials());
  const [crank, coupler] = machine.bodies.map(({ solid }) => new Box3().setFromObject(solid.surfaces[0]!.mesh).getSize(new Vector3()));
  assert.ok(Math.abs(crank!.x - 0.4) < 1e-6 && Math.abs(crank!.y - 0.4) < 1e-6);
  assert.ok(coupler!.z > 0.3, "a rod");
});

test("frames and axes are shown where they are asked for", () => {
  const machine = new Machine(sample("joints"), new Materials());
  const lines = () => {
    let count = 0;
    machine.group.traverseVisible((object) => (count += object.type === "LineSegments2" ? 1 : 0));
    return count;
  };
  const shown = (frames: boolean, axes: boolean) => {
    machine.show(first, { ...options, frames, axes });
    return lines();
  };
  const none = shown(false, false);
  assert.equal(shown(true, false) - none, 3 * 14, "13 bodies and the ground");
  assert.ok(shown(false, true) > none);
});

test("every kind of joint has its own symbol, but those without a place have none", () => {
  const symbols = new JointSymbols(1, new Materials());
  const end = (direction: Vec3 | null) => ({ body: null, at: [0, 0, 0] as Vec3, direction, reference: null, outline: null });
  const seen = new Map<string, string>();
  const corners = (kind: string) => {
    const parts = symbols.parts({ name: kind, kind, first: end([0, 0, 1]), second: end([0, 0, 1]) }, { from: -1, to: 1 });
    let text = "";
    for (const { object } of parts) {
      object.traverse((one) => {
        if (!(one instanceof Mesh)) return;
        one.geometry.computeBoundingBox();
        text += `${one.geometry.getAttribute("position").count} ${one.geometry.boundingBox!.max.toArray().join(" ")}; `;
      });
    }
    return text;
  };
  for (const kind of ["revolute", "spherical", "universal", "constant-velocity", "cylindrical", "prismatic", "screw", "weld", "planar", "distance", "point-on-plane", "point-on-line", "contact"]) {
    const text = corners(kind);
    assert.ok(text !== "", kind);
    assert.equal(seen.get(text), undefined, `${kind} looks like ${seen.get(text)}`);
    seen.set(text, kind);
  }
  assert.equal(corners("gear"), "");
});

test("a sliding joint is given a rail as long as its travel", () => {
  const animation = sample("sliderCrankInSpace");
  const guide = animation.joints.find(({ name }) => name === "guide")!;
  const frames = animation.time.reduce<{ index: number; share: number }[]>((list, _, index) => [...list, { index, share: 0 }], []);
  const { from, to } = travel(guide, frames)!;
  const x = frames.map(({ index }) => animation.bodies[2]!.track.position[3 * index]! - 0.25);
  close([from, to], [Math.min(...x), Math.max(...x)]);
  assert.equal(travel(animation.joints.find(({ kind }) => kind === "spherical")!, frames), null);
});

test("forces and moments are vectors in ground axes", () => {
  const animation = sample("sliderCrankInSpace");
  const wrenches = findWrenches(animation);
  assert.deepEqual(wrenches.map(({ name, kind, force, moment }) => `${kind} ${name} ${force ? "F" : ""}${moment ? "M" : ""}`), [
    "reaction ball F", "reaction cross F", "reaction guide FM", "load motor M", "load weight F",
  ]);
  const motor = wrenches.find(({ name }) => name === "motor")!;
  close(motor.moment!({ index: 60, share: 0 }), [3, 0, 0]);
  close(wrenches.find(({ name }) => name === "weight")!.force!(first), [0, 0, -15]);
  assert.ok(Math.abs(typicalSize(wrenches, "moment", [{ index: 60, share: 0 }]) - 3) < 1e-12);
});

test("a spring pulls its second end to its first", () => {
  const animation = sample("ballPendulum");
  const spring = findWrenches(animation).find(({ name }) => name === "spring")!;
  const [x, y, z] = spring.force!(first);
  assert.ok(x > 0 && Math.abs(Math.hypot(x, y, z) - 18) < 1e-9);
});

test("arrows point along their forces and are as long as the legend says", () => {
  const machine = new Machine(sample("ballPendulum"), new Materials());
  machine.show(first, options);
  const { forces } = machine;
  const [weight] = forces.group.children;
  weight!.updateWorldMatrix(true, true);
  const box = new Box3().setFromObject(weight!, true);
  const tip = weight!.localToWorld(new Vector3(0, 0, 20 / forces.perMetre.force));
  assert.ok(Math.abs(box.min.z - tip.z) < 1e-6 * 20, "down, as far as the scale says");
  machine.show(first, { ...options, forces: 0 });
  assert.ok(!forces.group.visible);
});

test("a path is cut where there is no place", () => {
  const { positions, upTo } = pathPieces([[0, 0, 0], [1, 0, 0], [NaN, 0, 0], [3, 0, 0], [4, 0, 0]]);
  assert.deepEqual([...positions], [0, 0, 0, 1, 0, 0, 3, 0, 0, 4, 0, 0]);
  assert.deepEqual(upTo, [0, 1, 1, 1, 2]);
});

test("the whole box is seen from every side", () => {
  const box = new Box3(new Vector3(-1, -2, -0.1), new Vector3(1, 2, 0.1));
  for (const direction of [[1, 0, 0], [0, 0, 1], [0, -1, 0], [1, -1.5, 0.8]] as const) {
    for (const aspect of [0.5, 1, 2]) {
      const d = fitDistance(box, new Vector3(...direction), 40, aspect);
      assert.ok(Number.isFinite(d) && d > 2, `${direction} ${d}`);
    }
  }
  // From above, 4 m must fit into the height: 2 / tan 20 deg, and the height of the box.
  assert.ok(Math.abs(fitDistance(box, new Vector3(0, 0, 1), 40, 1) - (2 / Math.tan(Math.PI / 9) + 0.1)) < 1e-9);
  assert.equal(fitDistance(new Box3(new Vector3(), new Vector3()), new Vector3(1, 0, 0), 40, 1), 1);
});

test("the floor lies under the machine, at zero where that is near", () => {
  assert.ok(Math.abs(floorHeight(0.1, 1, 1) + 1e-3) < 1e-12);
  assert.ok(Math.abs(floorHeight(-2, 1, 1) + 2.001) < 1e-12);
  assert.ok(Math.abs(floorHeight(10, 11, 1) - 9.999) < 1e-12);
});

test("a change of theme repaints materials that are in use", () => {
  const materials = new Materials();
  const solid = materials.solid("#4477aa") as ReturnType<Materials["solid"]> & { color: { getHexString(): string } };
  const light = solid.color.getHexString();
  materials.setTheme(DARK);
  assert.notEqual(solid.color.getHexString(), light);
  assert.equal(materials.solid("#4477aa"), solid);
});

test("a pose is said in words", () => {
  const h = Math.SQRT1_2;
  assert.equal(describe({ position: [0.01, 0, -1], quaternion: [-h, 0, 0, -h] }), "x 10 mm, y 0 µm, z −1 m, turned 90.00° about (0, 0, 1)");
  assert.equal(describe({ position: [1, 1, 1], quaternion: [1, 0, 0, 0] }), "x 1 m, y 1 m, z 1 m");
});
