/** The parts that the build puts into a page: kin itself, its worker, and the moving page. */

/* global WORKER, VIEW, KIN, EXAMPLES, WORDS */

/** kin as a compiled module: from the page if it holds kin, and otherwise from its file. */
export async function kinModule() {
  const held = document.getElementById("kin");
  if (!held) {
    return WebAssembly.compileStreaming(fetch(KIN));
  }
  const letters = atob(held.textContent.trim());
  const packed = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index += 1) {
    packed[index] = letters.charCodeAt(index);
  }
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compileStreaming(new Response(unpacked, { headers: { "content-type": "application/wasm" } }));
}

export function startWorker() {
  const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}

export const view = VIEW;

/** The mechanisms of the library as files. @type {{name: string, text: string}[]} */
export const examples = EXAMPLES;

/** The names that an expression can call, and the units of numbers. @type {{functions: string[], units: string[]}} */
export const words = WORDS;
