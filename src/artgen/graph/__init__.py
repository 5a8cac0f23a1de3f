"""The graph: immutable nodes, the handles that authors hold, evaluation, JSON, source and drawings."""

from artgen.graph.evaluation import Cache, Evaluation, evaluate
from artgen.graph.graph import Graph
from artgen.graph.handle import LITERAL_TYPES, Handle, LiteralType, handle_of
from artgen.graph.kernel import OPERATIONS, Operation, kernel, operation
from artgen.graph.node import Node, topological

__all__ = [
    "LITERAL_TYPES",
    "OPERATIONS",
    "Cache",
    "Evaluation",
    "Graph",
    "Handle",
    "LiteralType",
    "Node",
    "Operation",
    "evaluate",
    "handle_of",
    "kernel",
    "operation",
    "topological",
]
