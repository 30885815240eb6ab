import type { Point2 } from "../data/contract";

/** How a line or area looks; colours are CSS colours, lengths are pixels. */
export interface Ink {
  readonly fill?: string;
  readonly stroke?: string;
  readonly width?: number;
  readonly dash?: readonly number[];
  readonly opacity?: number;
}

export interface TextInk {
  readonly color: string;
  readonly size: number;
  readonly align?: "left" | "center" | "right";
  readonly bold?: boolean;
  /** Colour of a halo that keeps the text readable over lines. */
  readonly halo?: string;
}

/** What the figure needs to draw itself, in pixels. One painter draws on the screen, one writes SVG. */
export interface Painter {
  /** Areas with holes by the even-odd rule, or open lines. */
  path(lines: readonly (readonly Point2[])[], closed: boolean, ink: Ink): void;
  circle(centre: Point2, radius: number, ink: Ink): void;
  text(at: Point2, text: string, ink: TextInk): void;
}
