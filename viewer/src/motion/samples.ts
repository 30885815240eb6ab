import type { Frame } from "./frame";

/** At most `limit` frames spread evenly over a run, first and last among them. */
export function sampleFrames(count: number, limit: number): readonly Frame[] {
  const number = Math.min(count, limit);
  if (number <= 1) return [{ index: 0, share: 0 }];
  return Array.from({ length: number }, (_, i) => ({ index: Math.round((i * (count - 1)) / (number - 1)), share: 0 }));
}
