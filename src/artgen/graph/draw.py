"""Drawings of graphs: a Mermaid flow chart and a table."""

from collections import Counter
from collections.abc import Sequence
from typing import Any

from artgen.graph.evaluation import Evaluation
from artgen.graph.handle import Handle, handle_of
from artgen.graph.node import PARAMETER, Node, nodes_in, topological

_MERMAID_SHAPES = {"Body": ("[[", "]]"), "Solid": ("[", "]"), "Joint": ("{{", "}}")}


def to_mermaid(handle: Handle) -> str:
    """Return the graph that a handle reaches as a Mermaid flow chart."""
    order = topological(handle.node)
    number = {node.key: index for index, node in enumerate(order)}
    lines = ["flowchart TD"]
    for node in order:
        opening, closing = _MERMAID_SHAPES.get(type(handle_of(node)).__name__, ("(", ")"))
        title = str(node.inputs["name"] if node.op == PARAMETER else _title(node)).replace('"', "'")
        lines.append(f'  n{number[node.key]}{opening}"{title}"{closing}')
    for node in order:
        for name, value in node.inputs.items():
            children = dict.fromkeys(number[child.key] for child in nodes_in(value))
            lines += [f"  n{child} -- {name} --> n{number[node.key]}" for child in children]
    return "\n".join(lines) + "\n"


def table(handle: Handle, evaluation: Evaluation | None = None) -> str:
    """Return the nodes that a handle reaches as a text table, inputs before the nodes that use them."""
    order = topological(handle.node)
    number = {node.key: index for index, node in enumerate(order)}
    uses = Counter(child.key for node in order for child in node.children)
    rows = [("node", "type", "operation", "uses", "inputs", "where")]
    for node in order:
        inputs = ", ".join(f"{name}={_short(value, number)}" for name, value in node.inputs.items())
        where = node.where.rpartition("/")[2]
        kind = type(handle_of(node)).__name__
        rows.append((str(number[node.key]), kind, node.op, str(uses[node.key]), _cut(inputs, 60), where))
    text = _aligned(rows)
    if evaluation is not None:
        spent = sorted(evaluation.seconds.items(), key=lambda item: -item[1])
        costs = [("operation", "runs", "ms")]
        costs += [(name, str(evaluation.runs[name]), f"{1e3 * seconds:.3f}") for name, seconds in spent]
        text += "\n" + _aligned(costs)
    return text


def _title(node: Node) -> str:
    name = node.inputs.get("label") or node.inputs.get("name")
    return f"{node.op} {name}" if isinstance(name, str) else node.op


def _short(value: Any, number: dict[str, int]) -> str:
    if isinstance(value, Node):
        return f"#{number[value.key]}"
    if isinstance(value, tuple):
        return f"[{', '.join(_short(item, number) for item in value)}]"
    if isinstance(value, dict):
        return str(next(iter(value))).removeprefix("$")
    return f"{value:.6g}" if isinstance(value, float) else repr(value)


def _cut(text: str, longest: int) -> str:
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _aligned(rows: Sequence[tuple[str, ...]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() + "\n"
        for row in rows
    )
