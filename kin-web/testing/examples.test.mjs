/** Every mechanism of the list moves, and its page has the numbers of its text. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { ask as askOf } from "../page/ask.mjs";
import { withFirstLoads } from "../page/loads.mjs";

const bytes = readFileSync(new URL("../site/kin.wasm", import.meta.url));
const { exports: kin } = new WebAssembly.Instance(new WebAssembly.Module(bytes), {});

const ask = (question) => askOf(kin, question);

test("every mechanism of the list has no mistakes, and moves", () => {
  const { examples } = ask({ ask: "examples" });
  assert.equal(examples.length, 37);
  for (const { name, text } of examples) {
    const { check, report, refused } = ask({ ask: "motion", text }).motion;
    assert.deepEqual(
      check.mistakes.filter(({ severity }) => severity === "error"),
      [],
      name,
    );
    assert.equal(refused, null, `${name}: ${refused}`);
    assert.equal(report.name, name);
    assert.ok(report.solver !== null || report.frames.length > 0, name);
    const { text: formatted } = ask({ ask: "format", text });
    assert.equal(formatted, text, name);
  }
});

test("loads to begin with have no mistakes, also with their remarks", () => {
  for (const { name, text } of ask({ ask: "examples" }).examples) {
    const begun = withFirstLoads(text, ask({ ask: "motion", text }).motion.check.outline);
    const whole = begun.replace(/loads \{.*/s, (loads) => loads.replaceAll("// ", ""));
    for (const text of [begun, whole]) {
      const { check, refused } = ask({ ask: "motion", text }).motion;
      const errors = check.mistakes.filter(({ severity }) => severity === "error");
      assert.deepEqual(errors, [], text);
      assert.equal(refused, null, name);
    }
  }
});

test("files with loads have no mistakes, and move with their forces", () => {
  for (const file of ["crank_press", "rack_press"]) {
    const text = readFileSync(new URL(`../../kin-studio/examples/${file}.kin`, import.meta.url), "utf8");
    const { check, report } = ask({ ask: "motion", text }).motion;
    assert.deepEqual(check.mistakes, [], file);
    assert.ok(report.forces.joints.length > 0, file);
    const wrong = ask({ ask: "motion", text: text.replace("mass of ram", "mass of rams") }).motion;
    assert.match(wrong.check.mistakes[0].message, /there is no body `rams`; did you mean `ram`/);
  }
});
