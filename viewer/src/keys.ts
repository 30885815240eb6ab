/** What a key does, by the name of the key. */
export type KeyActions = Readonly<Record<string, (event: KeyboardEvent) => void>>;

/** Keys work everywhere but where they already mean something: in text, lists and on focused buttons. */
export function listenToKeys(actions: KeyActions): void {
  window.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isBusy(event)) return;
    const action = actions[event.key] ?? actions[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    action(event);
  });
  // A button that was clicked with the mouse must not keep the space bar.
  window.addEventListener("click", (event) => {
    const target = event.target;
    if (event.detail > 0 && target instanceof Element) target.closest("button")?.blur();
  });
}

function isBusy(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog[open]")) return true;
  if (target instanceof HTMLInputElement) return target.type !== "range" && !(target.type === "checkbox" && event.key !== " ");
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return event.key === " " && (target instanceof HTMLButtonElement || target.tagName === "SUMMARY");
}
