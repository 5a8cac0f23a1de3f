"""The author's function and statement of a node."""

import ast
import linecache
import textwrap
from pathlib import PurePath

from artgen.graph.node import PARAMETER, Node

PARAMETERS = "parameters"
"""Group of the nodes of parameters."""

_LINES = 12  # most lines of a statement that are shown


class Source:
    """Functions and statements of a file, or of a notebook cell.

    Attributes:
        functions: The functions.
        statements: First and last line of each statement without inner statements.
    """

    def __init__(self, file: str) -> None:
        self._lines = linecache.getlines(file)
        try:
            tree = ast.parse("".join(self._lines))
        except (SyntaxError, ValueError):  # edited since it was executed
            tree = ast.Module([], [])
        nodes = list(ast.walk(tree))
        self.functions = [node for node in nodes if isinstance(node, ast.FunctionDef)]
        self.statements = [
            (node.lineno, node.end_lineno or node.lineno)
            for node in nodes
            if isinstance(node, ast.stmt) and not hasattr(node, "body")
        ]

    def function(self, line: int) -> ast.FunctionDef | None:
        """Return the innermost function at a line, including its decorators."""
        inside = [each for each in self.functions if _first(each) <= line <= (each.end_lineno or 0)]
        return max(inside, key=_first, default=None)

    def statement(self, line: int) -> str:
        """Return the text of the statement at a line."""
        inside = [span for span in self.statements if span[0] <= line <= span[1]]
        return self.text(*min(inside, key=lambda span: span[1] - span[0], default=(line, line)))

    def parameter(self, line: int, name: str) -> tuple[int, str] | None:
        """Return the line and the text of a parameter of the function at a line."""
        made = self.function(line)
        for declared in [] if made is None else [*made.args.args, *made.args.kwonlyargs]:
            if declared.arg == name:
                return declared.lineno, self.text(declared.lineno, declared.lineno)
        return None

    def text(self, first: int, last: int) -> str:
        """Return lines without their common indentation."""
        lines = self._lines[first - 1 : min(last, first + _LINES - 1)]
        return textwrap.dedent("".join(lines)).rstrip()


class Authors:
    """Finds the author's function and line of a node; reads each file once."""

    def __init__(self) -> None:
        self._sources: dict[str, Source] = {}

    def group_of(self, node: Node) -> str:
        """Return the name of the author's function of a node, such as `doors.shelf`."""
        if node.op == PARAMETER:
            return PARAMETERS
        file, line = _place(node)
        function = self._source(file).function(line)
        path = PurePath(file)
        module = path.parent.name if path.stem == "__init__" else path.stem
        return module if function is None else f"{module}.{function.name}"

    def line_of(self, node: Node) -> tuple[str, str]:
        """Return the place of the line of a node, without folders, and its statement."""
        file, line = _place(node)
        source = self._source(file)
        found = None
        if node.op == PARAMETER:
            found = source.parameter(line, node.inputs["name"].rpartition(".")[2])
        line, text = found or (line, source.statement(line))
        return f"{PurePath(file).name}:{line}", text

    def _source(self, file: str) -> Source:
        if file not in self._sources:
            linecache.checkcache(file)
            self._sources[file] = Source(file)
        return self._sources[file]


def _place(node: Node) -> tuple[str, int]:
    file, _, line = node.where.rpartition(":")
    return file, int(line) if line.isdecimal() else 0


def _first(function: ast.FunctionDef) -> int:
    return min([function.lineno, *(each.lineno for each in function.decorator_list)])
