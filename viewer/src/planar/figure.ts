import type { Animation, Attachment, Body, Point2 } from "../data/contract";
import { mix } from "../data/palette";
import type { Frame } from "../motion/frame";
import { planarPose, toBody, toGround, type PlanarPose } from "../motion/pose";
import type { BodyLook } from "./body-look";
import type { Camera } from "./camera";
import { ForceArrows } from "./force-arrows";
import { drawGrid, drawScale } from "./grid";
import type { Guide } from "./guide";
import { layOut, lookCentre, type Layout } from "./layout";
import { inside } from "./outline";
import type { Painter } from "./painter";
import { Symbols } from "./symbols";
import type { Theme } from "./theme";

export type TraceMode = "growing" | "whole" | "off";

export interface FigureOptions {
  readonly theme: Theme;
  readonly traces: TraceMode;
  readonly names: boolean;
  /** Length of the arrows of forces, times what they have by themselves; 0 for none. */
  readonly forces: number;
  readonly highlighted: Body | null;
}

/** Mean height of the direction to a body that counts as hanging. */
const HANGING = -0.6;

const GROUND_COLOR = "#999999";

/** Symbols stay readable when the picture is zoomed far out or in [pixels]. */
const SMALLEST_PIN = 2.2;
const LARGEST_PIN = 14;

/** The drawing of a planar machine, as a textbook would draw it. */
export class Figure {
  readonly layout: Layout;
  readonly forces: ForceArrows;

  constructor(private readonly animation: Animation) {
    this.layout = layOut(animation);
    this.forces = new ForceArrows(animation, this.layout.bounds.size);
  }

  draw(painter: Painter, camera: Camera, frame: Frame, options: FigureOptions): void {
    new Drawing(this.animation, this.layout, this.forces, painter, camera, frame, options).draw();
  }

  /** The uppermost body at a point of the plane; `reach` is how near [m] counts as touching a thin one. */
  bodyAt([x, y]: Point2, frame: Frame, reach: number): Body | null {
    for (const look of [...this.layout.looks].reverse()) {
      const [bx, by] = toBody(planarPose(look.body, frame), x, y);
      const near = (p: Point2) => Math.hypot(p[0] - bx, p[1] - by) <= Math.max(reach, 2 * this.layout.unit);
      const segments = look.link.map((p, i) => [p, look.link[(i + 1) % look.link.length]!] as const);
      if (
        look.parts.some((part) => inside(part.loops, bx, by)) ||
        inside([look.link], bx, by) ||
        look.lumps.some(near) ||
        look.blocks.some(({ at }) => near(at)) ||
        segments.some(([p, q]) => distanceToSegment([bx, by], p, q) <= reach)
      ) {
        return look.body;
      }
    }
    return null;
  }
}

function distanceToSegment(at: Point2, p: Point2, q: Point2): number {
  const dx = q[0] - p[0];
  const dy = q[1] - p[1];
  const square = dx * dx + dy * dy;
  const share = square > 0 ? Math.min(1, Math.max(0, ((at[0] - p[0]) * dx + (at[1] - p[1]) * dy) / square)) : 0;
  return Math.hypot(at[0] - p[0] - share * dx, at[1] - p[1] - share * dy);
}

/** One picture of the figure. */
class Drawing {
  private readonly symbols: Symbols;
  /** Radius of a pin in pixels. */
  private readonly unit: number;
  private readonly poses = new Map<Body, PlanarPose>();

  constructor(
    private readonly animation: Animation,
    private readonly layout: Layout,
    private readonly forces: ForceArrows,
    private readonly painter: Painter,
    private readonly camera: Camera,
    private readonly frame: Frame,
    private readonly options: FigureOptions,
  ) {
    this.unit = Math.min(LARGEST_PIN, Math.max(SMALLEST_PIN, layout.unit * camera.scale));
    this.symbols = new Symbols(painter, options.theme, this.unit);
  }

  draw(): void {
    const { painter, camera, layout } = this;
    const { theme } = this.options;
    drawGrid(painter, camera, theme);
    const ground = layout.groundParts.map((part) => ({ loops: this.loops(null, part.loops), fill: mix(part.color ?? GROUND_COLOR, theme.fillBase, theme.fillShare) }));
    for (const { loops } of ground) painter.path(loops, true, { stroke: theme.quiet, width: 2.4 });
    for (const { loops, fill } of ground) painter.path(loops, true, { fill });
    for (const guide of layout.guides) if (guide.host === null) this.groundGuide(guide);
    this.supports();
    this.springs();
    for (const look of layout.looks) {
      this.body(look);
      for (const guide of layout.guides) if (guide.host === look.body) this.movingGuide(guide, look.body);
    }
    this.traces();
    this.joints();
    if (this.options.forces > 0) this.forces.draw(painter, camera, this.frame, theme, this.options.forces, (side) => this.point(side), this.unit);
    if (this.options.names) for (const look of layout.looks) this.name(look);
    drawScale(painter, camera, theme);
  }

  private pose(body: Body | null): PlanarPose {
    if (body === null) return planarPose(null, this.frame);
    let pose = this.poses.get(body);
    if (!pose) {
      pose = planarPose(body, this.frame);
      this.poses.set(body, pose);
    }
    return pose;
  }

  private seen(body: Body | null): boolean {
    const { x, y, c } = this.pose(body);
    return Number.isFinite(x + y + c);
  }

  private screen(body: Body | null, [x, y]: Point2): Point2 {
    return this.camera.toScreen(toGround(this.pose(body), x, y));
  }

  private point(side: Attachment): Point2 {
    return this.screen(side.body, [side.at[0], side.at[1]]);
  }

  private loops(body: Body | null, loops: readonly (readonly Point2[])[]): Point2[][] {
    return loops.map((loop) => loop.map((p) => this.screen(body, p)));
  }

  private colors(color: string): { fill: string; edge: string } {
    const { theme } = this.options;
    return { fill: mix(color, theme.fillBase, theme.fillShare), edge: mix(color, theme.edgeBase, theme.edgeShare) };
  }

  /** Outlines first, fillings over them: parts that overlap become one form with one outline. */
  private body(look: BodyLook): void {
    const { body } = look;
    if (!this.seen(body)) return;
    const { painter } = this;
    const edgeWidth = body === this.options.highlighted ? 3 : 1.5;
    const own = this.colors(body.color);
    const parts = look.parts.map((part) => ({ loops: this.loops(body, part.loops), ...this.colors(part.color ?? body.color) }));
    const link = look.link.map((p) => this.screen(body, p));
    const closed = link.length > 2;
    const linkWidth = 2.6 * this.unit;
    const blocks = look.blocks.map((block) => this.block(body, block));
    if (link.length > 0) painter.path([link], closed, { stroke: own.edge, width: linkWidth + 2 * edgeWidth });
    for (const block of blocks) painter.path([block], true, { stroke: own.edge, width: 2 * edgeWidth });
    for (const part of parts) painter.path(part.loops, true, { stroke: part.edge, width: 2 * edgeWidth });
    if (link.length > 0) painter.path([link], closed, { stroke: own.fill, width: linkWidth, ...(closed ? { fill: own.fill } : {}) });
    for (const block of blocks) painter.path([block], true, { fill: own.fill });
    for (const part of parts) painter.path(part.loops, true, { fill: part.fill });
    painter.path(this.loops(body, look.marks), false, { stroke: own.edge, width: 1, opacity: 0.6 });
    for (const lump of look.lumps) this.symbols.lump(this.screen(body, lump), body.color);
  }

  private block(body: Body, { at, direction }: { at: Point2; direction: Point2 }): Point2[] {
    const [x, y] = this.screen(body, at);
    const [px, py] = this.screen(body, [at[0] + direction[0], at[1] + direction[1]]);
    const length = Math.hypot(px - x, py - y) || 1;
    const d: Point2 = [(px - x) / length, (py - y) / length];
    const corner = (s: number, n: number): Point2 => [x + this.unit * (3 * s * d[0] - 2 * n * d[1]), y + this.unit * (3 * s * d[1] + 2 * n * d[0])];
    return [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  }

  private onGuide(guide: Guide, s: number, n: number): Point2 {
    const { origin, direction: d } = guide;
    return this.screen(guide.host, [origin[0] + s * d[0] - n * d[1], origin[1] + s * d[1] + n * d[0]]);
  }

  private groundGuide(guide: Guide): void {
    const rail = (n: number, side: 1 | -1) => this.symbols.hatched(this.onGuide(guide, guide.from, n), this.onGuide(guide, guide.to, n), side);
    // The screen's y points down: what is left of the line in the plane is -1 on the screen.
    if (guide.form === "rails") {
      rail(guide.left, -1);
      rail(guide.right, 1);
    } else if (guide.form === "line") {
      rail(0, guide.free > 0 ? -1 : 1);
    } else {
      this.slot(guide);
    }
  }

  private movingGuide(guide: Guide, host: Body): void {
    if (!this.seen(host)) return;
    if (guide.form === "slot") {
      this.slot(guide);
      return;
    }
    const offsets = guide.form === "rails" ? [guide.left, guide.right] : [0];
    const lines = offsets.map((n) => [this.onGuide(guide, guide.from, n), this.onGuide(guide, guide.to, n)]);
    this.painter.path(lines, false, { stroke: this.colors(host.color).edge, width: 1.3 });
  }

  private slot(guide: Guide): void {
    const line = [this.onGuide(guide, guide.from, 0), this.onGuide(guide, guide.to, 0)];
    const edge = guide.host ? this.colors(guide.host.color).edge : this.options.theme.ink;
    this.painter.path([line], false, { stroke: edge, width: 3 * this.unit + 2.4 });
    this.painter.path([line], false, { stroke: this.options.theme.background, width: 3 * this.unit });
  }

  private supports(): void {
    for (const { at, form, toward } of this.layout.supports) {
      const point = this.camera.toScreen(at);
      // What hangs below its pin hangs from a ceiling.
      if (form === "pin") this.symbols.support(point, toward[1] < HANGING ? -1 : 1);
      else this.symbols.wall(point, [point[0] + toward[0], point[1] - toward[1]]);
    }
  }

  private springs(): void {
    for (const spring of this.animation.springs) {
      if (!this.seen(spring.first.body) || !this.seen(spring.second.body)) continue;
      const start = [spring.first, spring.second].map(({ body, at }) => this.camera.toScreen(toGround(planarPose(body, { index: 0, share: 0 }), at[0], at[1])));
      const turns = this.symbols.turns(Math.hypot(start[1]![0] - start[0]![0], start[1]![1] - start[0]![1]));
      this.symbols.spring(this.point(spring.first), this.point(spring.second), turns);
    }
  }

  private joints(): void {
    for (const joint of this.animation.joints) {
      if (!this.seen(joint.first.body) || !this.seen(joint.second.body)) continue;
      switch (joint.kind) {
        case "revolute":
        case "pin-slot":
          this.symbols.pin(this.point(joint.second));
          break;
        case "distance":
          this.symbols.rod(this.point(joint.first), this.point(joint.second));
          this.symbols.pin(this.point(joint.first));
          this.symbols.pin(this.point(joint.second));
          break;
        case "weld":
          this.symbols.weld(this.point(joint.second));
          break;
        default:
          break;
      }
    }
  }

  private traces(): void {
    if (this.options.traces === "off") return;
    for (const { trace, points } of this.layout.traces) {
      const color = this.colors(trace.body?.color ?? this.options.theme.ink).edge;
      const now = this.screen(trace.body, [trace.at[0], trace.at[1]]);
      const shown = this.options.traces === "whole" ? points : points.slice(0, this.frame.index + 1);
      const line = shown.map((p) => this.camera.toScreen(p)).filter(([x, y]) => Number.isFinite(x + y));
      if (this.options.traces === "growing" && this.seen(trace.body)) line.push(now);
      this.painter.path([line], false, { stroke: color, width: 1.6, opacity: 0.85 });
      if (this.seen(trace.body)) this.painter.circle(now, 3, { fill: color });
    }
  }

  private name(look: BodyLook): void {
    if (!this.seen(look.body)) return;
    const { theme } = this.options;
    this.painter.text(this.screen(look.body, lookCentre(look)), look.body.name, { color: this.colors(look.body.color).edge, size: 13, align: "center", bold: true, halo: theme.background });
  }
}
