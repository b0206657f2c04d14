/** The page's modules without a browser. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { anatomyOf, followedAt, coordinatesOf } from "../src/page/kinematics/anatomy.mjs";
import { isMathematics, seemsMathematics, withClasses } from "../src/page/formulas.mjs";
import { createRoom, keepLines, placeName } from "../src/page/labels.mjs";
import { isBroken, motionOf, pieceAt, samplesOf } from "../src/page/kinematics/drive.mjs";
import { curvesOf } from "../src/page/curves.mjs";
import { allForces, forcesOn } from "../src/page/diagram.mjs";
import { forcesAt, scalesOfForces, sizeOf } from "../src/page/kinematics/forces.mjs";
import { kindText, marksOf, stopText } from "../src/page/kinematics/marks.mjs";
import { cautionOf } from "../src/page/dimensions.mjs";
import { createModel, FORMAT, givenDesign, movedOn, reasonToRefuse, solveAt } from "../src/page/kinematics/model.mjs";
import { nearestInput } from "../src/page/kinematics/nearest.mjs";
import { acrossOf, groundAxes } from "../src/page/kinematics/axes.mjs";
import { gearsAt } from "../src/page/kinematics/gears.mjs";
import { rackOf, teethOf } from "../src/page/teeth.mjs";
import { axisOf, sharedPower, unitWithPower } from "../src/page/axes.mjs";
import { placeOfReadout, readoutsOf } from "../src/page/readouts.mjs";
import { paceText, pacesAround, secondsOf, watchablePace } from "../src/page/pace.mjs";
import { numberText, steadyText, ticks, unitText, withUnit } from "../src/page/numbers.mjs";
import { givenPeaks, ownPeaks } from "../src/page/kinematics/peaks.mjs";
import { hull } from "../src/page/notation.mjs";
import { circleOfCurvature, instantCentre, ratesOfJoints } from "../src/page/kinematics/rates.mjs";
import { gapText, shortfallOf } from "../src/page/reasons.mjs";
import { quotedCell, sweepTable } from "../src/page/saving.mjs";
import { allRows, createSweep, movedInput, rowAt, rowBefore, straightNames } from "../src/page/kinematics/sweep.mjs";
import { poorTransmission } from "../src/page/kinematics/transmission.mjs";
import { createView, fitView, flat, onPage, orbitView, zoomView } from "../src/page/view.mjs";
import { poseText } from "../src/page/words.mjs";
import { bundle } from "./bundle.mjs";
import { forcesOf, LAW, reportOf, solver } from "./testing/slider_crank.mjs";

function prepared(changes) {
  const model = createModel(reportOf(changes), solver);
  const design = givenDesign(model);
  const assembly = model.report.assemblies[model.report.assembly];
  return { model, design, assembly, sweep: createSweep(model, design, assembly) };
}

const SHORT_ROD = {
  parameters: [
    { name: "r", text: "r", dimension: "length", value: 30 },
    { name: "l", text: "l", dimension: "length", value: 15 },
  ],
};

test("the bundle is that of the modules", async () => {
  for (const { path, text } of await bundle()) {
    assert.ok(readFileSync(path, "utf8") === text, `${path} is old: npm run bundle`);
    assert.doesNotMatch(text, /setAttribute\("style"|innerHTML|insertAdjacentHTML|eval\(|<\/?script|<!--|<\/style/);
  }
});

test("numbers are short, with true minus signs and powers of ten", () => {
  assert.deepEqual(
    [0, -1.5, 1234.5678, 1e-9, -2.5e8, Infinity].map((value) => numberText(value)),
    ["0", "−1.5", "1234.6", "1×10⁻⁹", "−2.5×10⁸", "∞"],
  );
  assert.equal(numberText(0.1 + 0.2, 6), "0.3");
  assert.deepEqual(
    [1.23456, -0.00001].map((value) => steadyText(value, 9.9)),
    ["1.235", "0.000"],
  );
});

test("units follow the order and the choice of degrees", () => {
  const units = { length: "mm", time: "s" };
  assert.deepEqual(
    [0, 1, 2, 4].map((order) => unitText("length", order, units, true)),
    ["mm", "mm/s", "mm/s²", "mm/s⁴"],
  );
  assert.deepEqual(
    [0, 3].map((order) => unitText("angle", order, units, true)),
    ["°", "°/s³"],
  );
  assert.equal(unitText("angle", 1, units, false), "rad/s");
  assert.equal(unitText("number", 1, units, false), "1/s");
  assert.deepEqual([withUnit("5", "°"), withUnit("5", "mm"), withUnit("5", "")], ["5°", "5 mm", "5"]);
});

test("ticks are round, and parts of a revolution in degrees", () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(0, 360, 4, true), [0, 90, 180, 270, 360]);
  assert.deepEqual(ticks(1, 1, 5), []);
});

test("an axis ends before few values that are far larger than the rest, and tells how far they go", () => {
  const wave = [...Array(200).keys()].map((step) => Math.sin(step / 10));
  const quiet = axisOf(wave, 1);
  assert.deepEqual([quiet.above, quiet.below], [null, null]);
  assert.ok(quiet.low < -1 && quiet.low > -1.3 && quiet.high > 1 && quiet.high < 1.3);
  const singular = axisOf([...wave, 1e18, -3e9], 1);
  assert.deepEqual([singular.above, singular.below], [1e18, -3e9]);
  assert.ok(singular.low < -1 && singular.high > 1 && singular.high - singular.low < 20);
  // a peak that can be read beside the rest is no singularity
  assert.equal(axisOf([...wave, 100], 1).above, null);
  // a short move between rests keeps its peak
  assert.equal(axisOf([...Array(200).fill(0), 5, 40, 5], 1).above, null);
});

test("what changes by rounding alone is a straight line", () => {
  const { low, high } = axisOf([1e-13, -2e-14, 3e-15], 90);
  assert.ok(high - low > 1 && low < 0 && high > 0);
});

test("numbers of an axis share a power of ten", () => {
  assert.deepEqual([[0, 20000], [5e-4], [2e7, -3e6], [0]].map(sharedPower), [0, -6, 6, 0]);
  assert.deepEqual([unitWithPower("mm", 6), unitWithPower("", -3), unitWithPower("°", 0)], ["10⁶ mm", "10⁻³", "°"]);
});

test("values stand beside the title, in lines with their names, or without names", () => {
  const names = (count) => [...Array(count).keys()].map((index) => `angle_${index}`);
  assert.equal(readoutsOf(names(1), 320, 130).columns, 0);
  const six = readoutsOf(names(6), 390, 130);
  assert.deepEqual([six.named, six.columns, six.count], [true, 3, 6]);
  assert.deepEqual(placeOfReadout(six, 4), [130, 26]);
  const narrow = readoutsOf(names(6), 195, 90);
  assert.ok(!narrow.named && narrow.count >= 4);
});

test("a newer report is refused with both numbers", () => {
  assert.equal(reasonToRefuse(reportOf()), "");
  const reason = reasonToRefuse(reportOf({ format: 7 }));
  assert.match(reason, /format 7/);
  assert.ok(reason.includes(`up to ${FORMAT}.`));
  assert.match(reasonToRefuse(reportOf({ format: 1 })), /format 1.*format \d+.*again/);
  assert.notEqual(reasonToRefuse(null), "");
});

test("Taylor polynomials lead from pose to pose", () => {
  const { model, design } = prepared();
  const one = solveAt(model, design, 1, 1).pose;
  const other = solveAt(model, design, 1.01, 1).pose;
  // the rest of the series is below (0.01)^5 times the size of the motion
  assert.ok(Math.abs(movedOn(one.s, 0.01 / design.speed) - other.s[0]) < 100 * 0.01 ** 5);
});

test("what moves in proportion to the input squashes the others, unless it is alone", () => {
  const { sweep } = prepared();
  assert.deepEqual(straightNames(sweep), []);
  const [s] = sweep.model.quantities;
  const quantities = [{ ...s, name: "gear" }, s];
  const scales = [[3, 1, 1e-13, 0, 1e-12], sweep.scales[0]];
  const of = (all) => straightNames({ ...sweep, model: { ...sweep.model, quantities: all }, scales });
  assert.deepEqual(of(quantities), ["gear"]);
  assert.deepEqual(of(quantities.slice(0, 1)), []);
});

test("a whole revolution is one stretch, and passes from its end to its beginning", () => {
  const { model, sweep } = prepared();
  assert.ok(sweep.full);
  const moved = movedInput(sweep, 6.2, 0.2);
  assert.ok(!moved.stopped);
  assert.ok(Math.abs(moved.x - (6.4 - 2 * Math.PI)) < 1e-12);
  assert.ok(Math.abs(sweep.travel[0][0] - 50) < 1e-9 && Math.abs(sweep.travel[0][1] - 110) < 1e-9);
});

test("limits are found to 1e-9, and motion stops there", () => {
  const { model, sweep } = prepared(SHORT_ROD);
  const limits = [Math.PI / 6, (5 * Math.PI) / 6, (7 * Math.PI) / 6, (11 * Math.PI) / 6];
  assert.equal(sweep.spans.length, 3);
  const found = sweep.gaps.flatMap(({ from, to }) => [from, to]);
  found.forEach((x, index) => assert.ok(Math.abs(x - limits[index]) < 2e-9, `${x}`));
  assert.ok(Math.abs(sweep.gaps[0].margin + 15) < 1e-12);
  const moved = movedInput(sweep, 0.4, 0.5);
  assert.ok(moved.stopped && Math.abs(moved.x - limits[0]) < 2e-9);
  const marks = marksOf(sweep);
  assert.equal(marks.length, 4);
  assert.ok(marks.every(({ foundByPage }) => foundByPage));
  assert.equal(stopText(sweep, marks, moved.x, true), "Limit at θ = 30°: the links of s do not meet.");
});

test("the report's exact limits replace those of the page", () => {
  const end = (input, kind = { Limit: "TurningPoint" }) => ({ kind, input, block: "s" });
  const branch = (...ends) => ({ circuit: 0, assembly: 0, ends });
  const cycle = (...branches) => ({ incomplete: [], circuits: [], branches });
  const { model, sweep } = prepared({ ...SHORT_ROD, cycle: cycle(branch(end(-Math.PI / 6), end(Math.PI / 6))) });
  const marks = marksOf(sweep);
  assert.deepEqual(
    marks.map(({ foundByPage }) => foundByPage),
    [false, true, true, false],
  );
  assert.equal(marks[0].x, Math.PI / 6);
  assert.equal(stopText(sweep, marks, marks[0].x, true), "Limit at θ = 30°: limit position of s.");
  const others = prepared({
    ...SHORT_ROD,
    cycle: cycle(
      branch(end(0.1, "Range"), end(0.2, { Limit: "Pole" })),
      branch(end(0.3, "Lost"), end(0.4, "FullTurn")),
    ),
  });
  const texts = marksOf(others.sweep).filter(({ foundByPage }) => !foundByPage);
  assert.deepEqual(
    texts.map(({ kind, text }) => [kind, text]),
    [
      ["Pole", "pole of s"],
      ["Lost", ""],
    ],
  );
});

test("a coupled mechanism goes on from its last pose, and reports where it is lost", () => {
  const near = { coupled: true, assemblies: [{ name: "assembly 1", argument: { s: 100 }, at: 0.1, circuit: 0 }] };
  const byGuess = {
    solve: (parameters, inputs, { s }) => {
      const [one, other] = [1, -1].map((sign) => solver.solve(parameters, inputs, sign));
      return !one.ok || Math.abs(one.pose.s[0] - s) < Math.abs(other.pose.s[0] - s) ? one : other;
    },
  };
  const turning = createModel(reportOf(near), byGuess);
  const whole = createSweep(turning, givenDesign(turning), turning.report.assemblies[0]);
  assert.ok(whole.full && allRows(whole).every(({ pose }) => pose.s[0] > 0));
  const stuck = createModel(reportOf({ ...near, ...SHORT_ROD }), byGuess);
  const part = createSweep(stuck, givenDesign(stuck), stuck.report.assemblies[0]);
  assert.equal(part.gaps.length, 1);
  assert.ok(part.gaps[0].lost);
  assert.ok(Math.abs(part.spans[0].to - Math.PI / 6) < 1e-6);
});

test("a pose between rows is solved, and stands still outside", () => {
  const { model, design, sweep, assembly } = prepared();
  const row = rowAt(sweep, 1.23456);
  assert.equal(row.pose.s[0], solveAt(model, design, 1.23456, 1).pose.s[0]);
  assert.equal(rowAt({ ...sweep, spans: [] }, 1), null);
});

test("peaks are those of calculus", () => {
  const { model, design, sweep, assembly } = prepared();
  const [position] = ownPeaks(sweep);
  assert.ok(Math.abs(position.highest.value - 110) < 1e-12);
  assert.ok(Math.abs(position.lowest.value - 50) < 1e-12 && Math.abs(position.lowest.at - Math.PI) < 1e-6);
  const velocity = ownPeaks(sweep)[1];
  const there = solveAt(model, design, velocity.highest.at, 1).pose.s;
  assert.ok(Math.abs(there[2]) < 1e-3 * 30 * 100, "the acceleration vanishes at the peak of the velocity");
});

test("at a limit positions have their extremes, and rates are unbounded", () => {
  const { sweep } = prepared(SHORT_ROD);
  const [position, velocity] = ownPeaks(sweep);
  // the page finds limits to 1e-10 of the range, and the position goes like the square root of that
  assert.ok(Math.abs(position.lowest.value + 30 * Math.cos(Math.PI / 6)) < 30 * 1e-4);
  assert.ok(Math.abs(position.highest.value - 45) < 1e-12);
  assert.deepEqual([velocity.highest.value, velocity.lowest.value, velocity.rms], [null, null, null]);
});

test("the report's peaks are taken over as they are", () => {
  const extremes = [
    { quantity: "s", order: 1, kind: "highest", value: 1.5, at: 0.25, place: "inner" },
    { quantity: "s", order: 1, kind: "lowest", value: null, at: 1, place: "unbounded" },
  ];
  const model = createModel(reportOf({ extremes, rms: [{ quantity: "s", order: 1, value: 2 }] }), solver);
  const [peak] = givenPeaks(model);
  assert.deepEqual([peak.highest.value, peak.lowest.value, peak.rms], [1.5, null, 2]);
});

test("a dragged crank follows the pointer, and stops at a limit", () => {
  const { model, design, sweep, assembly } = prepared();
  const placed = (pose) => pose.joints[1];
  const free = nearestInput(sweep, 0.3, placed, [20, 20]);
  assert.ok(Math.abs(free.x - Math.PI / 4) < 1e-4 && !free.beyond);
  const backwards = nearestInput(sweep, 0.1, placed, [20, -5]);
  assert.ok(Math.abs(backwards.x - (2 * Math.PI - Math.atan(0.25))) < 1e-4, "it passes the end of the revolution");
  const stuck = prepared(SHORT_ROD);
  const held = nearestInput(stuck.sweep, 0.3, placed, [0, 30]);
  assert.ok(held.beyond && Math.abs(held.x - Math.PI / 6) < 2e-9);
});

test("pins, the driven body and the floating body are found", () => {
  const { model, sweep } = prepared();
  const anatomy = anatomyOf(sweep);
  assert.deepEqual(anatomy.pins, [true, true, true]);
  assert.deepEqual(anatomy.driven, [true, false]);
  assert.equal(anatomy.floating, 1);
  const followed = followedAt(
    model,
    1,
    [
      [0, 0],
      [0, 0],
      [10, 0],
    ],
    [5, 2],
  );
  assert.deepEqual([followed.along, followed.across], [0.5, 0.2]);
  assert.deepEqual(
    coordinatesOf(model, followed, [
      [0, 0],
      [0, 0],
      [0, 10],
    ]),
    [-2, 5],
  );
});

test("rates of joints agree with those of the solver", () => {
  const { model, design, assembly, sweep } = prepared();
  const row = rowAt(sweep, 0.7);
  const rates = ratesOfJoints(sweep, row);
  [1, 2, 3].forEach((order) => {
    const size = 30 * 10 ** order;
    assert.ok(Math.abs(rates[2][order - 1][0] - row.pose.s[order]) < 1e-5 * size, `order ${order}`);
  });
});

test("curvature and instant centres of known motions", () => {
  const circle = circleOfCurvature([2, 0], [0, 6], [-18, 0]);
  assert.deepEqual([circle.centre, circle.radius], [[0, 0], 2]);
  assert.equal(circleOfCurvature([0, 0], [1, 0], [0, 0]), null);
  assert.deepEqual(instantCentre([1, 0], [0, 2], [0, 3], [-6, 0]), [0, 0]);
  assert.equal(instantCentre([1, 0], [0, 2], [1, 1], [1, 1]), null);
});

test("hulls are convex, and lines have two ends", () => {
  assert.equal(
    hull([
      [0, 0],
      [9, 9],
      [9, 0],
      [4, 5],
      [0, 9],
    ]).length,
    4,
  );
  assert.deepEqual(
    hull([
      [0, 0],
      [9, 9],
      [4, 4],
    ]),
    [
      [0, 0],
      [9, 9],
    ],
  );
  assert.equal(hull([[1, 1]]).length, 1);
});

test("a body of space turns about the normal of its path, along its shaft, or about a point", () => {
  const turned = (angle) => [Math.cos(angle), Math.sin(angle), 0.5];
  const poses = [0, 0.3, 0.9, 2].map((angle) => ({
    joints: [[0, 0, 0.5], turned(angle), [2, 0, 0], [2, 0, 3], [4, 0, 0], [4 + angle, angle ** 2, angle ** 3]],
  }));
  const outline = { ground: [0, 2, 3, 4], bodies: [{ joints: [0, 1] }, { joints: [2, 3, 1] }, { joints: [5, 4] }] };
  const axes = groundAxes({ outline }, poses, 3);
  assert.deepEqual(
    axes.map((axis) => axis && axis.map((value) => Math.abs(value))),
    [[0, 0, 1], null, [0, 0, 1], [0, 0, 1], null, null],
  );
  for (const direction of acrossOf([0.6, 0, 0.8])) {
    assert.ok(Math.abs(direction[0] * 0.6 + direction[2] * 0.8) < 1e-15);
    assert.ok(Math.abs(Math.hypot(...direction) - 1) < 1e-15);
  }
});

/** A gear on the ground and a wheel that rolls on it: outside, inside, or both as a rack. */
function rolling({ radii: [one, other], centre, rack = null, turn }) {
  const outline = {
    ground: [0, 2],
    bodies: [{ joints: [0, 1] }, { joints: [2, 3] }, { joints: [4] }],
    slides: [{ joint: 4, guide: null }],
  };
  const forces = {
    contacts: [
      {
        circles: [
          { body: 0, centre: { fixed: [0, 0] }, radius: one, dimension: null },
          ...(rack ? [] : [{ body: 1, centre: { joint: 2 }, radius: other, dimension: "r" }]),
        ],
        rack,
      },
    ],
  };
  const poseAt = (angle) => ({
    joints: [
      [0, 0],
      [Math.cos(angle), Math.sin(angle)],
      [centre, 0],
      [centre + Math.cos(turn * angle), Math.sin(turn * angle)],
      [one, 5 + one * angle],
    ],
    slides: [[0, 1]],
  });
  const angles = [0, 0.1, 0.2, 0.3];
  const model = { space: false, outline, report: { forces }, parameters: [{ declared: "r", name: "r" }] };
  const rows = angles.map((angle) => ({ x: angle, pose: poseAt(angle) }));
  const sweep = {
    model,
    design: { parameters: { r: other } },
    spans: [{ from: 0, to: 0.3, rows }],
    gaps: [],
    full: true,
  };
  return rows.map(({ pose }) => gearsAt(sweep, { fixed: [], drivers: [] }, pose));
}

test("teeth mesh: at the pitch point a tooth stands in a gap, and teeth turn with their bodies", () => {
  const cases = [
    { radii: [2, 5], centre: 7, turn: -2 / 5, isInside: false },
    { radii: [2, 5], centre: -3, turn: 2 / 5, isInside: true },
    { radii: [5, 2], centre: 3, turn: 5 / 2, isInside: true },
  ];
  for (const { isInside, ...one } of cases) {
    const poses = rolling(one);
    for (const { gears } of poses) {
      const [first, second] = gears;
      assert.ok(Math.abs(first.teeth / second.teeth - one.radii[0] / one.radii[1]) < 1e-12);
      assert.equal(first.isRing || second.isRing, isInside);
      const small = one.radii[0] < one.radii[1] ? first : second;
      const large = small === first ? second : first;
      const way = small.centre[0] - large.centre[0] > 0 ? 0 : Math.PI;
      const part = (gear, direction) => (gear.teeth * (direction - gear.phase)) / (2 * Math.PI);
      const sum = part(large, way) + (isInside ? -1 : 1) * part(small, isInside ? way : way + Math.PI);
      assert.ok(Math.abs(Math.abs(sum - Math.round(sum)) - 0.5) < 1e-9, `${sum}`);
    }
    const [before, after] = poses.map(({ gears }) => gears[1].phase);
    assert.ok(Math.abs(after - before - 0.1 * one.turn) < 1e-9);
  }
  const ring = teethOf(rolling(cases[1])[0].gears[1]);
  assert.equal(ring.length, 2);
});

test("a rack moves with its body below its gear", () => {
  const rack = { body: 2, along: [0, -3] };
  const [before, after] = rolling({ radii: [2, 1], centre: 9, rack, turn: 1 }).map(({ racks }) => racks[0]);
  const moved = rackOf(after).map(([x, y], index) => [x - rackOf(before)[index][0], y - rackOf(before)[index][1]]);
  assert.ok(moved.length > 8 && moved.every(([x, y]) => Math.abs(x) < 1e-9 && Math.abs(y - 0.2) < 1e-9));
  // the gear's pitch point is on the right, and the teeth point to the gear
  assert.ok(Math.abs(before.up[0] + 1) < 1e-9);
  assert.ok(Math.abs(before.from[0] - 2) < 1e-9);
});

test("names avoid lines, other names and the edge", () => {
  const room = createRoom(200, 100);
  keepLines(
    room,
    [
      [0, 50],
      [200, 50],
    ],
    5,
  );
  const one = placeName(room, [[100, 50]], "name", 14, undefined);
  const other = placeName(room, [[100, 50]], "name", 14, undefined);
  assert.ok(Math.abs(one.y - 50) > 10 && Math.abs(other.y - 50) > 10);
  assert.ok(Math.abs(one.x - other.x) > 30 || Math.abs(one.y - other.y) > 14);
  assert.equal(placeName(createRoom(10, 10), [[5, 5]], "much too long", 14, undefined), null);
});

test("views fit, zoom about a point and orbit about a centre", () => {
  const view = createView(false);
  fitView(
    view,
    [
      [0, 0],
      [10, 5],
    ],
    { left: 0, right: 100, top: 0, bottom: 100 },
  );
  assert.deepEqual(onPage(view, [0, 0]), [0, 75]);
  const before = onPage(view, [3, 2]);
  zoomView(view, before, 2);
  assert.deepEqual(onPage(view, [3, 2]).map(Math.round), before.map(Math.round));
  const space = createView(true);
  const centre = onPage(space, [1, 2, 3]);
  orbitView(space, [40, 10], [1, 2, 3]);
  onPage(space, [1, 2, 3]).forEach((value, axis) => assert.ok(Math.abs(value - centre[axis]) < 1e-12));
  assert.ok(flat(space, [0, 0, 1])[1] < 0, "z points up");
});

test("tables have a heading with units, and all digits", () => {
  const { model, sweep } = prepared();
  const lines = sweepTable(sweep, true).trim().split("\r\n");
  assert.equal(
    lines[0],
    "theta [deg],time [s],s [mm],s velocity [mm/s],s acceleration [mm/s²],s jerk [mm/s³],s snap [mm/s⁴]",
  );
  assert.equal(lines.length, allRows(sweep).length + 1);
  assert.ok(Math.abs(Number(lines[1].split(",")[2]) - 110) < 1e-12);
  assert.equal(quotedCell('a "b", c'), '"a ""b"", c"');
});

test("poor transmission is shaded between its crossings of 40 degrees", () => {
  const degree = Math.PI / 180;
  const samples = [
    [0, 60],
    [1, 50],
    [2, 30],
    [3, 20],
    [4, 60],
  ].map(([input, angle]) => ({ input, angles: [angle * degree] }));
  const model = createModel(
    reportOf({ transmission: { dyads: ["s"], worst: [{ angle: 0.3, at: 3 }], samples } }),
    solver,
  );
  const [band] = poorTransmission({ model, reported: true, spans: [{ from: 0, to: 5 }] });
  assert.ok(Math.abs(band[0] - 1.5) < 1e-9 && Math.abs(band[1] - 3.5) < 1e-9);
  assert.deepEqual(
    poorTransmission({
      model,
      reported: true,
      spans: [
        { from: 0, to: 1.7 },
        { from: 2.8, to: 3.1 },
      ],
    }),
    [[2.8, 3.1]],
  );
});

test("formulas hold mathematics alone", () => {
  assert.ok(isMathematics("mfrac", ["xmlns"]));
  assert.ok(
    !isMathematics("script", []) &&
      !isMathematics("mi", ["onclick"]) &&
      !isMathematics("maction", []) &&
      !isMathematics("mi", ["href"]),
  );
  assert.equal(
    withClasses('<mi style="font-weight:bold">x</mi><mo style="background:url(x)">+</mo>'),
    '<mi class="heavy">x</mi><mo>+</mo>',
  );
});

test("what is not mathematics is not even parsed", () => {
  assert.ok(
    seemsMathematics(
      '<math xmlns="x" display="block"><mrow><mi mathvariant="normal">e</mi><mo>&lt;</mo></mrow><mspace/></math>',
    ),
  );
  for (const evil of [
    "text",
    "<b>x</b>",
    '<mi onclick="x">y</mi>',
    "<mi onclick=x>y</mi>",
    "<!-- <mi> -->",
    "</script><mi>x</mi>",
    '<math href="x"></math>',
  ]) {
    assert.ok(!seemsMathematics(evil), evil);
  }
});

test("a pose is stated in words", () => {
  const { model, design, sweep, assembly } = prepared();
  const row = rowAt(sweep, 0);
  assert.equal(poseText(model, row, true, "open", [0]), "θ = 0°, s = 110 mm; open");
});

test("an angle goes on behind a gap as in kin's tables", () => {
  const psi = (x) => 2.9 + 0.2 * x;
  const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
  const solve = (_, { theta: [x] }) =>
    x > 2.0003 && x < 4.0007
      ? { ok: false, check: "reach of two circles", block: "psi", margin: -1 }
      : {
          ok: true,
          pose: {
            psi: [wrapped(psi(x)), 0.2, 0, 0, 0],
            joints: [
              [0, 0],
              [Math.cos(psi(x)), Math.sin(psi(x))],
            ],
            slides: [],
          },
        };
  const quantity = { name: "psi", key: "psi", text: "ψ", documentation: "", dimension: "angle" };
  const outline = { ground: [0], bodies: [{ name: "r", joints: [0, 1] }], slides: [], points: [] };
  const model = createModel(reportOf({ unknowns: [quantity], outline }), { solve });
  const sweep = createSweep(model, givenDesign(model), model.report.assemblies[0]);
  assert.equal(sweep.spans.length, 2);
  const rows = allRows(sweep);
  for (const { x, pose, shifts } of rows) {
    assert.ok(Math.abs(pose.psi[0] + shifts[0] - psi(x)) < 1e-9, `${x}`);
  }
  assert.ok(rows.filter(({ shifts }) => shifts[0] !== 0).length > 100);
});

test("the pace 1 is as fast as the mechanism", () => {
  assert.deepEqual(["s", "ms", "min", "turns"].map(secondsOf), [1, 1000, 1 / 60, 1]);
  for (const [speed, pace] of [
    [1, 1],
    [10, 0.2],
    [157.08, 0.01],
    [-157.08, 0.01],
    [0.01, 100],
  ]) {
    const { model, design } = prepared({ speed });
    const found = watchablePace(model, design);
    assert.equal(found, pace, `${speed}`);
    const seconds = (2 * Math.PI) / Math.abs(speed) / found;
    assert.ok(seconds >= 3 && seconds <= 12, `${seconds}`);
    assert.ok(pacesAround(found).includes(1) && pacesAround(found).includes(found));
  }
  assert.deepEqual(pacesAround(0.01), [0.002, 0.005, 0.01, 0.02, 0.05, 1]);
  assert.deepEqual([0.001, 0.2, 1, 50].map(paceText), ["1/1000×", "1/5×", "1×", "50×"]);
});

test("a gap is stated by a length only where its margin is one", () => {
  const { model } = prepared({});
  const gap = (check, margin) => ({ check, margin, block: "s", from: 0, to: 1, at: 0, lost: false });
  const amount = (length) => `${length} mm`;
  for (const [check, margin, text] of [
    ["reach of two circles", -5, "the links of s do not meet: short by 5 mm"],
    ["sqrt", -10000, "the links of s do not meet: short by 100 mm"],
    ["root of coupled equations", 53.34, "no position is found for s"],
    ["root of coupled equations", -53.34, "no position is found for s"],
    ["range of an angle", -0.5, "range of an angle (s)"],
    ["reach of two circles", NaN, "reach of two circles (s)"],
    ["regular determinant", 1e-17, "regular determinant (s)"],
  ]) {
    assert.equal(gapText(model, gap(check, margin), amount), text);
  }
  assert.equal(gapText(model, gap("reach of two circles", -5), null), "the links of s do not meet");
  assert.equal(shortfallOf(gap("reach of a link", -2)), 2);
});

test("what is typed and not taken is reported, and so are lengths that no link has", () => {
  const entry = { group: "parameters", dimension: "length", declared: "r2", name: "r2" };
  const said = (changes, typed, usual = 30) => cautionOf({ ...entry, ...changes }, typed, usual, "30 mm");
  assert.equal(said({}, ""), "This is no number: 30 mm is still shown.");
  assert.equal(said({ group: "speed" }, "0"), "A speed is not zero: 30 mm is still shown.");
  assert.match(said({}, "-30"), /negative length/);
  assert.match(said({}, "0"), /length zero/);
  for (const [changes, typed, usual] of [
    [{}, "5", 30],
    [{ declared: "p.x" }, "-5", 30],
    [{}, "-5", -3],
    [{ dimension: "angle" }, "-5", 1],
    [{ group: "speed" }, "-5", 1],
  ]) {
    assert.equal(said(changes, typed, usual), "");
  }
});

test("a drive has the rates of its series, and both sides of its joints", () => {
  const { model } = prepared(LAW);
  const { drive } = model;
  assert.ok(drive.overTime && model.variable.dimension === "time");
  assert.deepEqual(
    [0, 0.05, 0.1, 0.3, 0.5, 0.6].map((x) => pieceAt(drive, x)),
    [0, 0, 1, 1, 2, 2],
  );
  const motion = motionOf(drive, 0, 0.3, 1, 1, 4);
  assert.deepEqual(motion, [0.5, 3.75, 0, -187.5, 0]);
  // at another speed of the variable, rates by time have its powers
  assert.deepEqual(motionOf(drive, 0, 0.3, 1, 2, 3), [0.5, 7.5, 0, -1500]);
  const [before, behind] = [0, 1].map((piece) => motionOf(drive, 0, 0.1, piece, 1, 2));
  [0, 0, 37.5].forEach((value, order) => assert.ok(Math.abs(behind[order] - value) < 1e-12 && before[order] === 0));
  const samples = samplesOf(drive, 0, 0.6, 360, 8);
  assert.deepEqual(
    samples.filter(({ x }) => x === 0.1).map(({ piece }) => piece),
    [0, 1],
  );
  assert.ok(samples.every(({ x }, index) => index === 0 || x >= samples[index - 1].x));
  const line = { pieces: [{ from: 0, to: 1, at: 0, inputs: [[0, 1]] }], joints: [], overTime: false };
  assert.equal(samplesOf(line, 0, 1, 360, 8).length, 361);
});

test("a short piece has rows for itself", () => {
  const pieces = [
    [0, 0.5],
    [0.5, 0.501],
    [0.501, 1],
  ].map(([from, to]) => ({ from, to, at: from, inputs: [[0]] }));
  const samples = samplesOf({ pieces, joints: [], overTime: true }, 0, 1, 360, 8);
  assert.ok(samples.filter(({ x }) => x > 0.5 && x < 0.501).length >= 7);
});

test("under a law, curves have gaps where a derivative jumps", () => {
  const { model, design, assembly, sweep } = prepared(LAW);
  assert.equal(sweep.spans.length, 1);
  assert.ok(!sweep.full);
  const rows = allRows(sweep);
  const breaks = (order) =>
    rows
      .slice(1)
      .filter((row, index) => isBroken(model.drive, rows[index], row, order))
      .map(({ x }) => x);
  assert.deepEqual([0, 1, 2, 3, 4].map(breaks), [[], [], [0.1, 0.5], [0.1, 0.5], [0.1, 0.5]]);
  const row = rowAt(sweep, 0.1);
  const before = rowBefore(sweep, row);
  assert.deepEqual([before.piece, row.piece, before.pose.s[2], before.pose.s[0] - row.pose.s[0]], [0, 1, 0, 0]);
  assert.ok(row.pose.theta[2] > 37);
  assert.equal(rowBefore(sweep, rowAt(sweep, 0.2)), null);
  const marks = marksOf(sweep);
  assert.deepEqual(
    marks.map(({ kind }) => kind),
    ["Joint", "Joint"],
  );
  assert.equal(kindText(marks[0]), "Acceleration jumps at");
  assert.equal(stopText(sweep, marks, 0.6, true), "End of the range at time = 0.6 s.");
});

test("under a law, values are those of the solver with the motion of the law", () => {
  const { model, design, assembly, sweep } = prepared(LAW);
  const theta = [0.5, 3.75, 0, -187.5, 0];
  const { pose } = solver.solve({ r: 30, l: 80 }, { theta }, 1);
  const row = rowAt(sweep, 0.3);
  row.pose.s.forEach((value, order) =>
    assert.ok(Math.abs(value - pose.s[order]) <= 1e-12 * Math.abs(pose.s[order]), `order ${order}`),
  );
  // the input is one of the quantities
  assert.deepEqual(
    model.quantities.map(({ name, isInput }) => [name, isInput]),
    [
      ["s", false],
      ["theta", true],
    ],
  );
  assert.deepEqual(row.pose.theta, theta);
  const lines = sweepTable(sweep, true).trim().split("\r\n");
  assert.match(lines[0], /^time \[s\],s \[mm\],.*theta \[deg\],theta velocity/);
  assert.equal(lines[1].split(",").length, 11);
  assert.equal(poseText(model, row, true, "", [0]), `time = 0.3 s, s = ${numberText(pose.s[0])} mm`);
  // another rod: the same law
  const longer = { ...design, parameters: { r: 30, l: 100 } };
  const again = rowAt(createSweep(model, longer, assembly), 0.3);
  assert.deepEqual(again.pose.theta, theta);
  assert.ok(again.pose.s[0] > row.pose.s[0] + 15);
});

test("above a jump there is no bound", () => {
  const { model, design, assembly, sweep } = prepared(LAW);
  const peaks = ownPeaks(sweep).filter(({ quantity }) => quantity === "theta");
  assert.equal(peaks[0].highest.value, 1);
  assert.ok(Math.abs(peaks[1].highest.value - 3.75) < 1e-12 && Math.abs(peaks[1].highest.at - 0.3) < 1e-6);
  // the acceleration jumps up where the law begins, and up where it ends
  assert.ok(Math.abs(peaks[2].highest.value - 37.5) < 1e-9 && peaks[2].rms > 0);
  assert.deepEqual([peaks[3].highest, peaks[3].rms], [{ value: null, at: 0.1 }, null]);
  assert.ok(peaks[3].lowest.value < -187);
  assert.deepEqual(
    [peaks[4].highest, peaks[4].lowest],
    [
      { value: null, at: 0.1 },
      { value: null, at: 0.1 },
    ],
  );
});

test("rates of joints go on by the series of their own piece", () => {
  const { model, design, assembly, sweep } = prepared(LAW);
  const row = rowAt(sweep, 0.5 - 1e-9);
  const rates = ratesOfJoints(sweep, row);
  // the crank's pin at 1 rad with the acceleration of the end of the law
  const size = 30 * 37.5;
  assert.ok(Math.abs(rates[1][1][1] - 30 * Math.cos(1) * row.pose.theta[2]) < 1e-3 * size);
  assert.ok(Math.hypot(...ratesOfJoints(sweep, rowAt(sweep, 0.55))[1][0]) < 1e-9);
});

test("several inputs move along one line, and those that stand have values", () => {
  const input = (name, dimension, value) => ({
    name,
    key: name,
    text: name,
    documentation: "",
    dimension,
    ...(value === undefined ? {} : { value }),
  });
  const inputs = [input("theta", "angle"), input("lift", "length"), input("tilt", "angle", 0.25)];
  const drive = {
    variable: "input",
    pieces: [{ from: 0, to: 2, at: 1, inputs: [[1, 1], [7, -3], [0.25]] }],
    joints: [],
  };
  const seen = [];
  const solve = (_, given) => {
    seen.push(given);
    return {
      ok: true,
      pose: {
        s: [given.lift[0], ...given.lift.slice(1)],
        joints: [
          [0, 0],
          [Math.cos(given.theta[0]), Math.sin(given.theta[0])],
        ],
        slides: [],
      },
    };
  };
  const outline = { ground: [0], bodies: [{ name: "r", joints: [0, 1] }], slides: [], points: [] };
  const model = createModel(reportOf({ inputs, drive, range: [0, 2], period: null, speed: 10, outline }), { solve });
  const design = givenDesign(model);
  assert.deepEqual(design.standing, { tilt: 0.25 });
  solveAt(model, design, 1.5, 1);
  assert.deepEqual(seen.pop(), { theta: [1.5, 10, 0, 0, 0], lift: [5.5, -30, 0, 0, 0], tilt: [0.25, 0, 0, 0, 0] });
  const sweep = createSweep(model, design, model.report.assemblies[0]);
  assert.deepEqual(anatomyOf(sweep).drivers, [0]);
  const row = rowAt(sweep, 1.5);
  assert.equal(poseText(model, row, false, "", []), "theta = 1.5 rad, lift = 5.5 mm");
  const [head, first] = sweepTable(sweep, false)
    .split("\r\n")
    .map((line) => line.split(","));
  assert.deepEqual(
    [head.slice(0, 3), first.slice(0, 3)],
    [
      ["theta [rad]", "lift [mm]", "time [s]"],
      ["0", "10", "0"],
    ],
  );
});

/** Samples of a range, its ends among them. */
function placesIn([from, to], count) {
  return [...Array(count).keys()].map((index) => from + ((to - from) * index) / (count - 1));
}

test("forces between the samples are those of the formula, with their rates", () => {
  const { model, sweep } = prepared({ forces: forcesOf(placesIn([0, 2 * Math.PI], 181), 10) });
  for (const x of [0, 0.0123, 1, 3.3333, 2 * Math.PI]) {
    const { forces, curves, loads } = forcesAt(model, rowAt(sweep, x));
    const [pin] = forces;
    const expected = [50 * Math.cos(2 * x), 20 * Math.sin(x), -1000 * Math.sin(2 * x), 200 * Math.cos(x)];
    expected.forEach((value, index) => assert.ok(Math.abs(pin[index] - value) < 1e-2 * 10 ** (index > 1 ? 0 : -2)));
    assert.ok(Math.abs(curves[0][0] - 2 * Math.sin(x)) < 1e-6);
    assert.ok(Math.abs(loads[0][2] - 10 - x) < 1e-9 && Math.abs(loads[1][0] - x) < 1e-9);
    const [size, rate] = sizeOf(pin);
    assert.ok(Math.abs(size - Math.hypot(expected[0], expected[1])) < 1e-4);
    const slope = (expected[0] * expected[2] + expected[1] * expected[3]) / Math.hypot(expected[0], expected[1]);
    assert.ok(Math.abs(rate - slope) < 0.05);
  }
  assert.deepEqual(scalesOfForces(model, 100), { force: Math.hypot(50, 20), couple: 2 * Math.PI });
  // beside forces of this size at this distance, the couples are small
  assert.equal(scalesOfForces(model, 1e4).couple, 0.05 * Math.hypot(50, 20) * 1e4 * 0.001);
});

test("where the acceleration jumps, a force is that of its own side", () => {
  const forces = forcesOf([0, 0.08, 0.12, 0.6], 1);
  forces.samples.forEach(({ input, forces: [pin] }) => pin.splice(0, 4, input < 0.1 ? 5 : 80, 0, 0, 0));
  const { model } = prepared({ ...LAW, forces });
  const at = (x, piece) => forcesAt(model, { x, piece }).forces[0][0];
  assert.deepEqual([at(0.099, 0), at(0.1, 0), at(0.1, 1), at(0.11, 1)], [5, 5, 80, 80]);
});

test("what is not known of a force is left out", () => {
  const forces = forcesOf(placesIn([0, 2 * Math.PI], 19), 10);
  forces.samples.slice(4).forEach((sample) => (sample.forces[0] = null));
  const { model, sweep } = prepared({ forces });
  assert.deepEqual(
    allForces(model, rowAt(sweep, 4)).map(({ key }) => key),
    ["guide"],
  );
  const group = curvesOf(model).find(({ name }) => name === "force");
  assert.ok(Number.isNaN(group.curves[0].value(rowAt(sweep, 4), 0)));
  assert.ok(group.curves[0].scale(sweep, 0) > 0);
});

test("the force of a contact acts where two bodies touch", () => {
  const forces = forcesOf([0, 1], 10);
  forces.joints[1].joint = null;
  forces.samples.forEach((sample) => (sample.contacts = [[30 + 10 * sample.input, 5]]));
  const { model, sweep } = prepared({ forces });
  const row = rowAt(sweep, 0.25);
  assert.deepEqual(allForces(model, row)[1].at, [32.5, 5]);
  assert.deepEqual(forcesOn(model, row, 1)[1].at, [32.5, 5]);
  // without a pose there, no arrow stands anywhere
  forces.samples.forEach((sample) => delete sample.contacts);
  assert.equal(allForces(model, rowAt(sweep, 0.5)).length, 1);
});

test("a body alone has the opposite of the force that it exerts, and its loads", () => {
  const { model, sweep } = prepared({ forces: forcesOf(placesIn([0, 2 * Math.PI], 181), 10) });
  const row = rowAt(sweep, 0.5);
  const [onRod, onCrank] = [1, 0].map((body) => forcesOn(model, row, body));
  assert.deepEqual(
    onRod.map(({ kind }) => kind),
    ["joint", "joint", "mass"],
  );
  assert.deepEqual(
    onCrank.map(({ kind }) => kind),
    ["joint", "drive"],
  );
  assert.deepEqual(
    onCrank[0].force,
    onRod[0].force.map((part) => -part),
  );
  assert.deepEqual(onRod[0].at, row.pose.joints[1]);
  // a couple stands at the joint on the ground
  assert.deepEqual(onCrank[1].at, [0, 0]);
  assert.equal(onCrank[1].text, "drive 0.5 N m");
  assert.match(allForces(model, row)[1].title, /^guide: 3\.479 N on l, by ground$/);
});
