import assert from "node:assert/strict";
import { test } from "node:test";
import { defaultSpeed, nextSpeed, Player, speedSteps } from "../src/motion/player";

test("the default speed makes the run last about ten seconds", () => {
  for (const duration of [1e-5, 0.004, 0.4, 1, 9, 10, 37, 3600]) {
    const seconds = duration / defaultSpeed(duration);
    assert.ok(seconds > 6 && seconds < 16, `${duration} s would last ${seconds} s`);
  }
  assert.equal(defaultSpeed(10), 1);
  assert.equal(defaultSpeed(0), 1);
});

test("the speeds reach from 0.001 to 10, further where a run needs it", () => {
  const usual = speedSteps(1);
  assert.equal(usual[0], 0.001);
  assert.equal(usual.at(-1), 10);
  assert.equal(usual.length, 13);
  assert.ok(speedSteps(500).includes(500));
  assert.ok(speedSteps(2e-6).includes(2e-6));
  assert.equal(nextSpeed(usual, 1, 1), 2);
  assert.equal(nextSpeed(usual, 1, -1), 0.5);
  assert.equal(nextSpeed(usual, 10, 1), 10);
});

test("playing loops without losing time, or stops at the end", () => {
  const player = new Player(Float64Array.of(1, 2, 3));
  player.speed = 1;
  player.play();
  player.advance(2.25);
  assert.equal(player.time, 1.25);
  assert.ok(player.playing);
  player.loop = false;
  player.advance(5);
  assert.equal(player.time, 3);
  assert.ok(!player.playing);
  player.play();
  assert.equal(player.time, 1);
});

test("steps go to frames and stay inside", () => {
  const player = new Player(Float64Array.of(0, 0.5, 2));
  player.play();
  player.seek(0.6);
  player.step(1);
  assert.equal(player.time, 2);
  assert.ok(!player.playing);
  player.step(1);
  assert.equal(player.time, 2);
  player.toFrame(-3);
  assert.equal(player.time, 0);
  player.seek(NaN);
  assert.equal(player.time, 0);
  player.seek(99);
  assert.equal(player.time, 2);
});

test("a single instant cannot be played", () => {
  const player = new Player(Float64Array.of(5));
  player.toggle();
  assert.ok(!player.playing && !player.moves);
  assert.equal(player.time, 5);
});
