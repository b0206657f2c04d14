/** The drawing board: a drawing whose declaration goes into the text. */
import { part } from "../../kin-studio/src/page/elements.mjs";
import { createDrawing, examples } from "../drawing/main.mjs";
import { lengthUnitOf } from "./numbers.mjs";

/** The time in milliseconds that a declaration may take. */
const LIMIT = 8000;
/** No drawing yet, and no file. */
const NOTHING = { file: null, sketch: null };

/**
 * @param {(text: string, before: string | null) => void} declared what happens with the `.kin` file of each drawing
 *   without faults, and with that which the same drawing had before
 */
export function createBoard(ask, declared) {
  const [panel, button, choice, unit] = [part("drawn"), part("draw"), part("drawings"), part("drawing-unit")];
  let isQuiet = false;
  /** A drawing with its `.kin` file. */
  let last = NOTHING;
  const asked = (sketch) => ask({ ask: "draw", sketch, unit: unit.value }, LIMIT);

  const drawing = createDrawing(part("drawing"), part("tools"), {
    async declare(sketch) {
      const { drawn, refused } = await asked(sketch);
      return drawn ?? { faults: [{ message: refused ?? "", advice: "", points: [], links: [], slides: [] }] };
    },
    changed(result, sketch) {
      if (result.file && !isQuiet && !panel.hidden) {
        write(result.file, sketch);
      }
      isQuiet = false;
    },
  });

  function write(file, sketch) {
    const before = last.file;
    last = { file, sketch };
    declared(file, before);
  }

  unit.addEventListener("change", async () => {
    const { sketch } = last;
    if (sketch !== null) {
      const { drawn } = await asked(sketch);
      // in the meantime it may have changed
      if (drawn?.file && last.sketch === sketch) {
        write(drawn.file, sketch);
      }
    }
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
    last = NOTHING;
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
      unit.value = lengthUnitOf(file ?? "");
    },

    /** The drawing from which a text was written, as long as the text has only grown at its end; else null. */
    drawingOf: (text) => (isGrown(text, last.file) ? last.sketch : null),
  };
}

/** Whether a text is the file of a drawing, or has grown at its end. */
export const isGrown = (text, file) => file !== null && text.startsWith(file.trimEnd());
