"""The proof as data: which plane keeps which pieces apart in which cell of joint space."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from artgen.asset.certificate import PROOF_FORMAT
from artgen.proof.items import Items
from artgen.proof.results import Judged


def leaves_data(proven: Sequence[Judged]) -> dict[str, Any]:
    """Return what was proven as JSON data.

    `links` has for each kind of pieces and each link the order in which leaves count its pieces, and, where
    they are no colliders, the pieces themselves. Each leaf of a pair is one row: the range of pieces of the
    first link and that of the second (first, last + 1), the frame (-2 for heights and distances about the
    common axis), the normal and the lowest and highest position of each joint.
    """
    sets: list[dict[str, Any]] = []
    pairs: list[dict[str, Any]] = []
    known: dict[int, int] = {}
    ordered: list[dict[int, Items]] = []
    for judged in proven:
        key = id(judged.nodes)
        if key not in known:
            known[key] = len(sets)
            sets.append(_pieces(judged))
            ordered.append(_by_way(judged.leaves))
        rows = _rows(judged, ordered[known[key]].get(judged.number))
        pairs.append({"links": list(judged.way.links), "pieces": known[key], "leaves": rows})
    return {"format": PROOF_FORMAT, "pieces": sets, "pairs": pairs}


def _by_way(leaves: Sequence[Items]) -> dict[int, Items]:
    """Return the leaves of each way of a search, in the order in which it closed them."""
    if not leaves:
        return {}
    joined = Items.join(leaves)
    joined = joined[np.argsort(joined.way, kind="stable")]
    ways, first = np.unique(joined.way, return_index=True)
    ends = [*first[1:].tolist(), len(joined)]
    return {
        int(way): joined[np.arange(start, end)]
        for way, start, end in zip(ways, first.tolist(), ends, strict=True)
    }


def _pieces(judged: Judged) -> dict[str, Any]:
    result = {}
    for number, (name, cover) in enumerate(judged.covers.items()):
        points = None if cover.colliders else [each.tolist() for each in cover.points]
        result[name] = {
            "order": list(judged.nodes.orders[number]),
            "excess": cover.excess,
            "points": points,
            "labels": None if cover.colliders else list(cover.labels),
        }
    return result


def _rows(judged: Judged, items: Items | None) -> list[list[float]]:
    if items is None:
        return []
    nodes, count = judged.nodes, len(judged.way.variables)
    whole = np.column_stack(
        (
            nodes.first[items.first],
            nodes.last[items.first],
            nodes.first[items.second],
            nodes.last[items.second],
            items.frame,
        )
    ).tolist()
    cells = np.stack((items.low[:, :count], items.high[:, :count]), axis=2).reshape(len(items), -1)
    real = np.column_stack((items.normal, cells)).tolist()
    return [[*integers, *numbers] for integers, numbers in zip(whole, real, strict=True)]
