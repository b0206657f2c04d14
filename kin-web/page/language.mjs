/** The language of `.kin` files for the editor: its colours and its completions. */
import { HighlightStyle, LanguageSupport, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

import { words } from "./parts.mjs";

const KEYWORDS = [
  "kin",
  "struct",
  "input",
  "unknown",
  "output",
  "let",
  "for",
  "ground",
  "body",
  "slide",
  "dimensions",
  "motion",
  "assembly",
  "columns",
  "loads",
  "at",
];
const TYPES = ["Length", "Angle", "Scalar", "Vector", "Vector3", "Point", "Direction"];

/** Whether a word is a keyword here: at the beginning of a statement, and not as a name with a type or a value. */
function isKeyword(word, stream, begins) {
  const isName = word !== "assembly" && stream.match(/^\s*[-+*/:=.]/, false);
  return KEYWORDS.includes(word) && (word === "at" || (begins && !isName));
}

const parser = {
  name: "kin",
  startState: () => ({ begins: true }),
  token(stream, state) {
    if (stream.eatSpace()) {
      return null;
    }
    if (stream.match(/^\/\/.*/)) {
      return "comment";
    }
    if (stream.match(/^\d+(\.(?!\.)\d*)?(e[+-]?\d+)?/i)) {
      stream.match(/^[a-zµ°]+/i);
      return "number";
    }
    const word = stream.match(/^[\p{L}_][\p{L}\p{N}_]*/u)?.[0];
    const { begins } = state;
    // the first line, `kin 1`, has no end but that of the line
    state.begins = word ? word === "kin" : ";{}".includes(stream.next());
    if (!word) {
      return null;
    }
    if (isKeyword(word, stream, begins)) {
      return "keyword";
    }
    if (TYPES.includes(word)) {
      return "typeName";
    }
    return stream.match(/^\s*\(/u, false) ? "function" : "variableName";
  },
  languageData: { commentTokens: { line: "//" } },
  tokenTable: { function: tags.function(tags.variableName) },
};

const style = HighlightStyle.define([
  { tag: tags.comment, class: "token-comment" },
  { tag: tags.keyword, class: "token-keyword" },
  { tag: tags.number, class: "token-number" },
  { tag: tags.typeName, class: "token-type" },
  { tag: tags.function(tags.variableName), class: "token-function" },
]);

export const kin = new LanguageSupport(StreamLanguage.define(parser), syntaxHighlighting(style));

/**
 * Completions: units behind a number, and else the words of the language, its functions, and the names of the last text
 * without mistakes.
 */
export function completionsFrom(outlineNow) {
  const units = words.units.map((label) => ({ label, type: "constant" }));
  const known = [
    ...KEYWORDS.map((label) => ({ label, type: "keyword" })),
    ...TYPES.map((label) => ({ label, type: "type" })),
    ...words.functions.map((label) => ({ label, type: "function" })),
  ];
  return (context) => {
    const behindNumber = context.matchBefore(/\d\.?\p{L}[\p{L}\p{N}/]*/u);
    if (behindNumber) {
      return { from: behindNumber.from + behindNumber.text.search(/\p{L}/u), options: units };
    }
    const word = context.matchBefore(/[\p{L}_][\p{L}\p{N}_]*/u);
    if (!word && !context.explicit) {
      return null;
    }
    const outline = outlineNow();
    const quantities = ["dimensions", "inputs", "unknowns", "outputs"].flatMap((kind) => outline?.[kind] ?? []);
    const names = quantities.map(({ name, documentation }) => ({ label: name, type: "variable", info: documentation }));
    return { from: word?.from ?? context.pos, options: [...names, ...known] };
  };
}
