// Finds the npm packages: in ARTGEN_NODE_MODULES, or in node_modules beside this file after `npm ci`.

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

export const modules = resolve(process.env.ARTGEN_NODE_MODULES || join(here, "node_modules"));
export const load = createRequire(join(modules, "from_here.js"));
