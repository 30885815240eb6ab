import { ConeGeometry, CylinderGeometry, Group, Mesh, type Material } from "three";
import type { Animation, Vec3 } from "../data/contract";
import { mix } from "../data/palette";
import type { Frame } from "../motion/frame";
import { bodyPose, place } from "../motion/pose";
import { sampleFrames } from "../motion/samples";
import type { Theme } from "../planar/theme";
import { turnTo } from "./joint-symbols";
import type { Materials } from "./materials";
import { isFinite3, norm, scaled } from "./vectors";
import { findWrenches, typicalSize, type Wrench } from "./wrench";

/** Length of a typical arrow, as a part of the size of the machine. */
const TYPICAL_LENGTH = 0.16;
/** Arrows below this part of the typical one are rounding, or belong to joints that cannot hold them. */
const SMALLEST = 1e-3;
/** Length of a head, in units. */
const HEAD = 2.6;
const SAMPLES = 400;

/** Colours of forces are those of the plane; moments are turned towards violet. */
const PAINTS = {
  reaction: { force: (theme: Theme) => theme.reaction, moment: (theme: Theme) => mix(theme.reaction, "#7a3fd0", 0.6) },
  load: { force: (theme: Theme) => theme.load, moment: (theme: Theme) => mix(theme.load, "#2f6fe0", 0.6) },
} as const;

interface Arrow {
  readonly wrench: Wrench;
  readonly part: "force" | "moment";
  readonly group: Group;
  readonly shaft: Group;
  readonly heads: readonly Group[];
}

/** Forces as arrows and moments as arrows with two heads, each in one scale. */
export class ForceVectors {
  readonly group = new Group();
  /** Newtons, and newton metres, of an arrow one metre long. */
  readonly perMetre: Readonly<Record<"force" | "moment", number>>;
  private readonly arrows: readonly Arrow[];

  constructor(
    animation: Animation,
    size: number,
    private readonly unit: number,
    materials: Materials,
  ) {
    const wrenches = findWrenches(animation);
    const frames = sampleFrames(animation.time.length, SAMPLES);
    const scale = (part: "force" | "moment") => typicalSize(wrenches, part, frames) / (TYPICAL_LENGTH * size);
    this.perMetre = { force: scale("force"), moment: scale("moment") };
    const shaft = new CylinderGeometry(0.42 * unit, 0.42 * unit, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const head = new ConeGeometry(1.15 * unit, HEAD * unit, 16).rotateX(Math.PI / 2).translate(0, 0, (-HEAD * unit) / 2);
    const pair = (geometry: typeof shaft | typeof head, [plain, ghost]: readonly [Material, Material]) => {
      const pale = new Mesh(geometry, ghost);
      pale.renderOrder = 3;
      return new Group().add(new Mesh(geometry, plain), pale);
    };
    this.arrows = wrenches.flatMap((wrench) =>
      (["force", "moment"] as const).filter((part) => wrench[part] !== null && this.perMetre[part] > 0).map((part) => {
        const material = materials.arrow(PAINTS[wrench.kind][part]);
        const line = pair(shaft, material);
        const heads = Array.from({ length: part === "moment" ? 2 : 1 }, () => pair(head, material));
        const group = new Group().add(line, ...heads);
        this.group.add(group);
        return { wrench, part, group, shaft: line, heads };
      }),
    );
  }

  get empty(): boolean {
    return this.arrows.length === 0;
  }

  /** Moves the arrows to a frame, `factor` times as long as they are by themselves; 0 hides them. */
  show(frame: Frame, factor: number): void {
    this.group.visible = factor > 0;
    if (!this.group.visible) return;
    for (const arrow of this.arrows) {
      const { wrench, part, group } = arrow;
      const at = place(bodyPose(wrench.at.body, frame), wrench.at.at);
      const vector = wrench[part]!(frame);
      const size = norm(vector);
      const length = (factor * size) / this.perMetre[part];
      group.visible = isFinite3(at) && Number.isFinite(size) && size > SMALLEST * TYPICAL_LENGTH * this.perMetre[part];
      if (group.visible) this.place(arrow, at, scaled(vector, 1 / size), length);
    }
  }

  private place({ group, shaft, heads }: Arrow, at: Vec3, direction: Vec3, length: number): void {
    group.position.set(...at);
    group.quaternion.copy(turnTo(direction));
    // A short arrow has a small head: it must not point beyond its length.
    const share = Math.min(1, length / (1.6 * HEAD * this.unit * heads.length));
    const head = share * HEAD * this.unit;
    shaft.scale.set(share, share, Math.max(1e-9, length - 0.9 * head));
    heads.forEach((one, i) => {
      one.scale.setScalar(share);
      one.position.z = length - 0.75 * i * head;
    });
  }
}
