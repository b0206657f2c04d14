/** Every mechanism of the list moves, and its page has the numbers of its text. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const bytes = readFileSync(new URL("../site/kin.wasm", import.meta.url));
const { exports: kin } = new WebAssembly.Instance(new WebAssembly.Module(bytes), {});

/** The answer to a question, as `page/worker.mjs` asks it. */
function ask(question) {
  const text = new TextEncoder().encode(JSON.stringify(question));
  const start = kin.reserve(text.length);
  new Uint8Array(kin.memory.buffer, start, text.length).set(text);
  const length = kin.ask(start, text.length);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(kin.memory.buffer, kin.answered(), length)));
}

test("every mechanism of the list has no mistakes, and moves", () => {
  const { examples } = ask({ ask: "examples" });
  assert.equal(examples.length, 37);
  for (const { name, text } of examples) {
    const { check } = ask({ ask: "check", text });
    assert.deepEqual(
      check.mistakes.filter(({ severity }) => severity === "error"),
      [],
      name,
    );
    const { report, refused } = ask({ ask: "motion", text });
    assert.equal(refused, undefined, `${name}: ${refused}`);
    assert.equal(report.name, name);
    assert.ok(report.solver !== null || report.frames.length > 0, name);
    const { text: formatted } = ask({ ask: "format", text });
    assert.equal(formatted, text, name);
  }
});
