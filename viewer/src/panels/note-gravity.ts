/** How grave a note of the run is: what stopped it, what casts doubt on it, or only worth knowing. */
export type Gravity = "error" | "warning" | "plain";

/** The gravity of a note, from the word with which it begins. */
export function gravity(note: string): Gravity {
  const word = /^\s*(warning|error)\b/i.exec(note)?.[1]?.toLowerCase();
  return word === "error" || word === "warning" ? word : "plain";
}

/** Order of notes: the gravest first. */
export function rank(of: Gravity): number {
  return ["error", "warning", "plain"].indexOf(of);
}
