/** The whole text in the address, with its drawing if it comes from one: a link is a mechanism. */

async function through(stream, bytes) {
  const blob = new Blob([bytes]);
  return new Uint8Array(await new Response(blob.stream().pipeThrough(stream)).arrayBuffer());
}

async function packed(text) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return letters.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The text that was packed, or null if it is damaged. */
async function unpacked(letters) {
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) =>
      letter.charCodeAt(0),
    );
    return new TextDecoder("utf-8", { fatal: true }).decode(
      await through(new DecompressionStream("deflate-raw"), bytes),
    );
  } catch {
    return null;
  }
}

/** The part of an address behind `#`. */
export async function addressOf(text, drawing = null) {
  const own = drawing === null ? "" : `&drawing=${await packed(JSON.stringify(drawing))}`;
  return `kin=${await packed(text)}${own}`;
}

/**
 * The text of an address and the data of its drawing, either of which is null if there is none or it is damaged.
 * @returns {Promise<{text: string | null, drawing: unknown}>}
 */
export async function readAddress(hash) {
  const [, letters, drawn] = /^#?kin=([\w-]+)(?:&drawing=([\w-]+))?$/.exec(hash) ?? [];
  const [text, drawing] = await Promise.all([letters, drawn].map((part) => (part ? unpacked(part) : null)));
  try {
    return { text, drawing: JSON.parse(drawing) };
  } catch {
    return { text, drawing: null };
  }
}
