/** Elements that are drawn again in each frame. */
import { change, drawn } from "./elements.mjs";

/** Elements that are used again for the next frame. */
export function pool(layer) {
  const kept = new Map();
  const counts = new Map();
  return {
    begin() {
      counts.clear();
    },
    add(name, attributes) {
      const list = kept.get(name) ?? [];
      kept.set(name, list);
      const count = counts.get(name) ?? 0;
      counts.set(name, count + 1);
      const element = list[count] ?? drawn(name, {}, layer);
      list[count] = element;
      element.removeAttribute("display");
      change(element, attributes);
      return element;
    },
    end() {
      for (const [name, list] of kept) {
        for (const element of list.slice(counts.get(name) ?? 0)) {
          element.setAttribute("display", "none");
        }
      }
    },
  };
}
