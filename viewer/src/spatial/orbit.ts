import { PerspectiveCamera, Vector3, type Box3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Vec3 } from "../data/contract";
import { fitDistance } from "./fit-distance";

const ANGLE = 32;
/** Room around the machine, as a part of the distance. */
const MARGIN = 1.08;
/** Seen from the right, the front and above, as the first picture is. */
export const ISOMETRIC: Vec3 = [1, -1.45, 0.85];
/** The picture never turns upside down: it stops this far from the poles [rad]. */
const POLE = 0.01;

/** The eye: turned, moved and brought nearer by mouse, fingers and keys; z is up. */
export class Orbit {
  readonly camera = new PerspectiveCamera(ANGLE, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private direction = new Vector3(...ISOMETRIC).normalize();
  private touched = false;

  constructor(
    canvas: HTMLElement,
    private readonly box: Box3,
    changed: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("start", () => (this.touched = true));
    this.controls.addEventListener("change", changed);
    canvas.addEventListener("dblclick", () => this.fit());
  }

  resize(width: number, height: number): void {
    this.camera.aspect = Math.max(1, width) / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    if (!this.touched) this.fit();
  }

  /** Shows the whole motion from a direction; without one, from where the last was. */
  fit(direction?: Vec3): void {
    if (direction) this.direction.set(...direction).normalize();
    this.touched = false;
    const centre = this.box.getCenter(new Vector3());
    const distance = MARGIN * fitDistance(this.box, this.direction, this.camera.fov, this.camera.aspect);
    this.look(centre, this.direction.clone().multiplyScalar(distance));
    this.camera.near = distance / 400;
    this.camera.far = distance * 60;
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = distance / 200;
    this.controls.maxDistance = distance * 20;
    this.controls.update();
  }

  zoom(factor: number): void {
    this.touched = true;
    this.look(this.controls.target, this.offset().divideScalar(factor));
    this.controls.update();
  }

  /** Goes around the machine by angles [rad]. */
  turn(right: number, up: number): void {
    this.touched = true;
    const offset = this.offset();
    const radius = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) + right;
    const polar = Math.min(Math.PI - POLE, Math.max(POLE, Math.acos(offset.z / radius) - up));
    this.look(this.controls.target, new Vector3(Math.sin(polar) * Math.cos(azimuth), Math.sin(polar) * Math.sin(azimuth), Math.cos(polar)).multiplyScalar(radius));
    this.controls.update();
  }

  /** Moves sideways and upwards by parts of the picture's height. */
  move(right: number, up: number): void {
    this.touched = true;
    const offset = this.offset();
    const height = 2 * offset.length() * Math.tan((ANGLE * Math.PI) / 360);
    const x = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0).multiplyScalar(right * height);
    const y = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1).multiplyScalar(up * height);
    this.look(this.controls.target.clone().add(x).add(y), offset);
    this.controls.update();
  }

  /** Pixels a metre at the point that the eye looks at, in a picture of a height. */
  pixelsPerMetre(height: number): number {
    return height / (2 * this.offset().length() * Math.tan((ANGLE * Math.PI) / 360));
  }

  private offset(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target);
  }

  private look(target: Vector3, offset: Vector3): void {
    this.controls.target.copy(target);
    this.camera.position.copy(target).add(offset);
  }
}
