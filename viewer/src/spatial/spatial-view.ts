import { AmbientLight, AxesHelper, Box3, Color, DirectionalLight, GridHelper, Group, Line, Mesh, PerspectiveCamera, Scene, SphereGeometry, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Animation, Attachment, Body, Joint, Trace } from "../data/contract";
import { roundDown125 } from "../data/format";
import { mix } from "../data/palette";
import { make } from "../dom";
import type { Frame } from "../motion/frame";
import { bodyPose, place, poseAt } from "../motion/pose";
import { sampleFrames } from "../motion/samples";
import { LIGHT, type Theme } from "../planar/theme";
import type { PictureKind, View, ViewOptions } from "../view";
import { bodyGroup, material, polyline } from "./body-group";
import { helix } from "./spring-line";

/** The picture in space: WebGL, z up, turned with the mouse. */
export class SpatialView implements View {
  readonly pictures = ["png"] as const;
  readonly hasForces = false;
  readonly dragHelp = "turn the picture; with the right button, move it";
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(35, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly box = new Box3();
  private readonly groups: { body: Body; group: Group; label: HTMLElement }[] = [];
  private readonly pins: { joint: Joint; mesh: Mesh }[] = [];
  private readonly lines: { element: Joint; line: Line; coil: boolean }[] = [];
  private readonly traces: { trace: Trace; line: Line; dot: Mesh }[] = [];
  private readonly unit: number;
  private readonly grid = new Group();
  private shown: { frame: Frame; options: ViewOptions } | null = null;

  constructor(
    private readonly animation: Animation,
    private readonly host: HTMLElement,
    private readonly redraw: () => void,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    const canvas = this.renderer.domElement;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `Drawing of ${animation.title}: ${animation.bodies.map((body) => body.name).join(", ")}`);
    host.append(canvas);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", redraw);
    this.measure();
    this.unit = 0.008 * (this.box.getSize(new Vector3()).length() || 1);
    this.build();
    this.resize();
    this.fit();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.host;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = Math.max(1, clientWidth) / Math.max(1, clientHeight);
    this.camera.updateProjectionMatrix();
    // A new size empties the canvas; waiting for the next turn would show it empty.
    if (this.shown) this.draw(this.shown.frame, this.shown.options);
    else this.redraw();
  }

  fit(): void {
    const centre = this.box.getCenter(new Vector3());
    const radius = this.box.getSize(new Vector3()).length() / 2 || 1;
    const narrow = Math.min(1, this.camera.aspect);
    const distance = radius / Math.sin(((this.camera.fov / 2) * Math.PI) / 180) / narrow;
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(new Vector3(0.9, -1.5, 0.8).normalize().multiplyScalar(distance));
    this.camera.near = distance / 500;
    this.camera.far = distance * 50;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.redraw();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.controls.update();
    this.redraw();
  }

  draw(frame: Frame, options: ViewOptions): void {
    this.shown = { frame, options };
    for (const { body, group } of this.groups) {
      const { position, quaternion } = poseAt(body.track, frame);
      group.visible = position.every(Number.isFinite);
      group.position.set(...position);
      group.quaternion.set(quaternion[1], quaternion[2], quaternion[3], quaternion[0]);
    }
    const at = (side: Attachment) => place(bodyPose(side.body, frame), side.at);
    for (const { joint, mesh } of this.pins) mesh.position.set(...at(joint.second));
    for (const { element, line, coil } of this.lines) {
      const [a, b] = [at(element.first), at(element.second)];
      const points = coil ? helix(a, b, 2 * this.unit) : [...a, ...b];
      line.geometry.attributes.position!.array.set(points);
      line.geometry.attributes.position!.needsUpdate = true;
    }
    for (const { trace, line, dot } of this.traces) {
      line.visible = dot.visible = options.traces !== "off";
      line.geometry.setDrawRange(0, options.traces === "whole" ? Infinity : frame.index + 1);
      dot.position.set(...place(bodyPose(trace.body, frame), trace.at));
    }
    this.render(options.theme);
    this.names(options.names);
  }

  async picture(_kind: PictureKind): Promise<Blob> {
    this.render(LIGHT);
    const blob = await new Promise<Blob | null>((resolve) => this.renderer.domElement.toBlob(resolve));
    if (this.shown) this.draw(this.shown.frame, this.shown.options);
    if (!blob) throw new Error("the browser could not write the picture");
    return blob;
  }

  private render(theme: Theme): void {
    this.scene.background = new Color(theme.background);
    for (const child of this.grid.children) {
      if (child instanceof GridHelper) (child.material as { color?: Color }).color?.set(theme.axis);
    }
    this.renderer.render(this.scene, this.camera);
  }

  private names(shown: boolean): void {
    const { clientWidth, clientHeight } = this.host;
    for (const { group, label } of this.groups) {
      label.hidden = !shown || !group.visible;
      if (label.hidden) continue;
      const p = group.position.clone().project(this.camera);
      label.style.transform = `translate(-50%, -50%) translate(${((p.x + 1) / 2) * clientWidth}px, ${((1 - p.y) / 2) * clientHeight}px)`;
    }
  }

  /** The box around everything at every instant. */
  private measure(): void {
    const frames = sampleFrames(this.animation.time.length, 200);
    const add = (body: Body | null, x: number, y: number, z: number) => {
      for (const frame of frames) {
        const p = place(bodyPose(body, frame), [x, y, z]);
        if (p.every(Number.isFinite)) this.box.expandByPoint(new Vector3(...p));
      }
    };
    for (const body of this.animation.bodies) add(body, 0, 0, 0);
    for (const element of [...this.animation.joints, ...this.animation.springs]) {
      for (const side of [element.first, element.second]) add(side.body, ...side.at);
    }
    for (const body of this.animation.bodies) {
      const box = new Box3().setFromObject(bodyGroup(this.animation, body, body.shapes, body.color, 0.001));
      if (box.isEmpty()) continue;
      for (const x of [box.min.x, box.max.x]) for (const y of [box.min.y, box.max.y]) for (const z of [box.min.z, box.max.z]) add(body, x, y, z);
    }
  }

  private build(): void {
    const { animation, scene, unit } = this;
    scene.add(new AmbientLight(0xffffff, 1.7));
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(1, -2, 3);
    scene.add(sun);
    this.floor();
    scene.add(bodyGroup(animation, null, animation.groundShapes, "#999999", unit));
    for (const body of animation.bodies) {
      const group = bodyGroup(animation, body, body.shapes, body.color, unit);
      const label = make("span", "label", body.name);
      this.host.append(label);
      scene.add(group);
      this.groups.push({ body, group, label });
    }
    for (const joint of animation.joints) {
      const mesh = new Mesh(new SphereGeometry(1.35 * unit, 20, 14), material(joint.first.body === null || joint.second.body === null ? "#555b66" : "#d8dade"));
      scene.add(mesh);
      this.pins.push({ joint, mesh });
      if (joint.kind === "distance") this.addLine(joint, false);
    }
    for (const spring of animation.springs) this.addLine(spring, true);
    for (const trace of animation.traces) this.addTrace(trace);
  }

  private addLine(element: Joint, coil: boolean): void {
    const line = polyline(coil ? helix([0, 0, 0], [1, 0, 0], 1) : [0, 0, 0, 0, 0, 0], "#6b7280");
    line.frustumCulled = false;
    this.scene.add(line);
    this.lines.push({ element, line, coil });
  }

  private addTrace(trace: Trace): void {
    const points = sampleFrames(this.animation.time.length, Infinity).flatMap((frame) => [...place(bodyPose(trace.body, frame), trace.at)]);
    const color = mix(trace.body?.color ?? "#777777", "#000000", 0.15);
    const line = polyline(points, color);
    const dot = new Mesh(new SphereGeometry(0.7 * this.unit, 16, 12), material(color));
    this.scene.add(line, dot);
    this.traces.push({ trace, line, dot });
  }

  /** A grid of round cells under the machine, and the ground axes (x red, y green, z blue). */
  private floor(): void {
    const size = this.box.getSize(new Vector3()).length() || 1;
    const cell = roundDown125(size / 6);
    const count = 2 * Math.ceil((0.8 * size) / cell);
    const grid = new GridHelper(count * cell, count, 0xffffff, 0xffffff);
    grid.rotateX(Math.PI / 2);
    const middle = this.box.getCenter(new Vector3());
    grid.position.set(Math.round(middle.x / cell) * cell, Math.round(middle.y / cell) * cell, Math.min(0, this.box.min.z));
    const axes = new AxesHelper(cell / 2);
    this.grid.add(grid, axes);
    this.scene.add(this.grid);
  }
}
