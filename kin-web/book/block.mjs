/** A block of a chapter: the text of a `.kin` file, which can be changed, and its motion. */
import { button, made, setText } from "../../kin-studio/src/page/elements.mjs";
import { addressOf } from "../page/address.mjs";
import { createMovingText } from "../page/moving-text.mjs";

/**
 * @param {HTMLElement} figure the block as it stands without scripts
 * @param {(question: object, limit: number) => Promise<any>} ask
 */
export function createBlock(figure, ask) {
  const still = figure.querySelector("pre");
  const link = figure.querySelector("figcaption a");
  const given = still.textContent;
  const places = {
    editor: made("div", { className: "editor" }),
    mistakes: made("ul", { className: "mistakes", "aria-label": "Mistakes" }),
    moving: figure.querySelector(".moving"),
  };
  const state = made("span", { className: "state", role: "status" });
  const reset = button("As in the book", { hidden: true }, () => moving.set(given));

  const moving = createMovingText(places, ask, {
    async typed(text) {
      reset.hidden = text === given;
      const address = await addressOf(text);
      if (text === moving.text()) {
        link.hash = address;
      }
    },
    understood() {},
    moved: () => say(""),
    say,
  });

  function say(words) {
    setText(state, words);
  }

  still.replaceWith(places.editor, places.mistakes);
  link.after(reset, state);
  moving.set(given);
}
