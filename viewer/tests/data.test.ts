import assert from "node:assert/strict";
import { test } from "node:test";
import { readAddress } from "../src/data/address";
import { axisRange, extent, firstChoice, search } from "../src/data/choice";
import type { Channel } from "../src/data/contract";
import { decimalsFor, formatLength, formatNumber, formatTime, roundDown125 } from "../src/data/format";
import { mix, normalColor } from "../src/data/palette";

const channel = (name: string, unit: string, values: number[], meaning = ""): Channel => ({ name, unit, meaning, values: Float64Array.from(values) });

const silent = { time: null, frame: null, plot: null, x: null, forces: null, names: null, frames: null, axes: null, from: null };

test("the address names instant and channels", () => {
  assert.deepEqual(readAddress("?frame=12", ""), { ...silent, frame: 12 });
  assert.deepEqual(readAddress("", "#t=0.5&plot=a.b,c%20d&x=a.b&forces=2"), { ...silent, time: 0.5, plot: ["a.b", "c d"], x: "a.b", forces: 2 });
  assert.deepEqual(readAddress("", "#plot="), { ...silent, plot: [] });
  assert.deepEqual(readAddress("", "#names=1&frames=0&axes=yes&from=z"), { ...silent, names: true, frames: false, from: "z" });
  assert.equal(readAddress("?frame=x", "#t=").frame, null);
});

test("numbers are short, with a true minus", () => {
  assert.equal(formatNumber(-0.123456), "−0.12346");
  assert.equal(formatNumber(1234567), "1.235e6");
  assert.equal(formatNumber(2e-7), "2.000e−7");
  assert.equal(formatNumber(0), "0");
  assert.equal(formatNumber(NaN), "–");
  assert.equal(formatTime(0.1, 0.01), "0.10");
  assert.equal(formatTime(0.1, 1 / 120), "0.100");
  assert.equal(decimalsFor(0.25), 2);
  assert.equal(decimalsFor(5), 0);
  assert.equal(formatLength(0.05), "50 mm");
  assert.equal(formatLength(1), "1 m");
  assert.equal(formatLength(2000), "2 km");
  assert.equal(formatLength(5e-5), "50 µm");
});

test("round steps are 1, 2 or 5 times a power of ten, not above the limit", () => {
  for (const [limit, step] of [[1, 1], [1.9, 1], [2, 2], [4.99, 2], [7, 5], [0.0301, 0.02], [1e-3, 1e-3], [99, 50]] as const) {
    assert.ok(Math.abs(roundDown125(limit) / step - 1) < 1e-12, `${limit} gives ${roundDown125(limit)}`);
  }
});

test("a search needs every word, anywhere", () => {
  const all = [channel("crank.angle", "rad", [0]), channel("rod.angle", "rad", [0]), channel("A.force", "N", [0], "reaction at the crank")];
  assert.deepEqual(search(all, "CRANK").map((c) => c.name), ["crank.angle", "A.force"]);
  assert.deepEqual(search(all, "angle rod").map((c) => c.name), ["rod.angle"]);
  assert.equal(search(all, " ").length, 3);
});

test("the first plot shows what moves, of one unit", () => {
  const all = [channel("still", "m", [1, 1]), channel("a", "rad", [0, 1]), channel("b", "m", [0, 1]), channel("c", "rad", [0, 2])];
  assert.deepEqual(firstChoice(all).map((c) => c.name), ["a", "c"]);
  assert.deepEqual(firstChoice(all.slice(0, 1)).map((c) => c.name), ["still"]);
  assert.deepEqual(firstChoice([]), []);
  // A pin that stays at the origin to rounding does not move.
  assert.deepEqual(firstChoice([channel("pin", "m", [0, 1e-26]), ...all]).map((c) => c.name), ["a", "c"]);
});

test("an axis does not blow rounding errors up", () => {
  assert.deepEqual(extent(Float64Array.of(NaN, 2, -1)), { min: -1, max: 2 });
  assert.deepEqual(extent(Float64Array.of(NaN)), { min: 0, max: 0 });
  assert.deepEqual(axisRange(0, 0), [-1, 1]);
  const [low, high] = axisRange(2, 2 + 1e-12);
  assert.ok(Math.abs(low - 1) < 1e-11 && Math.abs(high - 3) < 1e-11);
  assert.deepEqual(axisRange(0, 100), [-6, 106]);
  assert.deepEqual(axisRange(Infinity, -Infinity), [0, 1]);
});

test("colours are checked before they reach the page", () => {
  assert.equal(normalColor("#ABC"), "#aabbcc");
  assert.equal(normalColor("#4477AA"), "#4477aa");
  for (const wrong of ["red", "#12345", "#1234567", null, 5, "#fff;}"]) assert.equal(normalColor(wrong), null);
  assert.equal(mix("#000000", "#ffffff", 0.5), "#808080");
});
