/** The drawing as data, in node. */
import assert from "node:assert/strict";
import { after, test } from "node:test";

import { examples } from "../examples.mjs";
import {
  addLink,
  addPoint,
  addSlide,
  addToLink,
  changed,
  driveAt,
  driveLink,
  driveSlide,
  fix,
  joinPoints,
  moveLink,
  movePoint,
  removeLink,
  removePoint,
  takeFromLink,
} from "../model/edits.mjs";
import { gridStep, snap, snapDirection } from "../model/grid.mjs";
import { createHistory } from "../model/history.mjs";
import { lengthOf, setLength, sidesOf } from "../model/lengths.mjs";
import { pick, pickLink } from "../model/picking.mjs";
import { at, completed, emptySketch, isDriven, unusedName } from "../model/sketch.mjs";
import { mistakeIn } from "../model/validity.mjs";
import { startKin } from "./kin.mjs";

const kin = startKin();
after(() => kin.stop());

const [fourBar, sliderCrank, inverted, clamp, watt, lift, fiveBar] = examples.map(({ sketch }) => sketch);
const near = (found, expected, part = 1e-9) =>
  assert.ok(Math.abs(found - expected) < part * (1 + Math.abs(expected)), `${found} instead of ${expected}`);

test("every example is a mechanism", async () => {
  for (const { title, sketch } of examples) {
    const result = await kin.declare(sketch);
    assert.ok(result.text?.startsWith(`struct ${sketch.name} `), `${title}: ${JSON.stringify(result)}`);
  }
});

test("a four-bar linkage is built from edits", async () => {
  const sketch = changed(emptySketch(), (draft) => {
    const [o, a, b, d] = [
      [0, 0],
      [0, 2],
      [4, 4],
      [5, 0],
    ].map((place) => addPoint(draft, place));
    fix(draft, o, true);
    fix(draft, d, true);
    driveLink(draft, addLink(draft, [o, a]), "ground");
    addLink(draft, [a, b]);
    assert.equal(addLink(draft, [d, b]), 2);
    assert.equal(addLink(draft, [b, a]), 1, "the link is there already");
  });
  assert.deepEqual(
    sketch.points.map(({ name }) => name),
    ["a", "b", "c", "d"],
  );
  const { text, dimensions } = await kin.declare(sketch);
  assert.match(text, /c == d \+ r4 \* cis\(theta4\);/);
  assert.deepEqual(dimensions[1], ["r2", 2]);
});

test("the drawing before a change stays as it is", () => {
  const before = structuredClone(fourBar);
  changed(fourBar, (draft) => removePoint(draft, 0));
  changed(fourBar, (draft) => movePoint(draft, 1, [9, 9]));
  assert.deepEqual(fourBar, before);
});

test("what is removed takes along what cannot be without it", () => {
  const withoutCrank = changed(fourBar, (draft) => removeLink(draft, 0));
  assert.deepEqual(withoutCrank.drives, []);
  assert.deepEqual(
    withoutCrank.links.map(({ points }) => points),
    [
      [1, 2, 4],
      [3, 2],
    ],
  );
  const withoutJoint = changed(fourBar, (draft) => removePoint(draft, 2));
  assert.deepEqual(
    withoutJoint.points.map(({ name }) => name),
    ["o", "a", "d", "c"],
  );
  assert.deepEqual(
    withoutJoint.links.map(({ points }) => points),
    [
      [0, 1],
      [1, 3],
    ],
  );
  const withoutSlide = changed(lift, (draft) => removePoint(draft, 1));
  assert.deepEqual(withoutSlide.drives, []);
  assert.deepEqual(withoutSlide.slides, [{ point: 3, on: 2, direction: 0, guided: null }]);
  const withoutTable = changed(lift, (draft) => removeLink(draft, 2));
  assert.deepEqual(withoutTable.slides, [lift.slides[0]]);
  assert.ok(isDriven(withoutTable, 0));
  const shortened = changed(fourBar, (draft) => takeFromLink(draft, 1, 4));
  assert.deepEqual(shortened.links[1].points, [1, 2]);
  assert.equal(shortened.points.length, 4, "the tracing point is of nothing else");
});

test("pins that are joined are one joint", async () => {
  const apart = changed(emptySketch(), (draft) => {
    const points = [
      [0, 0],
      [0, 2],
      [0.1, 2.1],
      [4, 4],
      [5, 0],
    ].map((place) => addPoint(draft, place));
    fix(draft, points[0], true);
    fix(draft, points[4], true);
    driveLink(draft, addLink(draft, [0, 1]), "ground");
    addLink(draft, [2, 3]);
    addLink(draft, [3, 4]);
  });
  assert.ok((await kin.declare(apart)).faults.length > 0);
  const joined = changed(apart, (draft) => joinPoints(draft, 1, 2));
  assert.deepEqual(
    joined.links.map(({ points }) => points),
    [
      [0, 1],
      [1, 2],
      [2, 3],
    ],
  );
  assert.ok((await kin.declare(joined)).text);
  // a link whose ends are joined is none
  assert.equal(changed(joined, (draft) => joinPoints(draft, 1, 0)).links.length, 2);
});

test("slides turn with their links, and leave the ground", () => {
  const turned = changed(inverted, (draft) => movePoint(draft, 3, [3, 4]));
  near(turned.slides[0].direction, inverted.slides[0].direction - (Math.atan2(2, -6) - Math.PI / 2));
  const shifted = changed(inverted, (draft) => moveLink(draft, 1, [1, 1]));
  near(shifted.slides[0].direction, inverted.slides[0].direction);
  assert.deepEqual(at(shifted, 3), [-2, 3]);
  const sliding = changed(fourBar, (draft) => addSlide(draft, 0, "ground", 0.5));
  assert.deepEqual(sliding.ground, [3]);
  const fixed = changed(sliding, (draft) => fix(draft, 0, true));
  assert.deepEqual(fixed.slides, []);
});

test("a slotted lever turns with the pin in its slot", async () => {
  const turned = changed(inverted, (draft) => movePoint(draft, 1, [1, 1]));
  near(turned.slides[0].direction, Math.atan2(1, -2));
  const [x, y] = at(turned, 3);
  near(x, 3 - 2 * Math.SQRT2 * Math.sqrt(4));
  near(y, Math.SQRT2 * Math.sqrt(4));
  near(lengthOf(turned, 2, 3), lengthOf(inverted, 2, 3));
  assert.match((await kin.declare(turned)).text, /a == d \+ s \* cis\(theta3\);/);
  // the table of the lift turns about its joint
  const lifted = changed(lift, (draft) => movePoint(draft, 4, [4, 3.5]));
  near(lifted.slides[1].direction, lift.slides[1].direction + Math.atan2(0.5, 4));
});

test("drives are where a part suggests them", () => {
  const drives = (sketch, part) => changed(sketch, (draft) => driveAt(draft, part)).drives;
  assert.deepEqual(drives(fourBar, { kind: "link", index: 0 }), []);
  assert.deepEqual(drives(fourBar, { kind: "link", index: 2 }).length, 2);
  assert.deepEqual(drives(sliderCrank, { kind: "point", index: 2 })[1], { slide: 0 });
  assert.deepEqual(drives(fourBar, { kind: "point", index: 3 })[1], { angle: { of: 2, to: "ground" } });
  assert.equal(
    changed(fourBar, (draft) => assert.equal(driveAt(draft, { kind: "point", index: 4 }), false)).drives.length,
    1,
  );
  assert.deepEqual(changed(lift, (draft) => driveSlide(draft, 0, false)).drives, []);
});

test("a typed length keeps every other length", async () => {
  for (const sketch of [fourBar, sliderCrank, inverted, clamp, watt, lift, fiveBar]) {
    for (const [link, { points }] of sketch.links.entries()) {
      const [from, to] = points;
      const length = 1.03 * lengthOf(sketch, from, to);
      const result = setLength(sketch, link, from, to, length);
      const words = `${sketch.name}, link ${link}`;
      assert.ok(result.isKept, words);
      near(lengthOf(result.sketch, from, to), length);
      for (const [other, own] of sketch.links.entries()) {
        const isCollinear = sketch === lift && other === link;
        for (const [one, two] of sidesOf(own)) {
          if ((other !== link || one !== from || two !== to) && !isCollinear) {
            near(lengthOf(result.sketch, one, two), lengthOf(sketch, one, two));
          }
        }
      }
      sketch.ground.forEach((point) => assert.deepEqual(at(result.sketch, point), at(sketch, point), words));
      if (sketch === inverted) {
        const [x, y] = [0, 1].map((axis) => at(result.sketch, 1)[axis] - at(result.sketch, 2)[axis]);
        const { direction } = result.sketch.slides[0];
        near(x * Math.sin(direction) - y * Math.cos(direction), 0);
      }
      assert.ok((await kin.declare(result.sketch)).text, words);
    }
  }
  // the crank keeps its angle while the rod gets longer
  const longer = setLength(fourBar, 1, 1, 2, 4.6).sketch;
  near(at(longer, 1)[0], 1);
  near(at(longer, 1)[1], 3);
});

test("a length with which the linkage cannot close moves the end of the link", () => {
  const { sketch, isKept } = setLength(fourBar, 1, 1, 2, 40);
  assert.equal(isKept, false);
  near(lengthOf(sketch, 1, 2), 40);
  assert.deepEqual(at(sketch, 0), at(fourBar, 0));
  assert.deepEqual(at(sketch, 3), at(fourBar, 3));
});

test("the grid is of round numbers and no line is nearer than sixteen pixels to the next", () => {
  for (let scale = 0.013; scale < 1e4; scale *= 1.37) {
    const step = gridStep(scale);
    const digit = Number(step.toExponential(3).split("e")[0]);
    assert.ok([1, 2, 5].includes(digit), `${step}`);
    assert.ok(step * scale >= 15.9 && step * scale < 45, `${step * scale} pixels`);
  }
  assert.deepEqual(snap([0.31, -0.29], 0.1), [0.3, -0.3]);
  assert.deepEqual(snap([-0.01, 7.26], 0.5), [0, 7.5]);
  near(snapDirection(0.8), Math.PI / 4);
  assert.equal(snapDirection(-0.01), 0);
});

test("the nearest pin is picked before a link", () => {
  const places = fourBar.points.map(({ x, y }) => [100 * x, -100 * y]);
  const part = (place) => pick(fourBar, places, place, { radius: 12 });
  assert.deepEqual(part([105, -305]), { kind: "point", index: 1 });
  assert.deepEqual(part([103, -200]), { kind: "link", index: 0 });
  assert.deepEqual(part([300, -480]), { kind: "link", index: 1 }, "within a plate");
  assert.equal(part([300, -200]), null);
  assert.equal(pickLink(fourBar, places, [103, -200], { radius: 12, except: [0] }), null);
});

test("undo and redo go through the drawings one by one", () => {
  const history = createHistory(emptySketch());
  assert.equal(history.canUndo(), false);
  history.push(fourBar);
  assert.equal(history.push(structuredClone(fourBar)), false, "nothing changed");
  history.push(watt);
  assert.equal(history.undo(), fourBar);
  assert.equal(history.redo(), watt);
  history.undo();
  history.push(lift);
  assert.equal(history.canRedo(), false);
  assert.equal(history.undo(), fourBar);
  assert.deepEqual(history.undo(), emptySketch());
  assert.deepEqual(history.undo(), emptySketch());
});

test("names are letters that are free", () => {
  const sketch = completed({ name: "Some" });
  assert.deepEqual(sketch.slides, []);
  const names = [...Array(25).keys()].map(() => sketch.points[addPoint(sketch, [0, 0])].name);
  assert.equal(new Set(names).size, 25);
  assert.equal(unusedName({ ...sketch, points: [] }), "a");
  const link = addLink(sketch, [0, 1]);
  addToLink(sketch, link, 2);
  addToLink(sketch, link, 2);
  assert.deepEqual(sketch.links[link].points, [0, 1, 2]);
});

test("data that is no drawing is refused", () => {
  for (const { sketch } of examples) {
    assert.equal(mistakeIn(sketch), null);
  }
  const refused = (change, words) => {
    const sketch = structuredClone(lift);
    change(sketch);
    assert.match(mistakeIn(completed(sketch)), words);
  };
  refused((sketch) => (sketch.links = null), /has lists/);
  refused((sketch) => (sketch.points[0].x = NaN), /two finite coordinates/);
  refused((sketch) => (sketch.points[0] = null), /two finite coordinates/);
  refused((sketch) => sketch.ground.push(6), /not drawn/);
  refused((sketch) => sketch.links[0].points.push(-1), /not drawn/);
  refused((sketch) => (sketch.links[0] = 3), /not drawn/);
  refused((sketch) => (sketch.slides[0].on = "air"), /not drawn/);
  refused((sketch) => (sketch.slides[0].guided = 9), /not drawn/);
  refused((sketch) => (sketch.drives[0].slide = 2), /not drawn/);
  refused((sketch) => sketch.drives.push({ angle: { of: 0, to: 5 } }), /not drawn/);
  const withoutGuide = structuredClone(lift);
  delete withoutGuide.slides[0].guided;
  assert.equal(mistakeIn(completed(withoutGuide)), null);
});
