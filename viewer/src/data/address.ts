/** What the address of the page asks for: `?frame=12`, `#t=0.5&plot=crank.angle,rod.angle&x=crank.angle&forces=1&names=1&from=z`. */
export interface Wishes {
  readonly time: number | null;
  readonly frame: number | null;
  /** Names of channels; null where the address does not say. */
  readonly plot: readonly string[] | null;
  readonly x: string | null;
  /** Length of the arrows of forces, times what they have by themselves; 0 for none. */
  readonly forces: number | null;
  /** Are the names of bodies shown? */
  readonly names: boolean | null;
  /** Are frames of bodies and axes of joints shown, in space? */
  readonly frames: boolean | null;
  readonly axes: boolean | null;
  /** Where a machine in space is looked at from. */
  readonly from: string | null;
}

export function readAddress(search: string, hash: string): Wishes {
  const parameters = new URLSearchParams(search);
  for (const [key, value] of new URLSearchParams(hash.replace(/^#/, ""))) parameters.set(key, value);
  const plot = parameters.get("plot");
  return {
    time: number(parameters.get("t")),
    frame: number(parameters.get("frame")),
    plot: plot === null ? null : plot.split(",").filter((name) => name !== ""),
    x: parameters.get("x"),
    forces: number(parameters.get("forces")),
    names: flag(parameters.get("names")),
    frames: flag(parameters.get("frames")),
    axes: flag(parameters.get("axes")),
    from: parameters.get("from"),
  };
}

function number(text: string | null): number | null {
  if (text === null || text.trim() === "") return null;
  const value = Number(text);
  return Number.isFinite(value) ? value : null;
}

function flag(text: string | null): boolean | null {
  return text === "1" ? true : text === "0" ? false : null;
}
