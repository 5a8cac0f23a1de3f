"""What the page of a graph shows: every node with its value, time, state, place and geometry."""

from collections import Counter
from collections.abc import Mapping
from typing import Any

from artgen.generator import Generator
from artgen.graph import Cache, Evaluation, Graph
from artgen.graph.handle import handle_of
from artgen.graph.node import PARAMETER, Node
from artgen.graph_view.authors import Authors
from artgen.graph_view.geometry import Gallery
from artgen.graph_view.spelled import input_text, value_text

_ABSENT = object()
_ALL = 10**7  # values: a cache that forgets nothing


def graph_record(
    generator: Generator, seed: int, overrides: Mapping[str, Any], change: Mapping[str, Any]
) -> tuple[dict[str, Any], bytes]:
    """Evaluate a graph and return the data of its page, and the meshes."""
    asset, _ = generator.evaluate(seed, cache=Cache(), certify=False, overrides=overrides)
    cache = Cache(_ALL)
    values = generator.sample(seed, attempt=asset.attempt, overrides=overrides)
    graph = Graph(generator.build(values))
    evaluation = graph.evaluate(values, cache)
    if change:
        values = generator.sample(seed, attempt=asset.attempt, overrides={**overrides, **change})
        graph = Graph(generator.build(values))
        evaluation = graph.evaluate(values, cache)
    nodes = graph.nodes
    number = {node.key: index for index, node in enumerate(nodes)}
    uses = Counter(child.key for node in nodes for child in dict.fromkeys(node.children))
    shown = {key: getattr(value, "name", value) for key, value in values.items()}
    distributions = {name: repr(each.distribution) for name, each in generator.parameters().items()}
    gallery, authors = Gallery(), Authors()
    records = []
    for node in nodes:
        value = shown[node.inputs["name"]] if node.op == PARAMETER else _value(node, evaluation, cache)
        record = _described(node, number, authors) | _outcome(node, value, evaluation, gallery)
        record["uses"] = uses[node.key]
        if node.op == PARAMETER:
            declared = distributions[_declared(node.inputs["name"], values)]
            record["inputs"] = [["drawn from", [declared]]]
        records.append(record)
    data = {
        "name": generator.name,
        "seed": seed,
        "change": {name: repr(value) for name, value in change.items()},
        "nodes": records,
        "meshes": gallery.meshes,
        "items": gallery.items,
    }
    return data, gallery.blob


def _declared(name: str, values: Mapping[str, Any]) -> str:
    """Return the name by which a category declares what is drawn as `leaf.stile`: `leaf.panelled.stile`."""
    chooser, _, last = name.rpartition(".")
    return f"{_declared(chooser, values)}.{values[chooser].name}.{last}" if chooser else name


def _value(node: Node, evaluation: Evaluation, cache: Cache) -> Any:
    return cache.get(evaluation.keys[node.key], _ABSENT)


def _described(node: Node, number: Mapping[str, int], authors: Authors) -> dict[str, Any]:
    """Say what a node is, and who made it."""
    where, source = authors.line_of(node)
    given = node.inputs.get("label") or node.inputs.get("name")
    return {
        "op": node.op,
        "type": type(handle_of(node)).__name__,
        "name": given if isinstance(given, str) else "",
        "group": authors.group_of(node),
        "where": where,
        "source": source,
        "inputs": [[name, input_text(value, number)] for name, value in node.inputs.items()],
        "from": list(dict.fromkeys(number[child.key] for child in node.children)),
    }


def _outcome(node: Node, value: Any, evaluation: Evaluation, gallery: Gallery) -> dict[str, Any]:
    """Say what a node gave, what that took, and how it looks."""
    if value is _ABSENT:  # the other branch of a switch
        return {"state": "unused", "value": "", "ms": 0.0, "shape": []}
    seconds = evaluation.node_seconds.get(node.key)
    ran = "cached" if seconds is None else "computed"
    return {
        "state": "given" if node.op == PARAMETER else ran,
        "value": value_text(value),
        "ms": round(1e3 * (seconds or 0.0), 4),
        "shape": gallery.add(value),
    }
