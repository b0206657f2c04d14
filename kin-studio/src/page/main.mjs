/** The page: what is shown, and what happens when a reader acts. */
import { movingPicture } from "./animation.mjs";
import { curvesOf } from "./curves.mjs";
import { createSliders } from "./dimensions.mjs";
import { button, change, choice, made, part, setText, tick } from "./elements.mjs";
import { allForces, forcesOn } from "./diagram.mjs";
import { handlePicture, handlePlots, handleScrubber } from "./pointers.mjs";
import { createHodographs } from "./hodographs.mjs";
import { anatomyOf, coordinatesOf } from "./kinematics/anatomy.mjs";
import { motionOf } from "./kinematics/drive.mjs";
import { scalesOfForces } from "./kinematics/forces.mjs";
import { gearsAt } from "./kinematics/gears.mjs";
import { inputText, marksOf, stopText } from "./kinematics/marks.mjs";
import { blockText, createModel, givenDesign, reasonToRefuse } from "./kinematics/model.mjs";
import { designLike, pageKeeping } from "./keeping.mjs";
import { nearestInput } from "./kinematics/nearest.mjs";
import { givenPeaks, ownPeaks } from "./kinematics/peaks.mjs";
import { circleOfCurvature, instantCentre, ratesOfJoints } from "./kinematics/rates.mjs";
import {
  allRows,
  createSweep,
  heldInput,
  innerRows,
  isAtLimit,
  movedInput,
  rowAt,
  sizeOf,
  spanAt,
  straightNames,
  valueAt,
} from "./kinematics/sweep.mjs";
import { BESIDE_LIMIT, PARTS } from "./kinematics/tolerances.mjs";
import { poorTransmission, worstTransmission } from "./kinematics/transmission.mjs";
import { numberText, ticks, unitFactor, withUnit } from "./numbers.mjs";
import { paceText, pacesAround, secondsOf, watchablePace } from "./pace.mjs";
import { createPaper } from "./paper.mjs";
import { createPicture } from "./picture.mjs";
import { createPlots } from "./plots.mjs";
import { gapText } from "./reasons.mjs";
import { handOver, pictureFile, pictureOfPixels, sweepTable } from "./saving.mjs";
import { createScrubber } from "./scrubber.mjs";
import { createView, fitView, flat, moveView, onPage, seesAll } from "./view.mjs";
import { poseText } from "./words.mjs";

/** The options of the picture: their words, and whether they are shown at first. */
const OPTIONS = [
  ["names", "Names", true],
  ["paths", "Paths", true],
  ["forces", "Forces", true],
  ["ghosts", "Other assemblies", true],
  ["velocity", "Velocity", false],
  ["acceleration", "Acceleration", false],
  ["jerk", "Jerk", false],
  ["curvature", "Circle of curvature", false],
  ["centres", "Instant centres", false],
];
/** The sizes of picture and plots on paper, in pixels, as the style sheet has them there. */
const PRINTED = [
  [403, 453],
  [269, 453],
];
const ARROWS = ["velocity", "acceleration", "jerk"];
/** The time in which the picture is fitted again, in seconds. */
const FITTING = 0.35;
/** The frames of a moving picture from one end of its motion to the other. */
const FRAMES = 90;
/** The length of the arrow of the largest force, as a part of the picture. */
const LONGEST_FORCE = 0.24;
/** The part of the plots that the paths of force vectors take. */
const HODOGRAPHS = 0.52;

/**
 * Starts the page.
 *
 * @param {object | null} kept the view of an earlier page, as `keep` of the returned object gives it, or with the
 *   design that a saved page has
 * @param {HTMLElement | null} written the page before this script changed it, if it can be saved
 * @returns {{keep: () => object, design: () => {name: string, value: number}[]} | null} the view of
 *   the page, and the dimensions and standing inputs that it shows by their declared names
 */
export function start(report, solver, kept = null, written = null) {
  const refusal = reasonToRefuse(report);
  if (refusal) {
    refuse(report, refusal);
    return null;
  }
  const model = createModel(report, solver);
  const given = givenDesign(model);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const watchable = watchablePace(model, given);
  const state = {
    design: given,
    reference: null,
    assembly: report.assembly ?? 0,
    x: model.from,
    degrees: model.degrees,
    time: false,
    zoom: [model.from, model.to],
    group: "",
    hidden: new Set(),
    turning: false,
    free: null,
    shows: Object.fromEntries(OPTIONS.map(([name, , first]) => [name, first])),
    playing: false,
    hovering: false,
    once: 0,
    pace: watchable,
    forward: 1,
    held: 0,
    followed: [],
    ownView: false,
    changed: false,
    size: [0, 0],
    plotSize: [0, 0],
    printing: false,
    scrubWidth: 0,
  };
  // many other assemblies are a tangle
  state.shows.ghosts = report.assemblies.length <= 2;
  if (kept !== null) {
    Object.assign(state.shows, kept.shows);
    state.degrees = kept.degrees;
    const same = report.assemblies.findIndex(({ name }) => name === kept.assembly);
    state.assembly = same < 0 || !kept.chosen ? state.assembly : same;
    if (kept.design) {
      state.design = designLike(given, kept.design);
    }
  }
  const view = createView(model.space);
  let sweep = createSweep(model, state.design, assemblyNow());
  let anatomy = anatomyOf(sweep);
  let others = null;
  let marks = [];
  let arrowScales = null;
  let row = null;
  let lastRow = null;
  let unsolved = false;
  let version = 0;
  let redrawn = true;
  let framed = false;
  let fitting = null;
  const picture = createPicture(part("picture"), model);
  const plots = createPlots(part("plots"), model);
  const hodographs = createHodographs(part("plots"), model);
  const groups = curvesOf(model);
  const first = allRows(sweep)[0];
  const forceScales = report.forces && first ? scalesOfForces(model, sizeOf(first.pose)) : null;
  const scrubber = createScrubber(part("scrubber"), model);
  let paper = null;
  /** The part below the fold, which is made when it is first asked for. */
  function paperNow() {
    if (paper === null) {
      paper = createPaper(part("paper"), model, (x) => goTo(x));
      paper.notes.set(kept?.notes ?? "");
    }
    return paper;
  }
  const notesNow = () => (paper === null ? (kept?.notes ?? "") : paper.notes.text());
  const sliders = createSliders(part("sliders"), model, given, (group, name, value) => {
    state.design = { ...state.design, [group]: group === "speed" ? value : { ...state.design[group], [name]: value } };
    solve();
  });

  function assemblyNow() {
    return report.assemblies[state.assembly];
  }

  /** Its name, and its circuit if there are several and the dimensions are the report's, for which they are known. */
  function nameOfAssembly({ name, circuit }) {
    const several = (report.cycle?.circuits?.length ?? 0) > 1 && circuit !== undefined && circuit !== null;
    return several && sweep.given ? `${name}, circuit ${circuit + 1}` : name;
  }

  let spentOnFrames = [];
  let asked = false;
  let last = 0;
  function redraw() {
    redrawn = true;
    ask();
  }

  /** The whole motion is solved again. */
  function solve() {
    unsolved = true;
    ask();
  }

  function ask() {
    if (!asked) {
      asked = true;
      requestAnimationFrame(frame);
    }
  }

  function frame(now) {
    asked = false;
    const begin = performance.now();
    const seconds = Math.min(0.1, (now - last) / 1000);
    last = now;
    if (unsolved) {
      solveAgain();
    }
    if (state.playing && !state.hovering) {
      play(seconds);
    }
    if (redrawn) {
      redrawn = false;
      drawStill();
    }
    goOnFitting(seconds);
    drawPose();
    if (state.playing && !state.hovering) {
      measureFrame(performance.now() - begin);
      ask();
    }
  }

  /** Keeps the median of the script's part of the last frames of a motion with the page. */
  function measureFrame(spent) {
    spentOnFrames.push(spent);
    if (spentOnFrames.length === 60) {
      document.body.dataset.frame = spentOnFrames.sort((one, other) => one - other)[30].toFixed(2);
      spentOnFrames = [];
    }
  }

  /** The whole motion again, after a dimension or the assembly changed. */
  function solveAgain() {
    const begin = performance.now();
    unsolved = false;
    version += 1;
    state.changed = true;
    sweep = createSweep(model, state.design, assemblyNow());
    anatomy = anatomyOf(sweep) ?? anatomy;
    others = null;
    arrowScales = null;
    redrawn = true;
    const spent = performance.now() - begin;
    document.body.dataset.solved = spent.toFixed(2);
    const gaps = sweep.given ? "" : " Limits are the page's own.";
    setText(part("solved"), `The whole motion was solved again in ${numberText(spent, 2)} ms.${gaps}`);
    state.x = heldInput(sweep, state.x);
    if (sweep.spans.length === 0) {
      say(`It closes nowhere in this assembly: ${gapText(model, sweep.gaps[0], amount)}.`, true);
    } else {
      say("", false);
    }
    later();
  }

  let laterTimer = 0;
  /** Work that may wait until the reader rests. */
  function later() {
    clearTimeout(laterTimer);
    laterTimer = setTimeout(() => {
      showPeaks();
      sayPose();
      fitAgain();
    }, 150);
  }

  /** Whether the numbers of the report hold for a sweep. */
  const isExact = (some) => model.frames !== null || some.reported;
  const exactPeaks = (some) => (isExact(some) ? givenPeaks(model) : []);
  function peaksOf(some) {
    const exact = exactPeaks(some);
    return exact.length > 0 ? exact : ownPeaks(some);
  }

  function showPeaks() {
    const source =
      exactPeaks(sweep).length > 0 ? "Exact values of the report." : "Found by the page at these dimensions.";
    const rest =
      model.drive.joints.length > 0 ? `${source} Where a derivative jumps, those above it are unbounded.` : source;
    const least = isExact(sweep) ? worstTransmission(model) : null;
    const at = least && inputText(model, least.at, state.degrees);
    const angle = least && ` Least transmission angle ${numberText((least.angle * 180) / Math.PI)}° at ${at}.`;
    const shown = peaksOf(sweep);
    const paper = paperNow();
    paper.showPeaks(shown, state.degrees, `${rest}${angle ?? ""}`);
    if (state.reference === null) {
      paper.comparison.hide();
    } else {
      const { reference } = state;
      paper.comparison.show([reference.design, sweep.design], [peaksOf(reference), shown], state.degrees);
    }
  }

  function amount(value) {
    return Number.isFinite(value) ? withUnit(numberText(value, 4), model.units.length) : "";
  }

  function say(text, stops) {
    setText(part("message"), text);
    part("message").classList.toggle("stops", stops);
  }

  function sayPose() {
    if (row !== null && !state.playing) {
      paperNow().showPose(row, state.degrees);
      setText(
        part("spoken"),
        poseText(model, row, state.degrees, report.assemblies.length > 1 ? assemblyNow().name : "", shownNow()),
      );
    }
  }

  /** Says where it stops if it does, and otherwise what was said no longer holds. */
  function sayStopIf(stops) {
    say(stops ? stopText(sweep, marks, state.x, state.degrees) : "", stops);
  }

  function play(seconds) {
    if (state.held > 0) {
      state.held -= seconds;
      // time does not run backwards
      if (state.held <= 0 && model.drive.overTime) {
        state.x = spanAt(sweep, state.x)?.from ?? state.x;
        say("", false);
      }
      return;
    }
    const change = state.forward * state.pace * seconds * state.design.speed * secondsOf(model.units.time);
    const moved = movedInput(sweep, state.x, change);
    state.x = moved.x;
    if (state.once > 0) {
      state.once -= Math.abs(change);
      if (state.once <= 0) {
        setPlaying(false);
      }
    }
    if (moved.stopped) {
      sayStopIf(true);
      state.forward = model.drive.overTime ? 1 : -state.forward;
      state.held = 0.6;
    } else {
      const span = spanAt(sweep, state.x);
      if (span !== null && Math.min(state.x - span.from, span.to - state.x) > BESIDE_LIMIT * model.width) {
        say("", false);
      }
    }
  }

  function setPlaying(playing) {
    state.playing = playing;
    setText(part("play"), playing ? "Pause" : "Play");
    if (playing) {
      last = performance.now();
      ask();
    } else {
      state.once = 0;
      later();
    }
  }

  /** Moves the input, by hand. */
  function goTo(x, quietly = false) {
    if (!quietly) {
      setPlaying(false);
    }
    state.x = heldInput(sweep, x);
    sayStopIf(isAtLimit(sweep, state.x));
    later();
    ask();
  }

  function stepBy(change) {
    setPlaying(false);
    const moved = movedInput(sweep, state.x, change);
    state.x = moved.x;
    sayStopIf(moved.stopped);
    later();
    ask();
  }

  function groupNow() {
    return groups.find(({ name }) => name === state.group) ?? groups[0];
  }

  function curvesNow() {
    const all = groupNow()?.curves ?? [];
    const seen = all.filter(({ name }) => !state.hidden.has(name));
    return seen.length > 0 ? seen : all.slice(0, 1);
  }

  /** The indices of the quantities that are plotted. */
  function shownNow() {
    const names = curvesNow().map(({ name }) => name);
    return model.quantities.flatMap(({ name }, index) => (names.includes(name) ? [index] : []));
  }

  /** Whether the forces belong to the picture: the report has them for its dimensions, speed and assembly only. */
  function knowsForces() {
    return forceScales !== null && (sweep.reported || (model.frames !== null && sweep.given));
  }

  function drawStill() {
    measure();
    marks = marksOf(sweep);
    drawPlots();
    const poor = poorTransmission(sweep);
    scrubber.draw({ width: state.scrubWidth, sweep, marks, poor, degrees: state.degrees, amount });
    const keys = [
      ["closes", "closes", sweep.spans],
      ["poor", "transmission angle below 40°", poor],
      ["gap", "does not close", sweep.gaps],
    ];
    const key = keys
      .filter(([, , bands]) => bands.length > 0)
      .map(([name, words]) => made("span", {}, made("i", { className: `key-${name}` }), words));
    part("key").replaceChildren(...(key.length > 1 ? key : []));
    sliders.show(state.design, state.degrees);
    [...part("assembly").options].forEach((option, index) => setText(option, nameOfAssembly(report.assemblies[index])));
    part("swap").disabled = part("drop").disabled = state.reference === null;
  }

  function drawPlots() {
    const [width, height] = state.plotSize;
    const isOfForces = ["force", "moment"].includes(state.group);
    const shown = isOfForces && !knowsForces() ? [] : curvesNow();
    const vectors = shown.filter(({ joint }) => joint !== undefined);
    const top = vectors.length > 0 ? Math.round((1 - HODOGRAPHS) * height) : height;
    plots.draw({
      width,
      height: top,
      shown,
      titles: groupNow()?.titles ?? [],
      degrees: state.degrees,
      time: state.time,
      zoom: state.zoom,
      sweep,
      reference: isOfForces ? null : state.reference,
      marks,
      speed: state.design.speed,
      brief: state.printing,
    });
    hodographs.draw({ width, top: top + 6, height: height - top - 6, shown: vectors, turning: state.turning, sweep });
    setText(part("forces-note"), isOfForces ? noteOfForces() : "");
  }

  /** Why forces are not shown, if some are not. */
  function noteOfForces() {
    if (!knowsForces()) {
      return "The forces are known for the given dimensions, speed and assembly.";
    }
    return report.forces.unknown ? `Not all forces are known: ${report.forces.unknown}` : "";
  }

  function measure() {
    const sizes = state.printing
      ? PRINTED
      : ["picture", "plots"].map((name) => [part(name).clientWidth, part(name).clientHeight]);
    const [before] = [state.size];
    [state.size, state.plotSize] = sizes;
    state.scrubWidth = state.printing ? 688 : part("scrubber").clientWidth;
    part("picture").setAttribute("viewBox", `0 0 ${state.size[0]} ${state.size[1]}`);
    part("plots").setAttribute("viewBox", `0 0 ${state.plotSize[0]} ${state.plotSize[1]}`);
    part("scrubber").setAttribute("viewBox", `0 0 ${state.scrubWidth} 70`);
    if (!framed || before[0] !== state.size[0] || before[1] !== state.size[1]) {
      framed = true;
      fit();
    }
  }

  function someRows() {
    return allRows(sweep).filter((_, index) => index % 3 === 0);
  }

  /** Fits the picture where a change has moved links out of it, unless the reader chose the view. */
  function fitAgain() {
    const joints = someRows().flatMap(({ pose }) => pose.joints);
    if (!state.changed || state.ownView || seesAll(view, joints, state.size)) {
      return;
    }
    state.changed = false;
    const from = { ...view };
    fit();
    if (!still) {
      fitting = { from, to: { ...view }, part: 0 };
      Object.assign(view, from);
      last = performance.now();
    }
    ask();
  }

  function goOnFitting(seconds) {
    if (fitting === null) {
      return;
    }
    const part = Math.min(1, fitting.part + seconds / FITTING);
    // slow at both ends
    moveView(view, fitting.from, fitting.to, part * part * (3 - 2 * part));
    fitting = part < 1 ? { ...fitting, part } : null;
    ask();
  }

  function fit() {
    state.ownView = false;
    fitting = null;
    const rows = someRows();
    const gears = anatomy && rows.length > 0 ? gearsAt(sweep, anatomy, rows[0].pose).gears : [];
    const round = gears.flatMap(({ centre: [x, y], radius }) =>
      [-1.1, 1.1].map((way) => [x + way * radius, y + way * radius]),
    );
    const points = rows.flatMap(({ pose }) => [
      ...round,
      ...pose.joints,
      ...state.followed.map((followed) => coordinatesOf(model, followed, pose.joints)),
    ]);
    if (state.shows.ghosts) {
      for (const other of otherSweeps()) {
        points.push(
          ...allRows(other.sweep)
            .filter((_, index) => index % 6 === 0)
            .flatMap(({ pose }) => pose.joints),
        );
      }
    }
    const [width, height] = state.size;
    const side = Math.min(54, 0.09 * width);
    const room = { left: side, right: width - side, top: 34, bottom: height - (forceScales ? 76 : 58) };
    fitView(view, points, room);
    if (seesForces()) {
      fitArrows(rows, points, room);
    }
  }

  /** The ends of the arrows of forces at some rows, by their points and their ways in pixels. */
  function tipsOf(rows) {
    return rows.flatMap((each) => {
      const forces = state.free === null ? allForces(model, each) : forcesOn(model, each, state.free);
      return arrowsOf(forces).map(({ at, by }) => ({ at, by }));
    });
  }

  /** The overhang of some arrows beyond the picture, to the left, right, up and down. */
  function overhang(tips) {
    const [width, height] = state.size;
    const seen = tips.map(({ at, by }) => onPage(view, at).map((value, axis) => value + by[axis]));
    const over = (measure) => seen.reduce((most, tip) => Math.max(most, measure(tip)), 0);
    return [
      over(([x]) => 10 - x),
      over(([x]) => x - width + 10),
      over(([, y]) => 10 - y),
      over(([, y]) => y - height + 50),
    ];
  }

  /** Leaves room for the arrows of forces, which keep their lengths whatever the scale is. */
  function fitArrows(rows, points, room) {
    const tips = tipsOf(rows);
    for (let round = 0; round < 4; round += 1) {
      const [left, right, up, down] = overhang(tips);
      room.left += left;
      room.right -= right;
      room.top += up;
      room.bottom -= down;
      fitView(view, points, room);
    }
  }

  /** The other assemblies, each with its sweep, solved when they are first looked at. */
  function otherSweeps() {
    others ??= report.assemblies.flatMap((assembly, index) =>
      index === state.assembly ? [] : [{ assembly, index, sweep: createSweep(model, state.design, assembly) }],
    );
    return others;
  }

  function colourOfCircuit(assembly, index) {
    const circuitOf = (one, index) => (sweep.given ? (one.circuit ?? index) : index);
    const circuit = circuitOf(assembly, index);
    const current = circuitOf(assemblyNow(), state.assembly);
    // the circuit on which the mechanism is has the first colour
    const rank = circuit === current ? 0 : circuit < current ? circuit + 1 : circuit;
    return `c${[0, 3, 1, 2, 5, 4][rank % 6]}`;
  }

  function trailsOf(of, colour) {
    return state.followed.flatMap((followed) =>
      of.spans.map(({ rows }) => ({
        points: rows.map(({ pose }) => coordinatesOf(model, followed, pose.joints)),
        colour,
        closed: of.full,
      })),
    );
  }

  function allTrails() {
    const others = state.shows.ghosts ? otherSweeps() : [];
    return [
      ...(state.reference ? trailsOf(state.reference, "reference") : []),
      ...others.flatMap(({ assembly, index, sweep: other }) => trailsOf(other, colourOfCircuit(assembly, index))),
      ...trailsOf(sweep, colourOfCircuit(assemblyNow(), state.assembly)),
    ];
  }

  /** The sense in which an input turns its body now: 1 or -1, and 0 where it stands or is none. */
  function senseOf(driver) {
    return driver === null
      ? 0
      : state.forward * Math.sign(motionOf(model.drive, driver, lastRow.x, lastRow.piece, state.design.speed, 1)[1]);
  }

  function drawPose() {
    row = rowAt(sweep, state.x);
    part("picture").classList.toggle("broken", row === null);
    lastRow = row ?? lastRow;
    if (lastRow === null || anatomy === null) {
      scrubber.point(state.x, "does not close");
      return;
    }
    const scene = {
      view,
      width: state.size[0],
      height: state.size[1],
      pose: lastRow.pose,
      anatomy,
      sweep,
      shows: state.shows,
      followed: state.followed,
      senses: anatomy.drivers.map(senseOf),
      forces: [],
      newton: null,
      free: row !== null && seesForces() ? state.free : null,
      still: [
        Object.values(view),
        state.size,
        version,
        state.shows.paths,
        state.shows.ghosts,
        state.followed.length,
      ].join(),
      trails: () => (state.shows.paths ? allTrails() : []),
      ghosts: [],
      reference: null,
      arrows: [],
      circles: [],
      centres: [],
      moves: state.playing,
    };
    if (state.shows.ghosts) {
      for (const { assembly, index, sweep: other } of otherSweeps()) {
        const pose = rowAt(other, state.x)?.pose;
        if (pose) {
          const title = `${nameOfAssembly(assembly)}: click to change to it`;
          // many names are a tangle
          const name = report.assemblies.length === 2 ? assembly.name : "";
          scene.ghosts.push({ pose, index, colour: colourOfCircuit(assembly, index), title, name });
        }
      }
    }
    if (state.reference) {
      scene.reference = rowAt(state.reference, state.x)?.pose ?? null;
    }
    if (row !== null) {
      addRates(scene);
      addForces(scene);
      plots.point(row);
      hodographs.point(row);
      scrubber.point(state.x, poseText(model, row, state.degrees, "", shownNow().slice(0, 2)));
    } else {
      scrubber.point(state.x, "does not close");
    }
    part("picture").classList.toggle("free", scene.free !== null);
    picture.draw(scene);
  }

  /** The points whose rates are drawn: followed points, or else the pins that move. */
  function carriers() {
    if (state.followed.length > 0) {
      return state.followed;
    }
    return anatomy.pins.flatMap((pin, joint) => (pin && !anatomy.fixed[joint] ? [{ name: "", joint }] : []));
  }

  function addRates(scene) {
    const wanted =
      ARROWS.some((name) => state.shows[name]) || (!model.space && (state.shows.curvature || state.shows.centres));
    const rates = wanted && !model.frames ? ratesOfJoints(sweep, row) : null;
    if (rates === null) {
      return;
    }
    arrowScales ??= scalesOfArrows();
    const ofOrder = (order) => rates.map((joint) => joint[order]);
    for (const followed of carriers()) {
      const point = coordinatesOf(model, followed, row.pose.joints);
      ARROWS.forEach((name, order) => {
        if (state.shows[name] && arrowScales[order] > 0) {
          const rate = coordinatesOf(model, followed, ofOrder(order));
          const long =
            0.24 * Math.min(...state.size) * Math.min(1, (1.6 * arrowScales[order]) / (Math.hypot(...rate) || 1));
          const by = flat(view, rate).map((value) => (value / arrowScales[order]) * long);
          scene.arrows.push({ from: point, by, order });
        }
      });
      if (state.shows.curvature && !model.space && (state.followed.length > 0 || !onCrank(followed))) {
        const [velocity, acceleration] = [0, 1].map((order) => coordinatesOf(model, followed, ofOrder(order)));
        const circle = circleOfCurvature(point, velocity, acceleration);
        if (circle) {
          scene.circles.push({ ...circle, at: point });
        }
      }
    }
    if (state.shows.centres && !model.space) {
      const floating = model.outline.bodies.filter(({ joints }) => joints.length > 1 && !joints.some(isFixed));
      floating.forEach(({ name, joints: [one, other] }) => {
        const points = [row.pose.joints[one], row.pose.joints[other]];
        const at = instantCentre(...points, rates[one][0], rates[other][0]);
        if (at) {
          scene.centres.push({ at, name: `centre of ${name}` });
        }
      });
    }
  }

  /** Forces with the lengths of their arrows in pixels, and couples as parts of the largest one. */
  function arrowsOf(forces) {
    const long = LONGEST_FORCE * Math.min(...state.size);
    return forces.map((one) => {
      const size = Math.hypot(...one.force);
      const part = forceScales.force > 0 ? Math.min(1.3, size / forceScales.force) / (size || 1) : 0;
      return {
        ...one,
        by: [one.force[0] * part * long, -one.force[1] * part * long],
        part: forceScales.couple > 0 ? one.couple / forceScales.couple : 0,
      };
    });
  }

  function addForces(scene) {
    if (!seesForces()) {
      return;
    }
    scene.forces = arrowsOf(state.free === null ? allForces(model, row) : forcesOn(model, row, state.free));
    const newtons = ticks(0, forceScales.force, 2)[1] ?? ticks(0, forceScales.force, 4)[1];
    if (newtons !== undefined) {
      const long = (newtons / forceScales.force) * LONGEST_FORCE * Math.min(...state.size);
      scene.newton = { long, text: `${numberText(newtons)} N` };
    }
  }

  /** Shows the forces on one body alone, or on all for null. */
  function seeAlone(body) {
    state.free = body;
    if (forceScales !== null && report.forces.joints.length > 0) {
      part("free-body").value = body === null ? "" : String(body);
    }
    if (seesForces() && overhang(tipsOf(someRows())).some((pixels) => pixels > 0)) {
      fit();
    }
    ask();
  }

  /** A click on a body shows it alone, and the next one shows all again. */
  function pick(body) {
    if (seesForces()) {
      seeAlone(body === state.free ? null : body);
    }
  }

  /** Whether the picture has forces in joints. */
  function seesForces() {
    return state.shows.forces && knowsForces() && report.forces.joints.length > 0;
  }

  function isFixed(joint) {
    return anatomy.fixed[joint];
  }

  function onCrank({ joint }) {
    return model.outline.bodies.some(({ joints }) => joints.includes(joint) && joints.some(isFixed));
  }

  /** The largest rates of a revolution, unless few are far larger than the rest, so that arrows keep their scale. */
  function scalesOfArrows() {
    const rows = innerRows(sweep);
    const sizes = [[], [], []];
    for (let part = 0; part < 24; part += 1) {
      const some = rows[Math.floor((part / 24) * rows.length)];
      const rates = some ? ratesOfJoints(sweep, some) : null;
      for (const followed of rates ? carriers() : []) {
        const sizeOf = (order) =>
          Math.hypot(
            ...coordinatesOf(
              model,
              followed,
              rates.map((joint) => joint[order]),
            ),
          );
        sizes.forEach((list, order) => list.push(sizeOf(order)));
      }
    }
    return sizes.map((list) => {
      list.sort((one, other) => one - other);
      return list.length > 0 ? Math.min(list[list.length - 1], 3 * list[list.length >> 1]) : 0;
    });
  }

  function changeAssembly(index) {
    state.assembly = index;
    part("assembly").value = String(index);
    if (state.reference) {
      state.reference = createSweep(model, state.reference.design, assemblyNow());
    }
    solve();
  }

  function setGroup(group) {
    state.group = group;
    listQuantities();
    redraw();
  }

  /** The choices above the plots. */
  function listQuantities() {
    const entries = groups.map(({ name, words }) => [name, words]);
    const group = entries.length > 1 ? [choice("Quantities", entries, state.group, setGroup)] : [];
    const curves = groupNow()?.curves ?? [];
    const boxes = curves.map(({ name, text, documentation, colour, dashed }) => {
      const box = tick({ checked: !state.hidden.has(name) }, (shown) => {
        state.hidden[shown ? "delete" : "add"](name);
        redraw();
      });
      const legend = made("span", { className: `legend c${colour}${dashed ? " dashed" : ""}` });
      return made("label", { title: documentation ?? "" }, box, legend, text);
    });
    const axes = [
      ["input", `over ${model.variable.text}`],
      ["time", "over time"],
    ];
    const over = choice("Plotted over", axes, state.time ? "time" : "input", (axis) => {
      state.time = axis === "time";
      redraw();
    });
    over.hidden = model.drive.overTime;
    const frames = [
      ["fixed", "fixed axes"],
      ["turning", "axes of the body"],
    ];
    const frame = choice("Axes of the directions", frames, state.turning ? "turning" : "fixed", (axes) => {
      state.turning = axes === "turning";
      redraw();
    });
    frame.hidden = !curves.some(({ joint }) => joint !== undefined);
    const whole = button("Whole range", { id: "whole", hidden: isWhole() }, () => zoomTo([model.from, model.to]));
    part("plot-options").replaceChildren(...group, ...boxes, made("span", { className: "pushed" }, frame, over), whole);
  }

  function isWhole() {
    return state.zoom[0] === model.from && state.zoom[1] === model.to;
  }

  function zoomTo([from, to]) {
    const least = 1e-4 * model.width;
    state.zoom = [Math.max(model.from, from), Math.min(model.to, Math.max(to, from + least))];
    part("whole").hidden = isWhole();
    redraw();
  }

  function listOptions() {
    const impossible = [
      ...(report.forces?.joints.length > 0 ? [] : ["forces"]),
      ...(report.assemblies.length < 2 ? ["ghosts"] : []),
      ...(model.space ? ["curvature", "centres"] : []),
    ];
    const boxes = OPTIONS.filter(([name]) => !impossible.includes(name)).map(([name, words]) => {
      const box = tick({ checked: state.shows[name], id: `show-${name}` }, (shown) => {
        state.shows[name] = shown;
        if ((name === "ghosts" && shown) || name === "forces") {
          fit();
        }
        if (name === "forces" && !shown) {
          seeAlone(null);
        }
        ask();
      });
      const order = ARROWS.indexOf(name);
      const style = name === "forces" ? "force joint" : `o${order}`;
      const legend = order < 0 && name !== "forces" ? [] : [made("span", { className: `legend ${style} own` })];
      return made("label", {}, box, ...legend, words);
    });
    if (!impossible.includes("forces")) {
      const bodies = model.outline.bodies.map(({ name }, body) => [String(body), `${name} alone`]);
      const free = choice("Free body", [["", "on all bodies"], ...bodies], "", (body) => {
        seeAlone(body === "" ? null : Number(body));
      });
      free.id = "free-body";
      boxes.splice(boxes.findIndex((box) => box.firstChild.id === "show-forces") + 1, 0, free);
    }
    const show = button("Fit", { className: "pushed" }, () => {
      fit();
      ask();
    });
    part("options").replaceChildren(...boxes, show);
  }

  function drag(placed, pointer) {
    if (row === null) {
      return;
    }
    setPlaying(false);
    const found = nearestInput(sweep, state.x, placed, pointer);
    state.x = found.x;
    sayStopIf(found.beyond);
    ask();
  }

  function trace(followed) {
    const unnamed = state.followed.filter(({ joint }) => joint === undefined).length;
    state.followed = [...state.followed, { ...followed, name: followed.name || `P${unnamed > 0 ? unnamed + 1 : ""}` }];
    arrowScales = null;
    ask();
  }

  /** Shows another sweep beside, or none. */
  function compare(reference) {
    state.reference = reference;
    version += 1;
    redraw();
    later();
  }

  function swap() {
    [sweep, state.reference] = [state.reference, sweep];
    state.design = sweep.design;
    solve();
  }

  function openDrawer(isOpen) {
    part("dimensions").hidden = !isOpen;
    part("board").classList.toggle("with-drawer", isOpen);
    part("open-dimensions").setAttribute("aria-expanded", String(isOpen));
    redraw();
  }

  function setUp() {
    document.title = report.title;
    setText(part("title"), report.title);
    const [summary] = (report.documentation ?? "").split(/\n\s*\n/);
    setText(part("subtitle"), summary.replaceAll("\n", " ").replaceAll("`", ""));
    const option = (value, selected, words) => made("option", { value: String(value), selected }, words);
    part("pace").append(...pacesAround(watchable).map((pace) => option(pace, pace === watchable, paceText(pace))));
    const assemblies = report.assemblies.map((one, index) =>
      option(index, index === state.assembly, nameOfAssembly(one)),
    );
    part("assembly").append(...assemblies);
    part("assembly-choice").hidden = report.assemblies.length < 2;
    part("angles").value = state.degrees ? "degrees" : "radians";
    const inDegrees = (x) => Math.round(x * unitFactor(model.variable.dimension, true) * 1000) / 1000;
    const { text, documentation } = model.variable;
    change(part("scrubber"), {
      "aria-label": documentation ? `${text}, ${documentation}` : text,
      "aria-valuemin": inDegrees(model.from),
      "aria-valuemax": inDegrees(model.to),
    });
    state.followed = model.outline.points.filter(({ joint }) => !model.outline.ground.includes(joint));
    if (state.followed.length === 0 && anatomy !== null && anatomy.floating >= 0) {
      state.followed = [{ name: "P", body: anatomy.floating, along: 0.5, across: 0 }];
    }
    const [span] = sweep.spans;
    const begin = given.speed < 0 && !(model.period > 0) ? model.to : model.from;
    // not at a limit, where rates are unbounded
    state.x = spanAt(sweep, begin) || !span ? begin : 0.5 * (span.from + span.to);
    const plots = report.plots ?? [];
    const isPlotted = ({ column }) => plots.includes(column);
    const isChosen = model.quantities.some(({ declared, isInput }) => !isInput && !plots.includes(declared));
    const hasAny = ({ curves }) => curves.some(({ column }) => column === plots[0]);
    // who drives a slide on the ground asks for its stroke
    const strokes = model.outline.slides.some(({ guide }) => guide === null) && !isChosen;
    const ofStroke = strokes && model.unknowns.some(({ dimension }) => dimension === "length") ? "length" : "";
    const first = groups.find(({ name }) => name === ofStroke) ?? groups.find(hasAny) ?? groups[0];
    state.group = first?.name ?? "number";
    if (plots.length > 0) {
      const others = groups.flatMap(({ curves }) =>
        curves.some(isPlotted) ? curves.filter((one) => !isPlotted(one)) : [],
      );
      others.forEach(({ name }) => state.hidden.add(name));
    }
    if (!isChosen) {
      straightNames(sweep).forEach((name) => state.hidden.add(name));
    }
    part("open-dimensions").hidden = model.frames !== null;
    listOptions();
    listQuantities();
    if (model.frames !== null) {
      say(`Dimensions cannot be changed here${report.unrecorded ? `: ${report.unrecorded}` : ""}.`, false);
    } else if (report.not_closed) {
      const { text, unknowns, margin, at } = report.not_closed;
      const position = `${model.variable.text} = ${inputText(model, at, state.degrees)}`;
      const block = unknowns ? ` (${blockText(model, unknowns)})` : "";
      const reason = margin === null ? text : `out of reach by ${amount(Math.abs(margin))} at ${position}${block}`;
      say(`It does not close everywhere: ${reason}.`, false);
    }
  }

  /** Acts when a part of the page is clicked. */
  function clicked(name, action) {
    part(name).addEventListener("click", action);
  }

  /** Acts when another value of a part is chosen. */
  function chosen(name, action) {
    part(name).addEventListener("change", () => action(part(name).value));
  }

  function listen() {
    clicked("play", () => setPlaying(!state.playing));
    chosen("pace", (pace) => (state.pace = Number(pace)));
    chosen("assembly", (index) => changeAssembly(Number(index)));
    chosen("angles", (unit) => {
      state.degrees = unit === "degrees";
      say("", false);
      showPeaks();
      redraw();
      later();
    });
    clicked("open-dimensions", () => openDrawer(part("dimensions").hidden));
    clicked("close-dimensions", () => {
      openDrawer(false);
      part("open-dimensions").focus();
    });
    clicked("reset", () => {
      state.design = given;
      solve();
    });
    clicked("keep", () => compare(sweep));
    clicked("drop", () => compare(null));
    clicked("swap", swap);
    handlePicture(part("picture"), model, {
      view,
      pose: () => lastRow.pose,
      drag,
      end: later,
      changed() {
        state.ownView = true;
        fitting = null;
        ask();
      },
      assembly: changeAssembly,
      pick,
      trace,
    });
    handlePlots(part("plots"), {
      inputAt: (x) => plots.inputAt(x),
      select: (chosen) => plots.select(chosen),
      hover(x) {
        state.hovering = true;
        if (state.once > 0) {
          setPlaying(false);
        }
        goTo(x, true);
      },
      leave() {
        state.hovering = false;
        if (state.playing) {
          last = performance.now();
          ask();
        }
      },
      zoom: zoomTo,
      zoomed: () => state.zoom,
      all: () => zoomTo([model.from, model.to]),
    });
    handleScrubber(part("scrubber"), { inputAt: (x) => scrubber.inputAt(x), move: (x) => goTo(x), end: later });
    for (const [event, printing] of [
      ["beforeprint", true],
      ["afterprint", false],
    ]) {
      addEventListener(event, () => {
        state.printing = printing;
        drawStill();
        drawPose();
        if (row !== null) {
          paperNow().showPose(row, state.degrees);
        }
      });
    }
    document.addEventListener("keydown", pressed);
    document.addEventListener("pointerdown", (event) => {
      if (!part("save").contains(event.target)) {
        part("save").open = false;
      }
    });
    const resized = new ResizeObserver(redraw);
    ["board", "picture", "plots"].forEach((name) => resized.observe(part(name)));
    listenToSaving();
  }

  /** The numbers of the pose: each quantity with its rates, in radians. */
  function valuesNow() {
    return (
      row &&
      Object.fromEntries(
        model.quantities.map(({ name, declared }, index) => [
          declared,
          row.pose[name].map((_, order) => valueAt(model, row, index, order)),
        ]),
      )
    );
  }

  /** The motion as a file: a revolution or a law anew and anew, and a part of a range there and back. */
  function motionFile() {
    const { x, forward, playing } = state;
    const { from, to } = spanAt(sweep, x) ?? { from: x, to: x };
    const ways = sweep.full || model.drive.overTime ? [1] : [1, -1];
    const begin = state.design.speed < 0 ? to : from;
    const frames = ways.flatMap((way) =>
      [...Array(FRAMES + 1).keys()].map((step) => () => {
        const part = (way > 0 ? step : FRAMES - step) / FRAMES;
        Object.assign(state, { x: begin + (from + to - 2 * begin) * part, forward: way, playing: true });
        drawPose();
      }),
    );
    const time = (to - from) / (Math.abs(state.design.speed) * secondsOf(model.units.time) * state.pace);
    const file = movingPicture(part("picture"), frames, ways.length * time, report.title);
    Object.assign(state, { x, forward, playing });
    drawPose();
    return file;
  }

  function listenToSaving() {
    const name = (report.module ?? report.name).replace(/[^A-Za-z0-9_-]+/g, "_");
    const on = (id, action) =>
      clicked(id, () => {
        part("save").open = false;
        action();
      });
    const text = (file, content, type) => handOver(file, new Blob([content], { type }));
    on("save-csv", () => text(`${name}.csv`, sweepTable(sweep, state.degrees), "text/csv"));
    on("save-animation", () => text(`${name}_moving.svg`, motionFile(), "image/svg+xml"));
    on("save-svg", () => text(`${name}.svg`, pictureFile(part("picture"), report.title), "image/svg+xml"));
    on("save-plots", () => text(`${name}_plots.svg`, pictureFile(part("plots"), report.title), "image/svg+xml"));
    on("save-png", () => {
      pictureOfPixels(part("picture"), report.title).then(
        (blob) => handOver(`${name}.png`, blob),
        (error) => say(`No picture was written: ${error.message}.`, true),
      );
    });
    on("save-json", () => {
      const { design, x: input } = state;
      const all = { report, design, assembly: assemblyNow().name, input, pose: valuesNow(), notes: notesNow() };
      text(`${name}.json`, `${JSON.stringify(all, null, 1)}\n`, "application/json");
    });
    part("save-page").hidden = written === null;
    on("save-page", () => text(`${name}.html`, pageKeeping(written, left()), "text/html"));
    on("print", () => print());
  }

  function pressed(event) {
    const target = event.target;
    const busy = target.closest("input, select, button, textarea, summary, pre");
    if (busy || event.altKey || event.ctrlKey || event.metaKey) {
      return;
    }
    const small = model.width / PARTS;
    const span = spanAt(sweep, state.x);
    const actions = {
      " ": () => setPlaying(!state.playing),
      ArrowRight: () => stepBy(small * (event.shiftKey ? 10 : 1)),
      ArrowLeft: () => stepBy(-small * (event.shiftKey ? 10 : 1)),
      Home: () => span && goTo(span.from),
      End: () => span && goTo(span.to),
      ...(state.free === null ? {} : { Escape: () => seeAlone(null) }),
    };
    if (target === part("scrubber") || target === part("picture")) {
      actions.ArrowUp = actions.ArrowRight;
      actions.ArrowDown = actions.ArrowLeft;
      actions.PageUp = () => stepBy(10 * small);
      actions.PageDown = () => stepBy(-10 * small);
    } else if (target !== document.body && target !== part("plots")) {
      return;
    } else if (event.key === "Home" || event.key === "End") {
      return;
    }
    if (actions[event.key]) {
      event.preventDefault();
      actions[event.key]();
    }
  }

  /** The view, which another page of this mechanism may take over. */
  function keep() {
    return {
      x: state.x,
      once: state.once,
      playing: state.playing,
      shows: state.shows,
      degrees: state.degrees,
      assembly: assemblyNow().name,
      chosen: state.assembly !== (report.assembly ?? 0),
      drawer: !part("dimensions").hidden,
      notes: notesNow(),
    };
  }

  /** All that a saved page opens with. */
  function left() {
    const { design, followed, group } = state;
    const reference = state.reference?.design ?? null;
    return { ...keep(), playing: false, once: 0, design, reference, followed, group, hidden: [...state.hidden] };
  }

  setUp();
  listen();
  if (kept?.design) {
    state.followed = kept.followed;
    state.hidden = new Set(kept.hidden);
    setGroup(kept.group);
    compare(kept.reference && createSweep(model, designLike(given, kept.reference), assemblyNow()));
  }
  if (givenPeaks(model).length > 0) {
    showPeaks();
  } else {
    // the page's own peaks take longer than the first picture, as does all that is below the fold
    later();
  }
  if (sweep.spans.length === 0) {
    unsolved = true;
  } else if (kept !== null) {
    state.x = heldInput(sweep, kept.x);
    state.once = kept.once;
    openDrawer(kept.drawer);
    setPlaying(kept.playing);
  } else if (!still) {
    state.once = model.width;
    setPlaying(true);
  }
  ask();

  const shown = (group) => (entry) => ({
    name: entry.declared,
    value: state.design[group][entry.name],
  });
  return {
    keep,
    design: () => [
      ...model.parameters.map(shown("parameters")),
      ...model.inputs.filter(({ moves }) => !moves).map(shown("standing")),
    ],
  };
}

/** Shows why nothing is shown. */
function refuse(report, reason) {
  const title = typeof report?.title === "string" ? report.title : "kin";
  document.title = title;
  document.body.replaceChildren(
    made("main", { className: "refused" }, made("h1", {}, title), made("p", { role: "alert", id: "refusal" }, reason)),
  );
}
