/** A place in the histories: between frame `index` and the next, `share` of the way. */
export interface Frame {
  readonly index: number;
  readonly share: number;
}

/** Finds `t` in a rising list of times; outside, the nearest end. */
export function locate(time: Float64Array, t: number): Frame {
  const last = time.length - 1;
  if (last < 1 || !(t > time[0]!)) return { index: 0, share: 0 };
  if (t >= time[last]!) return { index: last, share: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle]! <= t) low = middle;
    else high = middle;
  }
  const step = time[high]! - time[low]!;
  return { index: low, share: step > 0 ? (t - time[low]!) / step : 0 };
}

/** Number of the frame nearest to `t`. */
export function nearestFrame(time: Float64Array, t: number): number {
  const { index, share } = locate(time, t);
  return share >= 0.5 ? index + 1 : index;
}

/** The value of a history at a place, straight between frames. */
export function valueAt(values: Float64Array, { index, share }: Frame): number {
  const a = values[index]!;
  return share === 0 ? a : a + share * (values[index + 1]! - a);
}
