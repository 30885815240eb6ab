import { BoxGeometry, CylinderGeometry, Group, Mesh, Quaternion, Vector3, type BufferGeometry, type Object3D } from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Attachment, Body, Joint, Vec3 } from "../data/contract";
import { threadGeometry } from "./geometry/coil";
import { arcProfile, revolve } from "./geometry/revolve";
import { ball, cylinder } from "./geometry/solid";
import type { Materials } from "./materials";
import type { Travel } from "./travel";

const PIN = "#3f4650";
const SLEEVE = "#c3c8d0";
const RAIL = "#8b929d";

/** A part of a joint's symbol, its z along the joint's axis. */
export interface SymbolPart {
  readonly object: Object3D;
  /** Where it sits. */
  readonly seat: Attachment;
  /** Whose direction is its z axis. On another body than the seat, it turns as that body does. */
  readonly axis: Attachment | null;
}

/** Joints that have no place of their own. */
const PLACELESS = new Set(["gear", "parallel-axes", "perpendicular-axes", "coupler", "coordinate", "expression"]);

/** Draws joints by their kind. All symbols are built from few geometries, which are made once. */
export class JointSymbols {
  private readonly shapes = new Map<string, BufferGeometry>();

  constructor(
    private readonly unit: number,
    private readonly materials: Materials,
  ) {}

  /** The parts of a joint's symbol; `travel` is how far its second end goes along its axis. */
  parts(joint: Joint, travel: Travel | null): readonly SymbolPart[] {
    const { first, second } = joint;
    const onFirst = axisOf(first, second);
    const onSecond = axisOf(second, first);
    const at = (seat: Attachment, axis: Attachment | null, ...objects: Object3D[]): SymbolPart => ({ object: new Group().add(...objects), seat, axis });
    switch (joint.kind) {
      case "revolute":
        return [at(first, onFirst, this.knuckle()), at(second, onSecond, this.pin(5.4))];
      case "spherical":
        return [at(first, onFirst, this.socket()), at(second, null, this.ball(1.75, PIN))];
      case "constant-velocity":
        return [at(first, onFirst, this.socket(), this.stub()), at(second, onSecond, this.ball(1.6, PIN), this.stub())];
      case "universal":
        return [at(first, onFirst, this.pin(6), this.ball(1.1, PIN)), at(second, onSecond, this.pin(6))];
      case "cylindrical":
        return [...this.rail(first, travel, "round"), at(second, onSecond, this.sleeve(24))];
      case "prismatic":
        return [...this.rail(first, travel, "square"), at(second, onSecond, this.sleeve(4))];
      case "screw":
        return [...this.rail(first, travel, "thread"), at(second, onSecond, this.sleeve(6))];
      case "weld":
        return [at(second, onSecond, this.box(2.4, 2.4, 2.4, PIN))];
      case "planar":
        return [at(second, onFirst, this.box(7, 7, 0.5, SLEEVE)), at(second, null, this.ball(0.9, PIN))];
      case "point-on-plane":
        return [at(pointOf(joint), onFirst, this.disk()), at(pointOf(joint), null, this.ball(0.9, PIN))];
      case "point-on-line":
        return [...this.rail(first, travel, "round"), at(second, null, this.ball(1.2, PIN))];
      case "distance":
        return [at(first, null, this.ball(1, PIN)), at(second, null, this.ball(1, PIN))];
      default:
        return PLACELESS.has(joint.kind) ? [] : [at(second, null, this.ball(1, PIN))];
    }
  }

  /** The outer part of a hinge: two rings that leave the pin visible between them. */
  private knuckle(): Object3D {
    const ring = (z: number) => revolve([[0.85, z - 0.7], [1.7, z - 0.7], [1.7, z + 0.7], [0.85, z + 0.7]], true);
    return this.mesh(this.shape("knuckle", () => mergeGeometries([ring(-1.5), ring(1.5)])), SLEEVE);
  }

  private pin(length: number): Object3D {
    return this.mesh(this.shape(`pin ${length}`, () => cylinder(0.85, length)), PIN);
  }

  private ball(radius: number, color: string): Object3D {
    return this.mesh(this.shape(`ball ${radius}`, () => ball(radius)), color);
  }

  /** A bowl around the lower half of a ball. */
  private socket(): Object3D {
    const bowl = () => revolve([...arcProfile([0, 0], 2.3, -Math.PI / 2, 0.15, 12), ...arcProfile([0, 0], 1.8, 0.15, -Math.PI / 2, 12)]);
    return this.mesh(this.shape("socket", bowl), SLEEVE);
  }

  /** A short piece of a shaft. */
  private stub(): Object3D {
    return this.mesh(this.shape("stub", () => cylinder(0.9, 4).translate(0, 0, 2.6)), RAIL);
  }

  /** What slides on a rail; 4 and 6 sides for those that cannot turn freely. */
  private sleeve(sides: number): Object3D {
    const form = () => {
      const body = new CylinderGeometry(2.1, 2.1, 6, sides, 1).rotateX(Math.PI / 2).rotateZ(Math.PI / sides);
      if (sides >= 12) return body;
      // Few sides are flat sides.
      const flat = body.toNonIndexed();
      flat.computeVertexNormals();
      return flat;
    };
    return this.mesh(this.shape(`sleeve ${sides}`, form), SLEEVE);
  }

  private disk(): Object3D {
    return this.mesh(this.shape("disk", () => cylinder(3.2, 0.35)), SLEEVE);
  }

  private box(x: number, y: number, z: number, color: string): Object3D {
    return this.mesh(this.shape(`box ${x} ${y} ${z}`, () => new BoxGeometry(x, y, z)), color);
  }

  /** The line along which the second end slides, as long as its travel. */
  private rail(first: Attachment, travel: Travel | null, form: "round" | "square" | "thread"): readonly SymbolPart[] {
    if (travel === null) return [];
    const { unit } = this;
    const over = 5 * unit;
    const length = travel.to - travel.from + 2 * over;
    const geometry = form === "square" ? new BoxGeometry(1.5 * unit, 1.5 * unit, length) : cylinder(0.8 * unit, length);
    const bar = new Group().add(new Mesh(geometry, this.materials.solid(RAIL)));
    if (form === "thread") bar.add(new Mesh(threadGeometry(length, 0.95 * unit, 0.3 * unit), this.materials.solid(PIN)));
    bar.position.z = (travel.from + travel.to) / 2;
    return [{ object: new Group().add(bar), seat: first, axis: first }];
  }

  private mesh(geometry: BufferGeometry, color: string): Mesh {
    return new Mesh(geometry, this.materials.solid(color));
  }

  /** Geometries of size 1 for a pin's radius, made once and brought to size. */
  private shape(key: string, make: () => BufferGeometry): BufferGeometry {
    let shape = this.shapes.get(key);
    if (!shape) {
      shape = make().scale(this.unit, this.unit, this.unit);
      this.shapes.set(key, shape);
    }
    return shape;
  }
}

/** The end whose direction a part follows: its own, or else the other's. */
function axisOf(own: Attachment, other: Attachment): Attachment | null {
  return own.direction ? own : other.direction ? other : null;
}

/** The end of a point on a plane that is the point: the one without a direction. */
function pointOf({ first, second }: Joint): Attachment {
  return first.direction === null && second.direction !== null ? first : second;
}

/** The turn that brings z to a unit vector. */
export function turnTo(direction: Vec3): Quaternion {
  return new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...direction));
}

/** Does a part keep its place on one body? Then it need not be moved at every frame. */
export function fixedTo(part: SymbolPart): { readonly body: Body | null } | null {
  return part.axis === null || part.axis.body === part.seat.body ? { body: part.seat.body } : null;
}
