import type { Animation, Body, Point2 } from "../data/contract";
import { formatLength } from "../data/format";
import { make } from "../dom";
import type { Frame } from "../motion/frame";
import { planarAngle, planarPose } from "../motion/pose";
import type { PictureKind, View, ViewOptions } from "../view";
import { Camera } from "./camera";
import { CanvasPainter } from "./canvas-painter";
import { Figure } from "./figure";
import { Gestures } from "./gestures";
import { SvgPainter } from "./svg-painter";
import { LIGHT } from "./theme";

const MARGIN = 44;
/** A saved PNG has this many pixels for each of the screen's. */
const PNG_SCALE = 3;

/** The flat picture: a canvas that can be moved and zoomed, and a tip for the body under the pointer. */
export class PlanarView implements View {
  readonly pictures = ["svg", "png"] as const;
  readonly dragHelp = "move the picture";
  readonly tools = null;
  readonly hasForces: boolean;
  private readonly figure: Figure;
  private readonly camera = new Camera();
  private readonly canvas = make("canvas", "");
  private touched = false;
  private highlighted: Body | null = null;
  private pointer: Point2 | null = null;
  private shown: { frame: Frame; options: ViewOptions } | null = null;

  constructor(
    private readonly animation: Animation,
    private readonly host: HTMLElement,
    private readonly tooltip: HTMLElement,
    private readonly redraw: () => void,
  ) {
    this.figure = new Figure(animation);
    this.hasForces = !this.figure.forces.empty;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `Drawing of ${animation.title}: ${animation.bodies.map((body) => body.name).join(", ")}`);
    host.append(this.canvas);
    new Gestures(this.canvas, {
      pan: (dx, dy) => this.change(() => this.camera.panBy(dx, dy)),
      zoom: (at, factor) => this.change(() => this.camera.zoomAt(at, factor)),
      fit: () => this.fit(),
      point: (at) => {
        this.pointer = at;
        this.redraw();
      },
    });
    this.resize();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    this.camera.resize(clientWidth, clientHeight);
    if (!this.touched) this.camera.fit(this.figure.layout.bounds, MARGIN);
    // A new size empties the canvas; waiting for the next turn would show it empty.
    if (this.shown) this.draw(this.shown.frame, this.shown.options);
    else this.redraw();
  }

  fit(): void {
    this.touched = false;
    this.camera.fit(this.figure.layout.bounds, MARGIN);
    this.redraw();
  }

  zoom(factor: number): void {
    this.change(() => this.camera.zoomAt([this.camera.width / 2, this.camera.height / 2], factor));
  }

  draw(frame: Frame, options: ViewOptions): void {
    this.shown = { frame, options };
    this.point(frame);
    const context = this.canvas.getContext("2d");
    if (!context) return;
    const ratio = this.canvas.width / this.camera.width;
    this.paint(context, ratio, options);
  }

  async picture(kind: PictureKind): Promise<Blob> {
    if (!this.shown) throw new Error("nothing is shown yet");
    // Pictures go into documents, which are white.
    const options = { ...this.shown.options, theme: LIGHT };
    if (kind === "svg") {
      const painter = new SvgPainter(this.camera.width, this.camera.height, this.animation.title);
      this.figure.draw(painter, this.camera, this.shown.frame, { ...options, highlighted: null });
      return new Blob([painter.finish()], { type: "image/svg+xml" });
    }
    const canvas = make("canvas", "");
    canvas.width = this.camera.width * PNG_SCALE;
    canvas.height = this.camera.height * PNG_SCALE;
    const context = canvas.getContext("2d");
    if (context) this.paint(context, PNG_SCALE, options, null);
    return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser could not write the picture")))));
  }

  private paint(context: CanvasRenderingContext2D, ratio: number, options: ViewOptions, highlighted = this.highlighted): void {
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = options.theme.background;
    context.fillRect(0, 0, this.camera.width, this.camera.height);
    this.figure.draw(new CanvasPainter(context), this.camera, this.shown!.frame, { ...options, highlighted });
  }

  private change(action: () => void): void {
    this.touched = true;
    action();
    this.redraw();
  }

  /** Finds the body under the pointer and says what it is and where. */
  private point(frame: Frame): void {
    const at = this.pointer;
    this.highlighted = at && this.figure.bodyAt(this.camera.toWorld(at), frame, 6 / this.camera.scale);
    const body = this.highlighted;
    this.tooltip.hidden = body === null;
    if (!body || !at) return;
    const pose = planarPose(body, frame);
    const degrees = (planarAngle(pose) * 180) / Math.PI;
    this.tooltip.replaceChildren(
      make("strong", "", body.name),
      make("span", "", `x ${formatLength(pose.x)}, y ${formatLength(pose.y)}, angle ${degrees.toFixed(2)}°`.replace(/-/g, "−")),
    );
    const { offsetWidth, offsetHeight } = this.tooltip;
    this.tooltip.style.left = `${Math.max(4, Math.min(at[0] + 14, this.camera.width - offsetWidth - 4))}px`;
    this.tooltip.style.top = `${at[1] + 18 + offsetHeight > this.camera.height ? at[1] - offsetHeight - 10 : at[1] + 18}px`;
  }
}
