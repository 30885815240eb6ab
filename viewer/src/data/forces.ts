import type { Animation, Attachment, Channel } from "./contract";

/** A force on a body over time, in ground axes. */
export interface ForceHistory {
  readonly name: string;
  /** A joint's reaction on its second body, or what an element applies. */
  readonly kind: "reaction" | "load";
  /** Where it acts. */
  readonly at: Attachment;
  /** Components of the force; or, with `toward`, its size along the line to there. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly toward: Attachment | null;
  /** Moment on the body; null where there is none. */
  readonly moment: Float64Array | null;
}

/** Springs and dampers: one tension along the line of their two points. */
export const TENSIONED = new Set(["spring-damper"]);

/** The forces of a run whose place is known, from the channels NAME.force_x, NAME.force_y, NAME.moment and NAME.force. */
export function findForces(animation: Animation): readonly ForceHistory[] {
  const channels = new Map(animation.channels.map((channel) => [channel.name, channel]));
  const of = (name: string, suffix: string, unit: string): Channel | null => {
    const channel = channels.get(`${name}.${suffix}`);
    return channel && channel.unit === unit ? channel : null;
  };
  const out: ForceHistory[] = [];
  const add = (name: string, kind: ForceHistory["kind"], at: Attachment) => {
    const x = of(name, "force_x", "N");
    const y = of(name, "force_y", "N");
    const moment = of(name, "moment", "N m");
    if (x && y) out.push({ name, kind, at, x: x.values, y: y.values, toward: null, moment: moment?.values ?? null });
  };
  for (const joint of animation.joints) add(joint.name, "reaction", joint.second);
  for (const load of animation.loads) add(load.name, "load", load.at);
  for (const spring of animation.springs) {
    const tension = of(spring.name, "force", "N");
    if (tension && TENSIONED.has(spring.kind)) {
      out.push({ name: spring.name, kind: "load", at: spring.second, x: tension.values, y: tension.values, toward: spring.first, moment: null });
    }
  }
  return out;
}

/** Share of the values that the typical size leaves below it: a short peak must not make everything else vanish. */
const TYPICAL = 0.95;

/** The size that arrows are scaled by; 0 if there is no force. */
export function typicalForce(forces: readonly ForceHistory[]): number {
  const sizes = forces.map(({ x, y, toward }) => typical(x.length, (i) => (toward ? Math.abs(x[i]!) : Math.hypot(x[i]!, y[i]!))));
  return Math.max(0, ...sizes);
}

export function typicalMoment(forces: readonly ForceHistory[]): number {
  return Math.max(0, ...forces.map(({ moment }) => (moment ? typical(moment.length, (i) => Math.abs(moment[i]!)) : 0)));
}

/** The size that most values of a history do not exceed. */
export function typical(count: number, size: (index: number) => number): number {
  const sizes = Array.from({ length: count }, (_, i) => size(i)).filter(Number.isFinite);
  sizes.sort((a, b) => a - b);
  return sizes[Math.min(sizes.length - 1, Math.floor(TYPICAL * sizes.length))] ?? 0;
}
