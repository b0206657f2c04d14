/** Pictures of the drawing in a folder, to be looked at: `node look.mjs FOLDER`. */
import { join } from "node:path";

import { open, partAt, PHONE, resultOf } from "./desk.mjs";

const [folder = "."] = process.argv.slice(2);
const desk = await open();
for (const [name, options] of Object.entries({ light: {}, dark: { colorScheme: "dark" }, phone: PHONE })) {
  await desk.withDrawing(async (page) => {
    const titles = await page.evaluate(() => window.examples.map(({ title }) => title));
    for (const [index, title] of titles.entries()) {
      await page.evaluate((example) => window.drawing.load(window.examples[example].sketch), index);
      await resultOf(page);
      await page.mouse.click(...(await partAt(page, index % 2 === 0 ? "link" : "point", 1)));
      await resultOf(page);
      await page.screenshot({ path: join(folder, `${name}-${title.replace(/\W+/g, "_")}.png`) });
    }
    await page.evaluate(() => window.drawing.load(window.examples[5].sketch));
    await page.locator(".hit-point").nth(1).focus();
    for (const key of ["d", "Enter", "v", "ArrowRight"]) {
      await page.keyboard.press(key);
    }
    await resultOf(page);
    await page.screenshot({ path: join(folder, `${name}-fault.png`) });
    await page.locator("#drawing").focus();
    for (const key of ["l", "Enter", ...Array(6).fill("ArrowRight"), "ArrowUp"]) {
      await page.keyboard.press(key);
    }
    await page.screenshot({ path: join(folder, `${name}-pen.png`) });
  }, options);
}
await desk.close();
