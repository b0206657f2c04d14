/** A drawing as data, in the form of `kin_sketch::Sketch`, and what can be asked of it. */

/**
 * @typedef {"ground" | number} Body the ground, or the index of a link
 * @typedef {{name: string, x: number, y: number}} Point
 * @typedef {{name: string, points: number[]}} Link
 * @typedef {{point: number, on: Body, direction: number, guided: number | null}} Slide direction in radians
 * @typedef {{angle: {of: number, to: Body}} | {slide: number}} Drive
 * @typedef {{name: string, points: Point[], ground: number[], links: Link[], slides: Slide[], drives: Drive[]}} Sketch
 * @typedef {{kind: "point" | "link", index: number}} Part
 */

/** @returns {Sketch} */
export function emptySketch() {
  return { name: "Linkage", points: [], ground: [], links: [], slides: [], drives: [] };
}

/** A copy with every list, and with what each slide guides, where the text left them out. @returns {Sketch} */
export function completed(sketch) {
  const copy = { ...emptySketch(), ...structuredClone(sketch) };
  if (Array.isArray(copy.slides)) {
    copy.slides = copy.slides.map((slide) => ({ guided: null, ...slide }));
  }
  return copy;
}

/** @returns {[number, number]} */
export function at(sketch, point) {
  return [sketch.points[point].x, sketch.points[point].y];
}

/** The links that have a point. */
export function linksAt(sketch, point) {
  return [...sketch.links.keys()].filter((link) => sketch.links[link].points.includes(point));
}

/** The slides of a point. */
export function slidesAt(sketch, point) {
  return [...sketch.slides.keys()].filter((slide) => sketch.slides[slide].point === point);
}

/** The number that the notes give a link, after the ground, which is 1. */
export function numberOf(link) {
  return link + 2;
}

/** What a person calls a body. */
export function nameOf(sketch, body) {
  return body === "ground" ? "the ground" : sketch.links[body].name || `link ${numberOf(body)}`;
}

/** The body from which the drive of a link counts; null if it has none. @returns {Body | null} */
export function drivenFrom(sketch, link) {
  return sketch.drives.find((drive) => drive.angle?.of === link)?.angle.to ?? null;
}

/** Whether a slide is driven. */
export function isDriven(sketch, slide) {
  return sketch.drives.some((drive) => drive.slide === slide);
}

/** The joint about which a drive turns a link: its pivot on the body from which the angle counts. */
export function pivotOf(sketch, link) {
  const to = drivenFrom(sketch, link);
  const others = to === "ground" || to === null ? sketch.ground : sketch.links[to].points;
  const { points } = sketch.links[link];
  return points.find((point) => others.includes(point)) ?? points[0];
}

/** A letter that no point has yet. Letters that declarations use for other things are left out. */
export function unusedName(sketch) {
  const taken = new Set(sketch.points.map((point) => point.name));
  for (let round = 0; ; round += 1) {
    for (const letter of "abcdfghjkmnopqtuvwxyz") {
      const name = round === 0 ? letter : `${letter}${round}`;
      if (!taken.has(name)) {
        return name;
      }
    }
  }
}
