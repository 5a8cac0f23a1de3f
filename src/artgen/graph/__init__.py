"""The graph: immutable nodes, handles for authors, evaluation, JSON, source and drawings."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from artgen.graph.draw import table, to_mermaid
from artgen.graph.evaluation import Cache, Evaluation, evaluate, reached
from artgen.graph.handle import LITERAL_TYPES, Handle, LiteralType, handle_of, records
from artgen.graph.jsonfile import from_json, to_json
from artgen.graph.kernel import (
    DETAILS,
    FULL,
    OPERATIONS,
    Detail,
    Operation,
    define,
    detail_level,
    kernel,
    operation,
)
from artgen.graph.node import PARAMETER, Node, topological
from artgen.graph.source import to_python


@dataclass(frozen=True, eq=False)
class Graph:
    """All nodes that a handle reaches.

    Attributes:
        result: Handle of the root.
    """

    result: Handle

    @property
    def key(self) -> str:
        """Hash of the content: equal graphs have equal keys."""
        return self.result.node.key

    @property
    def nodes(self) -> list[Node]:
        """Every node once, inputs before the nodes that use them."""
        return topological(self.result.node)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the parameters whose values evaluation needs, in order of appearance."""
        return tuple(node.inputs["name"] for node in self.nodes if node.op == PARAMETER)

    def evaluate(
        self, parameters: Mapping[str, Any] | None = None, cache: Cache | None = None, detail: Detail = FULL
    ) -> Evaluation:
        """Compute the value of the root; see `artgen.graph.evaluate`."""
        return evaluate(self.result, parameters, cache, detail)

    def to_json(self) -> str:
        """Return the graph as JSON text."""
        return to_json(self.result)

    @staticmethod
    def from_json(text: str) -> "Graph":
        """Read a graph from the text of `to_json`; executes no code of the text.

        Raises:
            GraphError: The text is not a valid graph.
        """
        return Graph(from_json(text))

    def to_python(self, name: str = "build") -> str:
        """Return Python source of a function that builds the graph."""
        return to_python(self.result, name)

    def to_mermaid(self) -> str:
        """Return a Mermaid flow chart."""
        return to_mermaid(self.result)

    def table(self, evaluation: Evaluation | None = None) -> str:
        """Return the nodes, with the costs of an evaluation, as a text table."""
        return table(self.result, evaluation)


__all__ = [
    "DETAILS", "FULL", "LITERAL_TYPES", "OPERATIONS", "Cache", "Detail", "Evaluation", "Graph", "Handle",
    "LiteralType", "Node", "Operation", "define", "detail_level", "evaluate", "handle_of", "kernel",
    "operation", "reached", "records", "topological",
]  # fmt: skip
