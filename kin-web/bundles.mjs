/** Scripts and styles as texts, and the policy of a page that holds them. */
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

export const here = fileURLToPath(new URL(".", import.meta.url));

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

export async function style(entry) {
  const { outputFiles } = await build({ entryPoints: [`${here}${entry}`], bundle: true, minify: true, write: false });
  return outputFiles[0].text;
}

/** The moving page within its frame. */
export async function movingPage(styleEntry) {
  return {
    markup: readFileSync(`${here}../kin-studio/src/page/page.html`, "utf8"),
    style: await style(styleEntry),
    script: await bundled("page/view.mjs"),
  };
}

/**
 * A script that asks kin and shows moving pages.
 *
 * @param {string} kin the address of kin in WebAssembly
 * @param {object} known what kin says of itself: its examples, and the names that an expression can call
 */
export async function script(entry, view, kin, known, format = "esm") {
  const worker = await bundled("page/worker.mjs", {}, "iife");
  const parts = { WORKER: worker, VIEW: view, KIN: kin, EXAMPLES: known.examples, WORDS: known.words };
  const define = Object.entries(parts).map(([name, value]) => [name, JSON.stringify(value)]);
  return bundled(entry, Object.fromEntries(define), format);
}

export const hashOf = (content) => `'sha256-${createHash("sha256").update(content).digest("base64")}'`;

/**
 * The policy of a page. The editor makes style sheets while it runs; the frame's script is admitted by its hash, and
 * solvers come as blobs.
 */
export function policy(scripts, files = "") {
  return [
    "default-src 'none'",
    `script-src ${scripts} blob: 'wasm-unsafe-eval'`,
    `style-src 'unsafe-inline'${files}`,
    `img-src data: blob:${files}`,
    "worker-src blob:",
    "connect-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}
