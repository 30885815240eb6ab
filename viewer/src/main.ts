import { ContractError } from "./data/contract";
import { readAnimation } from "./data/read";
import { byId } from "./dom";
import { showMessage } from "./message";
import { Page } from "./page";

function start(): void {
  const text = byId("dalembert-data").textContent ?? "";
  try {
    new Page(readAnimation(text));
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

start();
