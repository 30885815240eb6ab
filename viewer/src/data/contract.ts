/** The animation as the page uses it: checked, with names resolved and numbers in typed arrays. */

export type Vec3 = readonly [number, number, number];
export type Quaternion = readonly [number, number, number, number];
export type Point2 = readonly [number, number];

/** Where a body is at every frame: 3 numbers of position and 4 of orientation (w, x, y, z) a frame. */
export interface Track {
  readonly position: Float64Array;
  readonly quaternion: Float64Array;
}

/** Forms of planar machines. */
export type FlatForm =
  | { readonly kind: "bar"; readonly length: number; readonly width: number }
  | { readonly kind: "rectangle"; readonly width: number; readonly height: number }
  | { readonly kind: "circle"; readonly radius: number }
  | { readonly kind: "ring"; readonly outer: number; readonly inner: number }
  | { readonly kind: "polygon"; readonly points: readonly Point2[] }
  | { readonly kind: "lump" };

/** Forms of spatial machines; the frame sits at the centre unless said otherwise. */
export type SolidForm =
  | { readonly kind: "box"; readonly size: Vec3 }
  /** About z. */
  | { readonly kind: "cylinder"; readonly radius: number; readonly length: number }
  /** About z. */
  | { readonly kind: "tube"; readonly outer: number; readonly inner: number; readonly length: number }
  | { readonly kind: "sphere"; readonly radius: number }
  /** Frame at the flat face, z to the round side. */
  | { readonly kind: "hemisphere"; readonly radius: number }
  /** Frame at the centre of the base, z to the apex. */
  | { readonly kind: "cone"; readonly radius: number; readonly height: number }
  /** Along x. */
  | { readonly kind: "rod"; readonly length: number; readonly radius: number }
  /** Across z. */
  | { readonly kind: "disk"; readonly radius: number; readonly thickness: number }
  /** Across z; width along x, height along y. */
  | { readonly kind: "plate"; readonly width: number; readonly height: number; readonly thickness: number }
  | { readonly kind: "ellipsoid"; readonly semiAxes: Vec3 }
  /** About z; `radius` to the middle of the tube, `tube` its own radius. */
  | { readonly kind: "torus"; readonly radius: number; readonly tube: number }
  /** Corners in threes of numbers, triangles in threes of corners, counter-clockwise from outside. */
  | { readonly kind: "mesh"; readonly vertices: Float32Array; readonly triangles: Uint32Array }
  /** Points [r, z] turned about z. */
  | { readonly kind: "revolved"; readonly profile: readonly Point2[] }
  /** nu rows of nv points; three numbers a point. */
  | { readonly kind: "surface"; readonly nu: number; readonly nv: number; readonly points: Float32Array }
  /** A line through points, three numbers a point. */
  | { readonly kind: "curve"; readonly points: Float32Array };

export type ShapeForm = FlatForm | SolidForm;

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
  /** The joint's axis in the frame of the body, a unit vector; the z axis of its frame in space. */
  readonly direction: Vec3 | null;
  /** The joint's x axis in the frame of the body, a unit vector across the axis. */
  readonly reference: Vec3 | null;
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
  /** The line along which channels of one number act; null where there is none. */
  readonly along: { readonly body: Body | null; readonly direction: Vec3 } | null;
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
  /** Direction that the picture shows upwards, a unit vector in ground axes. */
  readonly up: Vec3;
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
