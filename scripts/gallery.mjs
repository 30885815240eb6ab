// Draws the pictures of docs/gallery again from the models in examples.
//
//   npm ci --prefix viewer          once
//   node scripts/gallery.mjs        all of them
//   node scripts/gallery.mjs watt   some of them
//
// The program gives the motion (`dalembert view`). Planar machines are drawn by the viewer's own code, without a browser;
// for machines in space a headless Chromium takes a picture of the page.
// The program is built by cargo, or named by the environment variable DALEMBERT; Chromium by CHROMIUM.
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const gallery = join(root, "docs/gallery");

// When each picture is taken, as a share of the run; a picture without an entry shows its start.
const MOMENTS = {
  "cam-flat": 0.04,
  "cam-knife-edge": 0.06,
  "bicycle-wheel-gyroscope": 0.15,
  "bracket-pendulum": 0.1,
  bricard: 0.07,
  "cam-roller": 0.05,
  "cardan-gyroscope": 0.4,
  catenary: 0.05,
  "constant-velocity-joint": 0.36,
  "crank-rocker": 0.11,
  "double-crank": 0.09,
  "double-parallelogram": 0.04,
  "double-pendulum": 0.36,
  "double-rocker": 0.02,
  "double-universal-joint": 0.06,
  "four-bar": 0.03,
  "four-revolutes": 0.14,
  "heavy-top-cuspidal": 0.6,
  "heavy-top-looping": 0.6,
  "heavy-top-steady": 0.6,
  "intermediate-axis-flip": 0.25,
  peaucellier: 0.03,
  pendulum: 0.045,
  "pendulum-moving-base": 0.05,
  "planetary-gear": 0.2,
  "quick-return": 0.08,
  "rack-and-pinion": 0.08,
  "robot-arm-forward": 0.62,
  "robot-arm-inverse": 0.3,
  "rod-and-disk": 0.25,
  "ball-in-bowl": 0.35,
  "bead-on-wire": 0.62,
  "ellipsoid-on-plane": 0.3,
  "rolling-coin": 0.55,
  "rolling-cylinder": 0.06,
  "rolling-disc": 0.62,
  "rssr-four-bar": 0.2,
  "screw-jack": 0.2,
  "slider-crank": 0.06,
  "slider-driven": 0.05,
  "steering-rack": 0.2,
  "spatial-arm-2r": 0.3,
  "spatial-arm-3r": 0.62,
  "spatial-slider-crank": 0.05,
  "stewart-platform-forward": 0.45,
  "stewart-platform-inverse": 0.2,
  "torque-free-top": 0.3,
  "universal-joint": 0.06,
  watt: 0.14,
  "worm-gear": 0.3,
};

// Plots that stand beside pictures: command, channels.
const PLOTS = {
  "cam-roller": ["inverse", "contact.force_y"],
  pendulum: ["simulate", "bar.angle", "bar.omega"],
  "quick-return": ["kinematics", "ram.vx"],
  "robot-arm-inverse": ["inverse", "actuator shoulder.moment", "actuator elbow.moment"],
  "slider-crank": ["inverse", "motor.moment"],
  "spring-damper-four-bar": ["simulate", "crank.omega", "energy.total"],
};

// Where machines in space are looked at from, if not from the corner: see the address of the page in viewer/README.md.
const WISHES = {};

const WIDTH = 640;
const MARGIN = 46;
const SPATIAL_HEIGHT = 420;
// Only the picture of the page, without what stands around it.
const BARE = `header, #player, #panel { display: none !important; } #stage { height: ${SPATIAL_HEIGHT}px !important; }`;

const drawing = await viewer();
const names = process.argv.slice(2);
const program = build();
const work = mkdtempSync(join(tmpdir(), "dalembert-gallery-"));
try {
  for (const file of readdirSync(join(root, "examples")).sort()) {
    const name = basename(file, ".toml");
    if (!file.endsWith(".toml") || (names.length > 0 && !names.includes(name))) continue;
    picture(name);
    if (name in PLOTS) plot(name);
  }
} finally {
  rmSync(work, { recursive: true });
}

function build() {
  if (process.env.DALEMBERT) return process.env.DALEMBERT;
  execFileSync("cargo", ["build", "--quiet", "--package", "dalembert-cli"], { cwd: root, stdio: "inherit" });
  const metadata = execFileSync("cargo", ["metadata", "--no-deps", "--format-version", "1"], { cwd: root, encoding: "utf8" });
  return join(JSON.parse(metadata).target_directory, "debug/dalembert");
}

/** The viewer's drawing code, bundled for this program by the viewer's own bundler. */
async function viewer() {
  const folder = join(root, "viewer");
  const { build } = createRequire(join(folder, "package.json"))("esbuild");
  const { outputFiles } = await build({
    stdin: {
      contents: `
        export { readAnimation } from "./src/data/read";
        export { Camera } from "./src/planar/camera";
        export { Figure } from "./src/planar/figure";
        export { SvgPainter } from "./src/planar/svg-painter";
        export { LIGHT } from "./src/planar/theme";`,
      resolveDir: folder,
      loader: "ts",
    },
    bundle: true,
    write: false,
    format: "esm",
    platform: "node",
  });
  const file = join(mkdtempSync(join(tmpdir(), "dalembert-viewer-")), "drawing.mjs");
  writeFileSync(file, outputFiles[0].text);
  try {
    return await import(pathToFileURL(file));
  } finally {
    rmSync(dirname(file), { recursive: true });
  }
}

function run(...words) {
  execFileSync(program, words, { stdio: ["ignore", "ignore", "inherit"] });
}

function picture(name) {
  const page = join(work, `${name}.html`);
  run("view", join(root, "examples", `${name}.toml`), "--html", page);
  const [, data] = readFileSync(page, "utf8").match(/<script id="dalembert-data" type="application\/json">(.*?)<\/script>/s);
  const animation = drawing.readAnimation(data);
  if (animation.space === "spatial") {
    photograph(name, page, animation);
    return;
  }
  const figure = new drawing.Figure(animation);
  const { bounds } = figure.layout;
  // As high as the machine asks for, within reason.
  const height = Math.round(Math.min(520, Math.max(260, ((WIDTH - 2 * MARGIN) * bounds.height) / bounds.width + 2 * MARGIN)));
  const camera = new drawing.Camera();
  camera.resize(WIDTH, height);
  camera.fit(bounds, MARGIN);
  const painter = new drawing.SvgPainter(WIDTH, height, animation.title);
  const { background } = drawing.LIGHT;
  painter.path([[[0, 0], [WIDTH, 0], [WIDTH, height], [0, height]]], true, { fill: background });
  const index = Math.round((MOMENTS[name] ?? 0) * (animation.time.length - 1));
  figure.draw(painter, camera, { index, share: 0 }, { theme: drawing.LIGHT, traces: "whole", names: false, highlighted: null });
  write(`${name}.svg`, painter.finish());
}

/** A picture of the page of a machine in space, taken by Chromium with its software renderer. */
function photograph(name, page, animation) {
  const index = Math.round((MOMENTS[name] ?? 0) * (animation.time.length - 1));
  writeFileSync(page, readFileSync(page, "utf8").replace("</style>", `${BARE}</style>`));
  const png = join(work, `${name}.png`);
  const answer = spawnSync(
    chromium(),
    [
      "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
      `--user-data-dir=${join(work, "profile")}`, `--window-size=${WIDTH},${SPATIAL_HEIGHT}`, "--virtual-time-budget=4000",
      `--screenshot=${png}`, `${pathToFileURL(page)}#frame=${index}${WISHES[name] ? `&${WISHES[name]}` : ""}`,
    ],
    { encoding: "utf8", timeout: 120_000 },
  );
  if (!existsSync(png)) throw new Error(`${name}: Chromium took no picture\n${answer.stderr}`);
  write(`${name}.png`, readFileSync(png));
}

function chromium() {
  const names = process.env.CHROMIUM ? [process.env.CHROMIUM] : ["chromium", "chromium-browser", "google-chrome"];
  const found = names.find((one) => spawnSync(one, ["--version"]).status === 0);
  if (!found) throw new Error("machines in space need Chromium (or its path in CHROMIUM)");
  return found;
}

function plot(name) {
  const [command, ...channels] = PLOTS[name];
  const results = join(work, `${name}.csv`);
  const svg = join(work, `${name}-plot.svg`);
  run(command, join(root, "examples", `${name}.toml`), "--out", results);
  run("plot", results, ...channels, "--out", svg);
  write(`${name}-plot.svg`, readFileSync(svg, "utf8"));
}

function write(file, text) {
  writeFileSync(join(gallery, file), text);
  console.log(`docs/gallery/${file}  ${(text.length / 1000).toFixed(0)} kB`);
}
