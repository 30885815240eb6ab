import { readAddress } from "./data/address";
import type { Animation } from "./data/contract";
import { byId, fileName, save } from "./dom";
import { listenToKeys } from "./keys";
import { locate } from "./motion/frame";
import { Player } from "./motion/player";
import { showInfo } from "./panels/info-panel";
import { PlayerBar } from "./panels/player-bar";
import { PlotPanel } from "./panels/plot-panel";
import type { TraceMode } from "./planar/figure";
import { DARK, LIGHT, type Theme } from "./planar/theme";
import { VIEWPOINTS, type PictureKind, type View, type Viewpoint } from "./view";

/** Opens the picture on the page; null where the browser cannot draw it. */
export type OpenView = (animation: Animation, host: HTMLElement, tooltip: HTMLElement, redraw: () => void) => View | null;

const TRACE_MODES: readonly TraceMode[] = ["growing", "whole", "off"];
/** A page that was hidden must not leap ahead when it is seen again [s]. */
const LONGEST_TICK = 0.1;

/** The page: joins clock, picture, player and plots. */
export class Page {
  private readonly player: Player;
  private readonly view: View | null;
  private readonly bar: PlayerBar;
  private readonly plots: PlotPanel;
  private readonly dark = window.matchMedia("(prefers-color-scheme: dark)");
  private traces: TraceMode = "growing";
  private names = false;
  private forces = false;
  private frames = false;
  private axes = false;
  /** Length of the arrows, times what they have by themselves. */
  private forceScale = 1;
  private drawing = false;
  private last: number | null = null;

  constructor(
    private readonly animation: Animation,
    open: OpenView,
  ) {
    const redraw = () => this.redraw();
    this.player = new Player(animation.time);
    showInfo(animation);
    this.view = open(animation, byId("figure"), byId("tooltip"), redraw);
    this.bar = new PlayerBar(this.player, animation.time.length, redraw);
    this.plots = new PlotPanel(
      animation,
      this.theme,
      (time) => {
        this.player.pause();
        this.player.seek(time);
        redraw();
      },
      redraw,
    );
    this.buttons();
    this.keys();
    this.start();
    window.addEventListener("hashchange", () => this.obey());
    this.dark.addEventListener("change", redraw);
    if (this.view) new ResizeObserver(() => this.view?.resize()).observe(byId("figure"));
    redraw();
  }

  private get theme(): Theme {
    return this.dark.matches ? DARK : LIGHT;
  }

  /** Follows the address; without a wish for an instant the run plays, unless the user wants no motion. */
  private start(): void {
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!this.obey() && !still) this.player.play();
  }

  /** Does what the address says; did it name an instant? */
  private obey(): boolean {
    const { time, frame, plot, x, forces, names, frames, axes, from } = readAddress(location.search, location.hash);
    if (plot) this.plots.chooseNames(plot);
    if (x !== null) this.plots.against(x);
    if (forces !== null && forces > 0) this.scaleForces(Math.log10(forces));
    if (forces !== null) this.setForces(forces > 0);
    if (names !== null) this.setNames(names);
    if (frames !== null) this.setFrames(frames);
    if (axes !== null) this.setAxes(axes);
    const viewpoint = VIEWPOINTS.find((one) => one === from);
    if (viewpoint) this.view?.tools?.look(viewpoint);
    if (time === null && frame === null) return false;
    this.player.pause();
    if (time !== null) this.player.seek(time);
    else this.player.toFrame(frame!);
    this.redraw();
    return true;
  }

  private redraw(): void {
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.drawing = false;
    const passed = this.last === null ? 0 : Math.min(LONGEST_TICK, (now - this.last) / 1000);
    this.player.advance(passed);
    this.last = this.player.playing ? now : null;
    const frame = locate(this.animation.time, this.player.time);
    this.plots.setTheme(this.theme);
    this.view?.draw(frame, {
      theme: this.theme,
      traces: this.traces,
      names: this.names,
      forces: this.forces ? this.forceScale : 0,
      frames: this.frames,
      axes: this.axes,
    });
    this.bar.show();
    this.plots.show(frame);
    document.body.dataset.state = "drawn";
    if (this.player.playing) this.redraw();
  }

  private buttons(): void {
    const { view } = this;
    byId("fit").addEventListener("click", () => view?.fit());
    for (const id of ["fit", "names"]) byId(id).hidden = view === null;
    byId("traces-choice").hidden = view === null || this.animation.traces.length === 0;
    byId("traces").addEventListener("change", () => this.setTraces(byId<HTMLSelectElement>("traces").value as TraceMode));
    byId("names").addEventListener("click", () => this.setNames(!this.names));
    this.spatialButtons();
    byId("forces").hidden = byId("help-forces").hidden = !view?.hasForces;
    byId("forces").addEventListener("click", () => this.setForces(!this.forces));
    const slider = byId<HTMLInputElement>("force-scale");
    slider.addEventListener("input", () => this.scaleForces(Number(slider.value)));
    byId("help-button").addEventListener("click", () => byId<HTMLDialogElement>("help").showModal());
    byId("help-drag").textContent = view?.dragHelp ?? "";
    for (const kind of ["svg", "png"] as const) {
      const button = byId(`save-${kind}`);
      button.hidden = !view?.pictures.includes(kind);
      button.addEventListener("click", () => void this.savePicture(kind));
    }
  }

  /** Buttons that only a picture in space needs. */
  private spatialButtons(): void {
    const tools = this.view?.tools ?? null;
    for (const id of ["viewpoints", "frames", "axes", "help-steer", "help-viewpoints", "help-frames"]) byId(id).hidden = tools === null;
    for (const from of VIEWPOINTS) byId(`from-${from}`).addEventListener("click", () => this.look(from));
    byId("frames").addEventListener("click", () => this.setFrames(!this.frames));
    byId("axes").addEventListener("click", () => this.setAxes(!this.axes));
  }

  private look(from: Viewpoint): void {
    this.view?.tools?.look(from);
    this.redraw();
  }

  private async savePicture(kind: PictureKind): Promise<void> {
    if (!this.view) return;
    save(await this.view.picture(kind), `${fileName(this.animation.title)}.${kind}`);
  }

  private setTraces(mode: TraceMode): void {
    this.traces = mode;
    byId<HTMLSelectElement>("traces").value = mode;
    this.redraw();
  }

  private setNames(shown: boolean): void {
    this.names = shown;
    byId("names").setAttribute("aria-pressed", String(shown));
    this.redraw();
  }

  private setFrames(shown: boolean): void {
    this.frames = shown;
    byId("frames").setAttribute("aria-pressed", String(shown));
    this.redraw();
  }

  private setAxes(shown: boolean): void {
    this.axes = shown;
    byId("axes").setAttribute("aria-pressed", String(shown));
    this.redraw();
  }

  private setForces(shown: boolean): void {
    this.forces = shown && this.view !== null && this.view.hasForces;
    byId("forces").setAttribute("aria-pressed", String(this.forces));
    byId("force-scale-choice").hidden = !this.forces;
    this.redraw();
  }

  /** Sets the length of the arrows by its power of ten. */
  private scaleForces(power: number): void {
    this.forceScale = 10 ** power;
    byId<HTMLInputElement>("force-scale").value = String(power);
    this.redraw();
  }

  private keys(): void {
    const { player, view } = this;
    const then = (action: () => void) => () => {
      action();
      this.redraw();
    };
    const step = (count: number) => (event: KeyboardEvent) => {
      player.step(event.shiftKey ? 10 * count : count);
      this.redraw();
    };
    const end = (frame: number) =>
      then(() => {
        player.pause();
        player.toFrame(frame);
      });
    const tools = view?.tools;
    const steer = (right: number, up: number) => (event: KeyboardEvent) => {
      tools?.steer(right, up, event.shiftKey);
      this.redraw();
    };
    listenToKeys({
      ...(tools && {
        a: steer(-1, 0),
        d: steer(1, 0),
        w: steer(0, 1),
        s: steer(0, -1),
        i: () => this.look("iso"),
        x: () => this.look("x"),
        y: () => this.look("y"),
        z: () => this.look("z"),
        b: () => this.setFrames(!this.frames),
        j: () => this.setAxes(!this.axes),
      }),
      " ": then(() => player.toggle()),
      ArrowLeft: step(-1),
      ArrowRight: step(1),
      Home: end(0),
      End: end(this.animation.time.length - 1),
      "[": then(() => this.bar.faster(-1)),
      "]": then(() => this.bar.faster(1)),
      "+": () => view?.zoom(1.25),
      "=": () => view?.zoom(1.25),
      "-": () => view?.zoom(0.8),
      f: () => view?.fit(),
      l: then(() => (player.loop = !player.loop)),
      t: () => this.setTraces(TRACE_MODES[(TRACE_MODES.indexOf(this.traces) + 1) % TRACE_MODES.length]!),
      r: () => this.setForces(!this.forces),
      n: () => this.setNames(!this.names),
      "?": () => byId<HTMLDialogElement>("help").showModal(),
    });
  }
}
