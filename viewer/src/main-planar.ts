import { start } from "./main";
import { PlanarView } from "./planar/planar-view";

start(
  (...stage) => new PlanarView(...stage),
  ({ space }) => (space === "planar" ? null : "This page draws planar machines, and its data is of a spatial one. Write the page anew with dalembert."),
);
