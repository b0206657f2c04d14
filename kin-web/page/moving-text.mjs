/** A text that moves: its editor, the list of its mistakes, and its moving page. */
import { button, made } from "../../kin-studio/src/page/elements.mjs";
import { createEditor } from "./editor.mjs";
import { createFrames } from "./frame.mjs";
import { changesFor } from "./numbers.mjs";
import { view } from "./parts.mjs";

/** The time in milliseconds that the motion of a text may take. */
const LIMIT = 10_000;
/** The time in milliseconds after which a later text ends the question about an earlier one. */
const PATIENCE = 250;
const TYPED = "kin: typed";

/**
 * @param {{editor: HTMLElement, mistakes: HTMLElement, moving: HTMLElement}} places
 * @param {(question: object, limit: number) => Promise<any>} ask
 * @param {object} on what happens then
 * @param {(text: string) => void} on.typed after each change of the text
 * @param {(text: string, outline: object) => void} on.understood after a text without mistakes was compiled
 * @param {(report: object, text: string, isLast: () => boolean) => void} on.moved after its motion was shown
 * @param {(words: string) => void} on.say the state of the text in words
 */
export function createMovingText(places, ask, on) {
  let outline = null;
  let version = 0;
  /** The time until which a question is waited for, as long as there is one. */
  let until = 0;
  let timer = null;

  const editor = createEditor(places.editor, typed, () => outline);
  const frames = createFrames(places.moving, view, (design) => editor.change(changesFor(editor.numbers(), design)));
  frames.prepare();
  places.editor.addEventListener("focusin", frames.prepare);

  function typed(text) {
    performance.mark(TYPED);
    on.typed(text);
    compileIn(until - performance.now());
  }

  function compileIn(pause) {
    clearTimeout(timer);
    timer = setTimeout(compile, pause);
  }

  /** Lists mistakes below the text. A click leads to the place. */
  function list(mistakes) {
    const items = mistakes.map((mistake) => {
      const words = `${mistake.range.start.line + 1}: ${mistake.message}`;
      return made(
        "li",
        {},
        button(words, { className: mistake.severity }, () => editor.goTo(mistake)),
      );
    });
    places.mistakes.replaceChildren(...items);
  }

  function refuse(message) {
    places.moving.classList.add("stale");
    on.say("");
    list([{ severity: "error", message, range: { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } } }]);
  }

  /** Whether the report was shown, and not another one in its place. */
  async function show(report) {
    places.moving.classList.remove("stale");
    const isShown = await frames.show(report);
    if (isShown && places.editor.contains(document.activeElement)) {
      frames.prepare();
    }
    return isShown;
  }

  async function compile() {
    timer = null;
    version += 1;
    const mine = version;
    const isLast = () => mine === version && timer === null;
    const text = editor.text();
    const [typedLast] = performance.getEntriesByName(TYPED).slice(-1);
    performance.mark("kin: asked");
    until = performance.now() + PATIENCE;
    const asked = await ask({ ask: "motion", text }, LIMIT);
    if (mine !== version) {
      return;
    }
    until = 0;
    performance.mark("kin: answered");
    if (!isLast()) {
      compileIn(0);
      return;
    }
    if (asked.refused) {
      refuse(asked.refused);
      return;
    }
    const { check, report, refused } = asked.motion;
    editor.mark(check.mistakes);
    list(check.mistakes);
    if (check.outline === null) {
      places.moving.classList.add("stale");
      on.say(check.mistakes.length === 1 ? "1 mistake" : `${check.mistakes.length} mistakes`);
      return;
    }
    outline = check.outline;
    editor.setNumbers(outline.numbers);
    on.understood(text, outline);
    if (refused) {
      refuse(refused);
      return;
    }
    if ((await show(report)) && isLast()) {
      performance.mark("kin: shown");
      document.body.dataset.moved = (performance.now() - typedLast.startTime).toFixed(0);
      on.moved(report, text, isLast);
    }
  }

  return { text: editor.text, set: editor.set, show, refuse };
}
