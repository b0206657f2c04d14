/** The moving page within its frame: it starts when the shell sends a report, and tells when its sliders were moved. */
import { start } from "../../kin-studio/src/page/main.mjs";

const shell = parent;
const tell = (message) => shell.postMessage(message, "*");

/** The solver, which the report holds as the text of a module. */
async function solverOf(text) {
  if (text === null) {
    return null;
  }
  const address = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  try {
    return await import(address);
  } finally {
    URL.revokeObjectURL(address);
  }
}

async function begin({ report, kept }) {
  const page = start(report, await solverOf(report.solver), kept);
  if (page === null) {
    tell({ shown: true });
    return;
  }
  const sliders = document.getElementById("sliders");
  sliders.addEventListener("change", () => tell({ design: page.design() }));
  addEventListener(
    "message",
    ({ source, data }) => source === shell && data.ask === "keep" && tell({ kept: page.keep() }),
  );
  tell({ shown: true });
}

addEventListener("message", ({ source, data }) => source === shell && data.report && begin(data));
tell({ ready: true });
