/** The page of kin: text on the left, the moving page on the right. */
import { button, made, part, setText } from "../../kin-studio/src/page/elements.mjs";
import { handOver } from "../../kin-studio/src/page/saving.mjs";
import { addressOf, readAddress } from "./address.mjs";
import { createAsking } from "./asking.mjs";
import { createEditor } from "./editor.mjs";
import { createFrames } from "./frame.mjs";
import { createBoard } from "./board.mjs";
import { changesFor } from "./numbers.mjs";
import { kinModule, startWorker, view } from "./parts.mjs";

/** The times in milliseconds that answers may take. */
const LIMITS = { short: 4000, motion: 10_000, report: 60_000 };
/** The pause after which a text that is typed is compiled. */
const PAUSE = 40;

const module = kinModule();
/** Each kind of question has a worker: peaks, which take time, hold nothing up, and no question ends another. */
const quick = createAsking(startWorker, module);
const slow = createAsking(startWorker, module);
const byButton = createAsking(startWorker, module);
const board = createBoard(createAsking(startWorker, module), (text) => editor.set(text));
let examples = [];
let functions = [];
let outline = null;
/** The name of the mechanism that moves, in small letters, for files. */
let fileName = "mechanism";
let timer = 0;
let version = 0;

const editor = createEditor(
  part("editor"),
  typed,
  () => outline,
  () => functions,
);
const frames = createFrames(part("moving"), view, (design) => editor.change(changesFor(editor.text(), design)));

function typed(text) {
  const chosen = part("examples").value;
  if (chosen !== "" && text !== textOfExample(chosen)) {
    part("examples").value = "";
  }
  clearTimeout(timer);
  timer = setTimeout(compile, PAUSE);
}

function textOfExample(name) {
  return examples.find((one) => one.name === name)?.text;
}

function say(text) {
  setText(part("state"), text);
}

/** Lists mistakes below the text. A click leads to the place. */
function list(mistakes) {
  const items = mistakes.map((mistake) => {
    const words = `${mistake.range.start.line + 1}: ${mistake.message}`;
    return made(
      "li",
      {},
      button(words, { className: mistake.severity }, () => editor.goTo(mistake)),
    );
  });
  part("mistakes").replaceChildren(...items);
}

function refuse(message) {
  part("moving").classList.add("stale");
  say("");
  list([{ severity: "error", message, range: { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } } }]);
}

async function compile() {
  version += 1;
  const mine = version;
  const text = editor.text();
  const begin = performance.now();
  const asked = await quick({ ask: "motion", text }, LIMITS.motion);
  if (asked.superseded || mine !== version) {
    return;
  }
  if (asked.refused) {
    refuse(asked.refused);
    return;
  }
  const { check, report, refused } = asked.motion;
  editor.mark(check.mistakes);
  list(check.mistakes);
  if (check.outline === null) {
    part("moving").classList.add("stale");
    say(check.mistakes.length === 1 ? "1 mistake" : `${check.mistakes.length} mistakes`);
    return;
  }
  outline = check.outline;
  history.replaceState(null, "", `#${await addressOf(text, board.drawingOf(text))}`);
  if (refused) {
    refuse(refused);
    return;
  }
  show(report);
  document.body.dataset.moved = (performance.now() - begin).toFixed(0);
  say("finding peaks …");
  const whole = await slow({ ask: "report", text }, LIMITS.report);
  if (whole.superseded || mine !== version) {
    return;
  }
  say(whole.refused ? "the peaks are the page's own" : "");
  if (whole.report) {
    show(whole.report);
  }
}

function show(report) {
  fileName = report.module;
  part("moving").classList.remove("stale");
  frames.show(report);
}

/** Takes the text of a file: one of kin, or one of another program, which becomes a drawing. */
async function take(text) {
  part("examples").value = "";
  if (/^\s*(\/\/.*\n\s*)*kin\s+\d/.test(text)) {
    editor.set(text);
    return;
  }
  say("reading …");
  const { imported, refused, superseded } = await byButton({ ask: "import", text }, LIMITS.report);
  if (superseded) {
    return;
  }
  if (refused) {
    say("");
    refuse(refused);
    return;
  }
  board.load(imported.sketch, imported.drawn.file);
  if (imported.drawn.file) {
    editor.set(imported.drawn.file);
  }
  say(imported.notes.join(" "));
}

function textFile(name, content, type) {
  handOver(name, new Blob([content], { type }));
}

async function save(kind) {
  const text = editor.text();
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
  const text = editor.text();
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
  const { text, refused } = await byButton({ ask: "format", text: editor.text() }, LIMITS.short);
  if (text && text !== editor.text()) {
    editor.set(text);
  }
  say(refused ? "A text with such mistakes cannot be formatted." : "");
}

async function begin() {
  const asked = quick({ ask: "examples" }, LIMITS.motion);
  const { text: fromAddress, drawing } = await readAddress(location.hash);
  const askedFunctions = slow({ ask: "functions" }, LIMITS.motion);
  examples = (await asked).examples ?? [];
  functions = (await askedFunctions).functions ?? [];
  const choices = examples.map(({ name }) => new Option(name.replace(/(?!^)(?=[A-Z])/g, " "), name));
  part("examples").append(new Option("of one's own", ""), ...choices);
  part("examples").value = fromAddress === null ? "FourBar" : "";
  part("examples").addEventListener("change", () => {
    const text = textOfExample(part("examples").value);
    if (text) {
      editor.set(text);
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
  editor.set(text);
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
for (const button of document.querySelectorAll("[data-save]")) {
  button.addEventListener("click", () => {
    button.closest("details").open = false;
    save(button.dataset.save);
  });
}
addEventListener("hashchange", async () => {
  const { text, drawing } = await readAddress(location.hash);
  if (text !== null && text !== editor.text()) {
    follow(text, drawing);
  }
});
begin();
