/** The script and the style of the page, each as one small file. `npm run bundle` writes them; a test compares them. */
import { writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const page = fileURLToPath(new URL("../src/page/", import.meta.url));

/** The files with their paths and texts, as they should be. */
export async function bundle() {
  const { outputFiles } = await build({
    entryPoints: { main: `${page}alone.mjs`, page: `${page}page.css` },
    outdir: `${page}bundle`,
    bundle: true,
    minify: true,
    format: "esm",
    charset: "utf8",
    target: "es2022",
    write: false,
  });
  return outputFiles;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const { path, contents } of await bundle()) {
    writeFileSync(path, contents);
  }
}
