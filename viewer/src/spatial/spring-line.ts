import type { Vec3 } from "../data/contract";

const TURNS = 9;
const POINTS_A_TURN = 14;

/** Points of a helix between two points, three numbers a point, with straight ends. */
export function helix(a: Vec3, b: Vec3, radius: number): number[] {
  const d: Vec3 = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  // A spring of no length is a point; its number of points stays that of any other.
  const length = Math.hypot(...d) || Number.MIN_VALUE;
  const e: Vec3 = [d[0] / length, d[1] / length, d[2] / length];
  // Any axis that is not along the spring gives two normals to it.
  const other: Vec3 = Math.abs(e[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const n = unit(cross(e, other));
  const m = cross(e, n);
  const out: number[] = [...a];
  const count = TURNS * POINTS_A_TURN;
  for (let i = 0; i <= count; i++) {
    const s = length * (0.1 + (0.8 * i) / count);
    const angle = (2 * Math.PI * i) / POINTS_A_TURN;
    for (let k = 0; k < 3; k++) out.push(a[k]! + s * e[k]! + radius * (Math.cos(angle) * n[k]! + Math.sin(angle) * m[k]!));
  }
  out.push(...b);
  return out;
}

function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(v: Vec3): Vec3 {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}
