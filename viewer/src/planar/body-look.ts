import type { Animation, Body, Point2, Vec3 } from "../data/contract";
import { bodyParts, circle, type Part } from "./outline";

/** How a body is drawn, in its own frame. */
export interface BodyLook {
  readonly body: Body;
  readonly parts: readonly Part[];
  /** Centres of the lumps. */
  readonly lumps: readonly Point2[];
  /** Points joined by a link where the body has no shape; sorted around their centre if more than two. */
  readonly link: readonly Point2[];
  /** Lines on round things, without which nobody sees them turn. */
  readonly marks: readonly (readonly [Point2, Point2])[];
  /** Sliders of a body without shapes: centre and direction of a block. */
  readonly blocks: readonly { readonly at: Point2; readonly direction: Point2 }[];
}

/** Joints whose points say nothing of the form of a body. */
const FORMLESS_KINDS = new Set(["gear"]);

export function bodyLook(animation: Animation, body: Body, rollers: ReadonlyMap<Body, { at: Vec3; radius: number }>): BodyLook {
  const attachments = [...animation.joints, ...animation.springs].flatMap((element) =>
    [element.first, element.second].filter((side) => side.body === body).map((side) => ({ element, side })),
  );
  const curves = attachments.flatMap(({ side }) => (side.outline ? [{ centre: [side.at[0], side.at[1]] as const, outline: side.outline }] : []));
  const parts = bodyParts(body.shapes);
  const lumps = body.shapes.filter((s) => s.form.kind === "lump").map((s) => [s.position[0], s.position[1]] as const);
  if (body.shapes.length > 0) {
    const marks = body.shapes.flatMap(({ form, cut, position: [x, y] }) => (form.kind === "circle" && !cut ? [spoke(x, y, form.radius)] : []));
    return { body, parts, lumps, link: [], marks, blocks: [] };
  }

  const roller = rollers.get(body);
  if (curves.length > 0 || roller) {
    const wheels = roller && curves.length === 0 ? [{ x: roller.at[0], y: roller.at[1], radius: roller.radius }] : [];
    const loops = [...curves.map(({ outline }) => outline), ...wheels.map(({ x, y, radius }) => circle(x, y, radius))];
    const marks = [...curves.map(({ centre, outline }) => [centre, outline[0]!] as const), ...wheels.map(({ x, y, radius }) => spoke(x, y, radius))];
    return { body, parts: loops.map((loop) => ({ loops: [loop], color: null })), lumps, link: [], marks, blocks: [] };
  }
  const blocks = attachments
    .filter(({ element, side }) => element.kind === "prismatic" && side === element.second && side.direction !== null)
    .map(({ side }) => ({ at: [side.at[0], side.at[1]] as const, direction: [side.direction![0], side.direction![1]] as const }));
  const traced = animation.traces.filter((trace) => trace.body === body).map((trace) => trace.at);
  const points = distinct([...attachments.filter(({ element }) => !FORMLESS_KINDS.has(element.kind)).map(({ side }) => side.at), ...traced]);
  // One point alone is no link: the origin of the body is the other end.
  const ends = points.length === 1 && blocks.length === 0 ? distinct([[...points[0]!, 0], [0, 0, 0]]) : points;
  const link = ends.length > 2 ? around(ends) : ends;
  // Nothing to draw at all: a dot at the origin.
  return { body, parts, lumps: link.length < 2 && blocks.length === 0 ? [link[0] ?? [0, 0]] : lumps, link: link.length < 2 ? [] : link, marks: [], blocks };
}

function spoke(x: number, y: number, radius: number): readonly [Point2, Point2] {
  return [[x, y], [x + radius, y]];
}

function distinct(points: readonly Vec3[]): Point2[] {
  const size = Math.max(...points.map(([x, y]) => Math.hypot(x, y)), 0);
  const out: Point2[] = [];
  for (const [x, y] of points) {
    if (!out.some((p) => Math.hypot(p[0] - x, p[1] - y) <= 1e-6 * size)) out.push([x, y]);
  }
  return out;
}

function around(points: readonly Point2[]): Point2[] {
  const x = points.reduce((sum, p) => sum + p[0], 0) / points.length;
  const y = points.reduce((sum, p) => sum + p[1], 0) / points.length;
  return [...points].sort((a, b) => Math.atan2(a[1] - y, a[0] - x) - Math.atan2(b[1] - y, b[0] - x));
}
