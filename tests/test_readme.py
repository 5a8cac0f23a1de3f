"""What the README shows is true: its Python runs, its commands exist; and it stays short."""

import os
import re
import shlex
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import typer

from artgen.cli import command_line

TEXT = (Path(__file__).parent.parent / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", TEXT, flags=re.DOTALL)
COMMANDS = [
    line.removeprefix("$ ")
    for block in re.findall(r"```console\n(.*?)```", TEXT, flags=re.DOTALL)
    for line in block.splitlines()
    if line.startswith("$ artgen")
]


def run(arguments: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-W", "error", *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        env={**os.environ, "MPLBACKEND": "agg"},
        timeout=120,
    )


def test_it_is_one_screen_with_something_to_run() -> None:
    assert TEXT.count("\n") <= 90
    assert len(BLOCKS) >= 1
    assert len(COMMANDS) >= 3
    assert "$ make demo " in TEXT
    assert "$ make test " in TEXT


def test_python_blocks_run_one_after_the_other(tmp_path: Path) -> None:
    script = tmp_path / "readme.py"
    script.write_text("\n\n".join(BLOCKS), encoding="utf-8")
    done = run([str(script)], tmp_path)
    assert done.returncode == 0, done.stderr
    assert not done.stderr


def has_own_tests(command: str) -> bool:
    """Tell whether a command opens a browser, or works for minutes: its tests are elsewhere."""
    return command.split()[1] in ("view", "gallery", "studio", "images", "demos")


def draws(command: str) -> bool:
    return command.split()[1] in ("check", "render", "sheet")


def can_draw() -> bool:
    return find_spec("embreex") is not None


def test_commands_run_one_after_the_other(tmp_path: Path) -> None:
    for command in COMMANDS:
        if has_own_tests(command) or (draws(command) and not can_draw()):
            continue
        done = run(["-m", *shlex.split(command, comments=True)], tmp_path)
        assert done.returncode == 0, (command, done.stderr)
        assert not done.stderr, command


def test_the_other_commands_are_such_as_artgen_understands() -> None:
    known = typer.main.get_command(command_line())
    for command in filter(has_own_tests, COMMANDS):
        _, name, *arguments = shlex.split(command, comments=True)
        known.commands[name].make_context(name, arguments)  # reads the arguments, and runs nothing
