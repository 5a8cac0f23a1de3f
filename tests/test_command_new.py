"""`artgen new`: the package that it writes works as it is, installed or not."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from artgen import catalog
from artgen.testing import check_category

FILES = {"README.md", "pyproject.toml", "src/hamper.py", "tests/test_hamper.py"}


def files_below(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def run(*arguments: str, folder: Path, path: Path) -> str:
    done = subprocess.run(
        [sys.executable, "-m", *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(path), "PYTHONDONTWRITEBYTECODE": "1"},
        timeout=120,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_package_works_as_it_is(artgen_command, tmp_path: Path) -> None:
    made = artgen_command("new", "hamper")
    assert (made.code, made.err) == (0, "")
    package = tmp_path / "hamper"
    assert files_below(package) == FILES
    assert not [name for name in FILES if "my_category" in (package / name).read_text()]
    assert "artgen view hamper/src/hamper.py" in made.out
    # by its file, before anything is installed
    assert catalog.load_file(package / "src/hamper.py").labels == ("box", "lid", "handle")
    assert artgen_command("certify", "hamper/src/hamper.py", "--samples", "2", "--no-corners").code == 0
    assert "2 passed" in run("pytest", "-q", "-p", "no:cacheprovider", folder=package, path=tmp_path)
    # installed, in a folder of its own instead of this environment
    site = tmp_path / "site"
    options = ("--quiet", "--no-deps", "--no-index", "--no-build-isolation", "--target", str(site))
    run("pip", "install", *options, str(package), folder=tmp_path, path=tmp_path)
    shown = run("artgen", "list", folder=tmp_path, path=site)
    line = next(line for line in shown.splitlines() if line.startswith("hamper"))
    assert "Make a closed wooden box with a lid that is hinged at the back." in line
    assert " 1 " in line  # joint


def test_the_starter_is_sound_at_its_corners(artgen_command, tmp_path: Path) -> None:
    artgen_command("new", "casket", "--dir", str(tmp_path / "deep" / "er"))
    file = tmp_path / "deep" / "er" / "casket" / "src" / "casket.py"
    proven = artgen_command("certify", str(file), "--samples", "4")
    assert proven.out.startswith("casket: 100.0 % proven")
    check_category(str(file), seeds=[7, 8])


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("door", "there is a category 'door'; choose another name"),
        ("my-stapler", "'my-stapler' cannot name a category; use small letters, digits and _, at most 100"),
        ("Stapler", "'Stapler' cannot name a category"),
        ("s" * 300, f"{'s' * 300!r} cannot name a category; use small"),
        ("class", "'class' cannot name a category: it is a keyword of Python; choose another name"),
        ("uniform", "'uniform' is a name of artgen that categories import"),
        ("json", "there is a Python module 'json'; choose another name"),
        ("../stapler", "'../stapler' cannot name a category"),
    ],
)
def test_a_bad_name_is_refused(artgen_command, tmp_path: Path, name: str, message: str) -> None:
    result = artgen_command("new", name)
    assert result.code == 2
    assert result.err.startswith(f"error: {message}")
    assert not list(tmp_path.iterdir())


def test_an_existing_folder_is_left_alone(artgen_command, tmp_path: Path) -> None:
    (tmp_path / "hamper").mkdir()
    (tmp_path / "hamper" / "notes").write_text("mine")
    result = artgen_command("new", "hamper")
    assert result.code == 2
    assert result.err == "error: hamper exists; choose another name, or another place with --dir\n"
    assert files_below(tmp_path) == {"hamper/notes"}


def test_a_disk_that_refuses_leaves_nothing(artgen_command, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    result = artgen_command("new", "hamper", "--dir", "file")
    assert (result.code, files_below(tmp_path)) == (2, {"file"})
    assert result.err.startswith("error: cannot write file/hamper: ")
    assert result.err.endswith("; nothing was written\n")


def test_a_place_that_the_file_system_refuses_gives_one_line(artgen_command) -> None:
    result = artgen_command("new", "casket", "--dir", "b" * 300)
    assert (result.code, result.out) == (2, "")
    path = str(Path("b" * 300) / "casket")
    assert result.err == f"error: the file system refuses the name {path!r}: it is too long\n"
