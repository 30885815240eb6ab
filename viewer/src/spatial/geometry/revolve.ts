import { BufferGeometry, Float32BufferAttribute } from "three";
import type { Point2 } from "../../data/contract";

/** Flat sides of a full turn. */
const SIDES = 48;
/** Pieces of a profile that meet at less than this angle are one smooth curve [rad]. */
const CREASE = 0.6;

interface Piece {
  readonly from: Point2;
  readonly to: Point2;
  /** Normal in the plane of the profile, out of the material. */
  readonly normal: Point2;
}

/**
 * The surface of a profile of points [r, z] turned about z. A profile that goes counter-clockwise in the (r, z) plane
 * has its normals outwards. A closed one goes back to its first point.
 */
export function revolve(profile: readonly Point2[], closed = false): BufferGeometry {
  const pieces = piecesOf(closed ? [...profile, profile[0]!] : profile);
  const positions: number[] = [];
  const normals: number[] = [];
  const triangles: number[] = [];
  pieces.forEach((piece, i) => {
    const before = pieces[i - 1] ?? (closed ? pieces[pieces.length - 1] : undefined);
    const after = pieces[i + 1] ?? (closed ? pieces[0] : undefined);
    const first = positions.length / 3;
    for (let k = 0; k <= SIDES; k++) {
      const angle = (2 * Math.PI * (k % SIDES)) / SIDES;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (const [[r, z], other] of [[piece.from, before], [piece.to, after]] as const) {
        const [nr, nz] = blended(piece.normal, other?.normal);
        positions.push(r * c, r * s, z);
        normals.push(nr * c, nr * s, nz);
      }
    }
    for (let k = 0; k < SIDES; k++) {
      const [a, b, c, d] = [first + 2 * k, first + 2 * k + 1, first + 2 * k + 2, first + 2 * k + 3];
      // On the axis a side of the band has no length.
      if (piece.from[0] > 0) triangles.push(a, c, b);
      if (piece.to[0] > 0) triangles.push(b, c, d);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new Float32BufferAttribute(normals, 3));
  geometry.setIndex(triangles);
  return geometry;
}

function piecesOf(points: readonly Point2[]): readonly Piece[] {
  const out: Piece[] = [];
  for (let i = 1; i < points.length; i++) {
    const [from, to] = [points[i - 1]!, points[i]!];
    const [dr, dz] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(dr, dz);
    if (length > 0) out.push({ from, to, normal: [dz / length, -dr / length] });
  }
  return out;
}

function blended(own: Point2, other: Point2 | undefined): Point2 {
  if (!other || own[0] * other[0] + own[1] * other[1] < Math.cos(CREASE)) return own;
  const sum: Point2 = [own[0] + other[0], own[1] + other[1]];
  const length = Math.hypot(...sum);
  return [sum[0] / length, sum[1] / length];
}

/** Points [r, z] on an arc about (r, z) from one angle to another, counted from the direction of r. */
export function arcProfile(centre: Point2, radius: number, from: number, to: number, count: number): Point2[] {
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = from + ((to - from) * i) / count;
    // Rounding must not put a pole beside the axis.
    const r = centre[0] + radius * Math.cos(angle);
    return [Math.abs(r) < 1e-9 * radius ? 0 : r, centre[1] + radius * Math.sin(angle)] as const;
  });
}
