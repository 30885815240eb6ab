import assert from "node:assert/strict";
import { test } from "node:test";
import { gravity, rank } from "../src/panels/note-gravity";

test("notes are told apart by their first word", () => {
  assert.equal(gravity("error: motor cannot drive the rod"), "error");
  assert.equal(gravity("Warning: no mass is given for rod"), "warning");
  assert.equal(gravity("assembly moved rod by 1 m"), "plain");
  assert.equal(gravity("errors of the run are small"), "plain");
});

test("what stopped a run comes first", () => {
  const notes = ["moved", "warning: mass", "error: stop"];
  const sorted = [...notes].sort((a, b) => rank(gravity(a)) - rank(gravity(b)));
  assert.deepEqual(sorted, ["error: stop", "warning: mass", "moved"]);
});
