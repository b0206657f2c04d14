/** The drawing board: a drawing whose declaration goes into the text. */
import { part } from "../../kin-studio/src/page/elements.mjs";
import { createDrawing, examples } from "../drawing/main.mjs";

/** The time in milliseconds that a declaration may take. */
const LIMIT = 8000;

/** @param {(text: string) => void} declared what happens with the `.kin` file of each drawing without faults */
export function createBoard(ask, declared) {
  const [panel, button, choice] = [part("drawn"), part("draw"), part("drawings")];
  let isQuiet = false;
  /** A drawing with its `.kin` file. */
  let last = { file: null, sketch: null };

  const drawing = createDrawing(part("drawing"), part("tools"), {
    async declare(sketch) {
      const { drawn, refused } = await ask({ ask: "draw", sketch }, LIMIT);
      return drawn ?? { faults: [{ message: refused ?? "", advice: "", points: [], links: [], slides: [] }] };
    },
    changed(result, sketch) {
      if (result.file && !isQuiet && !panel.hidden) {
        last = { file: result.file, sketch };
        declared(result.file);
      }
      isQuiet = false;
    },
  });

  function show(isShown) {
    panel.hidden = !isShown;
    button.setAttribute("aria-pressed", String(isShown));
    button.textContent = isShown ? "Text alone" : "Draw";
  }

  choice.append(
    new Option("of one's own", ""),
    ...examples.map(({ title }, index) => new Option(title, String(index))),
  );
  choice.addEventListener("change", () => {
    if (choice.value === "") {
      drawing.clear();
    } else {
      drawing.load(examples[Number(choice.value)].sketch);
    }
  });
  button.addEventListener("click", () => show(panel.hidden));

  return {
    /**
     * Shows a drawing of another program or of a link. Its `.kin` file, with motions and units, is known already.
     * @throws {RangeError} if the data is no drawing
     */
    load(sketch, file) {
      const wasShown = !panel.hidden;
      // a drawing that is not seen has no size to be fitted into
      show(true);
      try {
        drawing.load(sketch);
      } catch (error) {
        show(wasShown);
        throw error;
      }
      isQuiet = true;
      last = { file, sketch };
    },

    /** The drawing from which a text was written, as long as nobody has changed the text; else null. */
    drawingOf: (text) => (text === last.file ? last.sketch : null),
  };
}
