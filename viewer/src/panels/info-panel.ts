import type { Animation } from "../data/contract";
import { byId, make } from "../dom";

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
  section.replaceChildren(...notes.map((note) => make("p", isWarning(note) ? "note warning" : "note", note)));
  const warnings = notes.filter(isWarning).length;
  const badge = byId("notes-badge");
  badge.hidden = warnings === 0;
  badge.textContent = warnings === 1 ? "⚠ 1 warning" : `⚠ ${warnings} warnings`;
  badge.addEventListener("click", () => section.scrollIntoView({ behavior: "smooth" }));
}

function isWarning(note: string): boolean {
  return /^\s*(warning|error)\b/i.test(note);
}
