/** What the keyboard and screen readers reach of the picture: an element for each part. */
import { change, drawn, line, tenth } from "../../kin-studio/src/page/elements.mjs";
import { hull } from "../../kin-studio/src/page/notation.mjs";
import { numberText } from "../../kin-studio/src/page/numbers.mjs";
import { lengthOf, sidesOf } from "./model/lengths.mjs";
import { drivenFrom, isDriven, nameOf, slidesAt } from "./model/sketch.mjs";

export function createHits(svg) {
  const groups = {
    link: drawn("g", { class: "hits" }, svg),
    point: drawn("g", { class: "hits" }, svg),
  };
  const element = (kind, index) => {
    const existing = groups[kind].children[index];
    if (existing !== undefined) {
      return existing;
    }
    const name = kind === "point" ? "circle" : "path";
    return drawn(
      name,
      { tabindex: 0, role: "button", "data-kind": kind, "data-index": index, class: `hit hit-${kind}` },
      groups[kind],
    );
  };
  return {
    draw({ sketch, places, selection }) {
      const isSelected = (kind, index) => selection?.kind === kind && selection.index === index;
      sketch.links.forEach(({ points }, index) => {
        const outer = hull(points.map((point) => places[point]));
        const ends = outer.length === 1 ? [outer[0], outer[0]] : outer;
        change(element("link", index), {
          d: line(ends, outer.length > 2),
          "aria-label": linkWords(sketch, index),
          "aria-pressed": isSelected("link", index),
        });
      });
      places.forEach(([x, y], index) => {
        change(element("point", index), {
          cx: tenth(x),
          cy: tenth(y),
          r: 12,
          "aria-label": pointWords(sketch, index),
          "aria-pressed": isSelected("point", index),
        });
      });
      for (const [kind, count] of [
        ["link", sketch.links.length],
        ["point", sketch.points.length],
      ]) {
        while (groups[kind].children.length > count) {
          const last = groups[kind].lastElementChild;
          if (last === document.activeElement) {
            svg.focus();
          }
          last.remove();
        }
      }
    },
    /** The part that an element stands for, or null. @returns {import("./model/sketch.mjs").Part | null} */
    partOf(target) {
      const kind = target?.getAttribute?.("data-kind") ?? null;
      return kind === null ? null : { kind, index: Number(target.getAttribute("data-index")) };
    },
    focus({ kind, index }) {
      groups[kind].children[index]?.focus();
    },
  };
}

/** What a screen reader says of a link. */
function linkWords(sketch, link) {
  const [from, to] = sidesOf(sketch.links[link])[0] ?? [];
  const names = sketch.links[link].points.map((point) => sketch.points[point].name);
  const base = drivenFrom(sketch, link);
  const words = [`${nameOf(sketch, link)} through ${names.join(", ")}`];
  if (to !== undefined) {
    words.push(`length ${numberText(lengthOf(sketch, from, to))}`);
  }
  if (base !== null) {
    words.push(`driven from ${nameOf(sketch, base)}`);
  }
  return words.join(", ");
}

/** What a screen reader says of a point. */
function pointWords(sketch, point) {
  const { name, x, y } = sketch.points[point];
  const words = [`point ${name} at ${numberText(x)}, ${numberText(y)}`];
  if (sketch.ground.includes(point)) {
    words.push("fixed");
  }
  for (const slide of slidesAt(sketch, point)) {
    words.push(`slides along ${nameOf(sketch, sketch.slides[slide].on)}${isDriven(sketch, slide) ? ", driven" : ""}`);
  }
  return words.join(", ");
}
