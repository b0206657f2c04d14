/** Changes of a drawing. Each changes the draft that it is given. */
import { at, drivenFrom, isDriven, linksAt, unusedName } from "./sketch.mjs";
import { turnLevers, turnSlides } from "./rails.mjs";

/** The drawing after a change. The one before stays as it is. */
export function changed(sketch, action) {
  const draft = structuredClone(sketch);
  action(draft);
  return draft;
}

/** Adds a point and returns its index. */
export function addPoint(draft, [x, y]) {
  return draft.points.push({ name: unusedName(draft), x, y }) - 1;
}

/** Adds a link through points and returns its index; the one that has them all already, if there is one. */
export function addLink(draft, points) {
  const same = draft.links.findIndex((link) => points.every((point) => link.points.includes(point)));
  return same >= 0 ? same : draft.links.push({ name: "", points: [...points] }) - 1;
}

/** Makes a point one of a link. */
export function addToLink(draft, link, point) {
  const { points } = draft.links[link];
  if (!points.includes(point)) {
    points.push(point);
  }
}

/** Fixes a point, which then slides along the ground no more, or sets it free. */
export function fix(draft, point, isFixed) {
  draft.ground = draft.ground.filter((other) => other !== point);
  if (isFixed) {
    draft.ground.push(point);
    removeSlides(draft, (slide) => slide.point === point && slide.on === "ground");
  }
}

/** Lets a point slide along a line of a body, of which it is then no fixed point, and returns the slide's index. */
export function addSlide(draft, point, on, direction) {
  const known = draft.slides.findIndex((slide) => slide.point === point && slide.on === on);
  if (known >= 0) {
    draft.slides[known].direction = direction;
    return known;
  }
  if (on === "ground") {
    draft.ground = draft.ground.filter((other) => other !== point);
  }
  return draft.slides.push({ point, on, direction, guided: null }) - 1;
}

/** Drives a link from a body, or drives it no more if the body is null. */
export function driveLink(draft, link, to) {
  draft.drives = draft.drives.filter((drive) => drive.angle?.of !== link);
  if (to !== null) {
    draft.drives.push({ angle: { of: link, to } });
  }
}

/** Drives a slide, or drives it no more. */
export function driveSlide(draft, slide, isToBe) {
  draft.drives = draft.drives.filter((drive) => drive.slide !== slide);
  if (isToBe) {
    draft.drives.push({ slide });
  }
}

/** Drives a link from the ground if it has no drive, and takes its drive away if it has one. */
export function toggleDrive(draft, link) {
  driveLink(draft, link, drivenFrom(draft, link) === null ? "ground" : null);
}

/** Moves a point. A slotted lever turns with the pin in its slot, and the lines of slides turn with their links. */
export function movePoint(draft, point, to) {
  const before = structuredClone(draft);
  [draft.points[point].x, draft.points[point].y] = to;
  turnLevers(before, draft, [point]);
  turnSlides(before, draft);
}

/** Moves several points: their indices and where they go. */
export function movePoints(draft, places) {
  const before = structuredClone(draft);
  for (const [point, [x, y]] of places) {
    Object.assign(draft.points[point], { x, y });
  }
  turnSlides(before, draft);
}

/** Moves all points of a link. */
export function moveLink(draft, link, [x, y]) {
  const places = draft.links[link].points.map((point) => {
    const [fromX, fromY] = at(draft, point);
    return [point, [fromX + x, fromY + y]];
  });
  movePoints(draft, new Map(places));
}

/** Makes two points one joint: the first one stays. A link that had both would be a link of one point, and goes. */
export function joinPoints(draft, kept, joined) {
  const renamed = (point) => (point === joined ? kept : point);
  for (const link of draft.links) {
    link.points = [...new Set(link.points.map(renamed))];
  }
  draft.ground = [...new Set(draft.ground.map(renamed))];
  draft.slides.forEach((slide) => (slide.point = renamed(slide.point)));
  dropPoint(draft, joined);
  const stays = joined < kept ? kept - 1 : kept;
  for (const link of linksAt(draft, stays).reverse()) {
    if (draft.links[link].points.length === 1 && !carriesSlide(draft, link)) {
      removeLink(draft, link);
    }
  }
}

/** Removes a point, and what cannot be without it: its slides, and links of which one point would be left. */
export function removePoint(draft, point) {
  removeSlides(draft, (slide) => slide.point === point);
  const shortened = linksAt(draft, point);
  draft.ground = draft.ground.filter((other) => other !== point);
  for (const link of shortened) {
    draft.links[link].points = draft.links[link].points.filter((other) => other !== point);
  }
  const gone = shortened.filter((link) => draft.links[link].points.length < 2);
  gone.reverse().forEach((link) => dropLink(draft, link));
  dropPoint(draft, point);
  removeLonely(draft);
}

/** Removes a link, its drive and slides, and the points that nothing else has. */
export function removeLink(draft, link) {
  dropLink(draft, link);
  removeLonely(draft);
}

/** Takes a point from a link; the link goes if it has one point left. */
export function takeFromLink(draft, link, point) {
  const { points } = draft.links[link];
  draft.links[link].points = points.filter((other) => other !== point);
  draft.slides.forEach((slide) => {
    if (slide.guided === link && slide.point === point) {
      slide.guided = null;
    }
  });
  if (draft.links[link].points.length < 2) {
    dropLink(draft, link);
  }
  removeLonely(draft);
}

/** Removes a slide with its drive. */
export function removeSlide(draft, slide) {
  removeSlides(draft, (other) => other === draft.slides[slide]);
}

function carriesSlide(draft, link) {
  return draft.slides.some((slide) => slide.on === link || slide.guided === link);
}

function removeSlides(draft, isGone) {
  for (let slide = draft.slides.length - 1; slide >= 0; slide -= 1) {
    if (isGone(draft.slides[slide])) {
      draft.slides.splice(slide, 1);
      draft.drives = draft.drives.filter((drive) => drive.slide !== slide);
      draft.drives.forEach((drive) => {
        if (drive.slide > slide) {
          drive.slide -= 1;
        }
      });
    }
  }
}

function dropLink(draft, link) {
  removeSlides(draft, (slide) => slide.on === link);
  const movedUp = (other) => (typeof other === "number" && other > link ? other - 1 : other);
  draft.links.splice(link, 1);
  draft.drives = draft.drives.filter((drive) => drive.angle?.of !== link && drive.angle?.to !== link);
  draft.drives.forEach((drive) => {
    if (drive.angle) {
      drive.angle = { of: movedUp(drive.angle.of), to: movedUp(drive.angle.to) };
    }
  });
  draft.slides.forEach((slide) => {
    slide.on = movedUp(slide.on);
    slide.guided = slide.guided === link ? null : movedUp(slide.guided);
  });
}

function dropPoint(draft, point) {
  const movedUp = (other) => (other > point ? other - 1 : other);
  draft.points.splice(point, 1);
  draft.ground = draft.ground.map(movedUp);
  draft.links.forEach((link) => (link.points = link.points.map(movedUp)));
  draft.slides.forEach((slide) => (slide.point = movedUp(slide.point)));
}

function removeLonely(draft) {
  for (let point = draft.points.length - 1; point >= 0; point -= 1) {
    const isUsed =
      draft.ground.includes(point) ||
      linksAt(draft, point).length > 0 ||
      draft.slides.some((slide) => slide.point === point && slide.on !== "ground");
    if (!isUsed) {
      removeSlides(draft, (slide) => slide.point === point);
      dropPoint(draft, point);
    }
  }
}

/** Drives what a part suggests: a link, the slide of a point, or the only link on a fixed point. */
export function driveAt(draft, { kind, index }) {
  if (kind === "link") {
    toggleDrive(draft, index);
    return true;
  }
  const slide = draft.slides.findIndex(({ point }) => point === index);
  if (slide >= 0) {
    driveSlide(draft, slide, !isDriven(draft, slide));
    return true;
  }
  const links = linksAt(draft, index);
  if (links.length === 1 && draft.ground.includes(index)) {
    toggleDrive(draft, links[0]);
    return true;
  }
  return false;
}
