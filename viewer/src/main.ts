import { ContractError, type Animation } from "./data/contract";
import { readAnimation } from "./data/read";
import { byId } from "./dom";
import { showMessage } from "./message";
import { Page, type OpenView } from "./page";

/** Starts the page on the data that it carries; `refuse` says why this page cannot draw an animation, or nothing. */
export function start(open: OpenView, refuse: (animation: Animation) => string | null): void {
  const text = byId("dalembert-data").textContent ?? "";
  try {
    const animation = readAnimation(text);
    const reason = refuse(animation);
    if (reason !== null) throw new ContractError([reason]);
    new Page(animation, open);
  } catch (error) {
    document.body.classList.add("failed");
    document.body.dataset.state = "failed";
    if (error instanceof ContractError) showMessage("This page cannot show its data", error.problems);
    else {
      showMessage("This page failed", [error instanceof Error ? error.message : String(error)]);
      throw error;
    }
  }
}
