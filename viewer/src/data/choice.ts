import type { Channel } from "./contract";

/** Channels whose name, unit or meaning contains every word of the query. */
export function search(channels: readonly Channel[], query: string): readonly Channel[] {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  return channels.filter((channel) => {
    const text = `${channel.name} ${channel.unit} ${channel.meaning}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

const FIRST_CHOICE = 2;

/** What to plot when nobody has chosen: the first channel that moves, and the next ones of the same unit. */
export function firstChoice(channels: readonly Channel[]): readonly Channel[] {
  const sizes = new Map<string, number>();
  for (const { unit, values } of channels) {
    const { min, max } = extent(values);
    sizes.set(unit, Math.max(sizes.get(unit) ?? 0, Math.abs(min), Math.abs(max)));
  }
  const moving = channels.filter(({ unit, values }) => varies(values, sizes.get(unit)!));
  const unit = (moving[0] ?? channels[0])?.unit;
  const pool = moving.length > 0 ? moving : channels;
  return pool.filter((channel) => channel.unit === unit).slice(0, FIRST_CHOICE);
}

/** Does a channel change by more than the rounding errors of channels of its unit, which are as large as `size`? */
function varies(values: Float64Array, size: number): boolean {
  const { min, max } = extent(values);
  return max - min > 1e-9 * size;
}

/** Smallest and largest value, without the gaps; 0 and 0 if there is none. */
export function extent(values: Float64Array): { min: number; max: number } {
  let min = Infinity;
  let max = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    min = Math.min(min, value);
    max = Math.max(max, value);
  }
  return min <= max ? { min, max } : { min: 0, max: 0 };
}

/** Range of an axis: a little more than the values; a constant gets room around it instead of its rounding errors. */
export function axisRange(min: number, max: number): [number, number] {
  const size = Math.max(Math.abs(min), Math.abs(max));
  if (!Number.isFinite(size)) return [0, 1];
  if (size === 0) return [-1, 1];
  if (max - min <= 1e-9 * size) return [min - 0.5 * size, max + 0.5 * size];
  const room = 0.06 * (max - min);
  return [min - room, max + room];
}
