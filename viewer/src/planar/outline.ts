import type { Point2, Shape, ShapeForm } from "../data/contract";
import { rotate } from "../motion/pose";

/** Closed curves; a point is inside where an odd number of them surround it. */
export type Loops = readonly (readonly Point2[])[];

/** Corners of a full circle: at 500 pixels of radius the chord is a quarter of a pixel off. */
const CIRCLE_CORNERS = 96;

/** The outline of a form in its own frame. Lumps and solids have none. */
export function formLoops(form: ShapeForm): Loops {
  switch (form.kind) {
    case "bar": {
      const half = form.length / 2;
      const radius = form.width / 2;
      return [[...arc(half, 0, radius, -Math.PI / 2, Math.PI / 2), ...arc(-half, 0, radius, Math.PI / 2, 1.5 * Math.PI)]];
    }
    case "rectangle": {
      const x = form.width / 2;
      const y = form.height / 2;
      return [[[-x, -y], [x, -y], [x, y], [-x, y]]];
    }
    case "circle":
      return [circle(0, 0, form.radius)];
    case "ring":
      return [circle(0, 0, form.outer), circle(0, 0, form.inner)];
    case "polygon":
      return [form.points];
    default:
      // A lump is a symbol, and solids are no plane's business.
      return [];
  }
}

/** The outline of a shape in the frame of its body, seen along z. */
export function shapeLoops(shape: Shape): Loops {
  return formLoops(shape.form).map((loop) =>
    loop.map(([x, y]) => {
      const r = rotate(shape.quaternion, [x, y, 0]);
      return [shape.position[0] + r[0], shape.position[1] + r[1]] as const;
    }),
  );
}

/** The parts of a body that are filled, each with the cuts that lie in it as holes. */
export interface Part {
  readonly loops: Loops;
  readonly color: string | null;
}

export function bodyParts(shapes: readonly Shape[]): readonly Part[] {
  const cuts = shapes.filter((shape) => shape.cut).flatMap(shapeLoops);
  return shapes
    .filter((shape) => !shape.cut && formLoops(shape.form).length > 0)
    .map((shape) => {
      const loops = shapeLoops(shape);
      const holes = cuts.filter((cut) => inside(loops, ...centre(cut)));
      return { loops: [...loops, ...holes], color: shape.color };
    });
}

/** Even-odd test of a point against closed curves. */
export function inside(loops: Loops, x: number, y: number): boolean {
  let odd = false;
  for (const loop of loops) {
    for (let i = 0, j = loop.length - 1; i < loop.length; j = i++) {
      const [xi, yi] = loop[i]!;
      const [xj, yj] = loop[j]!;
      if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) odd = !odd;
    }
  }
  return odd;
}

/** Corners on an arc from angle a to angle b about (x, y). */
export function arc(x: number, y: number, radius: number, a: number, b: number): Point2[] {
  const count = Math.max(2, Math.ceil((Math.abs(b - a) / (2 * Math.PI)) * CIRCLE_CORNERS));
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = a + ((b - a) * i) / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
}

export function circle(x: number, y: number, radius: number): Point2[] {
  return arc(x, y, radius, 0, 2 * Math.PI).slice(0, -1);
}

function centre(loop: readonly Point2[]): Point2 {
  const sum = loop.reduce((total, p) => [total[0]! + p[0], total[1]! + p[1]], [0, 0]);
  return [sum[0]! / loop.length, sum[1]! / loop.length];
}
