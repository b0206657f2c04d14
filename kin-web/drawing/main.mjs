/** A drawing of a plane linkage in the browser, which becomes a declaration. */
import { made, setText } from "../../kin-studio/src/page/elements.mjs";
import { createView, fitView, onPage, zoomView } from "../../kin-studio/src/page/view.mjs";
import { createBar } from "./bar.mjs";
import { createFaultList, faultyParts } from "./faults.mjs";
import { handlePointers } from "./gestures.mjs";
import { handleKeys } from "./keys.mjs";
import { createLengthField } from "./length-field.mjs";
import { changed as afterChange, moveLink, movePoint, removeLink, removePoint } from "./model/edits.mjs";
import { gridStep, snap } from "./model/grid.mjs";
import { createHistory } from "./model/history.mjs";
import { setLength } from "./model/lengths.mjs";
import { fromSegment, pick, pickLink, pickPoint } from "./model/picking.mjs";
import { turnSlides } from "./model/rails.mjs";
import { at, completed, emptySketch } from "./model/sketch.mjs";
import { mistakeIn } from "./model/validity.mjs";
import { createPanel } from "./panel.mjs";
import { createPicture, describe } from "./picture.mjs";
import { handleAt, handlesOf } from "./slide-handle.mjs";
import { toolset } from "./toolset.mjs";

export { examples } from "./examples.mjs";

/** How long a drawing rests before it is declared, in milliseconds. */
const REST = 120;
/** The distance of a fitted drawing from the edge in pixels, and the part of a small picture that it takes at most. */
const MARGIN = 64;
const MARGIN_PART = 0.18;
/** Pixels to the unit of length at the start, and the largest that fitting makes them. */
const SCALE = 60;
const NO_FAULTS = { points: [], links: [], slides: [] };

/**
 * @typedef {import("./model/sketch.mjs").Sketch} Sketch
 * @typedef {{message: string, advice: string, points: number[], links: number[], slides: number[]}} Fault
 * @typedef {{text: string, dimensions: [string, number][], inputs: [string, number][], unknowns: [string, number][]}}
 *   Declared
 */

/**
 * Makes an element a drawing.
 * @param {SVGSVGElement} svg
 * @param {HTMLElement} tools where the tool bar and the fields go
 * @param {{declare(sketch: Sketch): Promise<Declared | {faults: Fault[]}>,
 *   changed(result: Declared | {faults: Fault[]}, sketch: Sketch): void}} shell
 */
export function createDrawing(svg, tools, { declare, changed }) {
  const view = { ...createView(false), scale: SCALE };
  const history = createHistory(emptySketch());
  /** @type {Sketch | null} */
  let preview = null;
  let posed = null;
  let selection = null;
  let tool = toolset[0];
  let pending = null;
  let looseEnd = null;
  let pen = [0, 0];
  let isPenShown = false;
  let isSnapping = true;
  let radius = 12;
  let isHeld = false;
  let faults = [];
  let timer = 0;
  let asked = 0;
  let size = { width: 0, height: 0, top: 0 };

  svg.classList.add("drawing");
  svg.setAttribute("role", "application");
  svg.setAttribute("tabindex", "0");
  const picture = createPicture(svg);

  const sketch = () => preview ?? history.present();
  const shown = () => (posed === null || preview !== null ? sketch() : posed);
  const places = () => shown().points.map(({ x, y }) => onPage(view, [x, y]));
  const toPicture = (place) => onPage(view, place);
  const toDrawing = ([x, y]) => [(x - view.x) / view.scale, (view.y - y) / view.scale];
  const nearGrid = (place, isFree) => (isFree || !isSnapping ? place : snap(place, gridStep(view.scale)));

  const desk = {
    view,
    sketch,
    base: () => history.present(),
    tool: () => tool,
    selection: () => selection,
    pending: () => pending,
    isSnapping: () => isSnapping,
    toPicture,
    toDrawing,
    nearGrid,
    snapped: (place, isFree) => nearGrid(toDrawing(place), isFree),
    placeOf: (point) => places()[point],
    pick: (place) => pick(sketch(), places(), place, { radius }),
    pickHandle: (place) => handleAt(handlesOf(sketch(), places(), selection), place, radius),
    pickPoint: (place, except = []) => pickPoint(places(), place, { radius, except }),
    pickOtherLink(place, point) {
      const except = [...sketch().links.keys()].filter((link) => sketch().links[link].points.includes(point));
      return pickLink(sketch(), places(), place, { radius, except })?.index ?? null;
    },
    /** @returns {import("./toolset.mjs").Target} */
    target(place, isFree) {
      const part = desk.pick(place);
      if (part?.kind === "point") {
        return { point: part.index };
      }
      return part === null ? { at: desk.snapped(place, isFree) } : { link: part.index, at: onLink(part.index, place) };
    },
    /** A pointer went down, with its radius. Until it is lifted nothing above the picture moves it away. */
    hold(value) {
      radius = value;
      isHeld = true;
    },
    release() {
      isHeld = false;
      list.update(faults, sketch());
      render();
    },
    setPending(target) {
      pending = target;
      looseEnd = null;
      render();
    },
    loosen(from, to) {
      const sketched = sketch();
      const placeOf = (target) => (target.point === undefined ? target.at : at(sketched, target.point));
      looseEnd = to === null ? null : { from, to: placeOf(to) };
      render();
    },
    hover(place, isFree) {
      if (pending !== null) {
        desk.loosen(pending.point === undefined ? pending.at : at(sketch(), pending.point), desk.target(place, isFree));
      }
    },
    preview(action) {
      preview = afterChange(history.present(), action);
      render();
      ask();
    },
    commit() {
      if (preview !== null) {
        history.push(preview);
        preview = null;
        posed = null;
        refresh();
      }
    },
    cancel() {
      preview = null;
      [pending, looseEnd] = [null, null];
      refresh();
    },
    edit(action) {
      desk.preview(action);
      desk.commit();
    },
    select(part) {
      selection = part;
      render();
    },
    /** Selects a part and hands it the focus. */
    show(part) {
      desk.select(part);
      picture.hits.focus(part);
    },
    say(words) {
      setText(hint, words);
      render();
    },
    render: () => render(),
    choose(chosen) {
      tool = chosen;
      [pending, looseEnd] = [null, null];
      desk.say(tool.hint);
    },
    undo: () => step(history.undo),
    redo: () => step(history.redo),
    remove() {
      if (selection !== null) {
        const { kind, index } = selection;
        selection = null;
        desk.edit((draft) => (kind === "point" ? removePoint(draft, index) : removeLink(draft, index)));
        svg.focus();
      }
    },
    escape() {
      if (pending !== null || preview !== null) {
        desk.cancel();
      } else if (selection !== null) {
        desk.select(null);
        svg.focus();
      } else {
        desk.choose(toolset[0]);
      }
    },
    zoom(factor) {
      zoomView(view, [size.width / 2, size.height / 2], factor);
      render();
    },
    fit() {
      fit();
      render();
    },
    toggleSnapping() {
      isSnapping = !isSnapping;
      desk.say(isSnapping ? "New places lie on the grid." : "New places lie anywhere.");
    },
    setLength(link, from, to, length) {
      const result = setLength(history.present(), link, from, to, length);
      desk.edit((draft) => Object.assign(draft, structuredClone(result.sketch)));
      desk.say(
        result.isKept
          ? "All other lengths are as they were."
          : "The linkage cannot close with its other lengths: the end moved along the link, and other lengths changed.",
      );
    },
    partOf: picture.hits.partOf,
    showPen(isToBe) {
      isPenShown = isToBe;
      render();
    },
    arrow(part, [x, y], isFine) {
      const by = gridStep(view.scale) * (isFine ? 0.1 : 1);
      const moved = ([fromX, fromY]) => nearGrid([fromX + x * by, fromY + y * by], isFine);
      if (part === null) {
        pen = moved(pen);
        desk.hover(toPicture(pen), isFine);
        render();
      } else if (part.kind === "point") {
        desk.edit((draft) => movePoint(draft, part.index, moved(at(draft, part.index))));
      } else {
        desk.edit((draft) => moveLink(draft, part.index, [x * by, y * by]));
      }
    },
    click(part) {
      if (part !== null && tool.id === "select") {
        desk.select(part);
        panel.focus();
        return;
      }
      const corners = part?.kind === "link" ? sketch().links[part.index].points.slice(0, 2) : [part?.index];
      const middle = corners.map((point) => (part === null ? toPicture(pen) : places()[point]));
      const place = [0, 1].map((axis) => middle.reduce((sum, corner) => sum + corner[axis], 0) / middle.length);
      radius = 12;
      tool.press(desk, place, false)?.end(place, false, false);
      desk.hover(place, false);
    },
  };

  const bar = createBar(desk);
  const panel = createPanel(desk);
  const list = createFaultList(desk);
  const hint = made("p", { className: "hint", role: "status" }, tool.hint);
  tools.classList.add("drawing-tools");
  tools.replaceChildren(bar.element, panel.element, hint, list.element);
  handlePointers(svg, desk);
  desk.typeLength = createLengthField(svg, desk);
  handleKeys(svg, tools, desk);
  new ResizeObserver(() => render()).observe(svg);
  render();

  /** The place on a link that is nearest to a place in the picture; its middle, if that is near. */
  function onLink(link, place) {
    const corners = sketch().links[link].points;
    const sides = corners.map((from, index) => [from, corners[(index + 1) % corners.length]]);
    const found = sides.map(([from, to]) => ({ from, to, ...fromSegment(place, places()[from], places()[to]) }));
    const { from, to, along, distance } = found.reduce((best, side) => (side.distance < best.distance ? side : best));
    if (distance > radius) {
      return desk.snapped(place, false);
    }
    const [[x, y], [toX, toY]] = [at(sketch(), from), at(sketch(), to)];
    const part = Math.abs(along - 0.5) * Math.hypot(toX - x, toY - y) * view.scale < radius ? 0.5 : along;
    return [x + part * (toX - x), y + part * (toY - y)];
  }

  function step(move) {
    preview = null;
    [pending, looseEnd, posed] = [null, null, null];
    move();
    refresh();
  }

  /** Fields that come and go above the picture leave the drawing where it is on the screen. */
  function measure() {
    const { width, height, top } = svg.getBoundingClientRect();
    const now = { width, height, top: top + window.scrollY };
    if (size.width === 0) {
      [view.x, view.y] = [width / 2, height / 2];
    } else {
      view.x += (width - size.width) / 2;
      view.y += size.top - now.top;
    }
    size = now;
  }

  function fit() {
    const margin = Math.min(MARGIN, MARGIN_PART * Math.min(size.width, size.height));
    const room = { left: margin, top: margin, right: size.width - margin, bottom: size.height - margin };
    if (sketch().points.length > 0 && room.right > room.left && room.bottom > room.top) {
      fitView(
        view,
        shown().points.map(({ x, y }) => [x, y]),
        room,
      );
    }
  }

  /** Draws the present drawing and has it declared. */
  function refresh() {
    const { points, links } = sketch();
    if (selection !== null && selection.index >= (selection.kind === "point" ? points : links).length) {
      selection = null;
    }
    render();
    ask();
  }

  function render() {
    describe(svg, sketch());
    svg.setAttribute("data-tool", tool.id);
    bar.update({ tool, canUndo: history.canUndo(), canRedo: history.canRedo(), selection, isSnapping });
    if (!isHeld || panel.shows(selection)) {
      panel.update(sketch(), selection);
    }
    measure();
    if (size.width === 0) {
      return;
    }
    const long = (from, to) => Math.hypot(to[0] - from[0], to[1] - from[1]);
    const text = looseEnd?.from ? String(Number(long(looseEnd.from, looseEnd.to).toPrecision(4))) : "";
    picture.draw({
      sketch: shown(),
      places: places(),
      view,
      step: gridStep(view.scale),
      width: size.width,
      height: size.height,
      selection,
      faulty: posed === null ? faultyParts(faults) : NO_FAULTS,
      looseEnd: looseEnd && { from: looseEnd.from && toPicture(looseEnd.from), to: toPicture(looseEnd.to), text },
      pen: isPenShown ? toPicture(pen) : null,
    });
  }

  /** Has the drawing declared once it rests. */
  function ask() {
    clearTimeout(timer);
    timer = setTimeout(async () => {
      const [own, drawn] = [(asked += 1), structuredClone(sketch())];
      const result = await declare(drawn);
      if (own === asked) {
        const isEmpty = drawn.points.length === 0;
        faults = isEmpty ? [] : (result.faults ?? []);
        if (!isHeld) {
          list.update(faults, drawn);
        }
        render();
        changed(result, drawn);
      }
    }, REST);
  }

  /**
   * Shows another drawing. It can be undone.
   * @throws {RangeError} if the data is no drawing
   */
  function load(loaded) {
    const next = completed(loaded);
    const mistake = mistakeIn(next);
    if (mistake !== null) {
      throw new RangeError(mistake);
    }
    preview = null;
    [selection, pending, looseEnd, posed] = [null, null, null, null];
    history.push(next);
    fit();
    refresh();
  }

  return {
    load,
    /** The drawing as it is. */
    sketch: () => structuredClone(sketch()),
    undo: desk.undo,
    redo: desk.redo,
    /** Begins an empty drawing. It can be undone. */
    clear: () => load(emptySketch()),
    /** Shows the drawing with its points elsewhere, until null is given or the drawing is changed. */
    pose(points) {
      posed = points && structuredClone(sketch());
      posed?.points.forEach((point, index) => Object.assign(point, { x: points[index].x, y: points[index].y }));
      if (posed !== null) {
        turnSlides(sketch(), posed);
      }
      render();
    },
  };
}
