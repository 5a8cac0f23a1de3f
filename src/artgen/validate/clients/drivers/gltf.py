"""Driver of the Khronos validator: errors and warnings of a GLB, by node."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from driver_protocol import MISSING, serve

_PACKAGE = "gltf-validator"
_SCRIPT = """
const { readFileSync } = require("node:fs");
const { createRequire } = require("node:module");
const { validateBytes, version } = createRequire(process.argv[1] + "/here.js")("gltf-validator");
validateBytes(new Uint8Array(readFileSync(process.argv[2])), { maxIssues: 100 })
  .then(({ issues }) => console.log(JSON.stringify({ version: version(), ...issues })));
"""
_SEVERE = 1  # severities: 0 error, 1 warning, 2 information, 3 hint


def _read(request: dict[str, Any]) -> dict[str, Any]:
    node, modules = shutil.which("node"), _modules()
    if node is None or modules is None:
        sys.exit(MISSING)
    command = [node, "--eval", _SCRIPT, str(modules), request["file"]]
    done = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    if done.returncode:
        raise RuntimeError(f"the validator fails: {done.stderr.strip()}")
    report = json.loads(done.stdout)
    severe = [message for message in report["messages"] if message["severity"] <= _SEVERE]
    hints = len(report["messages"]) - len(severe)
    return {
        "version": report["version"],
        "said": [
            f"{message['code']}: {message['message']} ({message.get('pointer', 'the file')})"
            for message in severe
        ],
        "note": f"{hints} hints" if hints else "",
    }


@cache
def _modules() -> Path | None:
    """Return the folder of npm packages with the validator, if there is one."""
    return next((place for place in _places() if (place / _PACKAGE).is_dir()), None)


def _places() -> Iterator[Path]:
    """Yield folders of npm packages: the named one, that of artgen's sources, and npm's global one."""
    named = os.environ.get("ARTGEN_NODE_MODULES")
    if named:
        yield Path(named)
    for parent in Path(__file__).parents:
        yield parent / "scripts" / "gltf_check" / "node_modules"
    npm = shutil.which("npm")
    if npm is not None:
        command = [npm, "root", "--global"]
        found = subprocess.run(command, capture_output=True, text=True, check=False).stdout  # noqa: S603
        yield Path(found.strip())


if __name__ == "__main__":
    serve(_read)
