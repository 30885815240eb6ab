// Writes the pages of dist: template, style sheet and program in one file that asks for nothing else.
// Planar machines have a page of their own, without the library that draws in space: it is a sixth of the size.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
// The writer of a page puts the data into this element; it must stand in the page exactly once.
const PLACE = '<script id="dalembert-data" type="application/json"></script>';

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, entry)],
    absWorkingDir: here,
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2021",
    charset: "utf8",
    legalComments: "none",
    logLevel: "warning",
  }).catch(() => process.exit(1)); // esbuild has said why
  return result.outputFiles[0].text.trim();
}

// A closing tag inside the inlined text would end its element early.
function refuseClosingTag(text, tag) {
  if (text.toLowerCase().includes(`</${tag}`)) throw new Error(`the bundle contains "</${tag}"`);
  return text;
}

const PAGES = { "viewer.html": "src/main-planar.ts", "viewer-spatial.html": "src/main-spatial.ts" };

const style = refuseClosingTag(await bundle("src/style.css"), "style");
const template = await readFile(join(here, "src/page.html"), "utf8");
await mkdir(join(here, "dist"), { recursive: true });
for (const [name, entry] of Object.entries(PAGES)) {
  const script = refuseClosingTag(await bundle(entry), "script");
  // Functions as replacements: "$" in the bundle must not be read as a pattern.
  const page = template.replace("/*STYLE*/", () => style).replace("/*SCRIPT*/", () => script);
  if (page.split(PLACE).length !== 2) throw new Error(`the page must contain ${PLACE} exactly once`);
  await writeFile(join(here, "dist", name), page);
  console.log(`dist/${name}  ${(page.length / 1000).toFixed(0)} kB`);
}
