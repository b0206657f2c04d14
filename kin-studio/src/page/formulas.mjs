/** Formulas in MathML: only elements and attributes of mathematics are taken over from what the report holds. */

const MATH_SPACE = "http://www.w3.org/1998/Math/MathML";
const ELEMENTS = words(`math mrow mi mn mo mtext mspace ms mfrac msqrt mroot mstyle mpadded mphantom msub msup msubsup
  munder mover munderover mmultiscripts mprescripts none mtable mtr mtd semantics`);
const ATTRIBUTES = words(`class display mathvariant stretchy fence separator form lspace rspace width height depth
  accent accentunder displaystyle scriptlevel columnalign rowspacing columnspacing linethickness minsize maxsize
  symmetric largeop movablelimits`);

function words(text) {
  return new Set(text.split(/\s+/));
}

/** The styles that kin gives to parts of formulas, as classes of the page: its content policy admits no others. */
const CLASSES = {
  "font-weight:bold": "heavy",
  "padding-bottom:0.15em": "spaced",
  "text-align:-webkit-left;padding-left:0": "to-left",
  "text-align:-webkit-right;padding-right:0": "to-right",
};

/** MathML with classes in place of styles; unknown styles are left out. */
export function withClasses(source) {
  return source.replace(/\sstyle="([^"]*)"/g, (_, style) => (CLASSES[style] ? ` class="${CLASSES[style]}"` : ""));
}

/** The formula as an element, or null if it holds anything but MathML. @returns {Element | null} */
export function formulaOf(source) {
  if (!seemsMathematics(withClasses(source))) {
    return null;
  }
  const parsed = new DOMParser().parseFromString(withClasses(source), "application/xml");
  return parsed.documentElement ? taken(parsed.documentElement) : null;
}

/** Whether all tags of a text are those of mathematics: others are not even parsed. */
export function seemsMathematics(source) {
  const tags = [...source.matchAll(/<(\/?)([^\s>/]*)([^>]*)>?/g)];
  const attributes = (text) => [...text.matchAll(/([^\s=/"]+)\s*=\s*"[^"]*"/g)].map(([, name]) => name);
  const clean = (text) => /^(\s+[^\s=/"<]+\s*=\s*"[^"<]*")*\s*\/?$/.test(text);
  return tags.length > 0 && tags.every(([, , name, rest]) => clean(rest) && isMathematics(name, attributes(rest)));
}

/** Whether an element's name and attributes are those of presentation MathML. */
export function isMathematics(name, attributes) {
  return ELEMENTS.has(name) && attributes.every((attribute) => ATTRIBUTES.has(attribute) || attribute === "xmlns");
}

function taken(source) {
  const attributes = [...source.attributes];
  const inSpace = source.namespaceURI === MATH_SPACE || source.namespaceURI === null;
  if (
    !inSpace ||
    !isMathematics(
      source.localName,
      attributes.map(({ name }) => name),
    )
  ) {
    return null;
  }
  const element = document.createElementNS(MATH_SPACE, source.localName);
  for (const { name, value } of attributes) {
    if (name !== "xmlns") {
      element.setAttribute(name, value);
    }
  }
  for (const child of source.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) {
      element.append(child.textContent);
    } else if (child.nodeType === Node.ELEMENT_NODE) {
      const inner = taken(child);
      if (inner === null) {
        return null;
      }
      element.append(inner);
    } else if (child.nodeType !== Node.COMMENT_NODE) {
      return null;
    }
  }
  return element;
}
