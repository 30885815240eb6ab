import type { BufferGeometry } from "three";

/** A size at which the fixed tolerances of the library are small. */
const SIZE = 300;

/** Does something to a geometry while it is large: the library compares points by fixed distances. */
export function atWorkingSize(geometry: BufferGeometry, work: (large: BufferGeometry) => BufferGeometry): BufferGeometry {
  geometry.computeBoundingSphere();
  const radius = geometry.boundingSphere?.radius ?? 0;
  const factor = radius > 0 ? SIZE / radius : 1;
  const copy = geometry.clone().scale(factor, factor, factor);
  return work(copy).scale(1 / factor, 1 / factor, 1 / factor);
}
