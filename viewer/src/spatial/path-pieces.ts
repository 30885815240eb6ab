import type { Vec3 } from "../data/contract";
import { isFinite3 } from "./vectors";

/** A path as straight pieces between neighbouring instants. */
export interface PathPieces {
  /** Six numbers a piece: where it begins and ends. */
  readonly positions: Float32Array;
  /** Number of the pieces that lie before each instant. */
  readonly upTo: readonly number[];
}

/** Cuts a path into its pieces; an instant without a place leaves a gap. */
export function pathPieces(points: readonly Vec3[]): PathPieces {
  const positions: number[] = [];
  const upTo = points.map((point, i) => {
    const before = points[i - 1];
    if (before && isFinite3(before) && isFinite3(point)) positions.push(...before, ...point);
    return positions.length / 6;
  });
  return { positions: Float32Array.from(positions), upTo };
}
