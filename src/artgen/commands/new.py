"""`artgen new`: a small package with a starter category."""

import importlib.util
import keyword
import shutil
from importlib.resources import files
from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from artgen._names import NAME_RULE, is_identifier
from artgen.catalog import categories
from artgen.errors import ExportError, ParameterError
from artgen.export.files import write_files

_NAME = "my_category"  # name of the starter category
_FILES = {
    "README.md": "README.md",
    "package.toml": "pyproject.toml",  # with its own name, tools would find two projects named artgen
    f"src/{_NAME}.py": "src/{name}.py",
    f"tests/test_{_NAME}.py": "tests/test_{name}.py",
}
"""Files of the starter with their targets."""


def new(
    name: Annotated[str, Argument(metavar="NAME", help="Name of the category and its package: hamper.")],
    *,
    folder: Annotated[Path, Option("--dir", help="Parent of the folder of the package.")] = Path(),
) -> None:
    """Write a package with a starter category, its test, and its entry point."""
    _check_name(name)
    target, starter = folder / name, files("artgen") / "starter"
    if target.exists():
        raise ExportError(f"{target} exists; choose another name, or another place with --dir")
    texts = {
        path.format(name=name): (starter / file).read_text(encoding="utf-8").replace(_NAME, name).encode()
        for file, path in _FILES.items()
    }
    partial = target.with_name(f".{name}.partial")
    try:
        write_files(texts, partial)
        partial.rename(target)
    except OSError as error:
        shutil.rmtree(partial, ignore_errors=True)
        raise ExportError(f"cannot write {target}: {error.strerror or error}; nothing was written") from error
    module = target / "src" / f"{name}.py"
    typer.echo(f"{module}\n\ncheck it:      artgen check {module}\nlook at it:    artgen view {module}")
    typer.echo(f"prove it:      artgen certify {module}")
    typer.echo(f"add it to `artgen list`:  pip install --editable {target}")


def _check_name(name: str) -> None:
    """Check that a name is possible for a category and its module."""
    import artgen

    if keyword.iskeyword(name):
        raise ParameterError(
            f"{name!r} cannot name a category: it is a keyword of Python; choose another name"
        )
    if not is_identifier(name) or name != name.lower():
        raise ParameterError(f"{name!r} cannot name a category; use small {NAME_RULE}: hamper")
    if name in categories():
        raise ParameterError(f"there is a category {name!r}; choose another name")
    if name in artgen.__all__:
        raise ParameterError(f"{name!r} is a name of artgen that categories import; choose another name")
    module = importlib.util.find_spec(name)
    if module is not None and module.origin is not None:  # a plain folder has no loader
        raise ParameterError(f"there is a Python module {name!r}; choose another name")
