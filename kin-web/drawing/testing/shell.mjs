/** The page of the tests. `declareByKin` is given by the test: the Rust package behind a pipe. */
import { createDrawing, examples } from "../main.mjs";

window.results = [];
window.examples = examples;
window.drawing = createDrawing(document.getElementById("drawing"), document.getElementById("tools"), {
  declare: (sketch) => window.declareByKin(sketch),
  changed(result, sketch) {
    window.results.push({ result, sketch });
    document.getElementById("text").textContent = result.text ?? "";
  },
});
