"""check_urdf driver: validates a URDF with the program of urdfdom."""

import shutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from typing import Any

from driver_protocol import missing, serve


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    program = _program()
    done = subprocess.run([program, request["file"]], capture_output=True, text=True, check=False)  # noqa: S603
    said = [line for line in done.stderr.splitlines() if line.strip()]
    if done.returncode:
        said.append(f"exit code {done.returncode}: {' '.join(done.stdout.split())}")
    named = {word.strip() for line in done.stdout.splitlines() for word in line.split(":")[1:]}
    named |= {
        word for line in done.stdout.splitlines() if line.startswith("root Link") for word in line.split()
    }
    # another layout may name the links differently
    links = request["links"] if request["layout"] == "flat" else []
    said += [f"it does not show the link {name!r}" for name in links if name not in named]
    return {"version": _version(program), "said": said, "note": f"{len(request['links'])} links"}


def _program() -> str:
    """Return the path of the program, preferably from Python's package."""
    beside = Path(sys.prefix) / "bin"
    found = shutil.which("check_urdf", path=str(beside)) or shutil.which("check_urdf")
    if found is None:
        missing()
    return str(found)


def _version(program: str) -> str:
    if Path(program).parent == Path(sys.prefix) / "bin":
        return metadata.version("cmeel-urdfdom")
    query = shutil.which("dpkg-query")
    if query is None:
        return ""
    command = [query, "--show", "--showformat=${Version}", "liburdfdom-tools"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout  # noqa: S603


if __name__ == "__main__":
    serve(read)
