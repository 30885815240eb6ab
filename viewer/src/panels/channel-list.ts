import { search } from "../data/choice";
import type { Channel } from "../data/contract";
import { byId, make } from "../dom";

/** A list with thousands of rows is of no use to anybody; the search finds the rest. */
const LONGEST_LIST = 300;

/** The searchable list from which channels are chosen. */
export class ChannelList {
  private readonly input = byId<HTMLInputElement>("search");
  private readonly list = byId("channel-list");

  constructor(
    private readonly channels: readonly Channel[],
    private readonly isChosen: (channel: Channel) => boolean,
    private readonly choose: (channel: Channel, chosen: boolean) => void,
  ) {
    this.input.addEventListener("input", () => this.show());
  }

  show(): void {
    const found = search(this.channels, this.input.value);
    const rows: HTMLElement[] = found.slice(0, LONGEST_LIST).map((channel) => this.row(channel));
    if (found.length === 0) rows.push(make("li", "more", "No channel has these words."));
    if (found.length > LONGEST_LIST) rows.push(make("li", "more", `${found.length - LONGEST_LIST} more: search for them.`));
    this.list.replaceChildren(...rows);
    const chosen = this.channels.filter(this.isChosen).length;
    byId("channels-title").textContent = `Channels (${chosen} of ${this.channels.length} shown)`;
  }

  private row(channel: Channel): HTMLElement {
    const box = make("input", "");
    box.type = "checkbox";
    box.checked = this.isChosen(channel);
    box.addEventListener("change", () => this.choose(channel, box.checked));
    const label = make("label", "", box, make("span", "name", channel.name), make("span", "unit", channel.unit));
    label.title = channel.meaning;
    return make("li", "", label);
  }
}
