/** The targets of links and figures: other chapters, their headings, and files beside them. */
import { existsSync } from "node:fs";

/** @param {string} docs the folder of the markdown */
export function createLinks(docs) {
  const inside = [];
  const files = new Set();
  return {
    /** The files that the chapters show or link. */
    files,

    /** The address of a target in a chapter. */
    addressIn(chapter, target) {
      if (/^https?:/.test(target)) {
        return target;
      }
      const [, name, heading = ""] = /^(?:([\w-]+)\.md)?(?:#(.*))?$/.exec(target) ?? [];
      if (name !== undefined || target.startsWith("#")) {
        inside.push({ chapter, target, to: name ?? chapter, heading });
        return (name ? `${name}.html` : "") + (heading && `#${heading}`);
      }
      if (!existsSync(docs + target)) {
        throw new Error(`${chapter}.md links to nothing: ${target}`);
      }
      files.add(target);
      return target;
    },

    /**
     * @param {Map<string, string[]>} headings the identities of the headings of each chapter
     * @throws {Error} if a link leads to nothing
     */
    check(headings) {
      const dead = inside.filter(({ to, heading }) => {
        const there = headings.get(to);
        return !there || (heading !== "" && !there.includes(heading));
      });
      if (dead.length > 0) {
        throw new Error(dead.map(({ chapter, target }) => `${chapter}.md links to nothing: ${target}`).join("\n"));
      }
    },
  };
}
