/** What the address of the page asks for: `?frame=12`, `#t=0.5&plot=crank.angle,rod.angle&x=crank.angle&forces=1`. */
export interface Wishes {
  readonly time: number | null;
  readonly frame: number | null;
  /** Names of channels; null where the address does not say. */
  readonly plot: readonly string[] | null;
  readonly x: string | null;
  /** Length of the arrows of forces, times what they have by themselves; 0 for none. */
  readonly forces: number | null;
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
  };
}

function number(text: string | null): number | null {
  if (text === null || text.trim() === "") return null;
  const value = Number(text);
  return Number.isFinite(value) ? value : null;
}
