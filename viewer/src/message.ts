import { byId, make } from "./dom";

/** Says over the picture why there is none. */
export function showMessage(title: string, lines: readonly string[]): void {
  const message = byId("message");
  message.hidden = false;
  message.replaceChildren(make("h2", "", title), ...lines.map((line) => make("p", "", line)));
}
