/**
 * The time from a letter to the motion of the changed text, in milliseconds, where a person types slowly and quickly.
 *
 *     npm run build && CHROMIUM=/usr/bin/chromium npm run bench
 */
import { fileURLToPath } from "node:url";

import { chromium } from "playwright-core";

import { serve } from "../testing/serving.mjs";
import { visit } from "../testing/visiting.mjs";

const LETTERS = 25;
/** The pauses between letters in milliseconds: after the peaks are known, and before. */
const PAUSES = [1500, 100];
const STEPS = ["typed", "asked", "answered", "shown"];

const medianOf = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** Types a letter at the end of the text. @returns {Promise<number[]>} when each step was reached */
async function letter(page) {
  const count = () => performance.getEntriesByName("kin: shown").length;
  const before = await page.evaluate(count);
  await page.keyboard.type("a");
  await page.waitForFunction((before) => performance.getEntriesByName("kin: shown").length > before, before);
  const timeOf = (steps) => steps.map((step) => performance.getEntriesByName(`kin: ${step}`).at(-1).startTime);
  return page.evaluate(timeOf, STEPS);
}

const server = await serve(fileURLToPath(new URL("../site", import.meta.url)));
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
for (const name of ["FourBar", "JansenLeg"]) {
  for (const pause of PAUSES) {
    const { page } = await visit(browser, `${server.address}/`, {}, (address) => address.startsWith(server.address));
    await page.selectOption("#examples", name);
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("// ");
    await page.waitForTimeout(3000);
    const times = [];
    for (let index = 0; index < LETTERS; index += 1) {
      times.push(await letter(page));
      await page.waitForTimeout(pause);
    }
    const steps = STEPS.slice(1).map((step, index) => {
      const spans = times.map((time) => time[index + 1] - time[index]);
      return `${step} ${medianOf(spans).toFixed(0)}`;
    });
    const whole = medianOf(times.map((time) => time.at(-1) - time[0])).toFixed(0);
    console.log(`${name}, ${pause} ms between motion and letter: ${whole} ms (${steps.join(", ")})`);
    await page.context().close();
  }
}
await browser.close();
server.stop();
