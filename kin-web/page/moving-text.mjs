/** A text that moves: its editor, the list of its mistakes, and its moving page. The page has one, a chapter several. */
import { button, made } from "../../kin-studio/src/page/elements.mjs";
import { createEditor } from "./editor.mjs";
import { createFrames } from "./frame.mjs";
import { changesFor } from "./numbers.mjs";

/** The time in milliseconds that the motion of a text may take. */
const LIMIT = 10_000;
/** The pause in milliseconds after which a text that is typed is compiled. */
const PAUSE = 40;

/**
 * @param {{editor: HTMLElement, mistakes: HTMLElement, moving: HTMLElement}} places
 * @param {(question: object, limit: number) => Promise<any>} ask
 * @param {{markup: string, style: string, script: string}} view the moving page
 * @param {() => string[]} functionsNow the names that an expression can call
 * @param {object} on what happens then
 * @param {(text: string) => void} on.typed after each change of the text
 * @param {(text: string) => void} on.understood after a text without mistakes was compiled
 * @param {(report: object, text: string, isLast: () => boolean) => void} on.moved after its motion was shown
 * @param {(words: string) => void} on.say the state of the text in words
 */
export function createMovingText(places, ask, view, functionsNow, on) {
  let outline = null;
  let timer = 0;
  let version = 0;

  const editor = createEditor(places.editor, typed, () => outline, functionsNow);
  const frames = createFrames(places.moving, view, (design) => editor.change(changesFor(editor.text(), design)));

  function typed(text) {
    on.typed(text);
    clearTimeout(timer);
    timer = setTimeout(compile, PAUSE);
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

  function show(report) {
    places.moving.classList.remove("stale");
    frames.show(report);
  }

  async function compile() {
    version += 1;
    const mine = version;
    const text = editor.text();
    const begin = performance.now();
    const asked = await ask({ ask: "motion", text }, LIMIT);
    if (asked.superseded || mine !== version) {
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
    on.understood(text);
    if (refused) {
      refuse(refused);
      return;
    }
    show(report);
    document.body.dataset.moved = (performance.now() - begin).toFixed(0);
    on.moved(report, text, () => mine === version);
  }

  return { text: editor.text, set: editor.set, show, refuse };
}
