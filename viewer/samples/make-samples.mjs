// Writes dist/samples/*.html: the built page with the data of some mechanisms, to look at in a browser.
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import * as mechanisms from "./mechanisms.mjs";
import * as spatial from "./spatial.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "../dist/samples");
await mkdir(out, { recursive: true });

async function write(page, samples) {
  const template = await readFile(join(here, "../dist", page), "utf8");
  for (const [name, make] of Object.entries(samples)) {
    const json = JSON.stringify(make()).replaceAll("<", "\\u003c");
    const text = template.replace('type="application/json">', (opening) => opening + json);
    await writeFile(join(out, `${name}.html`), text);
    console.log(`dist/samples/${name}.html  ${(text.length / 1000).toFixed(0)} kB`);
  }
}

await write("viewer.html", { ...mechanisms, bareChain: () => mechanisms.chain(8, false) });
await write("viewer-spatial.html", spatial);
