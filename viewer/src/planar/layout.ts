import type { Animation, Body, Point2, Trace } from "../data/contract";
import { planarPose, toGround } from "../motion/pose";
import { sampleFrames } from "../motion/samples";
import { bodyLook, type BodyLook } from "./body-look";
import { Bounds } from "./bounds";
import { guides, rollers, type Guide } from "./guide";
import { bodyParts, type Part } from "./outline";
import { supports, type Support } from "./support";

/** Everything about the figure that does not change with time. */
export interface Layout {
  readonly looks: readonly BodyLook[];
  readonly groundParts: readonly Part[];
  readonly guides: readonly Guide[];
  readonly supports: readonly Support[];
  readonly traces: readonly { readonly trace: Trace; readonly points: readonly Point2[] }[];
  /** Radius of a pin [m]; every symbol is a multiple of it. */
  readonly unit: number;
  /** Where anything drawn ever is. */
  readonly bounds: Bounds;
}

/** Frames that are looked at to find where the machine goes. */
const SAMPLES = 300;

export function layOut(animation: Animation): Layout {
  const frames = sampleFrames(animation.time.length, SAMPLES);
  const round = rollers(animation);
  const looks = inDrawingOrder(animation).map((body) => bodyLook(animation, body, round));
  const groundParts = [...bodyParts(animation.groundShapes), ...groundCurves(animation)];

  const bounds = new Bounds();
  for (const part of groundParts) part.loops.forEach((loop) => bounds.addAll(loop));
  for (const element of [...animation.joints, ...animation.springs]) {
    for (const side of [element.first, element.second]) {
      if (side.body === null && element.kind !== "gear") bounds.add(side.at[0], side.at[1]);
    }
  }
  for (const look of looks) {
    const points = corners(look);
    for (const frame of frames) {
      const pose = planarPose(look.body, frame);
      for (const [x, y] of points) bounds.add(...toGround(pose, x, y));
    }
  }
  const all = sampleFrames(animation.time.length, Infinity);
  const traces = animation.traces.map((trace) => ({
    trace,
    points: all.map((frame) => toGround(planarPose(trace.body, frame), trace.at[0], trace.at[1])),
  }));
  for (const { points } of traces) bounds.addAll(points);

  const unit = pinRadius(animation, bounds.size);
  const parts = new Map<Body, readonly Part[]>(looks.map((look) => [look.body, look.parts]));
  const lines = guides(animation, parts, frames, unit);
  for (const guide of lines) {
    if (guide.host !== null) continue;
    for (const s of [guide.from, guide.to]) {
      for (const n of [guide.right, guide.left]) {
        bounds.add(guide.origin[0] + s * guide.direction[0] - n * guide.direction[1], guide.origin[1] + s * guide.direction[1] + n * guide.direction[0]);
      }
    }
  }
  const centres = new Map<Body, Point2>(looks.map((look) => [look.body, lookCentre(look)]));
  return { looks, groundParts, guides: lines, supports: supports(animation, centres, frames), traces, unit, bounds };
}

/** Sliders on the ground lie behind the links that move them, slotted bodies behind the pins in their slots. */
function inDrawingOrder(animation: Animation): readonly Body[] {
  const behind = (body: Body) =>
    animation.joints.some((j) => (j.kind === "prismatic" && j.first.body === null && j.second.body === body) || (j.kind === "pin-slot" && j.first.body === body));
  // A ring gear must not hide what rolls in it.
  const width = new Map(animation.bodies.map((body) => [body, curveWidth(animation, body)]));
  const byWidth = [...animation.bodies].sort((a, b) => width.get(b)! - width.get(a)!);
  return [...byWidth.filter(behind), ...byWidth.filter((body) => !behind(body))];
}

/** Curves of joints that stand still. */
function groundCurves(animation: Animation): readonly Part[] {
  const sides = animation.joints.flatMap(({ first, second }) => [first, second]);
  return sides.flatMap(({ body, outline }) => (body === null && outline ? [{ loops: [outline], color: null }] : []));
}

/** Width of the largest curve that is the form of a body; 0 where it has another form. */
function curveWidth(animation: Animation, body: Body): number {
  if (body.shapes.length > 0) return 0;
  const sides = animation.joints.flatMap(({ first, second }) => [first, second]).filter((side) => side.body === body);
  return Math.max(0, ...sides.map(({ outline }) => (outline ? new Bounds().addAll(outline).width : 0)));
}

/** Middle of what is drawn of a body, in its own frame. */
export function lookCentre(look: BodyLook): Point2 {
  const box = new Bounds().addAll(corners(look));
  return box.empty ? [0, 0] : [(box.xMin + box.xMax) / 2, (box.yMin + box.yMax) / 2];
}

function corners(look: BodyLook): readonly Point2[] {
  return [...look.parts.flatMap((part) => part.loops.flat()), ...look.lumps, ...look.link, ...look.blocks.map((b) => b.at)];
}

/** Pins must show, and must fit into the links that they join. */
function pinRadius(animation: Animation, size: number): number {
  const widths = animation.bodies
    .flatMap((body) => body.shapes)
    .flatMap(({ form }) => (form.kind === "bar" ? [form.width] : form.kind === "rectangle" ? [Math.min(form.width, form.height)] : []))
    .filter((width) => width > 0)
    .sort((a, b) => a - b);
  const whole = size > 0 ? size : 1;
  const narrow = widths[Math.floor(widths.length / 4)] ?? Infinity;
  return Math.min(0.0085 * whole, Math.max(0.3 * narrow, 0.003 * whole));
}
