/** Colours of the figure. */
export interface Theme {
  readonly background: string;
  readonly grid: string;
  readonly axis: string;
  readonly ink: string;
  readonly quiet: string;
  /** What body colours are mixed with to fill them, and how much of it. */
  readonly fillBase: string;
  readonly fillShare: number;
  /** What body colours are mixed with to outline them, and how much of it. */
  readonly edgeBase: string;
  readonly edgeShare: number;
  /** Arrows of reactions, and of forces that elements apply. */
  readonly reaction: string;
  readonly load: string;
}

export const LIGHT: Theme = {
  background: "#fcfcfa",
  grid: "#ebebe6",
  axis: "#d3d3cc",
  ink: "#2b2f36",
  quiet: "#7b8089",
  fillBase: "#ffffff",
  fillShare: 0.62,
  edgeBase: "#000000",
  edgeShare: 0.28,
  reaction: "#c0392b",
  load: "#1f7a4d",
};

export const DARK: Theme = {
  background: "#15181d",
  grid: "#22262d",
  axis: "#353b45",
  ink: "#e4e6ea",
  quiet: "#8f96a1",
  fillBase: "#15181d",
  fillShare: 0.55,
  edgeBase: "#ffffff",
  edgeShare: 0.25,
  reaction: "#ff8a75",
  load: "#5fd49a",
};
