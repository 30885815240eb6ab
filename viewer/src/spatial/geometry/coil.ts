import { BufferGeometry, CatmullRomCurve3, Curve, TubeGeometry, Vector3 } from "three";

const TURNS = 9;
const PIECES_A_TURN = 14;
/** Straight wire at each end, as a part of the length. */
const END = 0.1;

/** A helix about z with straight ends on the axis. */
class Helix extends Curve<Vector3> {
  constructor(
    private readonly radius: number,
    private readonly length: number,
    private readonly turns: number,
    private readonly end: number,
  ) {
    super();
  }

  override getPoint(t: number, target = new Vector3()): Vector3 {
    const share = Math.min(1, Math.max(0, (t - this.end) / (1 - 2 * this.end)));
    const angle = 2 * Math.PI * this.turns * share;
    // The wire leaves the axis and comes back to it within the straight ends.
    const off = this.end > 0 ? Math.min(1, t / this.end, (1 - t) / this.end) : 1;
    const r = this.radius * off;
    return target.set(r * Math.cos(angle), r * Math.sin(angle), this.length * t);
  }

  /** The same parameter, not the arc length: the pieces of wire must be spread over the turns. */
  override getPointAt(t: number, target?: Vector3): Vector3 {
    return this.getPoint(t, target);
  }

  override getTangentAt(t: number, target?: Vector3): Vector3 {
    return this.getTangent(t, target);
  }
}

/** The wire of a coil spring from the origin to `length` on z. */
export function coilGeometry(length: number, radius: number, wire: number): BufferGeometry {
  return new TubeGeometry(new Helix(radius, length, TURNS, END), TURNS * PIECES_A_TURN, wire, 7);
}

/** The thread of a screw about z, centred at the origin. */
export function threadGeometry(length: number, radius: number, wire: number): BufferGeometry {
  const turns = Math.max(2, Math.round(length / (4 * wire)));
  return new TubeGeometry(new Helix(radius, length, turns, 0), turns * PIECES_A_TURN, wire, 5).translate(0, 0, -length / 2);
}

/** A straight round rod between two points. */
export function strutGeometry(a: Vector3, b: Vector3, radius: number): BufferGeometry {
  return new TubeGeometry(new CatmullRomCurve3([a, b]), 1, radius, 14);
}
