/** The animation as the page uses it: checked, with names resolved and numbers in typed arrays. */

export type Vec3 = readonly [number, number, number];
export type Quaternion = readonly [number, number, number, number];
export type Point2 = readonly [number, number];

/** Where a body is at every frame: 3 numbers of position and 4 of orientation (w, x, y, z) a frame. */
export interface Track {
  readonly position: Float64Array;
  readonly quaternion: Float64Array;
}

export type ShapeForm =
  | { readonly kind: "bar"; readonly length: number; readonly width: number }
  | { readonly kind: "rectangle"; readonly width: number; readonly height: number }
  | { readonly kind: "circle"; readonly radius: number }
  | { readonly kind: "ring"; readonly outer: number; readonly inner: number }
  | { readonly kind: "polygon"; readonly points: readonly Point2[] }
  | { readonly kind: "lump" };

export interface Shape {
  readonly form: ShapeForm;
  readonly position: Vec3;
  readonly quaternion: Quaternion;
  readonly color: string | null;
  readonly cut: boolean;
}

export interface Body {
  readonly name: string;
  readonly color: string;
  readonly track: Track;
  readonly shapes: readonly Shape[];
}

/** A point of a body, or of the ground where `body` is null. */
export interface Attachment {
  readonly body: Body | null;
  readonly at: Vec3;
  readonly direction: Vec3 | null;
  /** Closed curve fixed to the body, in the body's frame: a cam's profile, a gear's pitch circle. */
  readonly outline: readonly Point2[] | null;
}

export interface Joint {
  readonly name: string;
  readonly kind: string;
  readonly first: Attachment;
  readonly second: Attachment;
}

export type Spring = Joint;

/** An element that pushes a body at a point. */
export interface Load {
  readonly name: string;
  readonly at: Attachment;
}

export interface Trace {
  readonly name: string;
  readonly body: Body | null;
  readonly at: Vec3;
}

export interface Channel {
  readonly name: string;
  readonly unit: string;
  readonly meaning: string;
  /** NaN where the run has no value. */
  readonly values: Float64Array;
}

export interface Animation {
  readonly title: string;
  readonly space: "planar" | "spatial";
  readonly analysis: string;
  readonly time: Float64Array;
  readonly bodies: readonly Body[];
  readonly groundShapes: readonly Shape[];
  readonly joints: readonly Joint[];
  readonly springs: readonly Spring[];
  readonly loads: readonly Load[];
  readonly traces: readonly Trace[];
  readonly channels: readonly Channel[];
  readonly notes: readonly string[];
  readonly summary: readonly (readonly [string, string])[];
  /** What the page itself could not show. */
  readonly skipped: readonly string[];
}

/** The data of a page cannot be shown; `problems` says why, one sentence each. */
export class ContractError extends Error {
  constructor(readonly problems: readonly string[]) {
    super(problems.join("\n"));
    this.name = "ContractError";
  }
}
