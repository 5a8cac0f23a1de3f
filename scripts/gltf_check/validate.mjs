// Judges GLB files by the Khronos validator: `node validate.mjs FILE...` prints a list of its reports as JSON.

import { readFileSync } from "node:fs";
import { load } from "./packages.mjs";

const { validateBytes } = load("gltf-validator");

const reports = [];
for (const path of process.argv.slice(2)) {
  const { issues, info } = await validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 100 });
  reports.push({ path, issues, info });
}
console.log(JSON.stringify(reports));
