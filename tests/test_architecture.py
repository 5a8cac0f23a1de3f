"""The rules of the layout: no circles of imports, parts beside their users, files worth opening."""

import ast
import re
from collections import defaultdict
from functools import cache
from pathlib import Path

import architecture
import grimp
import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from artgen.cli import COMMANDS

SOURCE = Path(__file__).parents[1] / "src" / "artgen"
PROGRAMS = ("starter", "drivers")  # templates, and programs of other environments
ALONE = (
    "artgen.cli",  # the entry point of the command
    "artgen.studio.guard",  # what keeps foreign pages out is read on its own
)
GEOMETRY = ("asset", "colliders", "export", "nodes", "proof", "topology", "referee")  # they decide on bytes
_TRIGONOMETRY = r"np\.(sin|cos|tan|arcsin|arccos|arctan2?|exp2?|log|log2|log10|log1p|cbrt|power)\b"
_PRODUCTS = (
    r"np\.(dot|vdot|inner|vecdot|linalg\.(inv|pinv|solve|lstsq|eigh?|qr|cholesky))\b"
    r"|np\.linalg\.norm\((?!.*axis=)"
)
LEAST_LINES = 60
LEAST_LINES_OF_ONE_USER = 200


@cache
def files() -> dict[str, Path]:
    """Return the files of the package by the name of their module."""
    found = [path for path in SOURCE.rglob("*.py") if not set(PROGRAMS) & set(path.parts)]
    return {_dotted(path): path for path in found}


def _dotted(path: Path) -> str:
    return ".".join(["artgen", *path.relative_to(SOURCE).with_suffix("").parts]).removesuffix(".__init__")


@cache
def imports() -> dict[str, set[str]]:
    """Return the modules that each module imports when it runs, in functions too."""
    graph = grimp.build_graph("artgen", cache_dir=None, exclude_type_checking_imports=True)
    found = {name: graph.find_modules_directly_imported_by(name) & {*files()} for name in files()}
    # the command line imports the module of a command by its name
    found["artgen.cli"] |= {f"artgen.commands.{place.partition('.')[0]}" for place in COMMANDS.values()}
    return found


def users(module: str) -> set[str]:
    return {name for name, targets in imports().items() if module in targets}


def circles(graph: dict[str, set[str]]) -> list[set[str]]:
    """Return the groups of modules that import each other."""
    names = sorted(graph)
    edges = [(names.index(first), names.index(second)) for first in names for second in graph[first]]
    rows, columns = np.array(edges).reshape(-1, 2).T
    table = coo_array((np.ones(len(edges)), (rows, columns)), shape=(len(names), len(names)))
    _, groups = connected_components(table, connection="strong")
    members = defaultdict(set)
    for name, group in zip(names, groups, strict=True):
        members[group].add(name)
    return [group for group in members.values() if len(group) > 1]


def test_no_imports_form_a_circle() -> None:
    assert circles(imports()) == []


def test_a_circle_is_found() -> None:
    added = imports() | {"artgen.errors": {"artgen.catalog"}}
    assert any({"artgen.errors", "artgen.catalog"} <= group for group in circles(added))


@pytest.mark.parametrize("module", sorted(name for name in files() if ".categories.shared." in name))
def test_a_shared_part_has_two_categories(module: str) -> None:
    found, waiting = set(), [module]
    while waiting:
        new = users(waiting.pop()) - found
        found |= new
        waiting += new
    categories = {name.split(".")[2] for name in found if name.startswith("artgen.categories.")} - {"shared"}
    assert len(categories) > 1 or files()[module].name == "__init__.py", f"{module} serves {categories} only"


def test_a_file_does_not_repeat_its_folder() -> None:
    repeated = [str(path) for path in files().values() if path.stem.startswith(f"{path.parent.name}_")]
    assert repeated == []


def test_every_file_is_worth_opening() -> None:
    """Small files belong to their customer, except for data, entry points and the fronts of packages."""
    small = []
    for module, path in files().items():
        text = path.read_text(encoding="utf-8")
        code = re.search(r"^(def|class) ", text, re.MULTILINE)
        if path.name in ("__init__.py", "__main__.py") or module in ALONE or not code:
            continue
        lines = len(text.splitlines())
        siblings = [name for name in users(module) if files()[name].parent == path.parent]
        if lines < LEAST_LINES:
            small.append(f"{module} has {lines} lines: merge it with the file that uses it")
        elif lines >= LEAST_LINES_OF_ONE_USER:
            continue
        elif len(users(module)) == len(siblings) == 1 and not is_table(siblings[0]):
            small.append(f"only {siblings[0]} uses {module} ({lines} lines)")
    assert small == []


def is_table(module: str) -> bool:
    """Tell whether a module puts several of its folder together, such as all families of materials."""
    path = files()[module]
    return (
        path.name == "__init__.py"
        or sum(files()[name].parent == path.parent for name in imports()[module]) > 5
    )


@pytest.mark.parametrize("package", GEOMETRY)
def test_geometry_uses_no_function_whose_digits_depend_on_the_processor(package: str) -> None:
    pattern = re.compile(_TRIGONOMETRY if package == "referee" else f"{_TRIGONOMETRY}|{_PRODUCTS}")
    found = {
        f"{path.relative_to(SOURCE)}: {match[0]}"
        for path in (SOURCE / package).rglob("*.py")
        for match in pattern.finditer(path.read_text(encoding="utf-8"))
    }
    assert not found, "use artgen._portable or math: the kernels of NumPy and BLAS differ between processors"


def test_a_class_name_has_one_meaning() -> None:
    homes = defaultdict(list)
    for name, path in files().items():
        if ".categories." in name:
            continue
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                homes[node.name].append(name)
    assert {name: found for name, found in homes.items() if len(found) > 1} == {}


def test_private_functions_have_no_sections_in_their_docstrings() -> None:
    long = [
        f"{name}:{node.lineno} {node.name}"
        for name, path in files().items()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.ClassDef)
        if node.name.startswith("_") and not node.name.startswith("__")
        if re.search(r"^(Args|Returns|Raises|Attributes):$", ast.get_docstring(node) or "", re.MULTILINE)
    ]
    assert long == []


def test_the_page_of_the_architecture_is_that_of_the_code() -> None:
    page = architecture.PAGE.read_text(encoding="utf-8")
    assert architecture.drawn(page) == page, "run: python scripts/architecture.py"


def test_a_wrong_name_on_the_page_is_found() -> None:
    with pytest.raises(LookupError, match=r"names artgen\.proof\.certfy, which does not exist"):
        architecture.drawn("see `artgen.proof.certfy`")
