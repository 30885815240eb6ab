import { Color, DirectionalLight, HemisphereLight, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, type Object3D } from "three";
import type { Animation, Quaternion, Vec3 } from "../data/contract";
import { formatLength } from "../data/format";
import { make } from "../dom";
import type { Frame } from "../motion/frame";
import { poseAt } from "../motion/pose";
import { CanvasPainter } from "../planar/canvas-painter";
import { LIGHT, type Theme } from "../planar/theme";
import type { PictureKind, SpatialTools, View, ViewOptions, Viewpoint } from "../view";
import { Floor } from "./floor";
import { Machine, type Pointable } from "./machine";
import { Materials } from "./materials";
import { ISOMETRIC, Orbit } from "./orbit";
import { drawOverlay, type Label, type OverlayContent } from "./overlay";
import { isFinite3 } from "./vectors";

/** A saved PNG has this many pixels for each of the screen's. */
const PNG_SCALE = 3;
/** Graphics cards refuse larger pictures. */
const LARGEST_SIDE = 8192;
/** A step of the keys: angle [rad], and part of the picture's height. */
const TURN_STEP = Math.PI / 24;
const MOVE_STEP = 0.06;

const DIRECTIONS: Readonly<Record<Viewpoint, Vec3>> = { iso: ISOMETRIC, x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1] };

/** The picture in space: WebGL, turned and moved with mouse, fingers and keys. */
export class SpatialView implements View {
  readonly pictures = ["png"] as const;
  readonly hasForces: boolean;
  readonly dragHelp = "turn the picture; with the right button, shift or two fingers, move it";
  readonly tools: SpatialTools = {
    look: (from) => this.orbit.fit(DIRECTIONS[from]),
    steer: (right, up, moving) => (moving ? this.orbit.move(MOVE_STEP * right, MOVE_STEP * up) : this.orbit.turn(TURN_STEP * right, TURN_STEP * up)),
  };
  private readonly renderer = new WebGLRenderer({ antialias: true });
  private readonly scene = new Scene();
  private readonly background = new Color();
  private readonly sun = new DirectionalLight(0xffffff, 1.75);
  private readonly sky = new HemisphereLight(0xffffff, 0xb9b4aa, 1.75);
  private readonly materials = new Materials();
  private readonly machine: Machine;
  private readonly floor: Floor;
  private readonly orbit: Orbit;
  private readonly overlay = make("canvas", "overlay");
  private readonly raycaster = new Raycaster();
  private pointer: Vector2 | null = null;
  private dragging = false;
  private shown: { frame: Frame; options: ViewOptions } | null = null;

  constructor(
    animation: Animation,
    private readonly host: HTMLElement,
    private readonly tooltip: HTMLElement,
    private readonly redraw: () => void,
  ) {
    const canvas = this.renderer.domElement;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `Drawing of ${animation.title}: ${animation.bodies.map((body) => body.name).join(", ")}`);
    host.append(canvas, this.overlay);
    this.machine = new Machine(animation, this.materials);
    this.hasForces = !this.machine.forces.empty;
    this.floor = new Floor(this.machine.box);
    this.orbit = new Orbit(canvas, this.machine.box, redraw);
    this.sky.position.set(0, 0, 1);
    this.scene.background = this.background;
    this.scene.add(this.sky, this.sun, this.sun.target, this.floor.lines, this.machine.group);
    this.listen(canvas);
    this.resize();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    const ratio = window.devicePixelRatio || 1;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.overlay.width = Math.max(1, Math.round(clientWidth * ratio));
    this.overlay.height = Math.max(1, Math.round(clientHeight * ratio));
    this.orbit.resize(clientWidth, clientHeight);
    // A new size empties the canvas; waiting for the next turn would show it empty.
    if (this.shown) this.draw(this.shown.frame, this.shown.options);
    else this.redraw();
  }

  fit(): void {
    this.orbit.fit();
    this.redraw();
  }

  zoom(factor: number): void {
    this.orbit.zoom(factor);
    this.redraw();
  }

  draw(frame: Frame, options: ViewOptions): void {
    this.shown = { frame, options };
    this.machine.show(frame, options);
    this.render(options.theme);
    this.point(frame);
    const context = this.overlay.getContext("2d");
    if (!context) return;
    const ratio = this.overlay.width / Math.max(1, this.host.clientWidth);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.host.clientWidth, this.host.clientHeight);
    drawOverlay(new CanvasPainter(context), options.theme, this.content(frame, options));
  }

  async picture(_kind: PictureKind): Promise<Blob> {
    if (!this.shown) throw new Error("nothing is shown yet");
    const { frame, options } = this.shown;
    const { clientWidth, clientHeight } = this.host;
    const scale = Math.min(PNG_SCALE, LARGEST_SIDE / Math.max(clientWidth, clientHeight));
    const canvas = make("canvas", "");
    canvas.width = Math.round(clientWidth * scale);
    canvas.height = Math.round(clientHeight * scale);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("the browser could not draw the picture");
    // Pictures go into documents, which are white.
    this.machine.highlight(null);
    this.renderer.setPixelRatio(scale);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.render(LIGHT);
    context.drawImage(this.renderer.domElement, 0, 0, canvas.width, canvas.height);
    context.setTransform(scale, 0, 0, scale, 0, 0);
    drawOverlay(new CanvasPainter(context), LIGHT, this.content(frame, options));
    this.resize();
    return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser could not write the picture")))));
  }

  private render(theme: Theme): void {
    this.background.set(theme.background);
    this.materials.setTheme(theme);
    this.floor.paint(theme);
    const light = theme === LIGHT;
    this.sky.intensity = light ? 1.9 : 1.35;
    this.sun.intensity = light ? 1.6 : 1.75;
    // The light comes over the left shoulder, so that every side that is seen is shaded alike.
    const { camera } = this.orbit;
    camera.updateMatrixWorld();
    this.sun.position.set(-0.55, 0.8, 1).applyQuaternion(camera.quaternion);
    this.renderer.render(this.scene, camera);
  }

  private content(frame: Frame, options: ViewOptions): OverlayContent {
    const { clientWidth: width, clientHeight: height } = this.host;
    const back = this.orbit.camera.quaternion.clone().invert();
    const axes = [0, 1, 2].map((k) => {
      const axis = new Vector3().setComponent(k, 1).applyQuaternion(this.machine.group.quaternion).applyQuaternion(back);
      return [axis.x, axis.y, axis.z] as const;
    });
    const pixels = this.orbit.pixelsPerMetre(height) * options.forces;
    const parts = options.forces > 0 ? (["force", "moment"] as const).filter((part) => this.machine.forces.perMetre[part] > 0) : [];
    const scales = parts.map((part) => ({ part, perPixel: this.machine.forces.perMetre[part] / pixels }));
    return { width, height, labels: options.names ? this.labels(frame) : [], cell: this.floor.cell, axes, scales };
  }

  private labels(frame: Frame): readonly Label[] {
    const { clientWidth, clientHeight } = this.host;
    return this.machine.bodies.flatMap((one) => {
      const at = this.machine.namePlace(one, frame);
      if (!isFinite3(at)) return [];
      const p = this.machine.group.localToWorld(new Vector3(...at)).project(this.orbit.camera);
      return p.z > 1 ? [] : [{ text: one.body.name, at: [((p.x + 1) / 2) * clientWidth, ((1 - p.y) / 2) * clientHeight] as const }];
    });
  }

  private listen(canvas: HTMLElement): void {
    const at = (event: PointerEvent) => {
      const box = canvas.getBoundingClientRect();
      this.pointer = new Vector2(event.clientX - box.left, event.clientY - box.top);
      this.redraw();
    };
    canvas.addEventListener("pointermove", at);
    canvas.addEventListener("pointerdown", (event) => {
      this.dragging = true;
      canvas.classList.add("dragged");
      at(event);
    });
    for (const name of ["pointerup", "pointercancel"] as const) {
      canvas.addEventListener(name, () => {
        this.dragging = false;
        canvas.classList.remove("dragged");
        this.redraw();
      });
    }
    canvas.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.redraw();
    });
  }

  /** Finds what is under the pointer and says what it is and where; not while the picture is being turned. */
  private point(frame: Frame): void {
    const found = this.pointer && !this.dragging ? this.under(this.pointer) : null;
    this.machine.highlight(found?.body ?? null);
    this.tooltip.hidden = found === null;
    if (!found || !this.pointer) return;
    const { body, joint } = found;
    const text = body ? describe(poseAt(body.track, frame)) : (joint?.kind ?? "");
    this.tooltip.replaceChildren(make("strong", "", body?.name ?? joint?.name ?? ""), make("span", "", text));
    const { offsetWidth, offsetHeight } = this.tooltip;
    const { x, y } = this.pointer;
    this.tooltip.style.left = `${Math.max(4, Math.min(x + 14, this.host.clientWidth - offsetWidth - 4))}px`;
    this.tooltip.style.top = `${y + 18 + offsetHeight > this.host.clientHeight ? y - offsetHeight - 10 : y + 18}px`;
  }

  private under(pointer: Vector2): Pointable | null {
    const { clientWidth, clientHeight } = this.host;
    this.raycaster.setFromCamera(new Vector2((2 * pointer.x) / clientWidth - 1, 1 - (2 * pointer.y) / clientHeight), this.orbit.camera);
    const seen = [...this.machine.pointables.keys()].filter(isShown);
    const [hit] = this.raycaster.intersectObjects(seen, false);
    return hit ? (this.machine.pointables.get(hit.object) ?? null) : null;
  }
}

function isShown(object: Object3D): boolean {
  return object.visible && (object.parent === null || isShown(object.parent));
}

/** "x 10 mm, y 0 m, z 1 m, turned 30.00° about (0, 0, 1)" */
export function describe({ position, quaternion }: { position: Vec3; quaternion: Quaternion }): string {
  const sign = quaternion[0] < 0 ? -1 : 1;
  const axis = quaternion.slice(1).map((v) => sign * v);
  const sine = Math.hypot(...axis);
  const degrees = (2 * Math.atan2(sine, Math.abs(quaternion[0])) * 180) / Math.PI;
  const place = ["x", "y", "z"].map((name, k) => `${name} ${formatLength(position[k]!)}`).join(", ");
  const turned = sine > 1e-9 ? `, turned ${degrees.toFixed(2)}° about (${axis.map((v) => Number((v / sine).toFixed(3)) + 0).join(", ")})` : "";
  return `${place}${turned}`.replace(/-/g, "−");
}
