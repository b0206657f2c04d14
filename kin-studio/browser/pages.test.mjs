/**
 * Whole pages in a browser: those of the gallery, in the folder named by the variable KIN_PAGES, and changed copies.
 *
 * The variable CHROMIUM names the browser; without it, it is /usr/bin/chromium.
 */
import assert from "node:assert/strict";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { chromium } from "playwright-core";

import { FORMAT } from "../src/page/kinematics/model.mjs";
import { forcesOf, LAW } from "./testing/slider_crank.mjs";

const folder = resolve(process.env.KIN_PAGES ?? "../../target/pages");
const files = readdirSync(folder)
  .filter((name) => name.endsWith(".html") && name !== "index.html")
  .sort();
const DATA = /(<script type="application\/json" id="report">)([^]*?)(<\/script>)/;
/** The pages by the names of their modules. */
const sources = new Map(
  files.map((file) => {
    const text = readFileSync(join(folder, file), "utf8");
    return [JSON.parse(text.match(DATA)[2]).module, { file, text }];
  }),
);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const DESK = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };

let browser;
let scratch;

before(async () => {
  assert.ok(files.length > 0, `there are no pages in ${folder}`);
  scratch = mkdtempSync(join(tmpdir(), "kin-pages-"));
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox"],
  });
});

after(async () => {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
});

/** The report of a page of the gallery. */
function reportOf(name) {
  return JSON.parse(sources.get(name).text.match(DATA)[2]);
}

/** The address of a page, or of a copy whose report was changed. */
function addressOf(name, change = null) {
  if (change === null) {
    return pathToFileURL(join(folder, sources.get(name).file)).href;
  }
  const report = reportOf(name);
  const json = JSON.stringify(change(report) ?? report)
    .replaceAll("<", "\\u003c")
    .replaceAll("\u2028", "\\u2028");
  const path = join(scratch, `${name}-${Math.random().toString(36).slice(2)}.html`);
  writeFileSync(
    path,
    sources.get(name).text.replace(DATA, (_, head, __, foot) => head + json + foot),
  );
  return pathToFileURL(path).href;
}

/** Opens a page, hands it to an action, and fails if it wrote an error to the console. */
async function withPage(address, action, options = {}) {
  const context = await browser.newContext({
    viewport: DESK,
    reducedMotion: "reduce",
    acceptDownloads: true,
    ...options,
  });
  try {
    const page = await context.newPage();
    const errors = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on(
      "request",
      (request) => /^(file|blob|data):/.test(request.url()) || errors.push(`request of ${request.url()}`),
    );
    await page.goto(address);
    await settle(page);
    await action(page);
    assert.deepEqual(errors, []);
  } finally {
    await context.close();
  }
}

/** Waits until what was asked for is drawn. */
function settle(page) {
  return page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))),
  );
}

/** Stops the page's clock, so that its timers and frames wait for `passes`, however busy the machine is. */
async function stopClock(page) {
  await page.clock.install();
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 1000));
}

/** Lets a time pass on a page whose clock is stopped, in milliseconds, with the frames that fall into it. */
function passes(page, time) {
  return page.clock.runFor(time);
}

/** The text of a file that the page hands over. */
async function saved(page, button) {
  await page.click("#save summary");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  return readFileSync(await download.path(), "utf8");
}

const inputNow = (page) => page.getAttribute("#scrubber", "aria-valuenow").then(Number);
const message = (page) => page.textContent("#message");

/** A double rocker: at 70.5 degrees its crank cannot go on. */
function asDoubleRocker(report) {
  [90, 60, 40, 50].forEach((value, index) => (report.parameters[index].value = value));
  Object.assign(report, {
    range: [0, 2 * Math.PI],
    period: 2 * Math.PI,
    cycle: null,
    extremes: [],
    rms: [],
    transmission: null,
    sensitivities: [],
    not_closed: null,
  });
}
/** The limit of the double rocker: coupler and rocker are stretched, 60² + 90² - 2 60 90 cos θ = (40 + 50)². */
const LIMIT = (Math.acos((60 ** 2 + 90 ** 2 - 90 ** 2) / (2 * 60 * 90)) * 180) / Math.PI;

/** The middle of the drive's bar and of its pivot, on the screen. */
function crank(page) {
  return page.evaluate(() => {
    const [x1, y1, x2, y2] = document
      .querySelector(".hit-driven")
      .getAttribute("d")
      .match(/-?[\d.]+/g)
      .map(Number);
    const box = document.querySelector("#picture").getBoundingClientRect();
    const pins = [...document.querySelectorAll(".pin")].filter((pin) => pin.getAttribute("r") === "5");
    const isPivot = (x, y) =>
      pins.some((pin) => Math.hypot(pin.getAttribute("cx") - x, pin.getAttribute("cy") - y) < 1);
    const ends = [
      [x1 + box.x, y1 + box.y],
      [x2 + box.x, y2 + box.y],
    ];
    return isPivot(x1, y1) ? { pivot: ends[0], arm: ends[1] } : { pivot: ends[1], arm: ends[0] };
  });
}

test("every page of the gallery loads, and its numbers are those of the solver in Rust", async (t) => {
  for (const name of sources.keys()) {
    await t.test(name, () =>
      withPage(addressOf(name), async (page) => {
        const report = reportOf(name);
        assert.equal(await page.title(), report.title);
        assert.ok((await page.locator("#plots .curve").count()) >= 5, "curves are drawn");
        assert.ok((await page.locator("#picture .pin, #picture .bar, #picture .pane").count()) > 0, "links are drawn");
        assert.equal((await page.locator(".formula").count()) > 0, true, "equations are shown as mathematics");
        const inner = report.extremes.filter(({ place, value }) => place === "inner" && value !== null);
        const some = [inner[0], inner[Math.floor(inner.length / 2)], inner[inner.length - 1]].filter(Boolean);
        for (const { quantity, order, value, at } of some) {
          const all = report.extremes.filter(
            (one) => one.quantity === quantity && one.order === order && one.value !== null,
          );
          const size = Math.max(...all.map((one) => Math.abs(one.value)));
          await page.evaluate(
            (x) =>
              [...document.querySelectorAll("#paper td button")]
                .find((button) => Number(button.dataset.at) === x)
                .click(),
            at,
          );
          await settle(page);
          const { pose, input } = JSON.parse(await saved(page, "#save-json"));
          assert.ok(Math.abs(input - at) <= 1e-12 * (1 + Math.abs(at)), `the input is ${input}, asked for ${at}`);
          const shown = pose[quantity][order];
          const revolutions = order === 0 ? Math.round((shown - value) / (2 * Math.PI)) * 2 * Math.PI : 0;
          // the page's solver and Rust's go the same way; rounding is enlarged by the condition of the pose
          assert.ok(
            Math.abs(shown - revolutions - value) <= 1e-7 * size + 1e-9,
            `${quantity} of order ${order} at ${at}: ${shown} and ${value}`,
          );
        }
        await page.click("#open-dimensions");
        await page.evaluate(() => {
          const slider = document.querySelector("#sliders input[type=range]");
          slider.value = String(Number(slider.value) * 1.01 + 1e-6);
          slider.dispatchEvent(new Event("input"));
        });
        await settle(page);
        assert.match(await page.textContent("#solved"), /solved again in .* ms/);
        assert.ok((await page.locator("#plots .curve").count()) >= 5, "curves are drawn at other dimensions");
      }),
    );
  }
});

test("play moves the mechanism, and pause holds it", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const start = await inputNow(page);
    await stopClock(page);
    await page.click("#play");
    await passes(page, 500);
    await page.click("#play");
    await passes(page, 50);
    const held = await inputNow(page);
    assert.ok(held > start + 3, `from ${start} to ${held}`);
    await passes(page, 150);
    assert.equal(await inputNow(page), held);
  }));

test("at a negative speed the crank turns backwards, as its arrow says", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const arrow = () => page.getAttribute("#picture .drive-head", "d");
    const forwards = await arrow();
    await page.click("#open-dimensions");
    const field = page.locator('input[aria-label^="Speed of"]');
    await field.fill(String(-Number(await field.inputValue())));
    await settle(page);
    assert.notEqual(await arrow(), forwards);
    const start = await inputNow(page);
    await stopClock(page);
    await page.click("#play");
    await passes(page, 500);
    await page.click("#play");
    await passes(page, 50);
    const held = await inputNow(page);
    const change = ((held - start + 540) % 360) - 180;
    assert.ok(change < -3, `from ${start} to ${held}`);
  }));

test("motion starts by itself, unless the reader prefers less of it", async () => {
  await withPage(addressOf("four_bar"), async (page) => assert.equal(await page.textContent("#play"), "Pause"), {
    reducedMotion: "no-preference",
  });
  await withPage(addressOf("four_bar"), async (page) => assert.equal(await page.textContent("#play"), "Play"));
});

/** A crank that rests, turns by one radian, and rests. */
function asServo(report) {
  Object.assign(report, LAW, {
    cycle: null,
    extremes: [],
    rms: [],
    transmission: null,
    sensitivities: [],
    not_closed: null,
  });
}

test("under a law the page runs over the time, and curves have gaps where a derivative jumps", () =>
  withPage(addressOf("four_bar", asServo), async (page) => {
    assert.equal(await page.getAttribute("#scrubber", "aria-valuemax"), "0.6");
    assert.match(await page.textContent("#scrubber"), /Acceleration jumps at 0\.1 s/);
    const parts = await page.evaluate(() =>
      [...document.querySelectorAll("#plots .curve")].map((curve) => curve.getAttribute("d").match(/M/g).length),
    );
    assert.deepEqual(parts, [1, 1, 1, 1, 3, 3, 3, 3, 3, 3]);
    assert.ok(await page.isHidden("[aria-label='Plotted over']"));
    // time does not run backwards: from the end it begins anew
    await page.focus("#scrubber");
    await page.keyboard.press("End");
    await settle(page);
    assert.equal(await inputNow(page), 0.6);
    await stopClock(page);
    await page.click("#play");
    await passes(page, 1200);
    await page.click("#play");
    await passes(page, 50);
    const again = await inputNow(page);
    assert.ok(again > 0 && again < 0.5, `${again}`);
    // the law has no slider, and keeps to its values
    await page.click("#open-dimensions");
    assert.equal(await page.locator("#speed-speed").count(), 0);
    assert.match(await page.textContent("#sliders"), /θ₂ moves under a law/);
    assert.match(await saved(page, "#save-csv"), /^time \[s\],theta3 \[deg\]/);
    assert.match(await page.textContent("#paper"), /theta2 under a law, from 0 s to 0\.6 s/);
  }));

test("the scrubber follows the pointer and the keys", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const box = await page.locator("#scrubber").boundingBox();
    await page.mouse.click(box.x + 22 + 0.25 * (box.width - 44), box.y + 40);
    await settle(page);
    assert.ok(Math.abs((await inputNow(page)) - 90) < 0.3);
    await page.focus("#scrubber");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Shift+ArrowRight");
    await settle(page);
    assert.ok(Math.abs((await inputNow(page)) - 101) < 0.3);
    // it is said once the reader rests
    await page.locator("#spoken", { hasText: /θ₂ = 101.*°, θ₃ = .*°, θ₄ = .*°/ }).waitFor({ state: "attached" });
  }));

test("a dragged crank turns, and stops at the limit with its position", () =>
  withPage(addressOf("four_bar", asDoubleRocker), async (page) => {
    const { pivot, arm } = await crank(page);
    const long = Math.hypot(arm[0] - pivot[0], arm[1] - pivot[1]);
    const at = (degrees) => [
      pivot[0] + long * Math.cos((degrees * Math.PI) / 180),
      pivot[1] - long * Math.sin((degrees * Math.PI) / 180),
    ];
    await page.mouse.move(...at(0.5));
    await page.mouse.down();
    for (const degrees of [15, 30, 45]) {
      await page.mouse.move(...at(degrees));
    }
    await settle(page);
    assert.ok(Math.abs((await inputNow(page)) - 45) < 1, `${await inputNow(page)}`);
    assert.equal(await message(page), "");
    for (const degrees of [60, 75, 95, 110]) {
      await page.mouse.move(...at(degrees));
    }
    await settle(page);
    await page.mouse.up();
    assert.ok(Math.abs((await inputNow(page)) - LIMIT) < 1e-3, `${await inputNow(page)} and ${LIMIT}`);
    assert.match(
      await message(page),
      new RegExp(`^Limit at θ₂ = ${LIMIT.toFixed(4).replace(/0+$/, "")}°: the links of θ₃, θ₄ do not meet`),
    );
    assert.match(await page.textContent("#scrubber"), /out of reach by 60/);
  }));

test("the coupler and the end of its rocker can be dragged as well", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const tracer = await page.locator("#picture .tracer").first().boundingBox();
    const from = [tracer.x + tracer.width / 2, tracer.y + tracer.height / 2];
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(from[0] + 20, from[1] + 25, { steps: 4 });
    await page.mouse.move(from[0] + 40, from[1] + 50, { steps: 4 });
    await page.mouse.up();
    await settle(page);
    assert.ok((await inputNow(page)) > 3, "the mechanism moved");
  }));

test("the assembly changes by a click on its ghost, and by its name", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const names = await page.locator("#assembly option").allTextContents();
    assert.ok(names.length === 2);
    const point = await page.evaluate(() => {
      const path = document.querySelector(".hit-ghost");
      const box = document.querySelector("#picture").getBoundingClientRect();
      for (let part = 0.02; part < 1; part += 0.02) {
        const { x, y } = path.getPointAtLength(part * path.getTotalLength());
        if (document.elementFromPoint(box.x + x, box.y + y) === path) {
          return [box.x + x, box.y + y];
        }
      }
      return null;
    });
    const before = await saved(page, "#save-json").then(JSON.parse);
    await page.mouse.click(...point);
    await settle(page);
    const other = await saved(page, "#save-json").then(JSON.parse);
    assert.notEqual(other.assembly, before.assembly);
    assert.notEqual(other.pose.theta4[0], before.pose.theta4[0]);
    await page.selectOption("#assembly", { index: 0 });
    await settle(page);
    assert.equal((await saved(page, "#save-json").then(JSON.parse)).assembly, before.assembly);
  }));

test("a slider solves the whole revolution again within a frame, and marks its limits", () =>
  withPage(addressOf("four_bar"), async (page) => {
    await page.click("#open-dimensions");
    const times = await page.evaluate(async () => {
      const slider = document.querySelector("#parameters-r2");
      const found = [];
      for (let step = 0; step < 40; step += 1) {
        slider.value = String(Number(slider.value) * 1.003);
        slider.dispatchEvent(new Event("input"));
        await new Promise((done) => requestAnimationFrame(() => done()));
        found.push(Number(document.body.dataset.solved));
      }
      return found.slice(5).sort((one, other) => one - other);
    });
    console.log(`four-bar: the whole revolution is solved again in ${times[17]} ms (median), ${times[34]} ms (worst)`);
    assert.ok(times[17] < 16, `${times[17]} ms`);
    // with a crank as long as the ground link, the coupler and the rocker do not reach around
    const [ground] = reportOf("four_bar").parameters;
    await page.fill('input[aria-label="r₂, as a number"]', String(2 * ground.value));
    await settle(page);
    assert.match(await page.textContent("#solved"), /page's own/);
    assert.ok((await page.locator("#scrubber .limit-mark").count()) >= 2);
    assert.match(await page.locator("#scrubber .limit-mark title").first().textContent(), /found by the page/);
    await page.click("#reset");
    await settle(page);
    assert.equal(
      await page.inputValue('input[aria-label="r₂, as a number"]'),
      String(reportOf("four_bar").parameters[1].value),
    );
  }));

test("A stays as a reference beside B, and they are exchanged", () =>
  withPage(addressOf("four_bar"), async (page) => {
    await page.click("#open-dimensions");
    await page.click("#keep");
    const given = reportOf("four_bar").parameters[2].value;
    await page.fill('input[aria-label="r₃, as a number"]', String(1.1 * given));
    await settle(page);
    assert.ok((await page.locator("#plots .reference").count()) >= 5);
    assert.equal(await page.locator("#picture .trails .reference").count(), 1);
    assert.match(await page.textContent("#picture .names"), /A/);
    // both peaks stand side by side, those of A as the report has them
    await page.waitForSelector("#comparison:not([hidden])");
    assert.match(await page.textContent("#comparison"), /r₃ 80 → 88 \(\+10 %\)/);
    const highest = reportOf("four_bar").extremes.find(
      ({ quantity, order, kind }) => quantity === "theta4" && order === 2 && kind === "highest",
    );
    const shown = await page.textContent("#comparison tbody tr:nth-child(8) td:nth-child(3)");
    assert.equal(shown, `${((highest.value * 180) / Math.PI).toPrecision(6)}°/s²`);
    await page.click("#swap");
    await settle(page);
    assert.equal(Number(await page.inputValue('input[aria-label="r₃, as a number"]')), given);
    await page.click("#drop");
    await settle(page);
    assert.equal(await page.locator("#plots .reference").count(), 0);
    await page.waitForSelector("#comparison", { state: "hidden" });
  }));

/** The ends of the links on the screen, as fractions of the picture. */
function endsOfLinks(page) {
  return page.evaluate(() => {
    const { width, height } = document.querySelector("#picture").getBoundingClientRect();
    const all = [...document.querySelectorAll("#picture .bar")].map((bar) => bar.getAttribute("d"));
    const numbers = all.flatMap((data) => data.match(/-?[\d.]+/g).map(Number));
    return numbers.map((value, index) => value / (index % 2 === 0 ? width : height));
  });
}

test("the picture is fitted again when a dimension moves links out of it, unless the reader chose the view", () =>
  withPage(addressOf("four_bar"), async (page) => {
    await page.click("#open-dimensions");
    await settle(page);
    const scale = () => page.textContent("#picture .grid text");
    const before = await scale();
    await stopClock(page);
    const set = (name, value) => page.fill(`input[aria-label="${name}, as a number"]`, String(value));
    // a change that the picture holds moves nothing but links
    await set("r₃", 78);
    await passes(page, 250);
    assert.equal(await scale(), before);
    await set("r₃", 160);
    await set("r₄", 170);
    await passes(page, 50);
    assert.ok((await endsOfLinks(page)).some((part) => part < 0 || part > 1));
    await passes(page, 250);
    assert.ok((await endsOfLinks(page)).every((part) => part >= 0 && part <= 1));
    const box = await page.locator("#picture").boundingBox();
    await page.mouse.move(box.x + 8, box.y + 8);
    await page.mouse.down();
    await page.mouse.move(box.x + 20, box.y + 8, { steps: 2 });
    await page.mouse.up();
    await set("r₃", 300);
    await set("r₄", 310);
    await passes(page, 250);
    assert.ok((await endsOfLinks(page)).some((part) => part < 0 || part > 1));
  }));

test("next to a singular position the axes end where curves can be read, and say how far they go", () =>
  withPage(
    addressOf("inverted_slider_crank", (report) => {
      report.parameters[1].value = report.parameters[0].value * 1.0000001;
      Object.assign(report, { cycle: null, extremes: [], rms: [], transmission: null, sensitivities: [] });
    }),
    async (page) => {
      const beyond = await page.locator("#plots .beyond").allTextContents();
      assert.ok(beyond.length >= 2 && beyond.some((text) => /^↑ up to .*×10/.test(text)), beyond.join());
      const labels = await page.locator("#plots .quiet.end:not(.beyond)").allTextContents();
      assert.ok(
        labels.every((text) => text.length < 7 || /^[^0-9]/.test(text)),
        labels.join(),
      );
    },
  ));

test("a page is saved with notes, dimensions and A, and opens as it was left", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const words = 'r₃ is the one to change </script><b id="evil">\nsecond line';
    await page.fill("#notes", words);
    await page.click("#open-dimensions");
    await page.click("#keep");
    await page.fill('input[aria-label="r₃, as a number"]', "85");
    await page.selectOption("#assembly", { index: 1 });
    await page.uncheck("#show-names");
    await settle(page);
    const path = join(scratch, "kept.html");
    writeFileSync(path, await saved(page, "#save-page"));
    const twice = join(scratch, "kept-twice.html");
    await withPage(pathToFileURL(path).href, async (again) => {
      assert.equal(await again.inputValue("#notes"), words);
      assert.equal(await again.locator("#evil").count(), 0);
      assert.equal(await again.inputValue('input[aria-label="r₃, as a number"]'), "85");
      assert.equal(await again.inputValue("#assembly"), "1");
      assert.equal(await again.isChecked("#show-names"), false);
      assert.ok((await again.locator("#plots .reference").count()) >= 5);
      await again.emulateMedia({ media: "print" });
      assert.equal(await again.locator("#notes").isVisible(), false);
      assert.equal(await again.textContent(".printed"), words);
      assert.ok(await again.locator(".printed").isVisible());
      await again.emulateMedia({ media: "screen" });
      await again.fill("#notes", "shorter");
      writeFileSync(twice, await saved(again, "#save-page"));
    });
    await withPage(pathToFileURL(twice).href, async (again) => {
      assert.equal(await again.inputValue("#notes"), "shorter");
    });
    const { notes } = await saved(page, "#save-json").then(JSON.parse);
    assert.equal(notes, words);
  }));

test("a moving picture is one file that moves by itself as the page does", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const seen = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("#picture .bar")].map((bar) =>
          bar
            .getAttribute("d")
            .match(/-?[\d.]+/g)
            .map(Number),
        ),
      );
    const before = await inputNow(page);
    const file = join(scratch, "moving.svg");
    writeFileSync(file, await saved(page, "#save-animation"));
    assert.equal(await inputNow(page), before);
    await page.focus("#scrubber");
    for (let step = 0; step < 9; step += 1) {
      await page.keyboard.press("Shift+ArrowRight");
    }
    await settle(page);
    const expected = await seen();
    const width = (reportOf("four_bar").range[1] - reportOf("four_bar").range[0]) / reportOf("four_bar").speed;
    await withPage(pathToFileURL(file).href, async (picture) => {
      // a quarter of the revolution
      const paths = await picture.evaluate((seconds) => {
        const root = document.documentElement;
        root.pauseAnimations();
        root.setCurrentTime(seconds);
        const bars = [...document.querySelectorAll("path")].filter(
          (one) => one.getAttribute("stroke-width") === "7.6px",
        );
        return bars.map((bar) =>
          getComputedStyle(bar)
            .d.match(/-?[\d.]+/g)
            .map(Number),
        );
      }, width / 4);
      assert.equal(paths.length, expected.length);
      paths.flat().forEach((value, index) => assert.ok(Math.abs(value - expected.flat()[index]) < 0.3));
    });
  }));

test("degrees become radians everywhere", () =>
  withPage(addressOf("four_bar"), async (page) => {
    assert.match(await page.textContent("#paper table"), /°\/s²/);
    await page.selectOption("#angles", "radians");
    await settle(page);
    assert.match(await page.textContent("#plots"), /rad\/s⁴/);
    assert.doesNotMatch(await page.textContent("#plots"), /°/);
    assert.doesNotMatch(await page.textContent("#paper table"), /°/);
    const [header] = (await saved(page, "#save-csv")).split("\r\n");
    assert.match(header, /theta2 \[rad\]/);
  }));

test("plots move the mechanism under the pointer, and are enlarged by a drag, the wheel and back", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const box = await page.locator("#plots").boundingBox();
    const ticks = () => page.locator("#plots text.middle").allTextContents();
    const whole = await ticks();
    const middle = [box.x + 58 + 0.5 * (box.width - 74), box.y + 200];
    await page.mouse.move(...middle);
    await settle(page);
    assert.ok(Math.abs((await inputNow(page)) - 180) < 1.5, `${await inputNow(page)}`);
    await page.mouse.down();
    await page.mouse.move(middle[0] + 80, middle[1], { steps: 3 });
    await page.mouse.up();
    await settle(page);
    assert.notDeepEqual(await ticks(), whole);
    await page.click("#whole");
    await settle(page);
    assert.deepEqual(await ticks(), whole);
    await page.mouse.move(...middle);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, -240);
    await page.keyboard.up("Control");
    await settle(page);
    assert.notDeepEqual(await ticks(), whole);
  }));

test("tables and pictures are handed over as files", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const table = (await saved(page, "#save-csv"))
      .trim()
      .split("\r\n")
      .map((line) => line.split(","));
    assert.equal(table[0][0], "theta2 [deg]");
    assert.ok(table.length > 360 && table.every((row) => row.length === table[0].length));
    const { parameters } = reportOf("four_bar");
    const [r1, r2, r3, r4] = parameters.map(({ value }) => value);
    for (const row of table.slice(1)) {
      const [theta2, , theta3] = row.map((value) => (Number(value) * Math.PI) / 180);
      const theta4 = (Number(row[7]) * Math.PI) / 180;
      // the loop closes: every row is a pose
      const x = r2 * Math.cos(theta2) + r3 * Math.cos(theta3) - r1 - r4 * Math.cos(theta4);
      const y = r2 * Math.sin(theta2) + r3 * Math.sin(theta3) - r4 * Math.sin(theta4);
      assert.ok(Math.hypot(x, y) < 1e-12 * (r1 + r2 + r3 + r4));
    }
    for (const button of ["#save-svg", "#save-plots"]) {
      const picture = await saved(page, button);
      assert.match(picture, /^<svg [^]*<\/svg>\n$/);
      assert.doesNotMatch(picture, /\s(class|style)=/);
      assert.ok(picture.includes("stroke="));
    }
    await page.click("#save summary");
    const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save-png")]);
    const pixels = readFileSync(await download.path());
    assert.equal(pixels.subarray(1, 4).toString(), "PNG");
    assert.ok(pixels.length > 5000);
  }));

test("a mechanism of space turns under the pointer, and its links are dragged", () =>
  withPage(addressOf("rssr"), async (page) => {
    const seen = () =>
      page.evaluate(() => [...document.querySelectorAll("#picture .bar")].map((bar) => bar.getAttribute("d")).join());
    const box = await page.locator("#picture").boundingBox();
    assert.equal(await page.locator("#picture .axis").count(), 2);
    assert.equal(await page.locator("#picture .ground-link").count(), 1);
    const hint = "Drag beside the links to turn the view";
    assert.ok((await page.textContent("#picture .grid")).includes(hint));
    const [before, input] = [await seen(), await inputNow(page)];
    await page.mouse.move(box.x + 8, box.y + 8);
    await page.mouse.down();
    await page.mouse.move(box.x + 90, box.y + 40, { steps: 3 });
    await page.mouse.up();
    await settle(page);
    assert.notEqual(await seen(), before);
    assert.equal(await inputNow(page), input);
    assert.equal(await page.locator("#picture .grid text:not([display])", { hasText: hint }).count(), 0);
    const { arm } = await crank(page);
    await page.mouse.move(...arm);
    await page.mouse.down();
    await page.mouse.move(arm[0] + 12, arm[1] + 22, { steps: 4 });
    await page.mouse.up();
    await settle(page);
    assert.notEqual(await inputNow(page), input);
  }));

test("a coupled mechanism goes on at other dimensions, and reports where its assembly ends", () =>
  withPage(addressOf("class_three_triad"), async (page) => {
    const report = reportOf("class_three_triad");
    const limits = await page.locator("#scrubber .limit-mark title").allTextContents();
    assert.ok(
      limits.length > 0 && limits.every((text) => !text.includes("found by the page")),
      "the report's own limits are exact",
    );
    await page.click("#open-dimensions");
    const [first] = report.parameters;
    await page.fill(`input[aria-label="${first.text}, as a number"]`, String(1.02 * first.value));
    await settle(page);
    const found = await page.locator("#scrubber .limit-mark title").allTextContents();
    assert.ok(found.length > 0 && found.every((text) => text.includes("found by the page")), found.join());
    assert.match(await page.textContent("#scrubber"), /assembly lost/);
  }));

test("frames per second", async () => {
  for (const name of ["four_bar", "jansen_leg"]) {
    await withPage(addressOf(name), async (page) => {
      await page.click("#play");
      const { frames, work } = await page.evaluate(async () => {
        const begin = performance.now();
        let frames = 0;
        while (performance.now() - begin < 2000 || document.body.dataset.frame === undefined) {
          await new Promise((done) => requestAnimationFrame(done));
          frames += 1;
        }
        return { frames: (1000 * frames) / (performance.now() - begin), work: Number(document.body.dataset.frame) };
      });
      console.log(
        `${name}: ${frames.toFixed(0)} frames per second, ${work} ms of script in each (median of the last 60)`,
      );
      // the browser draws without a graphics card here: the script's own part is what can be held to a frame
      assert.ok(work < 16, `${work} ms`);
      assert.ok(frames > 5, `${frames} frames per second`);
    });
  }
});

test("hostile texts are shown as texts", () => {
  const evil = '</script><b id="evil">x</b><!--\u2028${alert(1)}<img src=x onerror=alert(1)>';
  return withPage(
    addressOf("four_bar", (report) => {
      Object.assign(report, {
        title: evil,
        name: evil,
        documentation: `${evil}\n\n${evil}`,
        declaration: evil,
        hash: evil,
      });
      report.units = { length: evil, time: evil };
      report.parameters.forEach((one) => Object.assign(one, { text: evil, documentation: evil }));
      report.unknowns.forEach((one) => Object.assign(one, { text: evil, documentation: evil }));
      report.inputs.forEach((one) => Object.assign(one, { text: evil, documentation: evil }));
      report.assemblies.forEach((one) => (one.name = evil));
      report.blocks.forEach((one) => Object.assign(one, { unknowns: evil, solution: evil }));
      report.operations.forEach((one) => (one.text = evil));
      report.formulas.closure = {
        text: evil,
        mathml: `<math xmlns="http://www.w3.org/1998/Math/MathML"><mi>x</mi><script>alert(1)</script></math>`,
      };
      report.formulas.rates = {
        text: evil,
        mathml: `<math xmlns="http://www.w3.org/1998/Math/MathML"><mi onclick="alert(1)">x</mi></math>`,
      };
      report.formulas.outputs = { text: evil, mathml: evil };
    }),
    async (page) => {
      page.on("dialog", () => assert.fail("a script of the report ran"));
      assert.equal(await page.textContent("#title"), evil);
      assert.equal(await page.locator("#evil, #main b, #main img, #main script").count(), 0);
      assert.ok((await page.locator("#paper pre").count()) >= 3, "refused formulas are shown as text");
      await page.click("#open-dimensions");
      await settle(page);
      assert.equal(await page.locator("#evil").count(), 0);
    },
  );
});

test("a newer form of report is refused with both numbers", () =>
  withPage(
    addressOf("four_bar", (report) => {
      report.format = 9;
    }),
    async (page) => {
      const text = await page.textContent("#refusal");
      assert.match(text, /format 9/);
      assert.ok(text.includes(`up to ${FORMAT}.`));
    },
  ));

test("gears are drawn below the links, and grow with the dimension that is their radius", () =>
  withPage(
    addressOf("four_bar", (report) => {
      withForces(report);
      const [first, last] = [0, report.outline.bodies.length - 1];
      const pivot = report.outline.bodies[last].joints.find((joint) => report.outline.ground.includes(joint));
      const circles = [
        { body: first, centre: { fixed: [0, 0] }, radius: 30, dimension: "r2" },
        { body: last, centre: { joint: pivot }, radius: 60, dimension: null },
      ];
      report.forces.contacts = [{ circles, rack: null }];
    }),
    async (page) => {
      const corners = () =>
        page.$$eval("#picture .gear", (all) => all.map((gear) => gear.getAttribute("d").match(/[ML]/g).length / 4));
      assert.deepEqual(await corners(), [18, 36]);
      await page.click("#open-dimensions");
      await page.fill('input[aria-label="r₂, as a number"]', "20");
      await settle(page);
      assert.deepEqual(await corners(), [18, 54]);
    },
  ));

/** The four-bar with forces: that of its knee on the coupler, and one of the ground. */
function withForces(report) {
  const samples = [...Array(181).keys()].map((index) => (report.range[1] * index) / 180);
  const forces = forcesOf(samples, report.speed);
  Object.assign(forces.joints[0], { name: "knee", joint: 1 });
  Object.assign(forces.joints[1], { name: "pivot", on: 2, joint: report.outline.ground.at(-1), is_slide: false });
  Object.assign(report, { forces });
}

test("forces are arrows that a box hides, and a click shows those on one link", () =>
  withPage(addressOf("four_bar", withForces), async (page) => {
    const shown = () =>
      page.$$eval(".forces .arrow-head", (all) => all.filter((one) => !one.getAttribute("display")).length);
    const faded = () => page.$$eval(".bodies .bar.faded", (all) => all.length);
    // two forces, and the scale
    assert.equal(await shown(), 3);
    assert.match(await page.textContent(".forces"), /knee: [\d.]+ N on .*\d N/);
    const at = await page.evaluate(() => {
      const [x1, y1, x2, y2] = document
        .querySelectorAll(".hit")[1]
        .getAttribute("d")
        .match(/-?[\d.]+/g)
        .map(Number);
      const box = document.getElementById("picture").getBoundingClientRect();
      return [box.left + 0.4 * x1 + 0.6 * x2, box.top + 0.4 * y1 + 0.6 * y2];
    });
    await page.mouse.click(...at);
    await settle(page);
    assert.equal(await faded(), 2);
    assert.equal(await page.inputValue("#free-body"), "1");
    assert.match(await page.textContent(".names"), /weight and inertia 7\.071 N/);
    await page.keyboard.press("Escape");
    await settle(page);
    assert.equal(await faded(), 0);
    await page.uncheck("#show-forces");
    await settle(page);
    assert.equal(await shown(), 0);
  }));

test("forces are plotted with their peaks and paths, and known for the given dimensions alone", () =>
  withPage(addressOf("four_bar", withForces), async (page) => {
    await page.selectOption('[aria-label="Quantities"]', "force");
    await settle(page);
    assert.equal(await page.$$eval(".plot-peak", (all) => all.length), 1);
    assert.equal(await page.$$eval(".hodographs .curve", (all) => all.length), 2);
    const path = () => page.getAttribute(".hodographs .curve", "d");
    const fixed = await path();
    await page.selectOption('[aria-label="Axes of the directions"]', "turning");
    await settle(page);
    assert.notEqual(await path(), fixed);
    assert.equal(await page.textContent("#forces-note"), "");
    assert.match(await page.textContent("#paper"), /ForcesForceonby.*kneer3r253\.8516 N90°/);
    await page.click("#open-dimensions");
    await page.fill("#dimensions input[type=number]", "95");
    await page.keyboard.press("Enter");
    await settle(page);
    assert.equal(
      await page.textContent("#forces-note"),
      "The forces are known for the given dimensions, speed and assembly.",
    );
    assert.equal(await page.$$eval(".hodographs .curve", (all) => all.length), 0);
  }));

test("axe finds no serious fault in light, dark and on a phone", async (t) => {
  const looks = [
    ["light", { viewport: DESK, colorScheme: "light" }],
    ["dark", { viewport: DESK, colorScheme: "dark" }],
    ["phone", { viewport: PHONE, hasTouch: true, isMobile: true }],
  ];
  for (const name of ["four_bar", "jansen_leg", "rssr"].filter((one) => sources.has(one))) {
    for (const [look, options] of looks) {
      await t.test(`${name}, ${look}`, () =>
        withPage(
          addressOf(name),
          async (page) => {
            await page.click("#open-dimensions");
            await page.evaluate(axe);
            const { violations } = await page.evaluate(() =>
              globalThis.axe.run(document, { resultTypes: ["violations"] }),
            );
            const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
            assert.deepEqual(
              serious.map(({ id, nodes }) => [id, ...nodes.slice(0, 3).map(({ target }) => target.join(" "))]),
              [],
            );
          },
          options,
        ),
      );
    }
  }
});

test("on a phone nothing is too wide, boxes are large enough for a finger, and all values have their names", () =>
  withPage(
    addressOf("jansen_leg"),
    async (page) => {
      const boxes = await page
        .locator("#options label, #plot-options label")
        .evaluateAll((all) =>
          all.map((one) => one.getBoundingClientRect()).map(({ width, height }) => [width, height]),
        );
      assert.ok(boxes.length > 6 && boxes.every(([wide, high]) => wide >= 44 && high >= 44), boxes.join(" "));
      const values = await page.locator("#plots .plot-values.small").allTextContents();
      assert.equal(values.length, 6 * 5);
      assert.ok(
        values.every((text) => /^●angle_[a-z] −?\d/.test(text)),
        values.slice(0, 6).join(),
      );
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= PHONE.width, `${width} pixels`);
    },
    { viewport: PHONE, hasTouch: true, isMobile: true },
  ));

test("paper is A4, and holds the picture", () =>
  withPage(addressOf("four_bar"), async (page) => {
    const file = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
    const boxes = [...file.matchAll(/\/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)\s*\]/g)].map(([, width, height]) => [
      Number(width),
      Number(height),
    ]);
    assert.ok(boxes.length >= 1 && boxes.length <= 6, `${boxes.length} pages`);
    for (const [width, height] of boxes) {
      assert.ok(Math.abs(width - 595) < 2 && Math.abs(height - 842) < 2, `${width} by ${height} points`);
    }
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: 688, height: 1000 });
    await settle(page);
    const overhang = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    assert.equal(overhang, 0);
    assert.equal(await page.locator(".controls").isVisible(), false);
    assert.equal(await page.locator("#picture").isVisible(), true);
  }));
