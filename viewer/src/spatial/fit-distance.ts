import { Vector3, type Box3 } from "three";

/** Distance from the middle of a box at which all of it is seen from a direction; `angle` is the height of the picture [deg]. */
export function fitDistance(box: Box3, direction: Vector3, angle: number, aspect: number): number {
  const half = box.getSize(new Vector3()).multiplyScalar(0.5);
  const radius = half.length();
  if (!(radius > 0)) return 1;
  const z = direction.clone().normalize();
  // Looking along z, any two directions across do.
  const across = Math.abs(z.z) > 0.999 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
  const x = across.cross(z).normalize();
  const y = z.clone().cross(x);
  const tanY = Math.tan((angle * Math.PI) / 360);
  const tanX = tanY * aspect;
  let distance = 0;
  for (const sx of [-1, 1]) for (const sy of [-1, 1]) for (const sz of [-1, 1]) {
    const corner = new Vector3(sx * half.x, sy * half.y, sz * half.z);
    distance = Math.max(distance, Math.abs(corner.dot(x)) / tanX + corner.dot(z), Math.abs(corner.dot(y)) / tanY + corner.dot(z));
  }
  // A flat box seen from its edge has room enough.
  return Math.max(distance, 1.2 * radius);
}
