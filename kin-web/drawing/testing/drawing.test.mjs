/**
 * The drawing in a browser: a person's pointer, finger and keyboard draw, and kin declares.
 *
 * The variable CHROMIUM names the browser, KIN_DECLARE the program; without them, they are /usr/bin/chromium and the
 * example that `cargo build -p kin-sketch --features serde --example declare` made.
 */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import {
  choose,
  clickAt,
  drag,
  dragBetween,
  open,
  partAt,
  PHONE,
  resultOf,
  screen,
  seriousFaults,
  sketchOf,
} from "./desk.mjs";

let desk;
before(async () => (desk = await open()));
after(() => desk?.close());

const [O, A, B, D] = [
  [-4, -2],
  [-4, 0],
  [0, 2],
  [1, -2],
];
const FOUR_BAR = /^struct Linkage \{ r1: Length, r2: Length, r3: Length, r4: Length \}\ninput theta2: Angle;/;

/** Draws a four-bar linkage with the mouse. */
async function drawFourBar(page) {
  await choose(page, "link");
  await drag(page, O, A);
  await drag(page, A, B);
  await drag(page, B, D);
  await choose(page, "ground");
  await clickAt(page, O);
  await clickAt(page, D);
  await choose(page, "drive");
  await clickAt(page, [-4, -1]);
  await choose(page, "select");
}

const words = ({ faults }) => faults.map(({ message, advice }) => `${message}: ${advice}`);
const near = (found, expected, by) => assert.ok(Math.abs(found - expected) < by, `${found} instead of ${expected}`);

test("a four-bar linkage by mouse", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    const { text, dimensions } = await resultOf(page);
    assert.match(text, FOUR_BAR);
    assert.deepEqual(dimensions[1], ["r2", 2]);
    assert.equal(await page.textContent("#text"), text);
    assert.equal(await page.locator(".drawing-tools .faults li").count(), 0);
    // the same by clicks from pin to pin, and a third pin in the middle of the coupler
    await page.evaluate(() => window.drawing.clear());
    await choose(page, "link");
    for (const place of [O, A, A, B, B, D]) {
      await clickAt(page, place);
    }
    const clicked = await sketchOf(page);
    assert.deepEqual(
      clicked.links.map(({ points }) => points),
      [
        [0, 1],
        [1, 2],
        [2, 3],
      ],
    );
    await drag(page, [-2, 1], [-2, 3]);
    const { links, points } = await sketchOf(page);
    assert.deepEqual(links[1].points, [1, 2, 4]);
    assert.deepEqual([points[4].x, points[4].y], [-2, 1]);
    assert.deepEqual(links[3].points, [4, 5]);
  }));

test("a four-bar linkage by touch", () =>
  desk.withDrawing(async (page) => {
    const tap = async (place) => page.touchscreen.tap(...place);
    const tapTool = async (id) => page.locator(`.tool-${id}`).tap();
    const on = ([x, y]) => screen(page, [x / 2 + 0.5, y / 2]);
    await tapTool("link");
    for (const place of [O, A, A, B, B, D]) {
      await tap(await on(place));
    }
    await tapTool("ground");
    await tap(await on(O));
    await tap(await on(D));
    await tapTool("drive");
    await tap(await on([-4, -1]));
    assert.match((await resultOf(page)).text, FOUR_BAR);
    // a finger's breadth beside a pin is still the pin
    await tapTool("select");
    const [x, y] = await partAt(page, "point", 2);
    await tap([x + 18, y]);
    assert.equal(await page.textContent(".panel strong"), "Pin c");
    // two fingers enlarge
    const client = await page.context().newCDPSession(page);
    const touch = (type, ...places) =>
      client.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: places.map(([atX, atY], id) => ({ x: atX, y: atY, id })),
      });
    const before = await page.locator(".hit-link").first().boundingBox();
    const [left, right] = [await on([-2, -1]), await on([0, -1])];
    await touch("touchStart", left);
    await touch("touchStart", left, right);
    await touch("touchMove", [left[0] - 30, left[1]], [right[0] + 30, right[1]]);
    await touch("touchEnd");
    const after = await page.locator(".hit-link").first().boundingBox();
    assert.ok(after.height > 1.3 * before.height, `${after.height} after ${before.height}`);
    assert.match((await resultOf(page)).text, FOUR_BAR);
  }, PHONE));

test("a four-bar linkage by keyboard alone", () =>
  desk.withDrawing(async (page) => {
    const press = async (keys) => {
      for (const key of keys.split(" ")) {
        const [, name, count = "1"] = key.match(/^(.*?)(?:\*(\d+))?$/);
        for (let time = 0; time < Number(count); time += 1) {
          await page.keyboard.press(name);
        }
      }
    };
    while (!(await page.evaluate(() => document.activeElement.id === "drawing"))) {
      await press("Tab");
    }
    // the grid has half a unit; the pen starts at the origin
    await press("l Enter ArrowUp*4 Enter Enter ArrowRight*8 ArrowUp*4 Enter Enter ArrowRight*2 ArrowDown*8 Enter");
    await press("g Enter ArrowLeft*10 Enter d ArrowUp*2 Enter");
    const { text } = await resultOf(page);
    assert.match(text, FOUR_BAR);
    const { points, ground } = await sketchOf(page);
    assert.deepEqual(
      points.map(({ x, y }) => [x, y]),
      [
        [0, 0],
        [0, 2],
        [4, 4],
        [5, 0],
      ],
    );
    assert.deepEqual(ground, [3, 0]);
    // every part is reached, and says what it is
    const said = [];
    for (let part = 0; part < 7; part += 1) {
      await press("Tab");
      said.push(await page.evaluate(() => document.activeElement.getAttribute("aria-label")));
    }
    assert.deepEqual(said, [
      "link 2 through a, b, length 2, driven from the ground",
      "link 3 through b, c, length 4.4721",
      "link 4 through c, d, length 4.1231",
      "point a at 0, 0, fixed",
      "point b at 0, 2",
      "point c at 4, 4",
      "point d at 5, 0, fixed",
    ]);
    // arrows move the part, Control+Z takes it back, Enter leads to its fields, Delete removes it
    await press("ArrowRight Shift+ArrowUp");
    near((await sketchOf(page)).points[3].x, 5.5, 1e-9);
    near((await sketchOf(page)).points[3].y, 0.05, 1e-9);
    await press("Control+z Control+z");
    assert.equal((await sketchOf(page)).points[3].x, 5);
    await press("v Enter");
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute("data-field")), "name");
    await page.keyboard.type("pivot");
    await press("Tab");
    assert.equal((await sketchOf(page)).points[3].name, "dpivot");
    await page.locator(".hit-link").nth(2).focus();
    await press("Shift+Tab Delete");
    assert.deepEqual((await sketchOf(page)).links.length, 2);
    assert.equal(await page.evaluate(() => document.activeElement.id), "drawing");
  }));

test("a length is typed at its link", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    const lengthOf = async (from, to) => {
      const { points } = await sketchOf(page);
      return Math.hypot(points[to].x - points[from].x, points[to].y - points[from].y);
    };
    // a digit on the selected link begins its length
    await page.mouse.click(...(await screen(page, [-3, 0.5])));
    await page.keyboard.type("4,6");
    const field = page.locator(".at-link");
    assert.equal(await field.getAttribute("aria-label"), "Length b–c");
    const [box, link] = [await field.boundingBox(), await partAt(page, "link", 1)];
    near(box.x + box.width / 2, link[0], 2);
    near(box.y + box.height / 2, link[1], 2);
    await page.keyboard.press("Enter");
    near(await lengthOf(1, 2), 4.6, 1e-9);
    assert.equal(await field.isVisible(), false);
    // a double click opens it with the length that it has; Escape and what is no length leave it
    const [x, y] = await partAt(page, "link", 0);
    for (const [text, end] of [
      ["3", "Escape"],
      ["-3", "Enter"],
      ["", "Enter"],
    ]) {
      await page.mouse.dblclick(x, y);
      assert.equal(await field.inputValue(), "2");
      await field.fill(text);
      await page.keyboard.press(end);
      near(await lengthOf(0, 1), 2, 1e-9);
    }
    await page.mouse.dblclick(x, y);
    await page.keyboard.type("2.5");
    await page.mouse.click(...(await screen(page, [5, 3])));
    near(await lengthOf(0, 1), 2.5, 1e-9);
    assert.equal(await field.isVisible(), false);
  }));

test("a length is typed, and the others stay", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    await page.mouse.click(...(await partAt(page, "link", 1)));
    assert.equal(await page.inputValue("[data-field='length1-2']"), "4.472136");
    await page.fill("[data-field='length1-2']", "4,6");
    await page.keyboard.press("Enter");
    const { dimensions } = await resultOf(page);
    const named = Object.fromEntries(dimensions);
    near(named.r2, 2, 1e-9);
    near(named.r3, 4.6, 1e-9);
    near(named.r4, Math.hypot(1, 4), 1e-9);
    assert.equal(await page.textContent(".hint"), "All other lengths are as they were.");
    await page.fill("[data-field='length1-2']", "30");
    await page.keyboard.press("Enter");
    near(Object.fromEntries((await resultOf(page)).dimensions).r3, 30, 1e-9);
    assert.match(await page.textContent(".hint"), /other lengths changed/);
    // nonsense is not taken
    await page.fill("[data-field='length1-2']", "-3");
    await page.keyboard.press("Tab");
    assert.equal(await page.inputValue("[data-field='length1-2']"), "30");
  }));

test("undo and redo go back to the empty drawing and forth", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    const drawn = await sketchOf(page);
    for (let time = 0; time < 6; time += 1) {
      await page.click(".tool-undo");
    }
    assert.deepEqual((await sketchOf(page)).points, []);
    assert.ok(await page.isDisabled(".tool-undo"));
    await page.locator("#drawing").focus();
    for (let time = 0; time < 3; time += 1) {
      await page.keyboard.press("Control+Shift+z");
      await page.keyboard.press("Control+y");
    }
    assert.deepEqual(await sketchOf(page), drawn);
    assert.ok(await page.isDisabled(".tool-redo"));
  }));

test("a slider-crank whose block holds the rod's ram", () =>
  desk.withDrawing(async (page) => {
    await choose(page, "link");
    await drag(page, [-3, 0], [-3, 1]);
    await drag(page, [-3, 1], [1, 0]);
    await choose(page, "ground");
    await clickAt(page, [-3, 0]);
    await choose(page, "drive");
    await clickAt(page, [-3, 0]);
    await choose(page, "slider");
    await drag(page, [1, 0], [3, 0.1]);
    const { text } = await resultOf(page);
    assert.match(text, /slide c along vec2\(1, 0\);/);
    // its line is inclined, and the slide is driven instead of the crank
    await page.fill("[data-field='direction0']", "30");
    await page.keyboard.press("Enter");
    near((await sketchOf(page)).slides[0].direction, Math.PI / 6, 1e-12);
    await choose(page, "drive");
    await clickAt(page, [-3, 0.5]);
    await clickAt(page, [1, 0]);
    assert.deepEqual((await sketchOf(page)).drives, [{ slide: 0 }]);
    assert.match((await resultOf(page)).text, /input s: Length;/);
    // a ram: the link that ends at the block keeps its angle
    await choose(page, "link");
    await drag(page, [1, 0], [3, 1]);
    await page.mouse.click(...(await partAt(page, "point", 2)));
    await choose(page, "select");
    await page.mouse.click(...(await partAt(page, "point", 2)));
    await page.selectOption("[data-field='guided0']", "2");
    assert.equal((await sketchOf(page)).slides[0].guided, 2);
    assert.ok((await resultOf(page)).text);
    // a second click with the slider takes the line away
    await choose(page, "slider");
    await clickAt(page, [1, 0]);
    assert.deepEqual((await sketchOf(page)).slides, []);
  }));

test("the line of a slide is turned by its handle", () =>
  desk.withDrawing(async (page) => {
    await choose(page, "link");
    await drag(page, [-3, 0], [1, 0]);
    await choose(page, "slider");
    await clickAt(page, [1, 0]);
    await choose(page, "select");
    const direction = async () => (await sketchOf(page)).slides[0].direction;
    assert.equal(await direction(), 0);
    const handle = page.locator(".slide-handle");
    assert.equal(await handle.count(), 1);
    const middle = async () => {
      const { x, y, width, height } = await handle.boundingBox();
      return [x + width / 2, y + height / 2];
    };
    // to a round angle, and with Alt to any
    const [x, y] = await screen(page, [1, 0]);
    await dragBetween(page, await middle(), [x + 2, y - 60]);
    near(await direction(), Math.PI / 2, 1e-12);
    near((await middle())[0], x, 1);
    await page.keyboard.down("Alt");
    await dragBetween(page, await middle(), [x + 50, y - 20]);
    await page.keyboard.up("Alt");
    near(await direction(), Math.atan2(20, 50), 0.02);
    // one step back, and without the selection the line has no handle
    await page.keyboard.press("Control+z");
    near(await direction(), Math.PI / 2, 1e-12);
    await clickAt(page, [-4, -2]);
    assert.equal(await handle.isVisible(), false);
  }));

test("an inverted slider: the pin of the crank slides along a link", () =>
  desk.withDrawing(async (page) => {
    await choose(page, "link");
    await drag(page, [-3, -1], [-3, 0]);
    await drag(page, [0, -1], [-5, 0]);
    await choose(page, "ground");
    await clickAt(page, [-3, -1]);
    await clickAt(page, [0, -1]);
    await choose(page, "drive");
    await clickAt(page, [-3, -0.5]);
    await choose(page, "slider");
    await drag(page, [-3, 0], [-1, -0.8]);
    const { slides } = await sketchOf(page);
    assert.equal(slides[0].on, 1);
    near(slides[0].direction, Math.atan2(1, -5), 1e-12);
    assert.match((await resultOf(page)).text, /b == c \+ vec2\(s, offset_b\) \* cis\(theta3\);/);
  }));

test("the toggle clamp with a plate, and a name for the mechanism", () =>
  desk.withDrawing(async (page) => {
    await choose(page, "link");
    await drag(page, [-4, -2], [-3, 1]);
    await drag(page, [-3, 1], [-1, 0.5]);
    await drag(page, [0, -2], [-1, 0.5]);
    await choose(page, "pin");
    await drag(page, [-0.5, -0.75], [3, -1]);
    await choose(page, "ground");
    await clickAt(page, [-4, -2]);
    await clickAt(page, [0, -2]);
    await choose(page, "drive");
    await clickAt(page, [-3.5, -0.5]);
    await choose(page, "select");
    await clickAt(page, [4, 2]);
    await page.fill("[data-field='name']", "ToggleClamp");
    await page.keyboard.press("Enter");
    const { links } = await sketchOf(page);
    assert.deepEqual(links[2].points, [3, 2, 4]);
    const { text } = await resultOf(page);
    assert.match(text, /^struct ToggleClamp \{/);
    assert.match(text, /output f: Point = d \+ r4_f \* cis\(theta4\);/);
  }));

test("a fault is told, marked, shown and mended", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    await choose(page, "drive");
    await clickAt(page, [-4, -1]);
    const told = words(await resultOf(page));
    assert.match(told[0], /^the drawing moves in one way and has no drive; .*: add a drive, or a link$/);
    await page.waitForSelector(".faults li");
    assert.match(await page.textContent(".faults li"), /^The drawing moves in one way and has no drive/);
    assert.equal(await page.locator(".at-fault:not([display])").count(), 3, "three links can move");
    await clickAt(page, [-4, -1]);
    await resultOf(page);
    assert.equal(await page.locator(".faults li").count(), 0);
    assert.equal(await page.locator(".at-fault:not([display])").count(), 0);
    // a name that cannot be: the fault leads to the pin
    await choose(page, "select");
    await clickAt(page, B);
    await page.fill("[data-field='name']", "sin");
    await page.keyboard.press("Tab");
    await resultOf(page);
    await clickAt(page, [4, 2]);
    await page.click(".faults button");
    assert.equal(await page.textContent(".panel strong"), "Pin sin");
    assert.equal(await page.locator("circle.at-fault:not([display])").count(), 1);
    await page.fill("[data-field='name']", "knee");
    await page.keyboard.press("Tab");
    assert.match((await resultOf(page)).text, /knee == /);
  }));

test("pins snap to the grid, and leave it with Alt or by the button", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    const point = async () => {
      const { points } = await sketchOf(page);
      return [points[2].x, points[2].y];
    };
    await drag(page, B, [0.68, 2.3]);
    assert.deepEqual(await point(), [0.5, 2.5]);
    await page.keyboard.down("Alt");
    await drag(page, [0.5, 2.5], [0.7, 2.3]);
    await page.keyboard.up("Alt");
    near((await point())[0], 0.7, 0.02);
    await page.keyboard.press("n");
    assert.equal(await page.getAttribute(".tool-snapping", "aria-pressed"), "false");
    await drag(page, [0.7, 2.3], [1.1, 1.8]);
    near((await point())[0], 1.1, 0.02);
    // dropped on another pin, it is one joint with it
    await drag(page, [1.1, 1.8], D);
    assert.equal((await sketchOf(page)).points.length, 3);
    await page.click(".tool-undo");
    assert.equal((await sketchOf(page)).points.length, 4);
  }));

test("the picture is shifted, enlarged and fitted", () =>
  desk.withDrawing(async (page) => {
    await drawFourBar(page);
    const before = await partAt(page, "point", 2);
    await drag(page, [3, 0], [4, 1]);
    const shifted = await partAt(page, "point", 2);
    near(shifted[0] - before[0], 60, 1.5);
    near(shifted[1] - before[1], -60, 1.5);
    await page.mouse.move(...shifted);
    await page.mouse.wheel(0, -300);
    await page.waitForTimeout(50);
    const { height } = await page.locator(".hit-link").first().boundingBox();
    assert.ok(height > 140, `${height}`);
    near((await partAt(page, "point", 2))[0], shifted[0], 1.5);
    await page.keyboard.press("f");
    const box = await page.locator("#drawing").boundingBox();
    for (let index = 0; index < 4; index += 1) {
      const [x, y] = await partAt(page, "point", index);
      assert.ok(x > box.x + 40 && x < box.x + box.width - 40 && y > box.y + 40 && y < box.y + box.height - 40);
    }
  }));

test("the shell loads examples, shows poses and gets what changed", () =>
  desk.withDrawing(async (page) => {
    const count = await page.evaluate(() => window.examples.length);
    for (let index = 0; index < count; index += 1) {
      await page.evaluate((example) => window.drawing.load(window.examples[example].sketch), index);
      const { text } = await resultOf(page);
      assert.ok(text, await page.evaluate((example) => window.examples[example].title, index));
    }
    await page.evaluate(() => window.drawing.load(window.examples[2].sketch));
    await resultOf(page);
    const before = await partAt(page, "point", 1);
    const block = await page.locator(".block").first().getAttribute("d");
    const drawn = await sketchOf(page);
    await page.evaluate(() => {
      const { points } = window.drawing.sketch();
      window.drawing.pose(
        points.map(({ x, y }, index) => (index === 1 ? { x: 1, y: 0 } : index === 3 ? { x: -3, y: 0 } : { x, y })),
      );
    });
    assert.notDeepEqual(await partAt(page, "point", 1), before);
    assert.notEqual(await page.locator(".block").first().getAttribute("d"), block);
    assert.deepEqual(await sketchOf(page), drawn);
    await page.evaluate(() => window.drawing.pose(null));
    assert.deepEqual(await partAt(page, "point", 1), before);
    const refused = await page.evaluate(() => {
      try {
        window.drawing.load({ name: "Broken", ground: [0] });
        return "it was taken";
      } catch (error) {
        return String(error);
      }
    });
    assert.match(refused, /^RangeError: .* not drawn$/);
    assert.deepEqual(await sketchOf(page), drawn);
  }));

test("axe finds no serious fault, and targets are large enough", async () => {
  for (const options of [{}, { colorScheme: "dark" }, PHONE]) {
    await desk.withDrawing(
      async (page) => {
        await page.evaluate(() => window.drawing.load(window.examples[5].sketch));
        await resultOf(page);
        assert.deepEqual(await seriousFaults(page), []);
        await page.locator(".hit-point").nth(1).focus();
        await page.keyboard.press("ArrowUp");
        await page.keyboard.press("d");
        await page.keyboard.press("Enter");
        await resultOf(page);
        assert.equal(await page.locator(".faults li").count(), 1);
        assert.deepEqual(await seriousFaults(page), []);
        const least = options === PHONE ? 44 : 24;
        const small = await page.evaluate(
          (size) =>
            [...document.querySelectorAll(".drawing-tools button, .drawing-tools label, .hit-point")]
              .map((element) => ({ box: element.getBoundingClientRect(), words: element.outerHTML.slice(0, 80) }))
              .filter(({ box }) => Math.min(box.width, box.height) < size - 0.01)
              .map(({ box, words: found }) => `${box.width} × ${box.height}: ${found}`),
          least,
        );
        assert.deepEqual(small, []);
      },
      { ...options, bypassCSP: true },
    ); // axe sets styles of its own
  }
});
