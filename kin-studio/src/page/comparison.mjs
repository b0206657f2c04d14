/** The kept design beside the present one: what differs, and the extremes of both. */
import { made, table } from "./elements.mjs";
import { numberText, ORDERS, quantityText } from "./numbers.mjs";

/** A change that is rounding, as a part of the value. */
const SAME = 1e-9;

/** The change of a value as a part of it in words; empty where there is none. */
export function changeText(before, now) {
  if (typeof before !== "number" || typeof now !== "number" || Math.abs(now - before) <= SAME * Math.abs(before)) {
    return "";
  }
  if (before === 0) {
    return "new";
  }
  const percent = (100 * (now - before)) / Math.abs(before);
  return `${percent > 0 ? "+" : ""}${numberText(percent, 3)} %`;
}

/**
 * The dimensions, standing inputs and speed in which two designs differ.
 * @returns {{text: string, dimension: string, order: number, before: number, now: number}[]}
 */
export function differencesOf(model, before, now) {
  const of = (group, list) =>
    list.map(({ name, text, dimension }) => ({
      text,
      dimension,
      order: 0,
      before: before[group][name],
      now: now[group][name],
    }));
  const { text, dimension } = model.variable;
  const speed = { text: `speed of ${text}`, dimension, order: 1, before: before.speed, now: now.speed };
  const standing = model.inputs.filter(({ moves }) => !moves);
  return [...of("parameters", model.parameters), ...of("standing", standing), speed].filter(
    (one) => one.before !== one.now,
  );
}

/** The section of a page, which is hidden as long as no design is kept. */
export function createComparison(add, model) {
  const differences = made("p", {});
  const peaks = made("div", { className: "scroll" });
  const section = add("A and now", differences, peaks);
  section.id = "comparison";
  section.hidden = true;

  return {
    hide() {
      section.hidden = true;
    },
    /**
     * @param {import("./kinematics/model.mjs").Design[]} designs the kept and the present design
     * @param {import("./kinematics/peaks.mjs").Peak[][]} both their peaks
     */
    show([before, now], [peaksBefore, peaksNow], degrees) {
      const text = (value, quantity) => quantityText(value, quantity, model, degrees, 6);
      const all = differencesOf(model, before, now).map((one) => {
        const change = changeText(one.before, one.now);
        return `${one.text} ${text(one.before, one)} → ${text(one.now, one)}${change ? ` (${change})` : ""}`;
      });
      differences.textContent = all.length > 0 ? all.join(", ") : "Both have the same dimensions.";
      const rows = peaksNow.map((peak, index) => {
        const quantity = { ...model.quantities.find(({ name }) => name === peak.quantity), order: peak.order };
        const old = peaksBefore.find((one) => one.quantity === peak.quantity && one.order === peak.order);
        const isFirst = peak.quantity !== peaksNow[index - 1]?.quantity;
        const swatch = made("span", { className: `legend c${quantity.colour}` });
        const head = isFirst ? made("th", { scope: "row" }, swatch, ` ${quantity.text}`) : "";
        const sides = ["highest", "lowest"].flatMap((side) => {
          const values = [old, peak].map((one) => one?.[side] && (one[side].value ?? Infinity));
          const texts = values.map((value) =>
            typeof value !== "number" ? "–" : Number.isFinite(value) ? text(value, quantity) : "unbounded",
          );
          return [...texts, values.every(Number.isFinite) ? changeText(...values) : ""];
        });
        return [head, made("td", { className: "words" }, ORDERS[peak.order]), ...sides];
      });
      peaks.replaceChildren(
        table(["Quantity", "", "Highest of A", "now", "change", "Lowest of A", "now", "change"], rows),
      );
      section.hidden = false;
    },
  };
}
