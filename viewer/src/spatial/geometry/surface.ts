import { BufferAttribute, BufferGeometry } from "three";

/** Lines that are drawn on a surface along each of its parameters, at most. */
const LINES = 16;

/** A surface through a grid of points: nu rows of nv points. */
export function surfaceGeometry(nu: number, nv: number, points: Float32Array): BufferGeometry {
  const triangles: number[] = [];
  for (let i = 0; i + 1 < nu; i++) {
    for (let j = 0; j + 1 < nv; j++) {
      const [a, b, c, d] = [i * nv + j, i * nv + j + 1, (i + 1) * nv + j, (i + 1) * nv + j + 1];
      triangles.push(a, c, b, b, c, d);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points.slice(), 3));
  geometry.setIndex(triangles);
  geometry.computeVertexNormals();
  return geometry;
}

/** Lines of constant parameter on a surface, as pairs of points: without them its curvature is hard to see. */
export function surfaceLines(nu: number, nv: number, points: Float32Array): number[] {
  const out: number[] = [];
  const piece = (a: number, b: number) => out.push(...points.slice(3 * a, 3 * a + 3), ...points.slice(3 * b, 3 * b + 3));
  for (const i of chosen(nu)) for (let j = 0; j + 1 < nv; j++) piece(i * nv + j, i * nv + j + 1);
  for (const j of chosen(nv)) for (let i = 0; i + 1 < nu; i++) piece(i * nv + j, (i + 1) * nv + j);
  return out;
}

/** At most `LINES` numbers below a count, spread evenly, first and last among them. */
function chosen(count: number): readonly number[] {
  const lines = Math.min(count, LINES);
  return Array.from({ length: lines }, (_, i) => Math.round((i * (count - 1)) / (lines - 1)));
}
