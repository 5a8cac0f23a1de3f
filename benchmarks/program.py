"""Other programs of this folder, which print lines of JSON."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any


def output_of(name: str, *arguments: str | int | Path) -> list[dict[str, Any]]:
    """Run a program of this folder and return what it prints, line by line.

    Raises:
        CalledProcessError: It fails; its messages were printed.
    """
    command = [sys.executable, str(Path(__file__).with_name(name)), *map(str, arguments)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)  # noqa: S603 - ours
    return [json.loads(line) for line in done.stdout.splitlines()]
