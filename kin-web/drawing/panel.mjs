/** The values of what is selected, as fields. */
import { button, choice, made, tick } from "../../kin-studio/src/page/elements.mjs";
import { driveLink, driveSlide, fix, movePoint, removeSlide, takeFromLink } from "./model/edits.mjs";
import { lengthOf, sidesOf } from "./model/lengths.mjs";
import { drivenFrom, isDriven, linksAt, nameOf, numberOf, slidesAt } from "./model/sketch.mjs";
import { isLength, numberIn, typed } from "./typing.mjs";

/** A field with its label. The identity tells it from the others when the panel is made anew. */
function labelled(id, words, control) {
  control.setAttribute("data-field", id);
  control.removeAttribute("aria-label");
  return made("label", { className: "field" }, made("span", {}, words), control);
}

function textField(id, words, value, placeholder, action) {
  const input = made("input", { type: "text", value, placeholder, autocomplete: "off", spellcheck: false });
  input.addEventListener("change", () => action(input.value.trim()));
  return labelled(id, words, input);
}

function numberField(id, words, value, action, isAllowed = Number.isFinite) {
  const shown = typed(value);
  const input = made("input", {
    type: "text",
    value: shown,
    inputMode: "decimal",
    autocomplete: "off",
    className: "number",
  });
  input.addEventListener("change", () => {
    const number = numberIn(input.value);
    if (isAllowed(number)) {
      action(number);
    } else {
      input.value = shown;
    }
  });
  return labelled(id, words, input);
}

const bodies = (sketch, without = -1) => [
  ["ground", "the ground"],
  ...[...sketch.links.keys()].filter((link) => link !== without).map((link) => [String(link), nameOf(sketch, link)]),
];
const bodyOf = (value) => (value === "ground" ? value : Number(value));

/** Builds the panel. */
export function createPanel(desk) {
  const element = made("div", { className: "panel", role: "group" });
  let shown = "";
  let part = "";
  return {
    element,
    /** Whether the fields are those of a part. */
    shows: (selection) => part === JSON.stringify(selection),
    update(sketch, selection) {
      const now = JSON.stringify([sketch, selection]);
      if (now === shown) {
        return;
      }
      shown = now;
      part = JSON.stringify(selection);
      const field = element.contains(document.activeElement) ? document.activeElement.getAttribute("data-field") : null;
      const content =
        selection === null
          ? ofMechanism(desk, sketch)
          : selection.kind === "point"
            ? ofPoint(desk, sketch, selection.index)
            : ofLink(desk, sketch, selection.index);
      element.setAttribute("aria-label", content.title);
      element.replaceChildren(made("strong", {}, content.title), ...content.fields);
      if (field !== null) {
        [...element.querySelectorAll("[data-field]")].find((other) => other.dataset.field === field)?.focus();
      }
    },
    focus() {
      element.querySelector("input, select")?.focus();
    },
  };
}

function ofMechanism(desk, sketch) {
  const rename = (name) => desk.edit((draft) => (draft.name = name));
  return { title: "Mechanism", fields: [textField("name", "Name", sketch.name, "Linkage", rename)] };
}

function ofPoint(desk, sketch, point) {
  const { name, x, y } = sketch.points[point];
  const fixed = tick({ checked: sketch.ground.includes(point) }, (isFixed) =>
    desk.edit((draft) => fix(draft, point, isFixed)),
  );
  const fields = [
    textField("name", "Name", name, "", (text) => desk.edit((draft) => (draft.points[point].name = text))),
    numberField("x", "x", x, (value) => desk.edit((draft) => movePoint(draft, point, [value, y]))),
    numberField("y", "y", y, (value) => desk.edit((draft) => movePoint(draft, point, [x, value]))),
    labelled("fixed", "Fixed", fixed),
    ...slidesAt(sketch, point).map((slide) => ofSlide(desk, sketch, slide)),
  ];
  return { title: `Pin ${name}`, fields };
}

function ofSlide(desk, sketch, slide) {
  const { point, on, direction, guided } = sketch.slides[slide];
  const change = (action) => desk.edit((draft) => action(draft.slides[slide]));
  const carriers = choice("", bodies(sketch), String(on), (value) => change((own) => (own.on = bodyOf(value))));
  const rams = [
    ["", "turns about the pin"],
    ...linksAt(sketch, point).map((link) => [String(link), `holds ${nameOf(sketch, link)}`]),
  ];
  const ram = choice("", rams, guided === null ? "" : String(guided), (value) =>
    change((own) => (own.guided = value === "" ? null : Number(value))),
  );
  const driven = tick({ checked: isDriven(sketch, slide) }, (isToBe) =>
    desk.edit((draft) => driveSlide(draft, slide, isToBe)),
  );
  const degrees = numberField(`direction${slide}`, "Direction in °", (direction * 180) / Math.PI, (value) =>
    change((own) => (own.direction = (value * Math.PI) / 180)),
  );
  return made(
    "fieldset",
    {},
    made("legend", {}, "Slide"),
    labelled(`on${slide}`, "Along", carriers),
    degrees,
    labelled(`guided${slide}`, "Block", ram),
    labelled(`driven${slide}`, "Driven", driven),
    button("Remove the slide", {}, () => desk.edit((draft) => removeSlide(draft, slide))),
  );
}

function ofLink(desk, sketch, link) {
  const { name, points } = sketch.links[link];
  const title = name === "" ? `Link ${numberOf(link)}` : `Link ${numberOf(link)}, ${name}`;
  const letters = (...ends) => ends.map((point) => sketch.points[point].name).join("–");
  const lengths = sidesOf(sketch.links[link]).map(([from, to]) =>
    numberField(
      `length${from}-${to}`,
      points.length > 2 ? `Length ${letters(from, to)}` : "Length",
      lengthOf(sketch, from, to),
      (length) => desk.setLength(link, from, to, length),
      isLength,
    ),
  );
  const base = drivenFrom(sketch, link);
  const drive = choice("", [["", "not driven"], ...bodies(sketch, link)], base === null ? "" : String(base), (value) =>
    desk.edit((draft) => driveLink(draft, link, value === "" ? null : bodyOf(value))),
  );
  const removals = points.map((point) => {
    const words = { "aria-label": `Take ${letters(point)} from link ${numberOf(link)}` };
    return button(`${letters(point)} ×`, words, () => desk.edit((draft) => takeFromLink(draft, link, point)));
  });
  const pins = made("span", { className: "field", role: "group", "aria-label": "Pins" }, "Pins", ...removals);
  const fields = [
    textField("name", "Name", name, String(numberOf(link)), (text) =>
      desk.edit((draft) => (draft.links[link].name = text)),
    ),
    ...lengths,
    labelled("drive", "Driven from", drive),
    ...(points.length > 2 ? [pins] : []),
  ];
  return { title, fields };
}
