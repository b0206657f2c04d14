/** From the mechanism's coordinates to those of the picture: a scale, an offset, and for space a direction of view. */

/** @typedef {{space: boolean, scale: number, x: number, y: number, yaw: number, pitch: number}} View */

/** The direction along the diagonal of space. */
const DIAGONAL = { yaw: Math.PI / 4, pitch: Math.PI / 6 };

/** A view along the diagonal of space, or straight upon the plane. @returns {View} */
export function createView(space) {
  return { space, scale: 1, x: 0, y: 0, ...DIAGONAL };
}

/** Whether a view of space was turned. */
export function isTurned({ yaw, pitch }) {
  return yaw !== DIAGONAL.yaw || pitch !== DIAGONAL.pitch;
}

/** A point or direction without scale and offset; y points down. @returns {[number, number]} */
export function flat(view, point) {
  if (!view.space) {
    return [point[0], -point[1]];
  }
  const [x, y, z] = point;
  const [sine, cosine] = [Math.sin(view.yaw), Math.cos(view.yaw)];
  const towards = x * cosine + y * sine;
  return [y * cosine - x * sine, towards * Math.sin(view.pitch) - z * Math.cos(view.pitch)];
}

/** @returns {[number, number]} */
export function onPage(view, point) {
  const [x, y] = flat(view, point);
  return [x * view.scale + view.x, y * view.scale + view.y];
}

/** Shows some points as large as a rectangle allows. */
export function fitView(view, points, room) {
  const seen = points.map((point) => flat(view, point)).filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
  if (seen.length === 0) {
    return;
  }
  const low = [0, 1].map((axis) => seen.reduce((least, point) => Math.min(least, point[axis]), Infinity));
  const high = [0, 1].map((axis) => seen.reduce((most, point) => Math.max(most, point[axis]), -Infinity));
  const size = Math.max(high[0] - low[0], high[1] - low[1], 1e-9);
  const width = Math.max(high[0] - low[0], 0.05 * size);
  const height = Math.max(high[1] - low[1], 0.05 * size);
  view.scale = Math.max(1e-9, Math.min((room.right - room.left) / width, (room.bottom - room.top) / height));
  view.x = 0.5 * (room.left + room.right) - 0.5 * (low[0] + high[0]) * view.scale;
  view.y = 0.5 * (room.top + room.bottom) - 0.5 * (low[1] + high[1]) * view.scale;
}

/** Whether all points are seen in a picture of a size. */
export function seesAll(view, points, [width, height]) {
  return points.every((point) => {
    const [x, y] = onPage(view, point);
    return x >= 0 && x <= width && y >= 0 && y <= height;
  });
}

/** Brings a view from one place and scale to another, by a part of the way. */
export function moveView(view, from, to, part) {
  for (const name of ["scale", "x", "y"]) {
    view[name] = from[name] + (to[name] - from[name]) * part;
  }
}

/** Enlarges about a point of the picture. */
export function zoomView(view, at, factor) {
  view.scale *= factor;
  view.x = at[0] + (view.x - at[0]) * factor;
  view.y = at[1] + (view.y - at[1]) * factor;
}

/**
 * Turns a view of space about a point of the picture.
 * @param {[number, number]} by in pixels
 * @param {number[]} centre the point that stays
 */
export function orbitView(view, by, centre) {
  const before = onPage(view, centre);
  view.yaw -= by[0] / 150;
  view.pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, view.pitch + by[1] / 150));
  const after = onPage(view, centre);
  view.x += before[0] - after[0];
  view.y += before[1] - after[1];
}
