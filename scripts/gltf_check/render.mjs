// Draws GLB files with three.js in headless Chromium: `node render.mjs VIEWS.json`.
//
// VIEWS.json is a list of views: {glb, out, width, height, eye, target, fov} with the camera in glTF's axes
// (y up) [m, degrees], and what is wanted of: animation and time [s], positions of joints, unlit (base colors
// alone), light (the direction that one light comes from, instead of a room), background (0xrrggbb).
// ARTGEN_CHROMIUM names the browser if it is not on the path.

import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { load, modules } from "./packages.mjs";

const puppeteer = load("puppeteer-core");
const here = dirname(fileURLToPath(import.meta.url));
const views = JSON.parse(readFileSync(process.argv[2], "utf8"));
const types = { ".html": "text/html", ".js": "text/javascript", ".glb": "model/gltf-binary" };

function chromium() {
  const wanted = process.env.ARTGEN_CHROMIUM;
  return wanted || execFileSync("sh", ["-c", "command -v chromium || command -v google-chrome"], { encoding: "utf8" }).trim();
}

/** Returns the file behind an address: the page, a view's GLB by its number, or a module of three.js. */
function file(path) {
  if (path === "/") return join(here, "render.html");
  const glb = /^\/(\d+)\.glb$/.exec(path);
  return glb ? views[Number(glb[1])].glb : join(modules, normalize(path));
}

const server = createServer((request, response) => {
  try {
    const path = file(new URL(request.url, "http://localhost").pathname);
    const content = readFileSync(path);
    response.writeHead(200, { "Content-Type": types[extname(path)] ?? "application/octet-stream" }).end(content);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((started) => server.listen(0, "127.0.0.1", started));

const browser = await puppeteer.launch({
  executablePath: chromium(),
  headless: true,
  args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox", "--disable-dev-shm-usage"],
});
try {
  const page = await browser.newPage();
  page.on("pageerror", (error) => console.error(String(error)));
  page.on("console", (message) => message.type() === "error" && console.error(message.text()));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction("window.draw");
  for (const [number, view] of views.entries()) {
    const url = await page.evaluate((address, what) => window.draw(address, what), `/${number}.glb`, view);
    writeFileSync(view.out, Buffer.from(url.split(",")[1], "base64"));
  }
} finally {
  await browser.close();
  server.close();
}
