import type { Animation } from "../data/contract";
import { showMessage } from "../message";
import type { View } from "../view";
import { SpatialView } from "./spatial-view";

/** The picture in space, or a message where the browser has no WebGL; plots and tables work without it. */
export function openSpatialView(animation: Animation, host: HTMLElement, tooltip: HTMLElement, redraw: () => void): View | null {
  try {
    return new SpatialView(animation, host, tooltip, redraw);
  } catch (error) {
    showMessage("This browser cannot draw in three dimensions", [
      "The picture needs WebGL, which is switched off or missing here. Switch on hardware acceleration, or open the page in another browser. The plots and the summary work all the same.",
      error instanceof Error ? error.message : String(error),
    ]);
    return null;
  }
}
