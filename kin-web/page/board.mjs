/** The drawing board: a drawing whose declaration goes into the text. */
import { part } from "../../kin-studio/src/page/elements.mjs";
import { createDrawing, examples } from "../drawing/main.mjs";

/** The time in milliseconds that a declaration may take. */
const LIMIT = 8000;

/**
 * @param {(text: string, before: string | null) => void} declared what happens with the `.kin` file of each drawing
 *   without faults, and with that which the same drawing had before
 */
export function createBoard(ask, declared) {
  const [panel, button, choice, unit] = [part("drawn"), part("draw"), part("drawings"), part("drawing-unit")];
  let isQuiet = false;
  /** A drawing with its `.kin` file. */
  let last = { file: null, sketch: null };

  const drawing = createDrawing(part("drawing"), part("tools"), {
    async declare(sketch) {
      const { drawn, refused } = await ask({ ask: "draw", sketch, unit: unit.value }, LIMIT);
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
      const { drawn } = await ask({ ask: "draw", sketch, unit: unit.value }, LIMIT);
      if (drawn?.file) {
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
    last = { file: null, sketch: null };
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
      unit.value = unitOf(file ?? "");
    },

    /** The drawing from which a text was written, as long as the text has only grown at its end; else null. */
    drawingOf: (text) => (isGrown(text, last.file) ? last.sketch : null),
  };
}

/** Whether a text is the file of a drawing, or has grown at its end. */
export const isGrown = (text, file) => file !== null && text.startsWith(file.trimEnd());

/** The unit of the first length that a text gives, or empty. */
const unitOf = (text) => /=\s*\(?-?[\d.]+(?:e-?\d+)?(mm|cm|m|in)\b/.exec(text)?.[1] ?? "";
