/** Serves the folder `site`, as a visitor's server does. */
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const SITE = fileURLToPath(new URL("../site/", import.meta.url));
const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

/** @returns {Promise<{address: string, stop(): void}>} */
export function serve() {
  const server = createServer(async (request, response) => {
    const asked = normalize(new URL(request.url, "http://local").pathname);
    const path = asked.endsWith("/") ? `${asked}index.html` : asked;
    try {
      const content = await readFile(join(SITE, path));
      response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "text/plain" });
      response.end(content);
    } catch {
      response.writeHead(path === "/favicon.ico" ? 204 : 404).end();
    }
  });
  return new Promise((ready) => {
    server.listen(0, "127.0.0.1", () => {
      const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
      ready({ address: `http://127.0.0.1:${port}/`, stop: () => server.close() });
    });
  });
}
