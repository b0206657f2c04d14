/** Serves the files of the repository, under the strictest policy that the drawing has to work with. */
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const ROOT = new URL("../../../", import.meta.url).pathname;
const TYPES = { ".html": "text/html", ".mjs": "text/javascript", ".css": "text/css" };
const POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:";

/** @returns {Promise<{address: string, stop(): void}>} */
export function serve() {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://local").pathname);
    try {
      const text = await readFile(join(ROOT, path));
      response.writeHead(200, {
        "content-type": TYPES[extname(path)] ?? "text/plain",
        "content-security-policy": POLICY,
      });
      response.end(text);
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
