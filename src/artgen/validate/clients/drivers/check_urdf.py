"""check_urdf driver: validates a URDF with the program of urdfdom."""

import re
import shutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from typing import Any

from driver_protocol import MISSING, serve

_BESIDE = Path(sys.prefix) / "bin"  # programs of Python's packages


def _read(request: dict[str, Any]) -> dict[str, Any]:
    program = shutil.which("check_urdf", path=str(_BESIDE)) or shutil.which("check_urdf")
    if program is None:
        sys.exit(MISSING)
    done = subprocess.run([program, request["file"]], capture_output=True, text=True, check=False)  # noqa: S603
    said = [line for line in done.stderr.splitlines() if line.strip()]
    if done.returncode:
        said.append(f"exit code {done.returncode}: {' '.join(done.stdout.split())}")
    named = re.findall(r"^\s*(?:root Link|child\(\d+\)): +(\S+)", done.stdout, re.MULTILINE)
    said += [f"it does not show the link {name!r}" for name in request["links"] if name not in named]
    return {"version": _version(program), "said": said, "note": f"{len(request['links'])} links"}


def _version(program: str) -> str:
    if Path(program).parent == _BESIDE:
        return metadata.version("cmeel-urdfdom")
    query = shutil.which("dpkg-query")
    if query is None:
        return ""
    command = [query, "--show", "--showformat=${Version}", "liburdfdom-tools"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout  # noqa: S603


if __name__ == "__main__":
    serve(_read)
