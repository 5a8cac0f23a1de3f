"""The node: an operation on other nodes and literals, and the author's line that asked for it."""

import hashlib
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from types import FrameType, MappingProxyType
from typing import Any

PARAMETER = "parameter"
"""The operation that stands for a value which is drawn when an asset is generated."""


@dataclass(frozen=True, eq=False, repr=False)
class Node:
    """An operation on its inputs; immutable, and equal to another node if their keys are equal.

    Attributes:
        op: Name of a registered operation.
        inputs: For each input of the operation a node, a literal (a string, a number, a truth value, None, or
            a dictionary of JSON data), or a tuple of them; lists that are given become tuples.
        where: File and line of the author's code that made the node; no part of the key.
        key: Hash of the operation and everything below it.
        varies: Whether a parameter is among the nodes below (or is this node).
    """

    op: str
    inputs: Mapping[str, Any]
    where: str = ""
    key: str = field(init=False)
    varies: bool = field(init=False)

    def __post_init__(self) -> None:
        """Compute the key from the inputs' keys."""
        frozen = {name: _frozen(value) for name, value in self.inputs.items()}
        object.__setattr__(self, "inputs", MappingProxyType(frozen))
        object.__setattr__(self, "key", digest(self, lambda node: node.key))
        varies = self.op == PARAMETER or any(node.varies for node in self.children())
        object.__setattr__(self, "varies", varies)

    def children(self) -> Iterator["Node"]:
        """Yield the nodes among the inputs, in order, repeats included."""
        for value in self.inputs.values():
            yield from nodes_in(value)

    def __repr__(self) -> str:
        """Name the operation and its place, but not what lies below: that may be thousands of nodes."""
        return f"<node {self.op} at {self.where}>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Rebuild the node when it is pickled or copied; the key is computed again."""
        return Node, (self.op, dict(self.inputs), self.where)


def _frozen(value: Any) -> Any:
    return tuple(_frozen(item) for item in value) if isinstance(value, list | tuple) else value


def nodes_in(value: Any) -> Iterator[Node]:
    """Yield the nodes in the value of one input, in order, repeats included."""
    if isinstance(value, Node):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from nodes_in(item)


def digest(node: Node, key_of: Callable[[Node], str]) -> str:
    """Hash a node by its operation, its literals and `key_of(child)` of its children."""
    text: list[str] = [node.op]
    for name, value in node.inputs.items():
        text.append(name)
        _spell(value, key_of, text)
    return hashlib.blake2b("\0".join(text).encode(), digest_size=12).hexdigest()


def _spell(value: Any, key_of: Callable[[Node], str], text: list[str]) -> None:
    if isinstance(value, Node):
        text.append("$" + key_of(value))
    elif isinstance(value, tuple | list):  # a list only within JSON data
        text.append("[")
        for item in value:
            _spell(item, key_of, text)
        text.append("]")
    elif isinstance(value, dict):
        text.append("{")
        for name in sorted(value):
            text.append(name)
            _spell(value[name], key_of, text)
        text.append("}")
    else:
        text.append(repr(value))


def topological(root: Node) -> list[Node]:
    """Return every node that the root reaches once, inputs before the nodes that use them."""
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
            stack.extend((child, False) for child in reversed(list(node.children())))
    return order


_LANGUAGE = ("artgen.graph", "artgen.nodes", "artgen.sampling", "artgen.generator")
"""Modules that stand between an author and the nodes: never the place to blame."""


def authors_line() -> str:
    """Return `file:line` of the innermost caller outside the language itself.

    Constants that the language itself makes while it is imported are its own doing.
    """
    frame: FrameType | None = sys._getframe(1)
    inner = frame
    while frame is not None and _is_language(frame.f_globals.get("__name__", "")):
        inner, frame = frame, frame.f_back
    if frame is not None and not frame.f_code.co_filename.startswith("<frozen importlib"):
        inner = frame
    return f"{inner.f_code.co_filename}:{inner.f_lineno}" if inner is not None else ""


@cache
def _is_language(module: str) -> bool:
    return any(module == part or module.startswith(f"{part}.") for part in _LANGUAGE)
