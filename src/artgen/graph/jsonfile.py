"""Graphs as JSON data: reading a graph executes no code of the file."""

import json
from collections.abc import Mapping
from typing import Any

from artgen.errors import GraphError
from artgen.graph.handle import LITERAL_TYPES, Handle, handle_of, lift_all
from artgen.graph.kernel import operation
from artgen.graph.node import PARAMETER, Node, authors_line, topological

VERSION = 1


def to_json(handle: Handle) -> str:
    """Return the graph that a handle reaches as JSON text."""
    order = topological(handle.node)
    number = {node.key: index for index, node in enumerate(order)}

    def data(value: Any) -> Any:
        if isinstance(value, Node):
            return {"$": number[value.key]}
        return [data(item) for item in value] if isinstance(value, tuple) else value

    nodes = [
        {"op": node.op, "inputs": {name: data(value) for name, value in node.inputs.items()}}
        for node in order
    ]
    lines = ",\n  ".join(json.dumps(node, ensure_ascii=False) for node in nodes)
    return f'{{"artgen_graph": {VERSION},\n "nodes": [\n  {lines}\n ]}}\n'


def from_json(text: str) -> Handle:
    """Read a graph that `to_json` wrote and return the handle of its last node."""
    given: Any = text
    if not isinstance(given, str | bytes):
        raise GraphError(f"this is not a graph file: give the text that to_json() returns, not {given!r:.60}")
    try:
        return _read_graph(json.loads(text))
    except json.JSONDecodeError as error:
        raise GraphError(f"this is not a graph file: {error}") from None
    except RecursionError:
        raise GraphError("this is not a graph file: its lists are nested too deeply") from None


def _read_graph(data: Any) -> Handle:
    if not isinstance(data, dict) or not isinstance(data.get("nodes"), list) or not data["nodes"]:
        raise GraphError("this is not a graph file: it has no list of nodes")
    if data.get("artgen_graph") != VERSION:
        raise GraphError(
            f"the graph file has version {data.get('artgen_graph')!r}; this artgen reads version {VERSION}"
        )
    handles: list[Handle] = []
    where = authors_line()
    for index, entry in enumerate(data["nodes"]):
        handles.append(_read_node(entry, index, handles, where))
    return handles[-1]


def _read_node(entry: Any, index: int, handles: list[Handle], where: str) -> Handle:
    place = f"node {index} of the graph file"
    entry = entry if isinstance(entry, dict) else {}
    name, inputs = entry.get("op"), entry.get("inputs")
    if not isinstance(name, str) or not isinstance(inputs, dict):
        raise GraphError(f"{place} must have an op and inputs")
    where = f"{where} ({place})"
    if name == PARAMETER:
        return _read_parameter(inputs, place, where)
    values = {key: _read_value(value, index, handles, place) for key, value in inputs.items()}
    try:
        known = operation(name)
        return handle_of(Node(name, lift_all(known, values), where))
    except ValueError as error:
        raise GraphError(f"{place}: {str(error).partition(chr(10))[0]}") from None


def _read_parameter(inputs: Mapping[str, Any], place: str, where: str) -> Handle:
    kinds = [handle.__name__ for handle in Handle.HANDLES.values()]
    if set(inputs) != {"name", "kind"} or not isinstance(inputs["name"], str) or inputs["kind"] not in kinds:
        raise GraphError(f"{place}: a parameter needs a name and a kind, one of {', '.join(kinds)}")
    return handle_of(Node(PARAMETER, {"name": inputs["name"], "kind": inputs["kind"]}, where))


def _read_value(value: Any, index: int, handles: list[Handle], place: str) -> Any:
    if isinstance(value, list):
        return [_read_value(item, index, handles, place) for item in value]
    if not isinstance(value, dict):
        return value
    if set(value) == {"$"}:
        target = value["$"]
        if not isinstance(target, int) or isinstance(target, bool) or target < 0:
            raise GraphError(f"{place} refers to {target!r}, which is not the number of a node")
        if target >= index:
            raise GraphError(
                f"{place} refers to node {target}, which does not come before it: the graph has a cycle"
            )
        return handles[target]
    for kind, literal in LITERAL_TYPES.items():
        if set(value) == {"$" + literal.tag}:
            try:
                return literal.decode(value["$" + literal.tag])
            except (AttributeError, TypeError, ValueError, KeyError) as error:
                raise GraphError(f"{place}: no valid {kind.__name__}: {error}") from None
    raise GraphError(f"{place} has the unknown literal {value!r}")
