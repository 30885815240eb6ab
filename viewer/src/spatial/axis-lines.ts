import { Group } from "three";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Attachment } from "../data/contract";
import type { Theme } from "../planar/theme";
import type { Materials } from "./materials";
import { add, scaled } from "./vectors";

/** Colours of the axes x, y, z. */
export const AXIS_COLORS = ["#d6453d", "#2e9e52", "#3579dc"] as const;

const BODY_AXIS = 9;
const JOINT_AXIS = 8;
const JOINT_X = 4;

/** Builds frames of bodies and axes of joints as lines that nothing hides. */
export class AxisLines {
  private readonly frame: readonly LineSegmentsGeometry[];

  constructor(
    private readonly unit: number,
    private readonly materials: Materials,
  ) {
    this.frame = [0, 1, 2].map((k) => new LineSegmentsGeometry().setPositions([0, 0, 0, ...[0, 1, 2].map((i) => (i === k ? BODY_AXIS * unit : 0))]));
  }

  /** The axes x, y, z of a frame at its origin. */
  bodyFrame(): Group {
    const group = new Group();
    this.frame.forEach((geometry, k) => group.add(this.line(geometry, this.materials.overlay(AXIS_COLORS[k]!, 2.4))));
    return group;
  }

  /** The axis of a joint on one of its bodies, and its x axis where it has one; null without an axis. */
  jointAxis(end: Attachment): Group | null {
    if (end.direction === null) return null;
    const { unit } = this;
    const group = new Group();
    const reach = (length: number) => add(end.at, scaled(end.direction!, length * unit));
    const axis = new LineSegmentsGeometry().setPositions([...reach(-JOINT_AXIS), ...reach(JOINT_AXIS)]);
    const line = this.line(axis, this.materials.overlay((theme: Theme) => theme.ink, 1.6, 1.6 * unit));
    line.computeLineDistances();
    group.add(line);
    if (end.reference) {
      const across = new LineSegmentsGeometry().setPositions([...end.at, ...add(end.at, scaled(end.reference, JOINT_X * unit))]);
      group.add(this.line(across, this.materials.overlay(AXIS_COLORS[0], 1.6)));
    }
    return group;
  }

  private line(geometry: LineSegmentsGeometry, material: ConstructorParameters<typeof LineSegments2>[1]): LineSegments2 {
    const line = new LineSegments2(geometry, material);
    line.renderOrder = 4;
    return line;
  }
}
