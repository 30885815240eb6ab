import { firstChoice } from "../data/choice";
import type { Animation, Channel } from "../data/contract";
import { formatNumber } from "../data/format";
import { PALETTE } from "../data/palette";
import { byId, make } from "../dom";
import { valueAt, type Frame } from "../motion/frame";
import type { Theme } from "../planar/theme";
import { mix } from "../data/palette";
import { ChannelList } from "./channel-list";
import { Chart, type Curve } from "./chart";

const DASHES: readonly (readonly number[])[] = [[], [7, 4], [2, 3]];

/** Plot, legend and choice of channels. A single instant has no plot: the legend is then a table of values. */
export class PlotPanel {
  private chosen: Channel[];
  private x: Channel | null = null;
  private chart: Chart | null = null;
  private readonly host = byId("plot");
  private readonly xSelect = byId<HTMLSelectElement>("x-axis");
  private readonly legend = byId("legend").querySelector("tbody")!;
  private readonly list: ChannelList;
  private values: HTMLElement[] = [];
  private readonly single: boolean;

  constructor(
    private readonly animation: Animation,
    private theme: Theme,
    private readonly seek: (time: number) => void,
    private readonly redraw: () => void,
  ) {
    const { channels } = animation;
    this.single = animation.time.length < 2;
    this.chosen = this.single ? [...channels] : [...firstChoice(channels)];
    byId("plots").hidden = channels.length === 0;
    if (this.single) {
      byId("plots-title").textContent = "Values";
      byId("x-choice").hidden = true;
      this.host.hidden = true;
    }
    byId("channels").toggleAttribute("open", !this.single && window.innerWidth > 760);
    this.xSelect.append(...[["", "time"], ...channels.map((channel) => [channel.name, channel.name])].map(([value, text]) => option(value!, text!)));
    this.xSelect.addEventListener("change", () => this.against(this.xSelect.value));
    this.list = new ChannelList(
      channels,
      (channel) => this.chosen.includes(channel),
      (channel, chosen) => this.choose(chosen ? [...this.chosen, channel] : this.chosen.filter((other) => other !== channel)),
    );
    new ResizeObserver(() => this.resize()).observe(this.host);
    this.build();
  }

  /** Shows the channels of these names, in this order. */
  chooseNames(names: readonly string[]): void {
    const found = names.map((name) => this.animation.channels.find((channel) => channel.name === name));
    this.choose(found.filter((channel): channel is Channel => channel !== undefined));
  }

  /** Puts a channel on the x axis; an unknown name puts time there. */
  against(name: string): void {
    this.x = this.animation.channels.find((channel) => channel.name === name) ?? null;
    this.xSelect.value = this.x?.name ?? "";
    this.build();
  }

  setTheme(theme: Theme): void {
    if (theme === this.theme) return;
    this.theme = theme;
    this.build();
  }

  show(frame: Frame): void {
    this.chart?.show(frame);
    this.chosen.forEach((channel, i) => {
      const cell = this.values[i];
      const text = formatNumber(valueAt(channel.values, frame));
      if (cell && cell.textContent !== text) cell.textContent = text;
    });
  }

  private choose(channels: readonly Channel[]): void {
    this.chosen = [...new Set(channels)];
    this.build();
  }

  private curves(): Curve[] {
    return this.chosen.map((channel, i) => ({
      channel,
      color: mix(PALETTE[i % PALETTE.length]!, this.theme.edgeBase, 0.12),
      dash: DASHES[Math.floor(i / PALETTE.length) % DASHES.length]!,
    }));
  }

  private build(): void {
    const curves = this.curves();
    this.chart?.destroy();
    this.chart = null;
    this.host.replaceChildren();
    if (!this.single && curves.length > 0) {
      this.chart = new Chart(this.host, this.size(), this.animation.time, curves, this.x, { ink: this.theme.quiet, grid: this.theme.grid }, this.seek);
    } else if (!this.single) {
      this.host.append(make("p", "empty", "Choose channels from the list to plot them."));
    }
    this.values = [];
    this.legend.replaceChildren(...curves.map((curve) => this.legendRow(curve)));
    this.list.show();
    this.redraw();
  }

  private legendRow({ channel, color, dash }: Curve): HTMLElement {
    const swatch = make("i", "");
    swatch.style.borderTopColor = color;
    swatch.style.borderTopStyle = dash.length === 0 ? "solid" : dash[0]! > 3 ? "dashed" : "dotted";
    const value = make("td", "number");
    this.values.push(value);
    const drop = make("button", "", "×");
    drop.type = "button";
    drop.setAttribute("aria-label", `Remove ${channel.name}`);
    drop.addEventListener("click", () => this.choose(this.chosen.filter((other) => other !== channel)));
    const name = make("td", "", channel.name);
    name.title = channel.meaning;
    const cells = [name, value, make("td", "unit", channel.unit), make("td", "drop", drop)];
    return make("tr", "", ...(this.single ? cells : [make("td", "swatch", swatch), ...cells]));
  }

  private size(): { width: number; height: number } {
    const width = Math.max(200, this.host.clientWidth);
    return { width, height: Math.round(Math.min(300, Math.max(200, 0.62 * width))) };
  }

  private resize(): void {
    const { width, height } = this.size();
    this.chart?.resize(width, height);
    this.redraw();
  }
}

function option(value: string, text: string): HTMLOptionElement {
  const element = make("option", "", text);
  element.value = value;
  return element;
}
