/** A browser with the drawing in it, and a person's hands. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

import { chromium } from "playwright-core";

import { serve } from "../../testing/serving.mjs";
import { startKin } from "./kin.mjs";

const REPOSITORY = new URL("../../../", import.meta.url).pathname;
/** The strictest policy that the drawing has to work with. */
const POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:";
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
export const DESK = { viewport: { width: 1280, height: 860 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** Where the origin of the drawing was on the screen when the page was opened. */
const origins = new WeakMap();

/** Starts what all tests share. */
export async function open() {
  const [kin, server, browser] = [
    startKin(),
    await serve(REPOSITORY, { "content-security-policy": POLICY }),
    await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] }),
  ];
  return {
    /** Opens the drawing, hands it to an action, and fails if the page wrote an error to the console. */
    async withDrawing(action, options = {}) {
      const context = await browser.newContext({ ...DESK, ...options });
      try {
        const page = await context.newPage();
        const errors = [];
        page.on("console", (message) => ["error", "warning"].includes(message.type()) && errors.push(message.text()));
        page.on("pageerror", (error) => errors.push(String(error)));
        await page.exposeFunction("declareByKin", kin.declare);
        await page.goto(`${server.address}/kin-web/drawing/testing/shell.html`);
        await page.waitForFunction(() => window.drawing !== undefined);
        const box = await page.locator("#drawing").boundingBox();
        origins.set(page, [box.x + box.width / 2, box.y + box.height / 2]);
        await action(page);
        assert.deepEqual(errors, []);
      } finally {
        await context.close();
      }
    },
    async close() {
      await browser.close();
      server.stop();
      kin.stop();
    },
  };
}

export const sketchOf = (page) => page.evaluate(() => window.drawing.sketch());

/** The result of the present drawing, once it is declared. */
export async function resultOf(page) {
  await page.waitForFunction(() => {
    const last = window.results.at(-1);
    return last && JSON.stringify(last.sketch) === JSON.stringify(window.drawing.sketch());
  });
  return page.evaluate(() => window.results.at(-1).result);
}

/** Where a place of the drawing is on the screen, before it is shifted: 60 pixels to the unit. */
export async function screen(page, [x, y]) {
  const [originX, originY] = origins.get(page);
  return [originX + 60 * x, originY - 60 * y];
}

/** Where a part is on the screen. */
export async function partAt(page, kind, index) {
  const box = await page.locator(`.hit-${kind}[data-index="${index}"]`).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

export const choose = (page, tool) => page.click(`.tool-${tool}`);

export async function clickAt(page, place) {
  await page.mouse.click(...(await screen(page, place)));
}

export async function dragBetween(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 3 });
  await page.mouse.move(...to, { steps: 3 });
  await page.mouse.up();
}

export async function drag(page, from, to) {
  await dragBetween(page, await screen(page, from), await screen(page, to));
}

/** What axe finds of serious faults. */
export async function seriousFaults(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run());
  const serious = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
  return serious.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
}
