/** Writes the book as pages: each chapter of `SUMMARY.md` from its markdown, with the files that it shows. */
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";

import { hashOf, movingPage, policy, script, style } from "../bundles.mjs";
import { createLinks } from "./links.mjs";
import { escaped, render } from "./markdown.mjs";
import { navigation, neighbours, partsOf } from "./summary.mjs";

/** The policy of a chapter in which nothing moves. */
const STILL = "default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'";

const document = (title, policyOfPage, scripts, body) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policyOfPage}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)} – kin</title>
<link rel="stylesheet" href="book.css">
${scripts}</head>
<body>
<header>
<a class="home" href="index.html">kin</a>
<a class="to-chapters" href="#chapters">Chapters</a>
<a href="../index.html">Try it</a>
</header>
${body}</body>
</html>
`;

/**
 * @param {string} docs the folder of the markdown
 * @param {string} folder where the pages go
 * @param {object} known what kin says of itself
 */
export async function writeBook(docs, folder, known) {
  const parts = partsOf(readFileSync(`${docs}SUMMARY.md`, "utf8"));
  const chapters = parts.flatMap((part) => part.chapters);
  const links = createLinks(docs);
  const rendered = new Map();
  for (const { file } of chapters) {
    const markdown = readFileSync(`${docs}${file}.md`, "utf8");
    rendered.set(file, await render(markdown, (target) => links.addressIn(file, target)));
  }
  links.check(new Map([...rendered].map(([file, { headings }]) => [file, headings])));

  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const file of links.files) {
    mkdirSync(dirname(folder + file), { recursive: true });
    copyFileSync(docs + file, folder + file);
  }
  const view = await movingPage("book/view.css");
  writeFileSync(`${folder}living.js`, await script("book/living.mjs", view, "../kin.wasm", known, "iife"));
  writeFileSync(`${folder}book.css`, await style("book/book.css"));
  const moving = policy(`'self' ${hashOf(view.script)}`, " 'self'");
  chapters.forEach(({ title, file }, index) => {
    const { html, lives } = rendered.get(file);
    const body = `<main>\n${html}${neighbours(chapters, index)}</main>\n${navigation(parts, file)}`;
    const scripts = lives ? '<script src="living.js" defer></script>\n' : "";
    writeFileSync(`${folder}${file}.html`, document(title, lives ? moving : STILL, scripts, body));
  });
  copyFileSync(`${folder}${chapters[0].file}.html`, `${folder}index.html`);
}
