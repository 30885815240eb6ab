import { Box3, Group, Mesh, Quaternion, Vector3, type Material, type Object3D } from "three";
import type { Animation, Body, Joint, Vec3 } from "../data/contract";
import type { Frame } from "../motion/frame";
import { bodyPose, place, poseAt, rotate } from "../motion/pose";
import { sampleFrames } from "../motion/samples";
import type { ViewOptions } from "../view";
import { AxisLines } from "./axis-lines";
import { bodySolid, type BodySolid } from "./body-solid";
import { coilGeometry } from "./geometry/coil";
import { cylinder } from "./geometry/solid";
import { ForceVectors } from "./force-vectors";
import { fixedTo, JointSymbols, turnTo, type SymbolPart } from "./joint-symbols";
import type { Materials } from "./materials";
import { corners, measure, middle } from "./measure";
import { distinctPoints, shapesOf, struts } from "./struts";
import { TraceLine } from "./trace-line";
import { meanLength, travel } from "./travel";
import { add, isFinite3, norm, scaled, subtract } from "./vectors";

const GROUND_COLOR = "#9a9da3";
const SPRING_COLOR = "#6b7280";
/** Size of the symbols, as a part of the size of the machine. */
const UNIT = 0.0075;
const SAMPLES = 200;

/** What can be pointed at. */
export interface Pointable {
  readonly body: Body | null;
  readonly joint: Joint | null;
}

/** A body in the picture. */
export interface BodyInPicture {
  readonly body: Body;
  readonly group: Group;
  readonly solid: BodySolid;
  /** Where its name stands, in its own frame. */
  readonly middle: Vec3;
}

/** Everything of the machine in space: built once, then only moved. */
export class Machine {
  readonly group = new Group();
  readonly bodies: readonly BodyInPicture[];
  readonly forces: ForceVectors;
  /** The box around everything at every instant, in the axes of the picture. */
  readonly box: Box3;
  readonly pointables = new Map<Object3D, Pointable>();
  private readonly floating: SymbolPart[] = [];
  private readonly bars: { element: Joint; mesh: Mesh; length: number }[] = [];
  private readonly traces: readonly TraceLine[];
  private readonly frames = new Array<Object3D>();
  private readonly axes = new Array<Object3D>();

  constructor(
    private readonly animation: Animation,
    materials: Materials,
  ) {
    const up = new Quaternion().setFromUnitVectors(new Vector3(...animation.up), new Vector3(0, 0, 1));
    this.group.quaternion.copy(up);
    this.box = measure(animation, up);
    const size = this.box.getSize(new Vector3()).length();
    const unit = UNIT * size;
    const ground = bodySolid(animation.groundShapes, [], GROUND_COLOR, unit, materials);
    this.group.add(ground.group);
    this.bodies = animation.bodies.map((body) => this.body(body, unit, materials));
    const hosts = new Map<Body | null, Object3D>([[null, this.group], ...this.bodies.map(({ body, group }) => [body, group] as const)]);
    this.joints(hosts, unit, materials);
    this.axisLines(hosts, new AxisLines(unit, materials));
    const all = sampleFrames(animation.time.length, Infinity);
    this.traces = animation.traces.map((trace) => new TraceLine(trace, all.map((frame) => place(bodyPose(trace.body, frame), trace.at)), unit, materials));
    this.forces = new ForceVectors(animation, size, unit, materials);
    this.group.add(...this.traces.map(({ group }) => group), this.forces.group);
  }

  /** Moves everything to a frame. */
  show(frame: Frame, options: ViewOptions): void {
    for (const { body, group } of this.bodies) {
      const { position, quaternion } = poseAt(body.track, frame);
      group.visible = isFinite3(position) && quaternion.every(Number.isFinite);
      if (!group.visible) continue;
      group.position.set(...position);
      group.quaternion.set(quaternion[1], quaternion[2], quaternion[3], quaternion[0]);
    }
    for (const { object, seat, axis } of this.floating) {
      const at = place(bodyPose(seat.body, frame), seat.at);
      object.visible = isFinite3(at);
      object.position.set(...at);
      if (axis) object.quaternion.copy(turnTo(rotate(bodyPose(axis.body, frame).quaternion, axis.direction!)));
    }
    for (const bar of this.bars) this.stretch(bar, frame);
    for (const trace of this.traces) trace.show(frame, options.traces);
    for (const object of this.frames) object.visible = options.frames;
    for (const object of this.axes) object.visible = options.axes;
    this.forces.show(frame, options.forces);
  }

  /** Shows which body is pointed at. */
  highlight(lit: Body | null): void {
    for (const { body, solid } of this.bodies) {
      for (const { mesh, plain, lit: bright } of solid.surfaces) mesh.material = body === lit ? bright : plain;
    }
  }

  private body(body: Body, unit: number, materials: Materials): BodyInPicture {
    const shapes = shapesOf(this.animation, body);
    const rods = shapes.length === 0 ? struts(this.animation, body, unit) : [];
    const solid = bodySolid(shapes, rods, body.color, unit, materials);
    this.group.add(solid.group);
    for (const { mesh } of solid.surfaces) this.pointables.set(mesh, { body, joint: null });
    const points = shapes.length > 0 ? corners(shapes) : distinctPoints(this.animation, body);
    return { body, group: solid.group, solid, middle: middle(points) };
  }

  private joints(hosts: ReadonlyMap<Body | null, Object3D>, unit: number, materials: Materials): void {
    const symbols = new JointSymbols(unit, materials);
    const frames = sampleFrames(this.animation.time.length, SAMPLES);
    for (const joint of this.animation.joints) {
      for (const part of symbols.parts(joint, travel(joint, frames))) {
        const fixed = fixedTo(part);
        if (fixed) {
          part.object.position.set(...part.seat.at);
          if (part.axis) part.object.quaternion.copy(turnTo(part.axis.direction!));
          hosts.get(fixed.body)!.add(part.object);
          freeze(part.object);
        } else {
          this.group.add(part.object);
          this.floating.push(part);
        }
        part.object.traverse((object) => {
          if (object instanceof Mesh) this.pointables.set(object, { body: null, joint });
        });
      }
      if (joint.kind === "distance") this.bar(joint, cylinder(0.7 * unit, 1).translate(0, 0, 0.5), 1, materials.solid(SPRING_COLOR));
    }
    for (const spring of this.animation.springs) {
      // Built at its mean length: stretching it then changes the wire little.
      const length = meanLength(spring, frames) || unit;
      this.bar(spring, coilGeometry(length, 2.2 * unit, 0.42 * unit), length, materials.solid(SPRING_COLOR));
    }
  }

  private bar(element: Joint, geometry: Mesh["geometry"], length: number, material: Material): void {
    const mesh = new Mesh(geometry, material);
    this.group.add(mesh);
    this.bars.push({ element, mesh, length });
    this.pointables.set(mesh, { body: null, joint: element });
  }

  private stretch({ element: { first, second }, mesh, length }: Machine["bars"][number], frame: Frame): void {
    const a = place(bodyPose(first.body, frame), first.at);
    const d = subtract(place(bodyPose(second.body, frame), second.at), a);
    const now = norm(d);
    mesh.visible = now > 0 && Number.isFinite(now) && isFinite3(a);
    if (!mesh.visible) return;
    mesh.position.set(...a);
    mesh.quaternion.copy(turnTo(scaled(d, 1 / now)));
    mesh.scale.z = now / length;
  }

  private axisLines(hosts: ReadonlyMap<Body | null, Object3D>, lines: AxisLines): void {
    for (const { group } of this.bodies) {
      const frame = lines.bodyFrame();
      group.add(frame);
      this.frames.push(frame);
    }
    const ground = lines.bodyFrame();
    this.group.add(ground);
    this.frames.push(ground);
    for (const { first, second } of this.animation.joints) {
      for (const end of [first, second]) {
        const axis = lines.jointAxis(end);
        if (!axis) continue;
        hosts.get(end.body)!.add(axis);
        this.axes.push(axis);
      }
    }
  }

  /** Where the name of a body stands at a frame, in ground axes. */
  namePlace({ body, middle: at }: BodyInPicture, frame: Frame): Vec3 {
    const pose = poseAt(body.track, frame);
    return add(pose.position, rotate(pose.quaternion, at));
  }
}

/** What does not move in its body need not be placed anew at every frame. */
function freeze(object: Object3D): void {
  object.traverse((one) => {
    one.updateMatrix();
    one.matrixAutoUpdate = false;
  });
}
