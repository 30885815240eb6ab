import { BufferGeometry, EdgesGeometry, Float32BufferAttribute, Group, LineSegments, Matrix4, Mesh, Quaternion, Vector3, type Material } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Shape } from "../data/contract";
import { holesOf, isFlat, plateGeometry } from "./geometry/plate";
import { ball, solidGeometry } from "./geometry/solid";
import { surfaceLines } from "./geometry/surface";
import { atWorkingSize } from "./geometry/working-size";
import type { Materials } from "./materials";

/** Angle [deg] between faces above which their edge is drawn. */
const EDGE_ANGLE = 34;
/** Surfaces with more triangles are drawn without edges: they would only blacken them. */
const MOST_TRIANGLES = 60_000;
/** How much of a body with holes hides what is behind it. */
const HOLED = 0.62;
const HOLE = 0.3;
/** A surface by itself, on which something slides. */
const SHEET = 0.35;

/** The solid of a body, and the surfaces of it that can be pointed at. */
export interface BodySolid {
  readonly group: Group;
  readonly surfaces: readonly { readonly mesh: Mesh; readonly plain: Material; readonly lit: Material }[];
}

/** Builds shapes, and rods that stand for a body without any, as one surface a colour and one set of edges. */
export function bodySolid(shapes: readonly Shape[], struts: readonly BufferGeometry[], color: string, unit: number, materials: Materials): BodySolid {
  const group = new Group();
  const byColor = new Map<string, BufferGeometry[]>();
  const edges: number[] = [];
  const keep = (geometry: BufferGeometry, own: string) => {
    const list = byColor.get(own) ?? [];
    byColor.set(own, [...list, bare(geometry)]);
  };
  const cuts = shapes.filter((shape) => shape.cut);
  const plates = shapes.filter((shape) => !shape.cut && isFlat(shape));
  // A flat cut becomes a hole in plates; what is left is shown as a body of glass.
  const ghosts = cuts.filter((cut) => !plates.some((plate) => holesOf(cut, plate).length > 0));
  for (const shape of shapes) {
    if (shape.cut) continue;
    const own = shape.color ?? color;
    if (shape.form.kind === "curve") group.add(curve(shape, shape.form.points, own, materials));
    const geometry = surfaceOf(shape, cuts, unit);
    if (!geometry) continue;
    const lines = shape.form.kind === "surface" ? surfaceLines(shape.form.nu, shape.form.nv, shape.form.points) : edgesOf(geometry);
    geometry.applyMatrix4(placement(shape));
    if (shape.form.kind === "surface") {
      const sheet = new Mesh(geometry, materials.glass(own, SHEET));
      sheet.renderOrder = 1;
      group.add(sheet);
    }
    // One by one: a mesh has more numbers than a call may have arguments.
    for (const number of moved(lines, placement(shape))) edges.push(number);
    if (shape.form.kind !== "surface") keep(geometry, own);
  }
  for (const strut of struts) keep(strut, color);

  const surfaces: { mesh: Mesh; plain: Material; lit: Material }[] = [];
  for (const [own, list] of byColor) {
    const geometry = list.length === 1 ? list[0]! : mergeGeometries(list);
    const plain = ghosts.length > 0 ? materials.glass(own, HOLED) : materials.solid(own);
    const mesh = new Mesh(geometry, plain);
    group.add(mesh);
    surfaces.push({ mesh, plain, lit: materials.lit(own) });
  }
  if (edges.length > 0) group.add(new LineSegments(positions(edges), materials.edge(color)));
  for (const cut of ghosts) group.add(...ghost(cut, unit, color, materials));
  for (const child of group.children) child.matrixAutoUpdate = false;
  return { group, surfaces };
}

/** What is cut out: dark glass with edges that show through the body. */
function ghost(cut: Shape, unit: number, color: string, materials: Materials): (Mesh | LineSegments)[] {
  const geometry = surfaceOf(cut, [], unit);
  if (!geometry) return [];
  const lines = positions(moved(edgesOf(geometry), placement(cut)));
  const mesh = new Mesh(geometry.applyMatrix4(placement(cut)), materials.glass("#30343c", HOLE));
  mesh.renderOrder = 1;
  const outline = new LineSegments(lines, materials.hiddenEdge(color));
  outline.renderOrder = 2;
  return [mesh, outline];
}

function curve(shape: Shape, points: Float32Array, color: string, materials: Materials): LineSegments2 {
  const pairs: number[] = [];
  for (let i = 0; i + 3 < points.length; i += 3) pairs.push(...points.slice(i, i + 6));
  const line = new LineSegments2(new LineSegmentsGeometry().setPositions(moved(pairs, placement(shape))), materials.line(color, 2.6));
  return line;
}

/** The surface of a shape in its own frame; null where it has none. */
export function surfaceOf(shape: Shape, cuts: readonly Shape[], unit: number): BufferGeometry | null {
  const { form } = shape;
  switch (form.kind) {
    case "lump":
      return ball(2 * unit);
    case "bar":
    case "rectangle":
    case "circle":
    case "ring":
    case "polygon":
      return isFlat(shape) ? plateGeometry(shape, cuts, 1.6 * unit) : null;
    default:
      return solidGeometry(form);
  }
}

/** The placement of a shape in the frame of its body. */
export function placement({ position, quaternion: [w, x, y, z] }: Shape): Matrix4 {
  return new Matrix4().compose(new Vector3(...position), new Quaternion(x, y, z, w), new Vector3(1, 1, 1));
}

function edgesOf(geometry: BufferGeometry): ArrayLike<number> {
  const count = (geometry.index ?? geometry.getAttribute("position")).count / 3;
  if (count > MOST_TRIANGLES) return [];
  return atWorkingSize(geometry, (large) => new EdgesGeometry(large, EDGE_ANGLE)).getAttribute("position").array;
}

function moved(points: ArrayLike<number>, by: Matrix4): number[] {
  const out: number[] = [];
  const p = new Vector3();
  for (let i = 0; i < points.length; i += 3) {
    p.set(points[i]!, points[i + 1]!, points[i + 2]!).applyMatrix4(by);
    out.push(p.x, p.y, p.z);
  }
  return out;
}

function positions(points: readonly number[]): BufferGeometry {
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
}

/** Only what all surfaces have, so that they can become one. */
function bare(geometry: BufferGeometry): BufferGeometry {
  const plain = geometry.index ? geometry.toNonIndexed() : geometry;
  for (const name of Object.keys(plain.attributes)) if (name !== "position" && name !== "normal") plain.deleteAttribute(name);
  plain.clearGroups();
  return plain;
}
