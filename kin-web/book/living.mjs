/** The blocks of a chapter that move: each begins when it comes into view, and all ask one worker. */
import { createAsking } from "../page/asking.mjs";
import { kinModule, startWorker } from "../page/parts.mjs";
import { createBlock } from "./block.mjs";
import { createTurns } from "./turns.mjs";

/** How far below the window a block begins. */
const NEAR = "300px";

let turn = null;

function begin(figure) {
  turn ??= createTurns(createAsking(startWorker, kinModule()));
  createBlock(figure, turn());
}

const observer = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (isIntersecting) {
        observer.unobserve(target);
        begin(target);
      }
    }
  },
  { rootMargin: NEAR },
);

/** A page that is a file cannot load kin, and links the page that holds it. */
function leave(figure) {
  figure.classList.add("still");
  const link = figure.querySelector("figcaption a");
  link.href = link.href.replace("index.html", "kin.html");
}

const isFile = location.protocol === "file:";
document.querySelectorAll(".living").forEach((figure) => (isFile ? leave(figure) : observer.observe(figure)));
