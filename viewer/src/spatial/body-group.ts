import { BufferGeometry, CatmullRomCurve3, DoubleSide, EdgesGeometry, ExtrudeGeometry, Float32BufferAttribute, Group, Line, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, Path, Shape as OutlineShape, SphereGeometry, TubeGeometry, Vector2, Vector3 } from "three";
import type { Animation, Body, Shape, Vec3 } from "../data/contract";
import { mix } from "../data/palette";
import { formLoops } from "../planar/outline";

/** Angle [deg] between faces above which their edge is drawn. */
const EDGE_ANGLE = 25;

/** The solid of a body (or of the ground): its shapes as thin plates, or rods between its points. */
export function bodyGroup(animation: Animation, body: Body | null, shapes: readonly Shape[], color: string, unit: number): Group {
  const group = new Group();
  for (const shape of shapes) {
    if (!shape.cut) group.add(plate(shape, shapes.filter((other) => other.cut), shape.color ?? color, unit));
  }
  if (body !== null && shapes.length === 0) rods(animation, body, color, unit).forEach((rod) => group.add(rod));
  return group;
}

function plate(shape: Shape, cuts: readonly Shape[], color: string, unit: number): Group {
  const group = new Group();
  group.position.set(...shape.position);
  const [w, x, y, z] = shape.quaternion;
  group.quaternion.set(x, y, z, w);
  if (shape.form.kind === "lump") {
    group.add(new Mesh(new SphereGeometry(2 * unit, 24, 16), material(color)));
    return group;
  }
  const [outer, ...holes] = formLoops(shape.form);
  const outline = new OutlineShape((outer ?? []).map(([px, py]) => new Vector2(px, py)));
  outline.holes = holes.map((hole) => new Path(hole.map(([px, py]) => new Vector2(px, py))));
  for (const cut of cuts) {
    for (const loop of formLoops(cut.form)) {
      const dx = cut.position[0] - shape.position[0];
      const dy = cut.position[1] - shape.position[1];
      outline.holes.push(new Path(loop.map(([px, py]) => new Vector2(px + dx, py + dy))));
    }
  }
  const geometry = new ExtrudeGeometry(outline, { depth: 1.6 * unit, bevelEnabled: false });
  geometry.translate(0, 0, -0.8 * unit);
  group.add(new Mesh(geometry, material(color)));
  group.add(new LineSegments(new EdgesGeometry(geometry, EDGE_ANGLE), new LineBasicMaterial({ color: mix(color, "#000000", 0.45) })));
  return group;
}

/** Rods between the points at which joints and springs hold a body that has no shapes. */
function rods(animation: Animation, body: Body, color: string, unit: number): (Mesh | Line)[] {
  const points: Vec3[] = [];
  for (const element of [...animation.joints, ...animation.springs]) {
    for (const side of [element.first, element.second]) {
      if (side.body === body && !points.some((p) => Math.hypot(p[0] - side.at[0], p[1] - side.at[1], p[2] - side.at[2]) < 1e-9)) points.push(side.at);
    }
  }
  if (points.length === 1) points.push([0, 0, 0]);
  if (points.length === 0 || (points.length === 2 && Math.hypot(...points[0]!) < 1e-9 && Math.hypot(...points[1]!) < 1e-9)) {
    return [new Mesh(new SphereGeometry(2 * unit, 24, 16), material(color))];
  }
  const centre = points.reduce((sum, p) => sum.add(new Vector3(...p)), new Vector3()).divideScalar(points.length);
  // Two points: one rod; more: a star from their middle.
  const pairs = points.length === 2 ? [[new Vector3(...points[0]!), new Vector3(...points[1]!)]] : points.map((p) => [centre, new Vector3(...p)]);
  return pairs.map(([a, b]) => new Mesh(new TubeGeometry(new CatmullRomCurve3([a!, b!]), 1, unit, 12), material(color)));
}

export function material(color: string): MeshStandardMaterial {
  return new MeshStandardMaterial({ color: mix(color, "#ffffff", 0.35), roughness: 0.75, metalness: 0, side: DoubleSide });
}

/** An open line through points, three numbers a point. */
export function polyline(points: readonly number[], color: string): Line {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  return new Line(geometry, new LineBasicMaterial({ color }));
}
