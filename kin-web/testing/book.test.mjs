/** The book in a browser: its blocks move and can be changed, and without scripts it reads as it stands. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { chromium } from "playwright-core";

import { serve } from "./serving.mjs";
import { seriousFaults, typeText, visit } from "./visiting.mjs";

const PHONE = { width: 390, height: 844 };
const SITE = new URL("../site", import.meta.url).pathname;
const SUMMARY = new URL("../../docs/SUMMARY.md", import.meta.url);
let browser;
let site;

before(async () => {
  site = await serve(SITE);
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
});
after(async () => {
  await browser.close();
  site.stop();
});

const isOwn = (address) => address.startsWith(site.address);
const opened = (path, options = {}) => visit(browser, `${site.address}/${path}`, options, isOwn);

/** A block of a chapter, after its first motion. */
async function living(page, index = 0) {
  const block = page.locator(".living").nth(index);
  await block.scrollIntoViewIfNeeded();
  await frameOf(block).locator("#title:not(:empty)").waitFor({ state: "attached" });
  return block;
}

const frameOf = (block) => block.locator(".moving iframe:not(.behind)").contentFrame();

/** What a moving page says of its mechanism at the beginning of the motion. */
async function numbersOf(frame) {
  await frame.locator("#scrubber").focus();
  await frame.locator("#scrubber").press("Home");
  await frame.locator("#spoken:not(:empty)").waitFor({ state: "attached" });
  return frame.locator("#spoken").textContent();
}

test("blocks ask for kin once, when the first comes into view, and move", async () => {
  const { page, faults } = await opened("book/program.html", { viewport: { width: 1000, height: 300 } });
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.waitForTimeout(300);
  assert.deepEqual([asked, await page.locator(".cm-editor").count()], [[], 0]);
  await page.goto(`${site.address}/book/forces.html`);
  const scrubber = frameOf(await living(page)).locator("#scrubber");
  const first = await scrubber.getAttribute("aria-valuenow");
  await frameOf(page.locator(".living").first()).locator(`#scrubber:not([aria-valuenow="${first}"])`).waitFor();
  await living(page, 1);
  assert.equal(asked.filter((address) => address.endsWith(".wasm")).length, 1);
  assert.equal(page.workers().length, 1);
  assert.deepEqual(faults, []);
});

test("a mistake is underlined with its advice, and mended", async () => {
  const { page, faults } = await opened("book/first-mechanism.html");
  const block = await living(page);
  const given = await block.locator(".cm-content").innerText();
  const editor = block.locator(".editor");
  await typeText(page, editor, given.replace("rod * cis(phi)", "rodd * cis(phi)"));
  await block.locator(".mistakes button", { hasText: "did you mean `rod`" }).waitFor();
  await block.locator(".cm-lintRange-error").first().waitFor();
  await block.locator(".moving.stale").waitFor();
  await block.getByRole("button", { name: "As in the book" }).click();
  await block.locator(".moving:not(.stale)").waitFor();
  assert.equal(await block.locator(".mistakes li").count(), 0);
  assert.equal(await block.locator(".cm-content").innerText(), given);
  assert.deepEqual(faults, []);
});

test("the page opens with the text of a block, and says the same numbers", async () => {
  const { page, faults } = await opened("book/cycle.html");
  const block = await living(page);
  const given = await block.locator(".cm-content").innerText();
  const still = await block.locator("figcaption a").getAttribute("href");
  await typeText(page, block.locator(".editor"), given.replace("r4 = 45mm", "r4 = 47.5mm"));
  const link = block.locator(`figcaption a:not([href="${still}"])`);
  await link.waitFor();
  await page.waitForFunction(() => performance.getEntriesByName("kin: shown").length === 2);
  const numbers = await numbersOf(frameOf(block));
  await link.click();
  await page.waitForFunction(() => document.body.dataset.moved);
  assert.match(await page.locator(".cm-content").innerText(), /r4 = 47\.5mm/);
  await page.waitForFunction(() => document.getElementById("state").textContent === "");
  const moving = page.locator("#moving");
  await moving.locator('iframe.behind[title^="FourBar"]').waitFor({ state: "detached" });
  const whole = moving.locator("iframe:not(.behind)").contentFrame();
  assert.equal(await numbersOf(whole), numbers);
  assert.match(numbers, /\d/);
  assert.deepEqual(faults, []);
});

test("without scripts, and without a server, the texts and the links of blocks are there", async () => {
  const { page } = await opened("book/forces.html", { javaScriptEnabled: false });
  assert.match(await page.locator(".living pre").first().innerText(), /^kin 1\n/);
  assert.equal(await page.locator(".moving").first().isVisible(), false);
  const still = await page.locator(".living figcaption a").first().getAttribute("href");
  const { page: file, faults } = await visit(browser, new URL("../site/book/forces.html", import.meta.url).href);
  for (const [whole, link] of [
    [page, `${site.address}/book/${still}`],
    [
      file,
      await file
        .locator(".living figcaption a")
        .first()
        .evaluate(({ href }) => href),
    ],
  ]) {
    assert.equal(await whole.locator(".living pre").count(), 2);
    const { page: full } = await visit(browser, link, {}, isOwn);
    await full.waitForFunction(() => document.body.dataset.moved);
    assert.match(await full.locator(".cm-content").innerText(), /struct CrankPress/);
  }
  assert.deepEqual(faults, []);
});

test("axe finds no serious fault by day, by night and on a phone, and no page is wider than it", async () => {
  const { page } = await opened("book/assemblies.html", { bypassCSP: true });
  await living(page);
  for (const setting of [
    () => {},
    () => page.emulateMedia({ colorScheme: "dark" }),
    () => page.setViewportSize(PHONE),
  ]) {
    await setting();
    assert.deepEqual(await seriousFaults(page), []);
  }
  for (const chapter of ["assemblies", "library", "grammar"]) {
    await page.goto(`${site.address}/book/${chapter}.html`);
    const [whole, seen] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(whole <= seen, `${chapter}: ${whole} > ${seen}`);
  }
});

test("every chapter opens from the list without a fault", async () => {
  const { page, faults } = await opened("book/");
  const addresses = await page.locator("#chapters a").evaluateAll((links) => links.map(({ href }) => href));
  assert.equal(addresses.length, readFileSync(SUMMARY, "utf8").match(/\.md\)/g).length);
  for (const address of addresses) {
    await page.goto(address);
    const title = await page.locator("h1").innerText();
    assert.equal(await page.locator("[aria-current]").innerText(), title);
    const broken = await page.evaluate(() => [...document.images].filter((image) => image.naturalWidth === 0).length);
    assert.equal(broken, 0, address);
  }
  assert.deepEqual(faults, []);
});
