import { BufferAttribute, BufferGeometry } from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { atWorkingSize } from "./working-size";

/** Faces that meet at less than this angle look like one curved surface [rad]. */
const CREASE = 0.6;

/** Triangles as a surface, smooth where the faces nearly agree and sharp elsewhere. */
export function meshGeometry(vertices: Float32Array, triangles: Uint32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(vertices.slice(), 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return atWorkingSize(geometry, (large) => toCreasedNormals(large, CREASE));
}
