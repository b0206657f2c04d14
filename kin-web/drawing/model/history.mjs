/** The drawings before the present one and those after it. */

const KEPT = 200;

export function createHistory(first) {
  let [before, present, after] = [[], first, []];
  return {
    present: () => present,
    canUndo: () => before.length > 0,
    canRedo: () => after.length > 0,
    /** Makes a drawing the present one; false if it is as the last one was. */
    push(next) {
      if (JSON.stringify(next) === JSON.stringify(present)) {
        return false;
      }
      before = [...before, present].slice(-KEPT);
      [present, after] = [next, []];
      return true;
    },
    undo() {
      if (before.length > 0) {
        after = [present, ...after];
        present = before.pop();
      }
      return present;
    },
    redo() {
      if (after.length > 0) {
        before = [...before, present];
        present = after.shift();
      }
      return present;
    },
  };
}
