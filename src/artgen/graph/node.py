"""The node: an operation on other nodes and literals, and the author's line that asked for it."""

import hashlib
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any

Literal_ = str | int | float | bool | None
"""What a node may hold beside other nodes; also lists and dictionaries of it."""

PARAMETER = "parameter"
"""The operation that stands for a value which is drawn when an asset is generated."""


@dataclass(frozen=True, eq=False)
class Node:
    """An operation on its inputs; immutable, and equal to another node if their keys are equal.

    Attributes:
        op: Name of a registered operation.
        inputs: For each input of the operation a node, a literal, or a list of them.
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
        object.__setattr__(self, "key", digest(self, lambda node: node.key))
        varies = self.op == PARAMETER or any(node.varies for node in self.children())
        object.__setattr__(self, "varies", varies)

    def children(self) -> Iterator["Node"]:
        """Yield the nodes among the inputs, in order, repeats included."""
        for value in self.inputs.values():
            yield from _nodes_in(value)


def _nodes_in(value: Any) -> Iterator[Node]:
    if isinstance(value, Node):
        yield value
    elif isinstance(value, list):
        for item in value:
            yield from _nodes_in(item)


def digest(node: Node, key_of: Any) -> str:
    """Hash a node by its operation, its literals and `key_of(child)` of its children."""
    text: list[str] = [node.op]
    for name, value in node.inputs.items():
        text.append(name)
        _spell(value, key_of, text)
    return hashlib.blake2b("\0".join(text).encode(), digest_size=12).hexdigest()


def _spell(value: Any, key_of: Any, text: list[str]) -> None:
    if isinstance(value, Node):
        text.append("$" + key_of(value))
    elif isinstance(value, list):
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


_PACKAGE = Path(__file__).resolve().parent.parent
_LANGUAGE = tuple(str(_PACKAGE / part) for part in ("graph", "nodes", "sampling", "generator.py"))
"""Code that stands between an author and the nodes: never the place to blame."""


def authors_line() -> str:
    """Return `file:line` of the innermost caller outside the language itself."""
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and frame.f_code.co_filename.startswith(_LANGUAGE):
        frame = frame.f_back
    return f"{frame.f_code.co_filename}:{frame.f_lineno}" if frame is not None else ""
