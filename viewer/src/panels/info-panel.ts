import type { Animation } from "../data/contract";
import { byId, make } from "../dom";
import { gravity, rank } from "./note-gravity";

/** Title, notes and summary of the run. */
export function showInfo(animation: Animation): void {
  document.title = `${animation.title} – dalembert`;
  byId("title").textContent = animation.title;
  const bodies = animation.bodies.length;
  byId("subtitle").textContent = [animation.analysis, animation.space, `${bodies} ${bodies === 1 ? "body" : "bodies"}`].filter((part) => part !== "").join(" · ");
  showNotes([...animation.notes, ...animation.skipped]);
  const rows = animation.summary.map(([name, value]) => make("tr", "", make("td", "", name), make("td", "", value)));
  byId("summary").hidden = rows.length === 0;
  byId("summary").querySelector("tbody")!.replaceChildren(...rows);
}

function showNotes(notes: readonly string[]): void {
  const section = byId("notes");
  section.hidden = notes.length === 0;
  // What stopped the run comes first.
  const sorted = [...notes].sort((a, b) => rank(gravity(a)) - rank(gravity(b)));
  section.replaceChildren(...sorted.map((note) => make("p", `note ${gravity(note)}`, note)));
  const stops = notes.filter((note) => gravity(note) === "error").length;
  const warnings = notes.filter((note) => gravity(note) === "warning").length;
  const badge = byId("notes-badge");
  badge.hidden = stops + warnings === 0;
  badge.classList.toggle("error", stops > 0);
  const counted = warnings === 1 ? "1 warning" : `${warnings} warnings`;
  badge.textContent = `⚠ ${[...(stops > 0 ? ["run stopped"] : []), ...(warnings > 0 ? [counted] : [])].join(", ")}`;
  badge.addEventListener("click", () => section.scrollIntoView({ behavior: "smooth" }));
}
