import { start } from "./main";
import { openSpatialView } from "./spatial/open";

// Planar machines lie in the plane z = 0 and can be drawn here too.
start(openSpatialView, () => null);
