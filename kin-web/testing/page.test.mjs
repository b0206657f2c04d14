/** The page in a browser: it is typed into, and moves. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { chromium } from "playwright-core";

import { readAddress } from "../page/address.mjs";
import { seriousFaults, typeText as typeInto, visit } from "./visiting.mjs";

const address = new URL("../site/kin.html", import.meta.url).href;
let browser;

before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
});
after(() => browser.close());

/** A page at an address, after its first motion. Requests of the network are faults. */
async function opened(hash = "", options = {}) {
  const { page, faults } = await visit(browser, address + hash, { offline: true, ...options });
  await page.waitForFunction(() => document.body.dataset.moved);
  return { page, faults };
}

/** Whether the frame in front shows a mechanism of this title. */
async function shows(page, title) {
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  await frame.locator("#title", { hasText: title }).waitFor();
}

const typeText = (page, text) => typeInto(page, page.locator("#editor"), text);

const CRANK = `kin 1
struct Crank { r: Length, rod: Length }
input theta: Angle;
unknown x: Length, phi: Angle;
r * cis(theta) + rod * cis(phi) == vec2(x, 0);
dimensions { r = 30mm; rod = 80mm; }
motion { theta = 0deg..360deg at 60rpm; }
`;

test("a mechanism moves as soon as the page is open, without network", async () => {
  const { page, faults } = await opened();
  await shows(page, "FourBar");
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  const scrubber = frame.locator("#scrubber");
  const first = await scrubber.getAttribute("aria-valuenow");
  await page.waitForFunction((first) => {
    const inner = document.querySelector("#moving iframe:not(.behind)").contentDocument;
    return inner && inner.getElementById("scrubber").getAttribute("aria-valuenow") !== first;
  }, first);
  assert.deepEqual(faults, []);
});

test("a mistake is underlined and listed, and the mended text moves", async () => {
  const { page, faults } = await opened();
  await typeText(page, CRANK.replace("rod * cis", "rodd * cis"));
  await page.locator("#mistakes button", { hasText: "did you mean `rod`" }).waitFor();
  await page.locator(".cm-lintRange-error").first().waitFor();
  await page.locator("#moving.stale").waitFor();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  assert.equal(await page.locator("#mistakes li").count(), 0);
  assert.deepEqual(faults, []);
});

test("a name is not coloured as the keyword that it resembles", async () => {
  const { page, faults } = await opened();
  await typeText(page, CRANK.replaceAll(/\br\b/g, "ground"));
  await shows(page, "Crank");
  const words = await page.locator("#editor .token-keyword").allTextContents();
  assert.deepEqual(words, ["kin", "struct", "input", "unknown", "dimensions", "motion", "at"]);
  assert.deepEqual(faults, []);
});

test("a unit is completed behind a number, and a name elsewhere", async () => {
  const { page, faults } = await opened();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  await page.keyboard.press("Control+End");
  const completions = page.locator(".cm-tooltip-autocomplete li");
  for (const [typed, completed] of [
    ["// 45m", "mm"],
    [" ro", "rod"],
  ]) {
    await page.keyboard.type(typed);
    await completions
      .filter({ hasText: new RegExp(`^${completed}`) })
      .first()
      .waitFor();
    await page.keyboard.press("Escape");
  }
  assert.deepEqual(faults, []);
});

/** How often the motion of a text was shown. */
const countShown = () => performance.getEntriesByName("kin: shown").length;

/** Far above what a machine without other work takes, and far below what a person waits for, in milliseconds. */
const SLOWEST = 3000;

test("a letter changes the motion within a moment, also where a processor is slow", async (context) => {
  const { page, faults } = await opened();
  await page.waitForFunction(() => document.getElementById("state").textContent === "");
  const session = await page.context().newCDPSession(page);
  for (const slowdown of [1, 4]) {
    await session.send("Emulation.setCPUThrottlingRate", { rate: slowdown });
    await page.locator(".cm-content").click();
    await page.locator("#moving iframe.behind").waitFor({ state: "attached" });
    const before = await page.evaluate(countShown);
    await page.keyboard.press("Control+End");
    // the last letter counts, also where the one before it is still asked about
    await page.keyboard.type("// a");
    await page.waitForFunction((before) => performance.getEntriesByName("kin: shown").length > before, before);
    const [typed, asked, answered, shown] = await page.evaluate(() =>
      ["typed", "asked", "answered", "shown"].map(
        (step) => performance.getEntriesByName(`kin: ${step}`).at(-1).startTime,
      ),
    );
    const spans = [asked - typed, answered - asked, shown - answered].map((span) => span.toFixed(0));
    context.diagnostic(`slowed ${slowdown} times: ${(shown - typed).toFixed(0)} ms, of which ${spans.join(" + ")}`);
    assert.ok(shown - typed < SLOWEST * slowdown);
    const hash = await page.evaluate(() => location.hash);
    assert.match((await readAddress(hash)).text, /\/\/ a$/);
  }
  assert.deepEqual(faults, []);
});

test("a link holds the whole mechanism", async () => {
  const { page } = await opened();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  await page.waitForFunction(() => location.hash.startsWith("#kin="));
  const hash = await page.evaluate(() => location.hash);
  const { page: other } = await opened(hash);
  await shows(other, "Crank");
  const text = await other.locator(".cm-content").innerText();
  assert.match(text, /rod = 80mm/);
});

test("a slider writes its number into the text", async () => {
  const { page } = await opened();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  await frame.locator("#open-dimensions").click();
  const field = frame.getByLabel("rod, as a number");
  await field.fill("95");
  await field.press("Tab");
  await page.waitForFunction(() => document.querySelector(".cm-content").innerText.includes("rod = 95mm"));
  assert.match(await page.locator(".cm-content").innerText(), /r = 30mm/);
});

test("a slider that is held stays in its place while a changed text moves", async () => {
  const { page, faults } = await opened();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  await frame.locator("#open-dimensions").click();
  const slider = frame.getByRole("slider", { name: "rod" });
  await slider.waitFor();
  await page.waitForFunction(() => document.getElementById("state").textContent === "");
  // longer than the frame with the peaks takes to load
  await page.waitForTimeout(1000);
  await slider.hover();
  const { x, y, width, height } = await slider.boundingBox();
  await page.mouse.down();
  await page.evaluate(() => (document.querySelector("#moving iframe:not(.behind)").dataset.isHeld = "yes"));
  const answered = () => page.evaluate(() => performance.getEntriesByName("kin: answered").length);
  const before = await answered();
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText(CRANK.replace("rod = 80mm", "rod = 81mm"));
  while ((await answered()) === before) {
    await page.waitForTimeout(10);
  }
  await page.waitForTimeout(1000);
  await page.mouse.move(x + width * 0.7, y + height / 2, { steps: 4 });
  assert.equal(await page.locator("#moving iframe:not(.behind)").getAttribute("data-is-held"), "yes");
  await page.mouse.up();
  await page.waitForFunction(() => !document.querySelector(".cm-content").innerText.includes("rod = 81mm"));
  await page.waitForFunction(() => document.querySelector("#moving iframe:not(.behind)").dataset.isHeld !== "yes");
  assert.deepEqual(faults, []);
});

test("a press is not lost while the frame that comes next is ready already", async () => {
  const { page, faults } = await opened();
  // a frame listens to its sliders right before it tells that it is shown
  await page.addInitScript(() => {
    const listen = EventTarget.prototype.addEventListener;
    EventTarget.prototype.addEventListener = function (kind, ...rest) {
      if (this.id === "sliders") {
        queueMicrotask(() => top.pressFront?.());
      }
      return listen.call(this, kind, ...rest);
    };
  });
  await page.reload();
  await page.waitForFunction(() => document.body.dataset.moved && document.getElementById("state").textContent === "");
  await page.evaluate(() => {
    window.pressFront = () => {
      window.pressFront = null;
      window.pressed = document.querySelector("#moving iframe:not(.behind)");
      window.pressed.contentWindow.dispatchEvent(new PointerEvent("pointerdown", { pointerId: 7 }));
    };
  });
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+End");
  await page.keyboard.type("// a");
  await page.waitForFunction(() => window.pressFront === null);
  await page.waitForTimeout(200);
  assert.ok(await page.evaluate(() => window.pressed.isConnected && !window.pressed.classList.contains("behind")));
  await page.evaluate(() => {
    window.pressed.contentWindow.dispatchEvent(new PointerEvent("pointerup", { pointerId: 7 }));
  });
  await page.waitForFunction(() => !window.pressed.isConnected);
  assert.deepEqual(faults, []);
});

test("a number of the text keeps its unit, also as a coordinate, and stays if another one changes", async () => {
  const { page, faults } = await opened();
  await typeText(
    page,
    CRANK.replace("rod: Length", "rod: Length, tilt: Angle, pin: Vector")
      .replace("r * cis(theta)", "pin + r * cis(theta + tilt)")
      .replace("rod = 80mm", "rod = 8.0cm; tilt = 0.01turn; pin = (1, 0.123456789mm)"),
  );
  await shows(page, "Crank");
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  await frame.locator("#open-dimensions").click();
  for (const [label, typed, written] of [
    ["rod", "95", "rod = 9.5cm; tilt = 0.01turn; pin = (1, 0.123456789mm)"],
    ["tilt", "9", "rod = 9.5cm; tilt = 0.025turn; pin = (1, 0.123456789mm)"],
    ["pin.x", "3", "rod = 9.5cm; tilt = 0.025turn; pin = (3, 0.123456789mm)"],
  ]) {
    const field = page.locator("#moving iframe:not(.behind)").contentFrame().getByLabel(`${label}, as a number`);
    // the motion and the peaks of a text each come in a frame of their own
    await page.waitForFunction(() => document.getElementById("state").textContent === "");
    const before = await page.evaluate(countShown);
    await field.fill(typed);
    await field.press("Tab");
    const isShown = ([written, before]) =>
      document.querySelector(".cm-content").innerText.includes(written) &&
      performance.getEntriesByName("kin: shown").length > before;
    await page.waitForFunction(isShown, [written, before]);
  }
  assert.deepEqual(faults, []);
});

test("solvers and pages are saved", async () => {
  const { page } = await opened();
  await typeText(page, CRANK);
  await shows(page, "Crank");
  for (const [kind, name] of [
    ["kin", "crank.kin"],
    ["js", "crank.mjs"],
    ["page", "crank.html"],
  ]) {
    await page.locator("summary").first().click();
    const download = page.waitForEvent("download");
    await page.locator(`[data-save="${kind}"]`).click();
    assert.equal((await download).suggestedFilename(), name);
  }
});

test("a drawing becomes text, and the text moves", async () => {
  const { page, faults } = await opened();
  await page.locator("#draw").click();
  await page.locator("#drawings").selectOption({ label: "Toggle clamp" });
  await shows(page, "ToggleClamp");
  assert.match(await page.locator(".cm-content").innerText(), /b == d \+ r4 \* cis\(theta4\);/);
  await page.waitForFunction(() => location.hash.includes("&drawing="));
  assert.deepEqual(faults, []);
});

test("a link holds the drawing of its text, as long as the text is the drawing's", async () => {
  const { page } = await opened();
  await page.locator("#draw").click();
  await page.locator("#drawings").selectOption({ label: "Toggle clamp" });
  await page.waitForFunction(() => location.hash.includes("&drawing="));
  const hash = await page.evaluate(() => location.hash);
  const text = await page.locator(".cm-content").innerText();
  const { page: other, faults } = await opened(hash);
  await shows(other, "ToggleClamp");
  assert.equal(await other.locator(".cm-content").innerText(), text);
  assert.equal(await other.locator("#drawn").isVisible(), true);
  assert.match(await other.locator("#drawing").getAttribute("aria-label"), /\d points/);
  await typeText(other, CRANK);
  await other.waitForFunction(() => !location.hash.includes("&drawing="));
  // a drawing that is none is left out
  const { page: third } = await opened(hash.replace(/&drawing=.*/, "&drawing=AAAA"));
  await shows(third, "ToggleClamp");
  assert.equal(await third.locator("#drawn").isVisible(), false);
  assert.deepEqual(faults, []);
});

test("loads are added to a drawing, give its forces, and stay while it changes", async () => {
  const { page, faults } = await opened();
  const text = () => page.locator("#editor .cm-content").innerText();
  await page.locator("#draw").click();
  await page.locator("#drawings").selectOption({ label: "Toggle clamp" });
  await shows(page, "ToggleClamp");
  await page.locator("#add-loads").click();
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  await frame.locator("label", { hasText: "Forces" }).first().waitFor();
  assert.match(await text(), /force tip = \(0, -100N\);/);
  assert.equal(await page.locator("#add-loads").isVisible(), false);
  assert.ok(await page.evaluate(() => location.hash.includes("&drawing=")));
  const before = await text();
  await page.locator("#drawing .hit-point").nth(4).focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction((old) => document.querySelector("#editor .cm-content").innerText !== old, before);
  assert.match(await text(), /r4_tip = .*[^]*force tip = \(0, -100N\);/);
  // another drawing has no loads of this one
  await page.locator("#drawings").selectOption({ label: "Four-bar linkage" });
  await shows(page, "FourBar");
  assert.doesNotMatch(await text(), /loads/);
  assert.equal(await page.locator("#mistakes li").count(), 0);
  assert.deepEqual(faults, []);
});

test("a file of another program becomes a drawing and a mechanism", async () => {
  const { page, faults } = await opened();
  const file = fileURLToPath(new URL("../../kin-sketch/tests/foreign/pmks/four_bar.txt", import.meta.url));
  await page.locator("#file").setInputFiles(file);
  await page.locator("#drawn").waitFor();
  await page.waitForFunction(() => document.querySelector(".cm-content").innerText.includes("Imported from PMKS"));
  assert.deepEqual(faults, []);
});

test("forces are drawn, and their peaks are found", async () => {
  const { page, faults } = await opened();
  const file = fileURLToPath(new URL("../../kin-studio/examples/crank_press.kin", import.meta.url));
  await page.locator("#file").setInputFiles(file);
  await shows(page, "CrankPress");
  await page.waitForFunction(() => document.getElementById("state").textContent === "");
  await page.locator('#moving iframe.behind[title^="CrankPress"]').waitFor({ state: "detached" });
  const frame = page.locator("#moving iframe:not(.behind)").contentFrame();
  assert.equal(await frame.locator("#show-forces").isChecked(), true);
  // the peak that the chapter on forces prints
  await frame.locator(".paper td", { hasText: "5878" }).first().waitFor({ state: "attached" });
  assert.deepEqual(faults, []);
});

test("at twice the size everything can be reached", async () => {
  // a window of 1280 by 900 pixels, as it is laid out at 200 %
  const { page } = await opened("", { viewport: { width: 640, height: 450 }, deviceScaleFactor: 2 });
  for (const name of ["#examples", "#draw", "#open", "#link", "#editor", "#moving"]) {
    const box = await page.locator(name).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 640, `${name}: ${JSON.stringify(box)}`);
    await page.locator(name).scrollIntoViewIfNeeded();
  }
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 640);
});

test("axe finds no serious fault", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page } = await opened("", { colorScheme, bypassCSP: true });
    assert.deepEqual(await seriousFaults(page), []);
  }
});
