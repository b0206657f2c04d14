/** The reader's notes: a text that is kept in the saved page and printed. */
import { made } from "./elements.mjs";

/** @param {(title: string, ...content: (Node | string)[]) => HTMLElement} add adds a section to the page */
export function createNotes(add) {
  const field = made("textarea", { id: "notes", rows: 3, className: "no-print", "aria-label": "Notes" });
  field.placeholder = "Your own words. They are kept in the page that you save, and printed.";
  // a field is cut on paper
  const printed = made("p", { className: "printed prose" });
  const section = add("Notes", field, printed);
  const show = () => {
    printed.textContent = field.value;
    section.classList.toggle("no-print", field.value.trim() === "");
    field.rows = Math.min(20, Math.max(3, field.value.split("\n").length + 1));
  };
  field.addEventListener("input", show);
  show();
  return {
    text: () => field.value,
    set(text) {
      field.value = text;
      show();
    },
  };
}
