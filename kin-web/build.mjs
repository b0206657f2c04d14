/**
 * Builds the page into the folder `site`: `index.html` with `kin.wasm` beside it, and `kin.html`, which is one file.
 *
 *     npm ci && npm run build
 */
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

import { build } from "esbuild";

const here = fileURLToPath(new URL(".", import.meta.url));
const target = "wasm32-unknown-unknown";
/** Small, for visitors. `KIN_PROFILE=quick` takes a third of the time, for tests. */
const profile = process.env.KIN_PROFILE ?? "web";

/** The only output of a bundle. */
async function bundled(entry, define = {}, format = "esm") {
  const { outputFiles } = await build({
    entryPoints: [`${here}${entry}`],
    bundle: true,
    minify: true,
    format,
    charset: "utf8",
    target: "es2022",
    define,
    write: false,
  });
  // a text within a script must not end it
  return outputFiles[0].text.replaceAll("</", "<\\/").replaceAll("<!--", "<\\!--");
}

async function style(entry) {
  const { outputFiles } = await build({ entryPoints: [`${here}${entry}`], bundle: true, minify: true, write: false });
  return outputFiles[0].text;
}

const source = (content) => `'sha256-${createHash("sha256").update(content).digest("base64")}'`;

export async function buildPage(site = `${here}site/`) {
  execFileSync("cargo", ["build", "-p", "kin-web", "--profile", profile, "--target", target], {
    cwd: `${here}..`,
    stdio: "inherit",
  });
  const folder = process.env.CARGO_TARGET_DIR ?? `${here}../target`;
  const wasm = `${folder}/${target}/${profile}/kin_web.wasm`;
  const view = {
    markup: readFileSync(`${here}../kin-studio/src/page/page.html`, "utf8"),
    style: await style("../kin-studio/src/page/page.css"),
    script: await bundled("page/view.mjs"),
  };
  const worker = await bundled("page/worker.mjs", {}, "iife");
  const script = await bundled("page/main.mjs", { WORKER: JSON.stringify(worker), VIEW: JSON.stringify(view) });
  const css = await style("page/page.css");
  // the editor makes style sheets while it runs; the frame's script is admitted by its hash, and solvers come as blobs
  const policy = [
    "default-src 'none'",
    `script-src ${source(script)} ${source(view.script)} blob: 'wasm-unsafe-eval'`,
    "style-src 'unsafe-inline'",
    "img-src data: blob:",
    "worker-src blob:",
    "connect-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const page = (kin) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>kin: type an equation, see it move</title>
<style>${css}</style>
</head>
<body>
${readFileSync(`${here}page/page.html`, "utf8")}${kin}<script type="module">${script}</script>
</body>
</html>
`;
  mkdirSync(site, { recursive: true });
  copyFileSync(wasm, `${site}/kin.wasm`);
  writeFileSync(`${site}/index.html`, page(""));
  const packed = gzipSync(readFileSync(wasm), { level: 9 }).toString("base64");
  writeFileSync(`${site}/kin.html`, page(`<script type="application/octet-stream" id="kin">${packed}</script>\n`));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await buildPage();
}
