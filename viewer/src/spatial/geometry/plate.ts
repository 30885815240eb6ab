import { ExtrudeGeometry, Path, Shape as Outline, Vector2, type BufferGeometry } from "three";
import type { Point2, Shape } from "../../data/contract";
import { rotate } from "../../motion/pose";
import { formLoops, inside } from "../../planar/outline";
import { inverse } from "../vectors";

/** Is this a flat form, which becomes a thin plate in space? */
export function isFlat(shape: Shape): boolean {
  return formLoops(shape.form).length > 0;
}

/** A flat form as a plate of a thickness, with the flat cuts that lie in its plane as holes; in its own frame. */
export function plateGeometry(shape: Shape, cuts: readonly Shape[], thickness: number): BufferGeometry {
  const loops = formLoops(shape.form);
  const [outer, ...holes] = loops;
  const inner = cuts.filter((cut) => lies(cut, shape)).flatMap((cut) => formLoops(cut.form).map((loop) => carried(loop, cut, shape)));
  const within = inner.filter((loop) => loop.every(([x, y]) => inside(loops, x, y)));
  const outline = new Outline((outer ?? []).map(vector));
  outline.holes = [...holes, ...within].map((hole) => new Path(hole.map(vector)));
  const geometry = new ExtrudeGeometry(outline, { depth: thickness, bevelEnabled: false });
  return geometry.translate(0, 0, -thickness / 2);
}

/** Does a cut go straight through a plate, as a hole? */
export function lies(cut: Shape, plate: Shape): boolean {
  if (!isFlat(cut)) return false;
  const [a, b] = [rotate(cut.quaternion, [0, 0, 1]), rotate(plate.quaternion, [0, 0, 1])];
  return Math.abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) > 1 - 1e-6;
}

/** A curve in the plane of one shape, in the plane of another. */
function carried(loop: readonly Point2[], from: Shape, to: Shape): readonly Point2[] {
  const back = inverse(to.quaternion);
  return loop.map(([x, y]) => {
    const r = rotate(from.quaternion, [x, y, 0]);
    const offset = [0, 1, 2].map((k) => from.position[k]! + r[k]! - to.position[k]!);
    const [u, v] = rotate(back, [offset[0]!, offset[1]!, offset[2]!]);
    return [u, v] as const;
  });
}

function vector([x, y]: Point2): Vector2 {
  return new Vector2(x, y);
}
