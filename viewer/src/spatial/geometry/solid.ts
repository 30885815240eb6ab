import { BoxGeometry, BufferGeometry } from "three";
import type { SolidForm } from "../../data/contract";
import { meshGeometry } from "./mesh";
import { arcProfile, revolve } from "./revolve";
import { surfaceGeometry } from "./surface";

const QUARTER = Math.PI / 2;
const ROUND = 24;

/** The surface of a form in its own frame; null for a curve, which has none. */
export function solidGeometry(form: SolidForm): BufferGeometry | null {
  switch (form.kind) {
    case "box":
      return new BoxGeometry(...form.size);
    case "plate":
      return new BoxGeometry(form.width, form.height, form.thickness);
    case "cylinder":
      return cylinder(form.radius, form.length);
    case "disk":
      return cylinder(form.radius, form.thickness);
    case "rod":
      // Its axis is x.
      return cylinder(form.radius, form.length).rotateY(QUARTER);
    case "tube": {
      const h = form.length / 2;
      return revolve([[form.inner, -h], [form.outer, -h], [form.outer, h], [form.inner, h]], true);
    }
    case "sphere":
      return ball(form.radius);
    case "ellipsoid":
      return ball(1).scale(...form.semiAxes);
    case "hemisphere":
      return revolve([[0, 0], ...arcProfile([0, 0], form.radius, 0, QUARTER, ROUND / 2)]);
    case "cone":
      return revolve([[0, 0], [form.radius, 0], [0, form.height]]);
    case "torus":
      return revolve(arcProfile([form.radius, 0], form.tube, 0, 4 * QUARTER, ROUND).slice(0, -1).map(([r, z]) => [Math.max(0, r), z]), true);
    case "revolved":
      return revolve(form.profile);
    case "mesh":
      return meshGeometry(form.vertices, form.triangles);
    case "surface":
      return surfaceGeometry(form.nu, form.nv, form.points);
    case "curve":
      return null;
  }
}

export function cylinder(radius: number, length: number): BufferGeometry {
  return revolve([[0, -length / 2], [radius, -length / 2], [radius, length / 2], [0, length / 2]]);
}

export function ball(radius: number): BufferGeometry {
  return revolve(arcProfile([0, 0], radius, -QUARTER, QUARTER, ROUND));
}
