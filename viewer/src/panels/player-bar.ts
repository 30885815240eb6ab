import { formatTime } from "../data/format";
import { byId, make } from "../dom";
import { nextSpeed, speedSteps, type Player } from "../motion/player";

const ICONS = {
  play: "M4 2l10 6-10 6z",
  pause: "M3 2h4v12H3zM9 2h4v12H9z",
  back: "M11 3v10L4 8zM2 3h2v10H2z",
  forward: "M5 3v10l7-5zM12 3h2v10h-2z",
};

function icon(path: string): SVGElement {
  const name = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(name, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(name, "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

/** Buttons, slider and speed of the player. */
export class PlayerBar {
  private readonly play = byId<HTMLButtonElement>("play");
  private readonly slider = byId<HTMLInputElement>("slider");
  private readonly clock = byId("clock");
  private readonly speed = byId<HTMLSelectElement>("speed");
  private readonly loop = byId<HTMLInputElement>("loop");
  private readonly speeds: readonly number[];
  private readonly step: number;
  private wasPlaying: boolean | null = null;

  constructor(
    private readonly player: Player,
    frames: number,
    private readonly changed: () => void,
  ) {
    byId("player").hidden = !player.moves;
    this.step = player.duration / Math.max(1, frames - 1);
    this.speeds = speedSteps(player.speed);
    for (const speed of this.speeds) {
      const option = make("option", "", speed === 1 ? "1× real time" : `${speed}×`);
      option.value = String(speed);
      this.speed.append(option);
    }
    byId("back").append(icon(ICONS.back));
    byId("forward").append(icon(ICONS.forward));
    this.slider.min = String(player.start);
    this.slider.max = String(player.end);
    this.on(this.play, "click", () => player.toggle());
    this.on(byId("back"), "click", () => player.step(-1));
    this.on(byId("forward"), "click", () => player.step(1));
    this.on(this.slider, "input", () => player.seek(Number(this.slider.value)));
    this.on(this.speed, "change", () => (player.speed = Number(this.speed.value)));
    this.on(this.loop, "change", () => (player.loop = this.loop.checked));
    this.show();
  }

  faster(direction: 1 | -1): void {
    this.player.speed = nextSpeed(this.speeds, this.player.speed, direction);
  }

  show(): void {
    const { player } = this;
    if (player.playing !== this.wasPlaying) {
      this.wasPlaying = player.playing;
      this.play.replaceChildren(icon(player.playing ? ICONS.pause : ICONS.play));
      this.play.setAttribute("aria-label", player.playing ? "Pause" : "Play");
    }
    const now = formatTime(player.time, this.step);
    this.slider.value = String(player.time);
    this.slider.setAttribute("aria-valuetext", `${now} seconds`);
    this.clock.textContent = `${now} / ${formatTime(player.end, this.step)} s`;
    this.speed.value = String(player.speed);
    this.loop.checked = player.loop;
  }

  private on(element: HTMLElement, event: string, action: () => void): void {
    element.addEventListener(event, () => {
      action();
      this.changed();
    });
  }
}
