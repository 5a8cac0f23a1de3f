"""The node graph of a category as a web page: value, time, cache state and geometry of every node."""

from collections import Counter
from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Any

from artgen.errors import RenderError
from artgen.generator import Generator
from artgen.graph import Cache, Evaluation, Graph
from artgen.graph.handle import handle_of
from artgen.graph.node import PARAMETER, Node
from artgen.graph_view.nodes import Authors, Geometry, input_text, value_text
from artgen.view.page import Page, page_html, three_js

__all__ = ["graph_page"]

_ABSENT = object()
_ALL = 10**7  # most values in the cache: unlimited


def graph_record(
    generator: Generator, seed: int, overrides: Mapping[str, Any], change: Mapping[str, Any]
) -> tuple[dict[str, Any], bytes]:
    """Evaluate the graph of a generator; return the data of its page, and the meshes as bytes."""
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
    geometry, authors = Geometry(), Authors()
    records = []
    for node in nodes:
        declared = node.op == PARAMETER
        value = shown[node.inputs["name"]] if declared else cache.get(evaluation.keys[node.key], _ABSENT)
        given = node.inputs.get("label") or node.inputs.get("name")
        inputs = [[name, input_text(value, number)] for name, value in node.inputs.items()]
        if declared:
            inputs = [["drawn from", [distributions[_declared(node.inputs["name"], values)]]]]
        record = {
            "op": node.op,
            "type": type(handle_of(node)).__name__,
            "name": given if isinstance(given, str) else "",
            **authors.describe(node),
            "inputs": inputs,
            "from": list(dict.fromkeys(number[child.key] for child in node.children)),
            **_outcome(node, value, evaluation, geometry),
            "uses": uses[node.key],
        }
        records.append(record)
    data = {
        "name": generator.name,
        "seed": seed,
        "change": {name: repr(value) for name, value in change.items()},
        "nodes": records,
        "meshes": geometry.meshes,
        "items": geometry.items,
    }
    return data, bytes(geometry.blob)


def _declared(name: str, values: Mapping[str, Any]) -> str:
    """Return the declared name of a parameter: `leaf.panelled.stile` for the drawn name `leaf.stile`."""
    chooser, _, last = name.rpartition(".")
    return f"{_declared(chooser, values)}.{values[chooser].name}.{last}" if chooser else name


def _outcome(node: Node, value: Any, evaluation: Evaluation, geometry: Geometry) -> dict[str, Any]:
    """Return the value of a node, its cost, and its geometry."""
    if value is _ABSENT:  # in the other branch of a switch
        return {"state": "unused", "value": "", "ms": 0.0, "shape": []}
    seconds = evaluation.node_seconds.get(node.key)
    ran = "cached" if seconds is None else "computed"
    return {
        "state": "given" if node.op == PARAMETER else ran,
        "value": value_text(value),
        "ms": round(1e3 * (seconds or 0.0), 4),
        "shape": geometry.add(value),
    }


_SCRIPTS = (
    *(f"view/web/{name}.js" for name in ("elements", "orbit", "symbols")),
    *(f"graph_view/{name}.js" for name in ("visible", "drawing", "geometry", "details", "main")),
)
_EXPORT = "export const { layout, Graph } = dagre;"  # end of dagre as a module


def graph_page(
    generator: Generator,
    seed: int = 0,
    *,
    overrides: Mapping[str, Any] | None = None,
    change: Mapping[str, Any] | None = None,
) -> Page:
    """Make the page of the node graph of a category.

    Args:
        generator: A category or generator.
        seed: Seed of all draws.
        overrides: A value or a distribution by parameter name.
        change: Overrides of a second evaluation with the cache of the first: the page then shows which nodes
            were computed again.

    Raises:
        ParameterError: The seed, an override or a change is unknown or not allowed.
        ArtgenError: The graph cannot be built or evaluated.
        RenderError: The library for graph layout is not installed.
    """
    layout = dagre_js()
    data, meshes = graph_record(generator, seed, overrides or {}, change or {})
    title = f"Graph of {generator.name}, seed {seed}"
    text = page_html("graph_view/graph", title, _SCRIPTS, data, three=three_js(), dagre=layout, meshes=meshes)
    return Page(f"{generator.name}_{seed}_graph", text, height=700)


@lru_cache(maxsize=1)
def dagre_js() -> bytes:
    """Return dagre, which lays out layered graphs, from Netron: a script that defines `dagre`."""
    try:
        script = files("netron").joinpath("dagre.js").read_text(encoding="utf-8")
    except (ModuleNotFoundError, FileNotFoundError) as error:
        raise RenderError(
            "the graph is laid out by dagre, which comes with Netron: pip install 'artgen[studio]'"
        ) from error
    if _EXPORT not in script:
        raise RenderError(
            "this version of Netron has another dagre; install the version that artgen[studio] requires"
        )
    return script.replace(_EXPORT, "").encode()
