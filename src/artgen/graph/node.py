"""The node: an operation on other nodes and literals, with the author's line that recorded it."""

import hashlib
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from traceback import walk_tb
from types import FrameType, MappingProxyType
from typing import Any

PARAMETER = "parameter"
"""The operation of a value that is drawn at generation."""


@dataclass(frozen=True, eq=False, repr=False)
class Node:
    """An operation on its inputs; immutable, and equal to another node if their keys are equal.

    Attributes:
        op: Name of a registered operation.
        inputs: For each input of the operation a node, a literal (a string, a number, a truth value, None, or
            a dictionary of JSON data), or a tuple of these; lists become tuples.
        where: File and line of the author's code; not part of the key.
        key: Hash of the operation and everything below it.
        varies: Whether a parameter is among the nodes below, or is this node.
        children: The nodes among the inputs, in order, including repeats.
    """

    op: str
    inputs: Mapping[str, Any]
    where: str = ""
    key: str = field(init=False)
    varies: bool = field(init=False)
    children: tuple["Node", ...] = field(init=False)
    _text: tuple["str | Node", ...] = field(init=False)  # the text that is hashed, with nodes for their keys

    def __post_init__(self) -> None:
        """Compute the key from the inputs' keys."""
        text: list[str | Node] = [self.op]
        frozen = {}
        for name, value in self.inputs.items():
            text.append(name)
            frozen[name] = _spell(value, text)
        own = vars(self)
        own["inputs"] = MappingProxyType(frozen)
        own["children"] = children = tuple([part for part in text if type(part) is Node])
        own["varies"] = self.op == PARAMETER or any(node.varies for node in children)
        own["_text"] = tuple(text)
        own["key"] = _hashed([f"${part.key}" if isinstance(part, Node) else part for part in text])

    def digest(self, keys: Mapping[str, str]) -> str:
        """Hash the operation, its literals, and `keys` as the keys of its children."""
        return _hashed([f"${keys[part.key]}" if isinstance(part, Node) else part for part in self._text])

    def __repr__(self) -> str:
        """Return the operation and its place, without the possibly thousands of nodes below."""
        return f"<node {self.op} at {self.where}>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Rebuild the node when it is pickled or copied, which computes the key again."""
        return Node, (self.op, dict(self.inputs), self.where)


class Data(dict[str, Any]):
    """Immutable JSON data of an object, together with the object, so that it is encoded only once."""

    def __init__(self, data: Mapping[str, Any], value: Any) -> None:
        super().__init__(data)
        self.value = value
        spelling: list[str | Node] = []
        _spell(dict(data), spelling)
        self.spelling = tuple(spelling)

    def __reduce__(self) -> tuple[Any, ...]:
        """Rebuild the data when they are pickled or copied."""
        return Data, (dict(self), self.value)


def _hashed(text: list[str]) -> str:
    return hashlib.blake2b("\0".join(text).encode(), digest_size=12).hexdigest()


def nodes_in(value: Any) -> Iterator[Node]:
    """Yield the nodes in the value of one input, in order, including repeats."""
    if isinstance(value, Node):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from nodes_in(item)


def _spell(value: Any, text: list[str | Node]) -> Any:
    """Append the value of one input to a list of text and nodes, and return it with tuples for lists."""
    kind = type(value)
    if kind is Node:
        text.append(value)
    elif kind is float:  # the most frequent ones first
        text.append(repr(value))
    elif kind is Data:
        text.extend(value.spelling)
    elif isinstance(value, (tuple, list)):
        text.append("[")
        value = tuple([_spell(item, text) for item in value])
        text.append("]")
    elif isinstance(value, dict):
        text.append("{")
        for name in sorted(value):
            text.append(name)
            _spell(value[name], text)
        text.append("}")
    else:
        text.append(repr(value))
    return value


def topological(root: Node) -> list[Node]:
    """Return every node that the root reaches once, inputs before their users."""
    order: list[Node] = []
    seen: set[str] = set()
    stack: list[tuple[Node, bool]] = [(root, False)]
    while stack:
        node, expanded = stack.pop()
        if expanded:
            order.append(node)
        elif node.key not in seen:
            seen.add(node.key)
            stack.append((node, True))
            stack.extend((child, False) for child in reversed(node.children))
    return order


_LANGUAGE = ("artgen.graph", "artgen.nodes", "artgen.sampling", "artgen.generator", "numpy")
"""Modules between an author and the nodes, also those of NumPy; errors never point to them."""


def authors_line() -> str:
    """Return `file:line` of the innermost caller outside the language.

    A fitting has the line of its caller outside the package. Constants that the language creates during its
    import have a line of the language.
    """
    frame: FrameType | None = sys._getframe(1)
    inner = frame
    while frame is not None and _is_language(frame.f_globals.get("__name__", "")):
        inner, frame = frame, frame.f_back
    outer = frame
    while outer is not None and _is_in_package(outer.f_globals.get("__name__", "")):
        outer = outer.f_back
    if outer is not None and not outer.f_code.co_filename.startswith("<frozen importlib"):
        frame = frame if _is_language(outer.f_globals.get("__name__", "")) else outer
    if frame is not None and not frame.f_code.co_filename.startswith("<frozen importlib"):
        inner = frame
    return f"{inner.f_code.co_filename}:{inner.f_lineno}" if inner is not None else ""


def line_in(path: str, error: BaseException) -> str:
    """Return `file:line` of the innermost line of a file in a traceback; the file without such a line."""
    if isinstance(error, SyntaxError) and error.filename == path:
        return f"{path}:{error.lineno}"
    lines = [line for frame, line in walk_tb(error.__traceback__) if frame.f_code.co_filename == path]
    return f"{path}:{lines[-1]}" if lines else path


@cache
def _is_in_package(module: str) -> bool:
    """Return whether a module belongs to the package, but not to the language."""
    return module.startswith("artgen.") and not _is_language(module)


@cache
def _is_language(module: str) -> bool:
    return any(module == part or module.startswith(f"{part}.") for part in _LANGUAGE)
