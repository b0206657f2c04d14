/** Whether data has the form of a drawing whose every index is one of a part. */

/** What is wrong with data that shall be a drawing; null if nothing is. @returns {string | null} */
export function mistakeIn(sketch) {
  const isList = (list) => Array.isArray(list);
  if (![sketch.points, sketch.ground, sketch.links, sketch.slides, sketch.drives].every(isList)) {
    return "a drawing has lists of points, links, slides and drives";
  }
  const { points, ground, links, slides, drives } = sketch;
  const isPlace = (point) => typeof point?.name === "string" && Number.isFinite(point.x) && Number.isFinite(point.y);
  if (typeof sketch.name !== "string" || !points.every(isPlace)) {
    return "the drawing and each point have a name, and a point has two finite coordinates";
  }
  const isOf = (list) => (index) => Number.isInteger(index) && index >= 0 && index < list.length;
  const [isPoint, isLink, isSlide] = [points, links, slides].map(isOf);
  const isBody = (body) => body === "ground" || isLink(body);
  const isSound =
    ground.every(isPoint) &&
    links.every((link) => typeof link?.name === "string" && isList(link.points) && link.points.every(isPoint)) &&
    slides.every(
      (slide) =>
        isPoint(slide?.point) &&
        isBody(slide.on) &&
        Number.isFinite(slide.direction) &&
        (slide.guided === null || isLink(slide.guided)),
    ) &&
    drives.every((drive) => (drive?.angle ? isLink(drive.angle.of) && isBody(drive.angle.to) : isSlide(drive?.slide)));
  return isSound ? null : "a link, a slide, a drive or the ground has a part that is not drawn";
}
