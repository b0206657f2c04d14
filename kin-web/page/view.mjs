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

/** The page that is shown; null before it is, and for a report that cannot move. */
let page = null;
/** The pointers that are pressed, and whether a slider or a field has a number that is not told yet. */
const pressed = new Set();
let isEdited = false;
/** Whether the shell waits for the view, and whether it has it. */
let isAsked = false;
let isGiven = false;

async function begin({ report, kept }) {
  page = start(report, await solverOf(report.solver), kept);
  document.getElementById("sliders").addEventListener("change", () => page && tell({ design: page.design() }));
  tell({ shown: true });
}

/** Gives the view to the frame that takes the place of this one, but not while a person holds or edits something. */
function giveView() {
  if (isAsked && pressed.size === 0 && !isEdited) {
    isAsked = false;
    isGiven = true;
    delete document.body.dataset.touched;
    tell({ kept: page?.keep() ?? null });
  }
}

/**
 * Marks that a view that was given may be an old one. The shell reads the mark itself: a message could come after the
 * frame has been replaced, and a press would be lost.
 */
function touched() {
  if (isGiven) {
    isGiven = false;
    document.body.dataset.touched = "yes";
  }
}

function onAny(kinds, act) {
  for (const kind of kinds) {
    addEventListener(kind, act, true);
  }
}

onAny(["keydown"], touched);
onAny(["pointerdown"], ({ pointerId }) => {
  pressed.add(pointerId);
  touched();
});
onAny(["pointerup", "pointercancel"], ({ pointerId }) => {
  pressed.delete(pointerId);
  // after the slider has told its number
  setTimeout(giveView);
});
onAny(["input"], () => {
  isEdited = true;
  touched();
});
onAny(["change", "focusout"], () => {
  isEdited = false;
  setTimeout(giveView);
});
addEventListener("message", ({ source, data }) => {
  if (source !== shell) {
    return;
  }
  if (data.report) {
    begin(data);
  } else if (data.ask === "keep") {
    isAsked = true;
    giveView();
  }
});
tell({ ready: true });
