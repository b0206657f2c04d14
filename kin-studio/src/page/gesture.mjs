/** A pointer from where it goes down until it is lifted. */

/** The motion of a pointer from which a click is a drag, in pixels. */
export const STILL = 4;

/** The position of a pointer within an element. */
export function within(element, event) {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** Follows a pointer from where it went down until it is lifted. */
export function follow(element, event, move, end) {
  element.setPointerCapture(event.pointerId);
  const ofPointer = (handler) => (next) => {
    if (next.pointerId === event.pointerId) {
      handler(next);
    }
  };
  const onMove = ofPointer(move);
  const onEnd = ofPointer((next) => {
    element.removeEventListener("pointermove", onMove);
    element.removeEventListener("pointerup", onEnd);
    element.removeEventListener("pointercancel", onEnd);
    end(next);
  });
  element.addEventListener("pointermove", onMove);
  element.addEventListener("pointerup", onEnd);
  element.addEventListener("pointercancel", onEnd);
}
