/** A chapter's markdown as HTML, as GitHub shows it, with blocks of `.kin` files that can move. */
import { Marked } from "marked";

import { addressOf } from "../page/address.mjs";

export const escaped = (text) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** The identity of a heading, as GitHub gives it. */
const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, "")
    .replaceAll(" ", "-");

/** The text of a heading without its marks. */
const plain = (tokens) => tokens.map(({ tokens: inner, text }) => (inner ? plain(inner) : text)).join("");

/** A program without the lines that only its test needs: rustdoc hides lines that begin with `#` and a blank. */
const withoutHidden = (text) =>
  text
    .split("\n")
    .filter((line) => !/^#( |$)/.test(line))
    .join("\n");

const code = (text) => `<pre tabindex="0"><code>${escaped(text)}</code></pre>\n`;

/** The block of a `.kin` file, as it stands where no script makes it move. */
const living = (text, address) => `<figure class="living">
${code(text)}<div class="moving"></div>
<figcaption><a href="${address}">Open in the full page</a></figcaption>
</figure>
`;

/**
 * @param {(target: string) => string} addressOfTarget the address of a link
 * @returns {Promise<{html: string, headings: string[], lives: boolean}>} the chapter, the identities of its headings,
 *   and whether it has blocks that can move
 */
export async function render(markdown, addressOfTarget) {
  const headings = [];
  let lives = false;
  const marked = new Marked({
    async: true,
    async walkTokens(token) {
      if (token.type === "code" && token.lang === "kin") {
        lives = true;
        token.address = `../index.html#${await addressOf(token.text)}`;
      }
    },
    renderer: {
      heading({ tokens, depth }) {
        const id = slug(plain(tokens));
        headings.push(id);
        return `<h${depth} id="${id}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      code({ text, lang, address }) {
        if (address) {
          return living(text, address);
        }
        return code(lang?.startsWith("rust") ? withoutHidden(text) : text);
      },
      link({ href, tokens }) {
        return `<a href="${escaped(addressOfTarget(href))}">${this.parser.parseInline(tokens)}</a>`;
      },
      image: ({ href, text }) => `<img src="${escaped(addressOfTarget(href))}" alt="${escaped(text)}">`,
    },
  });
  const html = await marked.parse(markdown);
  const wide = html.replaceAll("<table>", '<div class="scroll" tabindex="0"><table>');
  return { html: wide.replaceAll("</table>", "</table></div>"), headings, lives };
}
