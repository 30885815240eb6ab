import { ExtrudeGeometry, Path, Shape as Outline, Vector2, type BufferGeometry } from "three";
import type { Point2, Shape } from "../../data/contract";
import { rotate } from "../../motion/pose";
import { formLoops, inside } from "../../planar/outline";
import { add, dot, inverse, subtract } from "../vectors";

/** Is this a flat form, which becomes a thin plate in space? */
export function isFlat(shape: Shape): boolean {
  return formLoops(shape.form).length > 0;
}

/** A flat form as a plate of a thickness, with the flat cuts that lie in its plane as holes; in its own frame. */
export function plateGeometry(shape: Shape, cuts: readonly Shape[], thickness: number): BufferGeometry {
  const [outer, ...own] = formLoops(shape.form);
  const outline = new Outline((outer ?? []).map(vector));
  outline.holes = [...own, ...cuts.flatMap((cut) => holesOf(cut, shape))].map((hole) => new Path(hole.map(vector)));
  const geometry = new ExtrudeGeometry(outline, { depth: thickness, bevelEnabled: false });
  return geometry.translate(0, 0, -thickness / 2);
}

/** The holes that a flat cut makes in a plate, in the frame of the plate; none where it is not parallel to it or not within it. */
export function holesOf(cut: Shape, plate: Shape): readonly (readonly Point2[])[] {
  const [a, b] = [rotate(cut.quaternion, [0, 0, 1]), rotate(plate.quaternion, [0, 0, 1])];
  if (Math.abs(dot(a, b)) < 1 - 1e-6) return [];
  const loops = formLoops(plate.form);
  const holes = formLoops(cut.form).map((loop) => carried(loop, cut, plate));
  return holes.every((loop) => loop.every(([x, y]) => inside(loops, x, y))) ? holes : [];
}

/** A curve in the plane of one shape, in the plane of another. */
function carried(loop: readonly Point2[], from: Shape, to: Shape): readonly Point2[] {
  const back = inverse(to.quaternion);
  return loop.map(([x, y]) => {
    const point = add(from.position, rotate(from.quaternion, [x, y, 0]));
    const [u, v] = rotate(back, subtract(point, to.position));
    return [u, v] as const;
  });
}

function vector([x, y]: Point2): Vector2 {
  return new Vector2(x, y);
}
