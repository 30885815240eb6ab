import type { FlatForm, SolidForm, Vec3 } from "./contract";
import type { Fields, Json } from "./fields";

/** Reads a form of planar machines; null for a kind that is none. */
export function readFlatForm(fields: Fields, raw: Json, where: string): FlatForm | null {
  const size = (key: string) => fields.size(raw[key], `${where}.${key}`);
  switch (raw.kind) {
    case "bar": {
      const length = size("length");
      const width = raw.width === undefined || raw.width === null ? length / 10 : size("width");
      return { kind: "bar", length, width };
    }
    case "rectangle":
      return { kind: "rectangle", width: size("width"), height: size("height") };
    case "circle":
      return { kind: "circle", radius: size("radius") };
    case "ring":
      return { kind: "ring", outer: size("outer"), inner: size("inner") };
    case "polygon":
      return { kind: "polygon", points: fields.points(raw.points, `${where}.points`) };
    case "lump":
      return { kind: "lump" };
    default:
      return null;
  }
}

/** Reads a form of spatial machines; null for a kind that is none. */
export function readSolidForm(fields: Fields, raw: Json, where: string): SolidForm | null {
  const size = (key: string) => fields.positive(raw[key], `${where}.${key}`);
  const sizes = (key: string): Vec3 => {
    const list = fields.list(raw[key], `${where}.${key}`);
    const at = (i: number) => fields.positive(list[i], `${where}.${key}[${i}]`);
    if (list.length > 3) fields.problem(`${where}.${key} must have 3 numbers, it has ${list.length}.`);
    return [at(0), at(1), at(2)];
  };
  switch (raw.kind) {
    case "box":
      return { kind: "box", size: sizes("size") };
    case "cylinder":
      return { kind: "cylinder", radius: size("radius"), length: size("length") };
    case "tube": {
      const form = { kind: "tube", outer: size("outer"), inner: size("inner"), length: size("length") } as const;
      if (form.inner >= form.outer) fields.problem(`${where}.inner must be smaller than outer.`);
      return form;
    }
    case "sphere":
      return { kind: "sphere", radius: size("radius") };
    case "hemisphere":
      return { kind: "hemisphere", radius: size("radius") };
    case "cone":
      return { kind: "cone", radius: size("radius"), height: size("height") };
    case "rod":
      return { kind: "rod", length: size("length"), radius: size("radius") };
    case "disk":
      return { kind: "disk", radius: size("radius"), thickness: size("thickness") };
    case "plate":
      return { kind: "plate", width: size("width"), height: size("height"), thickness: size("thickness") };
    case "ellipsoid":
      return { kind: "ellipsoid", semiAxes: sizes("semi_axes") };
    case "torus":
      return { kind: "torus", radius: size("radius"), tube: size("tube") };
    case "mesh":
      return mesh(fields, raw, where);
    case "revolved": {
      const profile = fields.points(raw.profile, `${where}.profile`);
      if (profile.length < 2) fields.problem(`${where}.profile must have at least 2 points.`);
      if (profile.some(([r]) => r < 0)) fields.problem(`${where}.profile must not have negative radii.`);
      return { kind: "revolved", profile };
    }
    case "surface": {
      const nu = fields.count(raw.nu, 2, `${where}.nu`);
      const nv = fields.count(raw.nv, 2, `${where}.nv`);
      return { kind: "surface", nu, nv, points: fields.triples(raw.points, 4, `${where}.points`, 3 * nu * nv) };
    }
    case "curve":
      return { kind: "curve", points: fields.triples(raw.points, 2, `${where}.points`) };
    default:
      return null;
  }
}

function mesh(fields: Fields, raw: Json, where: string): SolidForm {
  const vertices = fields.triples(raw.vertices, 3, `${where}.vertices`);
  const list = fields.triples(raw.triangles, 1, `${where}.triangles`);
  const corners = vertices.length / 3;
  // Float32 holds whole numbers exactly up to 2^24; the list itself is looked at for what lies above.
  const indices = Array.isArray(raw.triangles) ? (raw.triangles as number[]) : [...list];
  const wrong = indices.find((index) => !(Number.isInteger(index) && index >= 0 && index < corners));
  if (wrong !== undefined) {
    fields.problem(`${where}.triangles names corner ${String(wrong)} of ${corners}, counted from 0.`);
    return { kind: "mesh", vertices: new Float32Array(9), triangles: new Uint32Array(3) };
  }
  return { kind: "mesh", vertices, triangles: Uint32Array.from(indices) };
}
