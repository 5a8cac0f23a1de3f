"""Whether each link is one piece: no part of it floats away from the others."""

from collections.abc import Iterator, Sequence

import numpy as np

from artgen._arrays import Array
from artgen.asset import Link
from artgen.asset.report import Finding
from artgen.asset.shells import Shell, point_text, skins

JOINED = 0.5e-3
"""Gap up to which two solids of a link count as joined [m]."""

_FAR = 10.0  # [m]: gaps are measured up to here


def floating_findings(link: Link) -> Iterator[Finding]:
    """Yield each group of solids of a link that is farther from the rest than `JOINED`."""
    shells = [shell for skin in skins(link) for shell in skin.solids]
    groups = _groups(shells)
    largest = max(groups, key=lambda group: sum(shells[number].volume for number in group), default=[])
    for group in groups:
        if group is largest:
            continue
        others = [number for number in range(len(shells)) if number not in set(group)]
        gap, part, other = _nearest(
            [shells[number] for number in group], [shells[number] for number in others]
        )
        center = point_text(part.bounds.mean(axis=0))
        several = f" with {len(group) - 1} more solids" if len(group) > 1 else ""
        yield Finding(
            "tree",
            f"solid {part.label!r} at {center}{several} floats {1e3 * gap:.3g} mm away from {other.label!r}",
            link.name,
            value=gap,
            unit="m",
            hint=link.separate
            or "let it overlap what carries it, make it a link of its own, or say why they "
            "are apart with part(..., separate=...)",
            severity="note" if link.separate else "fault",
        )


def _groups(shells: Sequence[Shell]) -> list[list[int]]:
    """Return the numbers of the solids that hang together."""
    count = len(shells)
    group = list(range(count))

    def leader(number: int) -> int:
        while group[number] != number:
            group[number] = group[group[number]]
            number = group[number]
        return number

    apart = _box_gaps(shells, shells)
    first, second = np.nonzero(np.triu(apart <= JOINED, 1))
    # the nearest boxes first: most of them overlap, and every pair that is joined already costs nothing
    for index in np.argsort(apart[first, second], kind="stable"):
        a, b = leader(int(first[index])), leader(int(second[index]))
        if a != b and _joined(shells[first[index]], shells[second[index]]):
            group[max(a, b)] = min(a, b)
    result: dict[int, list[int]] = {}
    for number in range(count):
        result.setdefault(leader(number), []).append(number)
    return list(result.values())


def _box_gaps(a: Sequence[Shell], b: Sequence[Shell]) -> Array:
    """Return the distance between the bounding boxes of each two solids, shape (n, m) [m]."""
    if not a or not b:
        return np.zeros((len(a), len(b)))
    first, second = (np.array([shell.bounds for shell in shells]) for shells in (a, b))
    apart = np.maximum(first[:, None, 0] - second[None, :, 1], second[None, :, 0] - first[:, None, 1])
    return np.asarray(np.linalg.norm(np.maximum(apart, 0.0), axis=2))


def _joined(a: Shell, b: Shell) -> bool:
    return bool(a.manifold.min_gap(b.manifold, 2.0 * JOINED) <= JOINED)


def _nearest(group: Sequence[Shell], others: Sequence[Shell]) -> tuple[float, Shell, Shell]:
    """Return the smallest gap between two groups of solids, and the two solids."""
    apart = _box_gaps(group, others)
    best = (_FAR, group[0], others[0])
    for index in np.argsort(apart, axis=None, kind="stable"):
        first, second = (int(number) for number in np.unravel_index(index, apart.shape))
        if apart[first, second] >= best[0]:
            break
        gap = float(group[first].manifold.min_gap(others[second].manifold, best[0]))
        if gap < best[0]:
            best = (gap, group[first], others[second])
    return best
