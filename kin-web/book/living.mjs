/** The blocks of a chapter that move: each begins when it comes into view, and all ask one worker. */
import { createAsking } from "../page/asking.mjs";
import { kinModule, startWorker } from "../page/parts.mjs";
import { createBlock } from "./block.mjs";
import { createTurns } from "./turns.mjs";

/** How far below the window a block begins. */
const NEAR = "300px";
/** The time in milliseconds that the list of functions may take. */
const LIMIT = 10_000;

let turn = null;
let functions = [];

function begin(figure) {
  const isFirst = turn === null;
  turn ??= createTurns(createAsking(startWorker, kinModule()));
  createBlock(figure, turn(), () => functions);
  if (isFirst) {
    turn()({ ask: "functions" }, LIMIT).then((answer) => (functions = answer.functions ?? []));
  }
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
document.querySelectorAll(".living").forEach((figure) => observer.observe(figure));
