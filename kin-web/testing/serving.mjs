/** Serves a folder, as a visitor's server does. */
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/**
 * @param {string} folder
 * @param {object} headers those of every answer
 * @returns {Promise<{address: string, stop(): void}>} the address of the folder, without a slash at its end
 */
export function serve(folder, headers = {}) {
  const server = createServer(async (request, response) => {
    const asked = normalize(new URL(request.url, "http://local").pathname);
    const path = asked.endsWith("/") ? `${asked}index.html` : asked;
    try {
      const content = await readFile(join(folder, path));
      response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "text/plain", ...headers });
      response.end(content);
    } catch {
      response.writeHead(path === "/favicon.ico" ? 204 : 404).end();
    }
  });
  return new Promise((ready) => {
    server.listen(0, "127.0.0.1", () => {
      const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
      ready({ address: `http://127.0.0.1:${port}`, stop: () => server.close() });
    });
  });
}
