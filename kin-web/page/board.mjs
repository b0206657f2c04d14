/** The drawing board: a drawing whose declaration goes into the text. */
import { part } from "../../kin-studio/src/page/elements.mjs";
import { createDrawing, examples } from "../drawing/main.mjs";

/** The time in milliseconds that a declaration may take. */
const LIMIT = 8000;

/** @param {(text: string) => void} declared what happens with the `.kin` file of each drawing without faults */
export function createBoard(ask, declared) {
  const [panel, button, choice] = [part("drawn"), part("draw"), part("drawings")];
  let isQuiet = false;

  const drawing = createDrawing(part("drawing"), part("tools"), {
    async declare(sketch) {
      const { drawn, refused } = await ask({ ask: "draw", sketch }, LIMIT);
      return drawn ?? { faults: [{ message: refused ?? "", advice: "", points: [], links: [], slides: [] }] };
    },
    changed(result) {
      if (result.file && !isQuiet && !panel.hidden) {
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
    /** Shows a drawing that another program made. Its declaration, with motions and units, is known already. */
    load(sketch) {
      show(true);
      isQuiet = true;
      drawing.load(sketch);
    },
  };
}
