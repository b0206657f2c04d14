/**
 * Builds the folder `site`: the page as `index.html` with `kin.wasm` beside it, the same page as one file, `kin.html`,
 * and the book in `book`, whose blocks ask the same `kin.wasm`.
 *
 *     npm ci && npm run build
 */
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

import { writeBook } from "./book/build.mjs";
import { hashOf, here, movingPage, policy, script, style } from "./bundles.mjs";
import { ask } from "./page/ask.mjs";

const target = "wasm32-unknown-unknown";
/** Small, for visitors. `KIN_PROFILE=quick` takes a third of the time, for tests. */
const profile = process.env.KIN_PROFILE ?? "web";

/** kin comes while the page is read, and not after its script. */
const PRELOAD = '<link rel="preload" href="kin.wasm" as="fetch" type="application/wasm" crossorigin>\n';

/** The path of kin in WebAssembly, which is built. */
function buildKin() {
  execFileSync("cargo", ["build", "-p", "kin-web", "--profile", profile, "--target", target], {
    cwd: `${here}..`,
    stdio: "inherit",
  });
  const folder = process.env.CARGO_TARGET_DIR ?? `${here}../target`;
  return `${folder}/${target}/${profile}/kin_web.wasm`;
}

/** What kin says of itself. The pages hold it, so that none has to ask before its mechanism moves. */
async function knownBy(wasm) {
  const { instance } = await WebAssembly.instantiate(readFileSync(wasm));
  const { examples } = ask(instance.exports, { ask: "examples" });
  const { words } = ask(instance.exports, { ask: "words" });
  return { examples, words };
}

async function writePage(site, wasm, known) {
  const view = await movingPage("../kin-studio/src/page/page.css");
  const own = await script("page/main.mjs", view, "kin.wasm", known);
  const css = await style("page/page.css");
  const page = (kin) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy(`${hashOf(own)} ${hashOf(view.script)}`)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>kin: type an equation, see it move</title>
${kin === "" ? PRELOAD : ""}<style>${css}</style>
</head>
<body>
${readFileSync(`${here}page/page.html`, "utf8")}${kin}<script type="module">${own}</script>
</body>
</html>
`;
  writeFileSync(`${site}/index.html`, page(""));
  const packed = gzipSync(readFileSync(wasm), { level: 9 }).toString("base64");
  writeFileSync(`${site}/kin.html`, page(`<script type="application/octet-stream" id="kin">${packed}</script>\n`));
}

export async function buildSite(site = `${here}site/`) {
  const wasm = buildKin();
  mkdirSync(site, { recursive: true });
  copyFileSync(wasm, `${site}/kin.wasm`);
  const known = await knownBy(wasm);
  await writePage(site, wasm, known);
  await writeBook(`${here}../docs/`, `${site}/book/`, known);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await buildSite();
}
