import type { Frame } from "./motion/frame";
import type { FigureOptions } from "./planar/figure";

export type ViewOptions = Omit<FigureOptions, "highlighted">;
export type PictureKind = "svg" | "png";

/** A picture of the machine on the page: flat or in space. */
export interface View {
  /** Kinds of picture that it can save. */
  readonly pictures: readonly PictureKind[];
  /** Has it forces to show as arrows? */
  readonly hasForces: boolean;
  /** What dragging does, for the help. */
  readonly dragHelp: string;
  draw(frame: Frame, options: ViewOptions): void;
  resize(): void;
  fit(): void;
  zoom(factor: number): void;
  picture(kind: PictureKind): Promise<Blob>;
}
