/** The order of the chapters, and the ways between them. */
import { escaped } from "./markdown.mjs";

/** The parts of `SUMMARY.md` with their chapters; the first has no title. */
export function partsOf(summary) {
  const parts = [{ title: "", chapters: [] }];
  for (const line of summary.split("\n")) {
    const [, title, file] = /^(?:- )?\[(.*)\]\((.*)\.md\)$/.exec(line) ?? [];
    const [, part] = /^# (.*)$/.exec(line) ?? [];
    if (file) {
      parts.at(-1).chapters.push({ title, file });
    } else if (part && part !== "Summary") {
      parts.push({ title: part, chapters: [] });
    }
  }
  return parts;
}

/** Links to all chapters. */
export function navigation(parts, current) {
  const item = ({ title, file }) =>
    `<li><a href="${file}.html"${file === current ? ' aria-current="page"' : ""}>${escaped(title)}</a></li>\n`;
  const lists = parts.map(
    ({ title, chapters }) => `${title && `<h2>${escaped(title)}</h2>\n`}<ul>\n${chapters.map(item).join("")}</ul>\n`,
  );
  return `<nav id="chapters" aria-label="Chapters">\n${lists.join("")}</nav>\n`;
}

/** Links to the chapters before and after one. */
export function neighbours(chapters, index) {
  const before = chapters[index - 1];
  const after = chapters[index + 1];
  const links = [
    before ? `<a rel="prev" href="${before.file}.html">← ${escaped(before.title)}</a>` : "",
    after ? `<a rel="next" href="${after.file}.html">${escaped(after.title)} →</a>` : "",
  ];
  return `<nav class="neighbours" aria-label="Neighbouring chapters">${links.join("\n")}</nav>\n`;
}
