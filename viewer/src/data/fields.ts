import type { Point2, Quaternion, Vec3 } from "./contract";

export type Json = { readonly [key: string]: unknown };

/** Reads fields of untrusted JSON and collects every problem instead of stopping at the first. */
export class Fields {
  readonly problems: string[] = [];

  problem(text: string): void {
    // A file with the wrong lengths everywhere would otherwise bury the reader.
    if (this.problems.length < 20) this.problems.push(text);
  }

  object(value: unknown, where: string): Json {
    if (typeof value === "object" && value !== null && !Array.isArray(value)) return value as Json;
    this.problem(`${where} must be an object.`);
    return {};
  }

  list(value: unknown, where: string): readonly unknown[] {
    if (value === undefined || value === null) return [];
    if (Array.isArray(value)) return value;
    this.problem(`${where} must be a list.`);
    return [];
  }

  text(value: unknown, where: string, fallback?: string): string {
    if (typeof value === "string") return value;
    if (value !== undefined && value !== null) this.problem(`${where} must be text.`);
    else if (fallback === undefined) this.problem(`${where} is missing.`);
    return fallback ?? "";
  }

  size(value: unknown, where: string): number {
    if (typeof value === "number" && Number.isFinite(value) && value >= 0) return value;
    this.problem(`${where} must be a number that is not negative.`);
    return 0;
  }

  /** A size that makes no sense at zero. */
  positive(value: unknown, where: string): number {
    if (typeof value === "number" && Number.isFinite(value) && value > 0) return value;
    this.problem(`${where} must be a positive number.`);
    return 1;
  }

  /** How many there are of something, at least `least`. */
  count(value: unknown, least: number, where: string): number {
    if (typeof value === "number" && Number.isInteger(value) && value >= least) return value;
    this.problem(`${where} must be a whole number, at least ${least}.`);
    return least;
  }

  /** Finite numbers in threes, at least `least` of them; `length` numbers where that is known. */
  triples(value: unknown, least: number, where: string, length?: number): Float32Array {
    const list = this.list(value, where);
    if (length !== undefined && list.length !== length) this.problem(`${where} must have ${length} numbers, it has ${list.length}.`);
    else if (list.length % 3 !== 0 || list.length < 3 * least) this.problem(`${where} must have three numbers for each of at least ${least}, it has ${list.length}.`);
    else if (!list.every((entry) => typeof entry === "number" && Number.isFinite(entry))) this.problem(`${where} must have finite numbers only.`);
    else return Float32Array.from(list as number[]);
    return new Float32Array(length ?? 3 * least);
  }

  /** A direction as a unit vector; null where there is none. */
  direction(value: unknown, where: string): Vec3 | null {
    const v = this.vec3(value, where, [0, 0, 0]);
    const length = Math.hypot(...v);
    return length > 0 ? [v[0] / length, v[1] / length, v[2] / length] : null;
  }

  /** Numbers of a history; null (no value at this frame) becomes NaN. */
  numbers(value: unknown, length: number, where: string): Float64Array {
    const out = new Float64Array(length).fill(NaN);
    const list = this.list(value, where);
    if (list.length !== length) {
      this.problem(`${where} must have ${length} numbers, it has ${list.length}.`);
      return out;
    }
    list.forEach((entry, i) => {
      if (typeof entry === "number") out[i] = entry;
      else if (entry !== null) this.problem(`${where}[${i}] must be a number.`);
    });
    return out;
  }

  vec3(value: unknown, where: string, fallback: Vec3): Vec3 {
    if (value === undefined || value === null) return fallback;
    const v = this.numbers(value, 3, where);
    return [finite(v[0]), finite(v[1]), finite(v[2])];
  }

  quaternion(value: unknown, where: string): Quaternion {
    if (value === undefined || value === null) return [1, 0, 0, 0];
    const q = this.numbers(value, 4, where);
    const norm = Math.hypot(q[0]!, q[1]!, q[2]!, q[3]!);
    if (!(norm > 0)) {
      this.problem(`${where} must be a quaternion that is not zero.`);
      return [1, 0, 0, 0];
    }
    return [q[0]! / norm, q[1]! / norm, q[2]! / norm, q[3]! / norm];
  }

  points(value: unknown, where: string): readonly Point2[] {
    return this.list(value, where).map((entry, i) => {
      const pair = this.list(entry, `${where}[${i}]`);
      const [x, y] = pair;
      if (typeof x === "number" && typeof y === "number") return [x, y] as const;
      this.problem(`${where}[${i}] must be [x, y].`);
      return [0, 0] as const;
    });
  }
}

function finite(value: number | undefined): number {
  return value !== undefined && Number.isFinite(value) ? value : 0;
}
