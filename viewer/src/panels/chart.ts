import uPlot from "uplot";
import { axisRange, extent } from "../data/choice";
import type { Channel } from "../data/contract";
import { decimalsFor } from "../data/format";
import { make } from "../dom";
import { valueAt, type Frame } from "../motion/frame";

export interface Curve {
  readonly channel: Channel;
  readonly color: string;
  readonly dash: readonly number[];
}

export interface ChartColors {
  readonly ink: string;
  readonly grid: string;
}

/** One plot: curves against time or against another channel, with marks at the shown instant. */
export class Chart {
  private readonly plot: uPlot;
  private readonly line = make("div", "now");
  private readonly dots: HTMLElement[] = [];

  constructor(
    host: HTMLElement,
    size: { width: number; height: number },
    private readonly time: Float64Array,
    private readonly curves: readonly Curve[],
    /** The channel on the x axis; null for time. */
    private readonly x: Channel | null,
    colors: ChartColors,
    seek: (time: number) => void,
  ) {
    const data = [x ? [...x.values] : [...time], ...curves.map((curve) => Array.from(curve.channel.values, (v) => (Number.isFinite(v) ? v : null)))];
    this.plot = new uPlot(this.options(size, colors), data as uPlot.AlignedData, host);
    if (!x) this.plot.over.append(this.line);
    for (const curve of curves) {
      const dot = make("div", "dot");
      dot.style.background = curve.color;
      this.dots.push(dot);
      this.plot.over.append(dot);
    }
    this.listen(seek);
  }

  resize(width: number, height: number): void {
    this.plot.setSize({ width, height });
  }

  destroy(): void {
    this.plot.destroy();
  }

  /** Puts the marks at an instant. */
  show(frame: Frame): void {
    const across = this.x ? this.x.values : this.time;
    const left = this.plot.valToPos(valueAt(across, frame), "x");
    this.line.style.transform = `translateX(${left}px)`;
    this.curves.forEach(({ channel }, i) => {
      const top = this.plot.valToPos(valueAt(channel.values, frame), scaleOf(channel));
      const dot = this.dots[i]!;
      dot.hidden = !Number.isFinite(left + top);
      dot.style.transform = `translate(${left}px, ${top}px)`;
    });
  }

  private options(size: { width: number; height: number }, colors: ChartColors): uPlot.Options {
    const units = [...new Set(this.curves.map((curve) => curve.channel.unit))];
    const scales: uPlot.Scales = { x: { time: false, range: () => this.xRange() } };
    for (const unit of units) {
      const values = this.curves.filter((curve) => curve.channel.unit === unit).map((curve) => extent(curve.channel.values));
      const range = axisRange(Math.min(...values.map((v) => v.min)), Math.max(...values.map((v) => v.max)));
      scales[`y:${unit}`] = { range: () => range };
    }
    const axis = (label: string, more: Partial<uPlot.Axis>): uPlot.Axis => ({
      label,
      labelSize: 20,
      labelFont: "12px system-ui, sans-serif",
      font: "11px system-ui, sans-serif",
      stroke: colors.ink,
      grid: { stroke: colors.grid, width: 1 },
      ticks: { stroke: colors.grid, width: 1, size: 4 },
      values: (_, splits) => tickLabels(splits),
      ...more,
    });
    const path = this.x ? { paths: inOrder } : {};
    return {
      ...size,
      padding: [8, 16, 0, 0],
      scales,
      legend: { show: false },
      cursor: { show: false },
      axes: [
        axis(this.x ? `${this.x.name}${this.x.unit ? ` [${this.x.unit}]` : ""}` : "time [s]", { size: 30, space: 55 }),
        ...units.map((unit, i) => axis(unit === "" ? "" : `[${unit}]`, { scale: `y:${unit}`, side: i === 0 ? 3 : 1, size: 50, space: 28, ...(i === 0 ? {} : { grid: { show: false } }) })),
      ],
      series: [
        // Values of another channel are in no order; uPlot then looks at all of them.
        this.x ? { sorted: 0 } : {},
        ...this.curves.map((curve): uPlot.Series => ({ scale: scaleOf(curve.channel), stroke: curve.color, width: 1.8, dash: [...curve.dash], points: { show: false }, spanGaps: false, pxAlign: 0, ...path })),
      ],
    };
  }

  private xRange(): [number, number] {
    if (!this.x) return [this.time[0]!, this.time[this.time.length - 1]!];
    const { min, max } = extent(this.x.values);
    return axisRange(min, max);
  }

  private listen(seek: (time: number) => void): void {
    const { over } = this.plot;
    const go = (event: PointerEvent) => {
      const box = over.getBoundingClientRect();
      seek(this.timeAt(event.clientX - box.left, event.clientY - box.top));
    };
    over.addEventListener("pointerdown", (event) => {
      over.setPointerCapture(event.pointerId);
      go(event);
    });
    over.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) go(event);
    });
  }

  /** The instant that a place of the plot belongs to: for x-y plots, that of the nearest point of a curve. */
  private timeAt(left: number, top: number): number {
    if (!this.x) return this.plot.posToVal(left, "x");
    let best = Infinity;
    let time = this.time[0]!;
    for (let i = 0; i < this.time.length; i++) {
      const dx = this.plot.valToPos(this.x.values[i]!, "x") - left;
      for (const { channel } of this.curves) {
        const distance = Math.hypot(dx, this.plot.valToPos(channel.values[i]!, scaleOf(channel)) - top);
        if (distance < best) {
          best = distance;
          time = this.time[i]!;
        }
      }
    }
    return time;
  }
}

function scaleOf(channel: Channel): string {
  return `y:${channel.unit}`;
}

/** Joins the points in the order of time, whatever their x. */
const inOrder: uPlot.Series.PathBuilder = (u, index) => {
  const stroke = new Path2D();
  const xs = u.data[0];
  const ys = u.data[index] as (number | null)[];
  const scale = u.series[index]!.scale!;
  let pen = false;
  for (let i = 0; i < xs.length; i++) {
    const y = ys[i];
    const x = xs[i]!;
    if (y === null || y === undefined || !Number.isFinite(x)) {
      pen = false;
      continue;
    }
    const px = u.valToPos(x, "x", true);
    const py = u.valToPos(y, scale, true);
    if (pen) stroke.lineTo(px, py);
    else stroke.moveTo(px, py);
    pen = true;
  }
  return { stroke };
};

function tickLabels(splits: readonly number[]): string[] {
  const step = splits.length > 1 ? splits[1]! - splits[0]! : 1;
  const largest = Math.max(...splits.map(Math.abs));
  const wide = largest >= 1e5 || largest < 1e-3;
  return splits.map((value) => {
    if (Math.abs(value) < step * 1e-6) return "0";
    const text = wide ? Number(value.toPrecision(3)).toExponential() : value.toFixed(decimalsFor(step));
    return text.replace(/e\+/, "e").replace(/-/g, "−");
  });
}
