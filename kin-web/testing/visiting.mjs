/** A page of the site in a browser, with the faults that it reports. */
import { fileURLToPath } from "node:url";

const axe = fileURLToPath(new URL("../node_modules/axe-core/axe.min.js", import.meta.url));

/**
 * @param {object} options those of a context, such as its width
 * @param {(address: string) => boolean} isAllowed whether a page may request an address of the network
 */
export async function visit(browser, address, options = {}, isAllowed = () => false) {
  const context = await browser.newContext({ acceptDownloads: true, ...options });
  const page = await context.newPage();
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  page.on("request", (request) => {
    if (/^https?:/.test(request.url()) && !isAllowed(request.url())) {
      faults.push(request.url());
    }
  });
  await page.goto(address);
  return { page, faults };
}

/** The serious faults that axe finds, each with the first element that has it. The context bypasses the policy. */
export async function seriousFaults(page) {
  await page.addScriptTag({ path: axe });
  const found = await page.evaluate(() => globalThis.axe.run(document.body, { iframes: false }));
  const serious = found.violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
  return serious.map(({ id, nodes }) => [id, nodes[0].html]);
}

/** Replaces the text of an editor. */
export async function typeText(page, editor, text) {
  await editor.locator(".cm-content").click();
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText(text);
}
