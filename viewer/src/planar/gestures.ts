import type { Point2 } from "../data/contract";

export interface GestureActions {
  pan(dx: number, dy: number): void;
  zoom(at: Point2, factor: number): void;
  fit(): void;
  /** The pointer rests here; null when it has left. */
  point(at: Point2 | null): void;
}

/** Mouse, wheel and fingers on the picture. */
export class Gestures {
  private readonly down = new Map<number, Point2>();

  constructor(
    private readonly element: HTMLElement,
    private readonly actions: GestureActions,
  ) {
    element.addEventListener("pointerdown", (event) => {
      element.setPointerCapture(event.pointerId);
      this.down.set(event.pointerId, this.at(event));
      element.classList.add("dragged");
      actions.point(this.at(event));
    });
    element.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"] as const) {
      element.addEventListener(name, (event) => {
        this.down.delete(event.pointerId);
        if (this.down.size === 0) element.classList.remove("dragged");
      });
    }
    element.addEventListener("pointerleave", () => actions.point(null));
    element.addEventListener("dblclick", () => actions.fit());
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        // Lines and pages of a wheel are about 16 and 400 pixels.
        const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
        actions.zoom(this.at(event), Math.exp(-Math.max(-300, Math.min(300, pixels)) * 0.0016));
      },
      { passive: false },
    );
  }

  private move(event: PointerEvent): void {
    const now = this.at(event);
    const before = this.down.get(event.pointerId);
    if (before && this.down.size === 1) this.actions.pan(now[0] - before[0], now[1] - before[1]);
    if (before && this.down.size === 2) {
      const other = [...this.down].find(([id]) => id !== event.pointerId)![1];
      const span = (p: Point2) => Math.hypot(p[0] - other[0], p[1] - other[1]);
      const middle: Point2 = [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2];
      this.actions.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
      if (span(before) > 0) this.actions.zoom(middle, span(now) / span(before));
    }
    if (before) this.down.set(event.pointerId, now);
    this.actions.point(now);
  }

  private at(event: MouseEvent): Point2 {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}
