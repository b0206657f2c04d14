/** The page of kin: text on the left, the moving page on the right. */
import { part, setText } from "../../kin-studio/src/page/elements.mjs";
import { handOver } from "../../kin-studio/src/page/saving.mjs";
import { addressOf, readAddress } from "./address.mjs";
import { createAsking } from "./asking.mjs";
import { createBoard, isGrown } from "./board.mjs";
import { loadsOf, withFirstLoads, withSection } from "./loads.mjs";
import { createMovingText } from "./moving-text.mjs";
import { examples, kinModule, startWorker } from "./parts.mjs";

/** The times in milliseconds that answers may take. */
const LIMITS = { short: 4000, report: 60_000 };
/** The time in milliseconds without a change after which peaks are looked for: while a person types, they would only
 * hold up the motion. */
const REST = 300;

const module = kinModule();
/** Each kind of question has a worker: peaks, which take time, hold nothing up, and no question ends another. */
const quick = createAsking(startWorker, module);
const slow = createAsking(startWorker, module);
const byButton = createAsking(startWorker, module);
const board = createBoard(createAsking(startWorker, module), drawn);
/** The name of the mechanism that moves, in small letters, for files. */
let fileName = "mechanism";
/** The last text without mistakes, and its loads or the text with loads to begin with; null without them. */
let loads = { of: "", own: null, begun: null };

const places = { editor: part("editor"), mistakes: part("mistakes"), moving: part("moving") };
const moving = createMovingText(places, quick, { typed, understood, moved, say });

function typed(text) {
  const chosen = part("examples").value;
  if (chosen !== "" && text !== textOfExample(chosen)) {
    part("examples").value = "";
  }
}

/** Takes the text of a drawing, with the loads that stood behind the text of the same drawing before. */
function drawn(text, before) {
  moving.set(loads.own !== null && isGrown(loads.of, before) ? withSection(text, loads.own) : text);
}

async function understood(text, outline) {
  const own = loadsOf(text, outline);
  loads = { of: text, own, begun: own === null ? withFirstLoads(text, outline) : null };
  part("add-loads").hidden = loads.begun === null;
  history.replaceState(null, "", `#${await addressOf(text, board.drawingOf(text))}`);
}

/** The peaks, which take longer than the motion. */
async function moved(report, text, isLast) {
  fileName = report.module;
  say("finding peaks …");
  await new Promise((rested) => setTimeout(rested, REST));
  if (!isLast()) {
    return;
  }
  const whole = await slow({ ask: "report", text }, LIMITS.report);
  if (whole.superseded || !isLast()) {
    return;
  }
  say(whole.refused ? "the peaks are the page's own" : "");
  if (whole.report) {
    moving.show(whole.report);
  }
}

function textOfExample(name) {
  return examples.find((one) => one.name === name)?.text;
}

function say(text) {
  setText(part("state"), text);
}

/** Takes the text of a file: one of kin, or one of another program, which becomes a drawing. */
async function take(text) {
  part("examples").value = "";
  if (/^\s*(\/\/.*\n\s*)*kin\s+\d/.test(text)) {
    moving.set(text);
    return;
  }
  say("reading …");
  const { imported, refused, superseded } = await byButton({ ask: "import", text }, LIMITS.report);
  if (superseded) {
    return;
  }
  if (refused) {
    say("");
    moving.refuse(refused);
    return;
  }
  board.load(imported.sketch, imported.drawn.file);
  if (imported.drawn.file) {
    moving.set(imported.drawn.file);
  }
  say(imported.notes.join(" "));
}

function textFile(name, content, type) {
  handOver(name, new Blob([content], { type }));
}

async function save(kind) {
  const text = moving.text();
  if (kind === "kin") {
    textFile(`${fileName}.kin`, text, "text/plain");
    return;
  }
  const question = kind === "page" ? { ask: "page", text } : { ask: "code", text, language: kind };
  say("writing …");
  const { text: page, files, refused } = await byButton(question, LIMITS.report);
  say(refused ?? "");
  for (const [file, content] of page ? [[`${fileName}.html`, page]] : (files ?? [])) {
    textFile(file, content, page ? "text/html" : "text/plain");
  }
}

async function copyLink() {
  const text = moving.text();
  const address = `${location.href.split("#")[0]}#${await addressOf(text, board.drawingOf(text))}`;
  history.replaceState(null, "", address);
  try {
    await navigator.clipboard.writeText(address);
    say("The link is copied: it holds the whole mechanism.");
  } catch {
    say("The link stands in the address bar: it holds the whole mechanism.");
  }
}

async function format() {
  const { text, refused } = await byButton({ ask: "format", text: moving.text() }, LIMITS.short);
  if (text && text !== moving.text()) {
    moving.set(text);
  }
  say(refused ? "A text with such mistakes cannot be formatted." : "");
}

async function begin() {
  const { text: fromAddress, drawing } = await readAddress(location.hash);
  const choices = examples.map(({ name }) => new Option(name.replace(/(?!^)(?=[A-Z])/g, " "), name));
  part("examples").append(new Option("of one's own", ""), ...choices);
  part("examples").value = fromAddress === null ? "FourBar" : "";
  part("examples").addEventListener("change", () => {
    const text = textOfExample(part("examples").value);
    if (text) {
      moving.set(text);
    }
  });
  follow(fromAddress ?? textOfExample("FourBar") ?? "kin 1\n", drawing);
  if (location.hash && fromAddress === null) {
    say("The link is damaged: it holds no mechanism.");
  }
}

/** Shows the text of a link, and its drawing. */
function follow(text, drawing) {
  if (drawing !== null) {
    try {
      board.load(drawing, text);
    } catch (error) {
      if (!(error instanceof RangeError)) {
        throw error;
      }
    }
  }
  moving.set(text);
}

part("open").addEventListener("click", () => part("file").click());
part("file").addEventListener("change", async () => {
  const [file] = part("file").files;
  part("file").value = "";
  if (file) {
    await take((await file.text()).replace(/^\uFEFF/, "").replaceAll("\r\n", "\n"));
  }
});
part("format").addEventListener("click", format);
part("link").addEventListener("click", copyLink);
part("add-loads").addEventListener("click", () => {
  if (moving.text() === loads.of) {
    moving.set(loads.begun);
  } else {
    say("Loads can be added to a text without mistakes.");
  }
});
for (const button of document.querySelectorAll("[data-save]")) {
  button.addEventListener("click", () => {
    button.closest("details").open = false;
    save(button.dataset.save);
  });
}
addEventListener("hashchange", async () => {
  const { text, drawing } = await readAddress(location.hash);
  if (text !== null && text !== moving.text()) {
    follow(text, drawing);
  }
});
begin();
