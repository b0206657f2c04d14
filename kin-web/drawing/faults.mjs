/** What keeps the drawing from being a mechanism, in words. A fault of which a part is drawn selects it. */
import { button, made } from "../../kin-studio/src/page/elements.mjs";

/** The parts that faults are about. */
export function faultyParts(faults) {
  const all = (kind) => [...new Set(faults.flatMap((fault) => fault[kind] ?? []))];
  return { points: all("points"), links: all("links"), slides: all("slides") };
}

/** The first part of a fault that can be selected, or null. @returns {import("./model/sketch.mjs").Part | null} */
function firstPart(fault, sketch) {
  const [point, link, slide] = [fault.points?.[0], fault.links?.[0], fault.slides?.[0]];
  if (sketch.links[link] !== undefined) {
    return { kind: "link", index: link };
  }
  const index = point ?? sketch.slides[slide]?.point;
  return sketch.points[index] === undefined ? null : { kind: "point", index };
}

export function createFaultList(desk) {
  const element = made("ul", { className: "faults", "aria-label": "What is left to do" });
  // what stands between backticks is a name
  const worded = ({ message, advice }) => {
    const text = advice ? `${message}: ${advice}.` : `${message}.`;
    const pieces = (text[0].toUpperCase() + text.slice(1)).split("`");
    return pieces.map((piece, index) => (index % 2 === 0 ? piece : made("code", {}, piece)));
  };
  return {
    element,
    update(faults, sketch) {
      element.replaceChildren(
        ...faults.map((fault) => {
          const part = firstPart(fault, sketch);
          if (part === null) {
            return made("li", {}, ...worded(fault));
          }
          const leading = button("", {}, () => desk.show(part));
          leading.append(...worded(fault));
          return made("li", {}, leading);
        }),
      );
    },
  };
}
