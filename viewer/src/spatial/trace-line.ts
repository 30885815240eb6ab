import { Group, Mesh, type InterleavedBufferAttribute } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Trace, Vec3 } from "../data/contract";
import { mix } from "../data/palette";
import type { Frame } from "../motion/frame";
import { bodyPose, place } from "../motion/pose";
import { LIGHT, type Theme } from "../planar/theme";
import type { TraceMode } from "../planar/figure";
import { ball } from "./geometry/solid";
import type { Materials } from "./materials";
import { pathPieces, type PathPieces } from "./path-pieces";
import { isFinite3 } from "./vectors";

const WIDTH = 2;

/** The path of a point, growing with time or whole, and a dot where the point is. */
export class TraceLine {
  readonly group = new Group();
  private readonly line: LineSegments2;
  private readonly tip: LineSegments2;
  private readonly dot: Mesh;
  private readonly pieces: PathPieces;

  constructor(
    private readonly trace: Trace,
    private readonly points: readonly Vec3[],
    unit: number,
    materials: Materials,
  ) {
    const color = trace.body?.color ?? "#777777";
    const paint = (theme: Theme) => mix(color, theme === LIGHT ? "#000000" : "#ffffff", 0.22);
    const material = materials.line(paint, WIDTH);
    this.pieces = pathPieces(points);
    this.line = new LineSegments2(new LineSegmentsGeometry().setPositions(this.pieces.positions), material);
    this.tip = new LineSegments2(new LineSegmentsGeometry().setPositions(new Float32Array(6)), material);
    this.dot = new Mesh(ball(0.75 * unit), materials.solid(color));
    // The tip moves; its box is not kept.
    this.tip.frustumCulled = false;
    this.group.add(this.line, this.tip, this.dot);
  }

  show(frame: Frame, mode: TraceMode): void {
    this.group.visible = mode !== "off";
    if (!this.group.visible) return;
    const now = place(bodyPose(this.trace.body, frame), this.trace.at);
    this.dot.visible = isFinite3(now);
    this.dot.position.set(...now);
    const whole = mode === "whole";
    const count = whole ? this.pieces.positions.length / 6 : this.pieces.upTo[frame.index]!;
    this.line.geometry.instanceCount = count;
    this.line.visible = count > 0;
    const last = this.points[frame.index]!;
    this.tip.visible = !whole && frame.share > 0 && isFinite3(last) && isFinite3(now);
    if (this.tip.visible) this.moveTip(last, now);
  }

  /** In place: a new buffer at every frame would fill the memory of the graphics card. */
  private moveTip(from: Vec3, to: Vec3): void {
    const { data } = this.tip.geometry.getAttribute("instanceStart") as InterleavedBufferAttribute;
    data.array.set([...from, ...to]);
    data.needsUpdate = true;
  }
}
