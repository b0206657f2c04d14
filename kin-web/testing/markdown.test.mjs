/** Chapters become pages as GitHub shows them, and links to nothing are mistakes. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { createLinks } from "../book/links.mjs";
import { render } from "../book/markdown.mjs";
import { readAddress } from "../page/address.mjs";

const docs = new URL("../../docs/", import.meta.url).pathname;

test("a chapter becomes HTML, with the identities that GitHub gives to headings", async () => {
  const { html, headings, lives } = await render(
    "# A `b`, *c*\n\n1 < 2, [there](x.md)\n\n| a |\n|---|\n| 1 |\n",
    (to) => to,
  );
  assert.deepEqual([headings, lives], [["a-b-c"], false]);
  assert.match(html, /<h1 id="a-b-c">A <code>b<\/code>, <em>c<\/em><\/h1>/);
  assert.match(html, /<p>1 &lt; 2, <a href="x\.md">there<\/a><\/p>/);
  assert.match(html, /<div class="scroll" tabindex="0"><table>[^]*<\/table><\/div>/);
});

test("lines that only tests need are hidden in programs alone", async () => {
  const { html } = await render("```rust\n# use a;\nlet b = 1;\n```\n\n```sh\n# a remark\n```\n", String);
  assert.doesNotMatch(html, /use a/);
  assert.match(html, /let b = 1;/);
  assert.match(html, /# a remark/);
});

test("the block of a file holds its text, and a link with it", async () => {
  const { html, lives } = await render("```kin\nkin 1\nx > 0;\n```\n", String);
  assert.equal(lives, true);
  assert.match(html, /<code>kin 1\nx &gt; 0;<\/code>/);
  const [, hash] = /href="\.\.\/index\.html#([^"]+)"/.exec(html);
  assert.equal((await readAddress(hash)).text, "kin 1\nx > 0;");
});

test("links lead to chapters, headings and files that are there", () => {
  const links = createLinks(docs);
  assert.equal(links.addressIn("cycle", "laws.md#a"), "laws.html#a");
  assert.equal(links.addressIn("cycle", "#b"), "#b");
  assert.equal(links.addressIn("cycle", "https://example.org/"), "https://example.org/");
  assert.equal(links.addressIn("cycle", "figures/page.svg"), "figures/page.svg");
  assert.throws(() => links.addressIn("cycle", "figures/none.svg"), /cycle\.md links to nothing: figures\/none\.svg/);
  assert.deepEqual([...links.files], ["figures/page.svg"]);
  const headings = { cycle: ["b"], laws: ["a"] };
  links.check(new Map(Object.entries(headings)));
  assert.throws(
    () => links.check(new Map(Object.entries({ ...headings, laws: [] }))),
    /cycle\.md links to nothing: laws/,
  );
  assert.throws(() => links.check(new Map([["cycle", ["b"]]])), /laws\.md#a/);
});
