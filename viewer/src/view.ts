import type { Frame } from "./motion/frame";
import type { FigureOptions } from "./planar/figure";

export interface ViewOptions extends Omit<FigureOptions, "highlighted"> {
  /** Frames of bodies, in space. */
  readonly frames: boolean;
  /** Axes of joints, in space. */
  readonly axes: boolean;
}

export type PictureKind = "svg" | "png";

/** Where a machine in space is looked at from. */
export type Viewpoint = "iso" | "x" | "y" | "z";

export const VIEWPOINTS: readonly Viewpoint[] = ["iso", "x", "y", "z"];

/** What only a picture in space can do. */
export interface SpatialTools {
  /** Shows the whole motion from a direction. */
  look(from: Viewpoint): void;
  /** Turns the picture by steps, or moves it. */
  steer(right: number, up: number, moving: boolean): void;
}

/** A picture of the machine on the page: flat or in space. */
export interface View {
  /** Kinds of picture that it can save. */
  readonly pictures: readonly PictureKind[];
  /** Has it forces to show as arrows? */
  readonly hasForces: boolean;
  /** What dragging does, for the help. */
  readonly dragHelp: string;
  /** Null for a flat picture. */
  readonly tools: SpatialTools | null;
  draw(frame: Frame, options: ViewOptions): void;
  resize(): void;
  fit(): void;
  zoom(factor: number): void;
  picture(kind: PictureKind): Promise<Blob>;
}
