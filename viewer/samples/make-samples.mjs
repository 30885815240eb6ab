// Writes dist/samples/*.html: the built page with the data of some mechanisms, to look at in a browser.
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import * as mechanisms from "./mechanisms.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "../dist/samples");
const template = await readFile(join(here, "../dist/viewer.html"), "utf8");
await mkdir(out, { recursive: true });
for (const [name, make] of Object.entries({ ...mechanisms, bareChain: () => mechanisms.chain(8, false) })) {
  const json = JSON.stringify(make()).replaceAll("<", "\\u003c");
  const page = template.replace('type="application/json">', (opening) => opening + json);
  await writeFile(join(out, `${name}.html`), page);
  console.log(`dist/samples/${name}.html  ${(page.length / 1000).toFixed(0)} kB`);
}
