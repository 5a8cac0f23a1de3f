"""The graph of a category as one HTML page, which needs no network and no other file."""

import html
import json
from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Any

from artgen.errors import RenderError
from artgen.generator import Generator
from artgen.graph_view.record import graph_record
from artgen.view.web.page import Page, filled, packed, three_js
from artgen.view.web.page import read as read_viewer

_OF_VIEWER = ("elements.js", "orbit.js", "signs.js")
_SCRIPTS = ("visible.js", "drawing.js", "geometry.js", "details.js", "main.js")
_EXPORT = "export const { layout, Graph } = dagre;"  # how dagre ends, as a module


def graph_page(
    generator: Generator,
    seed: int = 0,
    *,
    overrides: Mapping[str, Any] | None = None,
    change: Mapping[str, Any] | None = None,
    height: int = 700,
) -> Page:
    """Make the page of the node graph of a category.

    Args:
        generator: A category or generator.
        seed: Decides every draw.
        overrides: A value or a distribution by parameter name.
        change: Overrides with which the graph is evaluated a second time, from the cache of the first: the
            page then tells what had to be computed anew.
        height: Of the cell of a notebook [pixels].

    Raises:
        ParameterError: The seed, an override or a change is unknown or not allowed.
        ArtgenError: The graph cannot be built or evaluated.
        RenderError: The library that lays graphs out is not installed.
    """
    layout = dagre_js()
    data, meshes = graph_record(generator, seed, overrides or {}, change or {})
    parts = {
        "TITLE": html.escape(f"Graph of {generator.name}, seed {seed}"),
        "STYLE": _read("graph.css"),
        "THREE": packed(three_js().encode()),
        "DAGRE": packed(layout.encode()),
        "MESHES": packed(meshes),
        "DATA": packed(json.dumps(data, separators=(",", ":"), allow_nan=False).encode()),
        "SCRIPT": "\n".join([*map(read_viewer, _OF_VIEWER), *map(_read, _SCRIPTS)]),
    }
    return Page(f"{generator.name}_{seed}_graph", filled(_read("graph.html"), parts), height)


@lru_cache(maxsize=1)
def dagre_js() -> str:
    """Return dagre, which lays out layered graphs and comes with Netron: a script that defines `dagre`."""
    try:
        script = files("netron").joinpath("dagre.js").read_text(encoding="utf-8")
    except (ModuleNotFoundError, FileNotFoundError) as error:
        raise RenderError(
            "the graph is laid out by dagre, which comes with Netron: pip install 'artgen[studio]'"
        ) from error
    if _EXPORT not in script:
        raise RenderError(
            "this version of Netron has another dagre; install the one that artgen[studio] asks for"
        )
    return script.replace(_EXPORT, "")


@lru_cache(maxsize=16)
def _read(name: str) -> str:
    return files("artgen.graph_view").joinpath(name).read_text(encoding="utf-8")
