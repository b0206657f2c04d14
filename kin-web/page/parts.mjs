/** The parts that the build puts into a page: kin itself, its worker, and the moving page. */

/* global WORKER, VIEW, KIN */

/** kin as a compiled module: from the page if it holds kin, and otherwise from its file. */
export async function kinModule() {
  const held = document.getElementById("kin");
  if (!held) {
    const response = await fetch(KIN);
    return WebAssembly.compile(await response.arrayBuffer());
  }
  const packed = Uint8Array.from(atob(held.textContent.trim()), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

export function startWorker() {
  const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}

export const view = VIEW;
