/** The text of the mechanism, with its mistakes underlined. */
import { autocompletion, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, indentUnit } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { EditorState, RangeSet, RangeValue, StateEffect, StateField } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";

import { completionsFrom, kin } from "./language.mjs";

/** A number of the outline. Its range follows what is typed, before it and in it. */
class OutlinedNumber extends RangeValue {
  startSide = -1;
  endSide = 1;

  constructor(number) {
    super();
    this.number = number;
  }
}

/** @type {import("@codemirror/state").StateEffectType<RangeSet<OutlinedNumber>>} */
const numbersAre = StateEffect.define();
const numberRanges = StateField.define({
  create: () => RangeSet.empty,
  update(ranges, { changes, effects }) {
    return effects.find((effect) => effect.is(numbersAre))?.value ?? ranges.map(changes);
  },
});

/**
 * @param {(text: string) => void} changed what happens after each change of the text
 * @param {() => object | null} outlineNow the outline of the last text without mistakes
 */
export function createEditor(parent, changed, outlineNow) {
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        bracketMatching(),
        indentUnit.of("    "),
        kin,
        numberRanges,
        autocompletion({ override: [completionsFrom(outlineNow)] }),
        lintGutter(),
        keymap.of([indentWithTab, ...completionKeymap, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ "aria-label": "The mechanism as text", tabindex: "0" }),
        EditorView.updateListener.of((update) => update.docChanged && changed(view.state.doc.toString())),
      ],
    }),
  });

  /** The place of a line and of a unit of UTF-16 in it, both from zero. */
  function placeOf({ line, character }) {
    const { doc } = view.state;
    if (line >= doc.lines) {
      return doc.length;
    }
    const { from, to } = doc.line(line + 1);
    return Math.min(from + character, to);
  }

  return {
    text: () => view.state.doc.toString(),
    set(text) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
    },
    change(changes) {
      view.dispatch({ changes });
    },
    mark(mistakes) {
      const diagnostics = mistakes.map(({ severity, message, range }) => {
        const from = placeOf(range.start);
        return { severity, message, from, to: Math.max(from, placeOf(range.end)) };
      });
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },
    /** Takes the numbers of the text's outline. */
    setNumbers(numbers) {
      const ranges = numbers.map((number) => {
        const { start, end } = number.range;
        return new OutlinedNumber(number).range(placeOf(start), placeOf(end));
      });
      view.dispatch({ effects: numbersAre.of(RangeSet.of(ranges, true)) });
    },
    /** The numbers of the last outline, where they stand now. */
    numbers() {
      const { doc } = view.state;
      const numbers = [];
      for (const at = view.state.field(numberRanges).iter(); at.value; at.next()) {
        const { from, to } = at;
        numbers.push({ ...at.value.number, from, to, text: doc.sliceString(from, to) });
      }
      return numbers;
    },
    goTo({ range }) {
      view.dispatch({ selection: { anchor: placeOf(range.start) }, scrollIntoView: true });
      view.focus();
    },
  };
}
