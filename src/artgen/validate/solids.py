"""Check of solids: closed surfaces, orientation, slivers, duplicates, gaps, and weights of the materials."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import groupby

import numpy as np
from manifold3d import Manifold, OpType
from scipy.cluster.hierarchy import DisjointSet
from scipy.spatial import cKDTree

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.collision import link_parts
from artgen.asset.manifolds import box_gaps, touching
from artgen.asset.report import AGAIN, CheckResult, Finding, Severity
from artgen.asset.shells import LinkShells, Shell, point_text, skins, winding_number
from artgen.errors import ArtgenError

CHECK = "solids"

THINNEST = 0.05e-3
"""Mean thickness below which a solid is a sliver [m]."""

SMALLEST = 1e-11
"""Volume below which a solid is a sliver [m^3]."""

_FAR = 10.0  # largest measured gap [m]
_MANY_FLAT = 0.25  # share of flat triangles that clean booleans never exceed
_SAME_PLACE = 1e-6  # distance between the centers of possible duplicates [m]
_SAME_VOLUME = 1e-3  # relative volume difference of duplicates
_INSIDE = 0.5  # winding number around a point: 1 inside, 0 outside
_ROUNDING = 1e-3  # relative tolerance; meshes in files are rounded to 0.1 micrometre
_FORMATS = "urdf or mjcf among the formats"
# faults of a surface by the field that counts them: message and remedy
_FLAWS = {
    "doubled": (
        "has {} triangles that lie on others of the same winding, {at}",
        "remove a second copy of a solid; unite overlapping solids with | if they have faces in one plane",
    ),
    "open_edges": (
        "is not closed: {} edges have a face on one side only, {at}",
        "close the surface, or export the asset again",
    ),
    "turned_edges": (
        "has {} edges whose faces are wound against each other, {at}",
        "wind all triangles counter-clockwise from outside",
    ),
    "against": (
        "has {} triangles that lean away from their normals, {at}",
        "a corner was moved or a winding turned; a face stands within 60 degrees of the mean of its normals",
    ),
    "flat": ("has {} triangles without area of {triangles}", "cut it with fewer coplanar faces"),
}

_fault = partial(Finding, CHECK)


def check_solids(asset: Asset) -> CheckResult:
    """Check the solids of every link, or its visible meshes if it was read from files."""
    findings: list[Finding] = []
    solids = triangles = absent = 0
    for link in asset.links:
        try:
            found = skins(link)
        except ArtgenError as error:
            absent += isinstance(error.__context__, FileNotFoundError)
            message = f"its meshes cannot be read: {error}"
            findings.append(_fault(message, link.name, hint=f"{AGAIN} with {_FORMATS}"))
            continue
        wrong = list(_link_findings(link, found))
        if not wrong:
            # labels whose meshes do not close, which the check of colliders reports
            with suppress(ArtgenError):
                wrong = list(_weight_findings(link))
        findings += wrong
        solids += sum(len(skin.shells) for skin in found)
        triangles += sum(skin.triangles for skin in found)
    if absent == len(asset.links):
        return CheckResult(CHECK, skipped=f"no mesh files; export it with {_FORMATS}")
    detail = f"{len(asset.links)} links, {solids} solids, {triangles} triangles"
    return CheckResult(CHECK, tuple(findings), detail)


def _link_findings(link: Link, found: Sequence[LinkShells]) -> Iterator[Finding]:
    """Yield the faults of the surfaces of a link."""
    if not found and not link.absent:
        yield _fault("it has no surface", link.name, hint="give the link a solid")
    for skin in found:
        yield from _surface_findings(link, skin)
    shells = [shell for skin in found if skin.closed for shell in skin.shells]
    for _, group in groupby(shells, key=lambda shell: shell.piece):
        yield from _orientation_findings(link, list(group))
    for shell in shells:
        name = f"solid {shell.label!r} at {point_text(shell.bounds.mean(axis=0))}"
        if shell.thickness < THINNEST:
            message = f"{name} is a sliver, {1e3 * shell.thickness:.4g} mm thick on average"
            hint = f"let solids overlap or keep apart, not graze; at least {1e3 * THINNEST:g} mm"
            yield _fault(message, link.name, value=shell.thickness, unit="m", hint=hint)
        elif abs(shell.volume) < SMALLEST:
            message = f"{name} is a particle of {1e9 * shell.volume:.4g} mm^3"
            hint = f"cut deeper or leave it out; at least {1e9 * SMALLEST:g} mm^3"
            yield _fault(message, link.name, value=shell.volume, unit="m^3", hint=hint)
    yield from _duplicate_findings(link, shells)


def _surface_findings(link: Link, skin: LinkShells) -> Iterator[Finding]:
    name = f"solid {skin.label!r}" if skin.label else "its mesh"
    at = f"first at {point_text(skin.place)}"
    if not skin.finite or not skin.triangles:
        message, hint = "has coordinates that are not finite", "look for a division by 0 in its measures"
        if skin.finite:
            message, hint = "has no triangles", "the boolean left nothing of it"
        yield _fault(f"{name} {message}", link.name, hint=hint)
        return
    for field, (message, hint) in _FLAWS.items():
        count = getattr(skin, field)
        if count > (_MANY_FLAT * skin.triangles if field == "flat" else 0):
            text = message.format(count, at=at, triangles=skin.triangles)
            yield _fault(f"{name} {text}", link.name, value=float(count), hint=hint)
            if field == "doubled":
                return  # edges are counted without the second triangles


def _orientation_findings(link: Link, shells: Sequence[Shell]) -> Iterator[Finding]:
    """Yield inverted shells, except for the walls of hollows."""
    for shell in shells:
        if shell.volume > 0.0 or not shell.area:
            continue
        around = sum(winding_number(other.corners, shell.points[0]) for other in shells if other is not shell)
        if around < _INSIDE:
            message = (
                f"solid {shell.label!r} at {point_text(shell.center)} is turned inside out: "
                f"its volume is {1e6 * shell.volume:.4g} cm^3"
            )
            hint = "wind its triangles counter-clockwise seen from outside"
            yield _fault(message, link.name, value=shell.volume, unit="m^3", hint=hint)


def _duplicate_findings(link: Link, shells: Sequence[Shell]) -> Iterator[Finding]:
    solid = [shell for shell in shells if shell.volume > SMALLEST]
    if len(solid) < 2:
        return
    pairs = cKDTree(np.array([shell.center for shell in solid])).query_pairs(_SAME_PLACE)
    for first, second in sorted(pairs):
        a, b = solid[first], solid[second]
        if abs(a.volume - b.volume) > _SAME_VOLUME * a.volume:
            continue
        difference = (a.manifold - b.manifold).volume() + (b.manifold - a.manifold).volume()
        if difference <= _SAME_VOLUME * a.volume:
            names = f"{a.label!r}" if a.label == b.label else f"{a.label!r} and {b.label!r}"
            message = f"solid {names} at {point_text(a.center)} exists twice, {1e6 * a.volume:.4g} cm^3 each"
            yield _fault(message, link.name, value=a.volume, unit="m^3", hint="weld it once")


def _weight_findings(link: Link) -> Iterator[Finding]:
    """Yield a mass outside the range of the densities of the link's materials."""
    parts = link_parts(link)
    if not parts:
        return
    volume = Manifold.batch_boolean([part.solid for part in parts], OpType.Add).volume()
    labels = {part.label for part in parts}
    densities = {part.material.density for part in parts}
    densities |= {surface.material.density for surface in link.surfaces if surface.label in labels}
    least, most = min(densities) * volume, max(densities) * volume
    mass = link.mass_properties.mass
    if not least * (1.0 - _ROUNDING) <= mass <= most * (1.0 + _ROUNDING):
        span = f"{least:.5g}" if least == most else f"{least:.5g} to {most:.5g}"
        message = f"its mass is {mass:.5g} kg, but its solids of {1e6 * volume:.5g} cm^3 weigh {span} kg"
        yield _fault(message, link.name, value=mass, unit="kg", hint=AGAIN)


def floating_findings(link: Link) -> Iterator[Finding]:
    """Yield each group of solids of a link that is farther from the rest than `JOINED`."""
    shells = [shell for skin in skins(link) for shell in skin.solids]
    groups = _groups(shells)
    largest = max(groups, key=lambda group: sum(shell.volume for shell in group), default=[])
    for group in groups:
        if group is largest:
            continue
        gap, part, other = _nearest(group, [shell for each in groups if each is not group for shell in each])
        center = point_text(part.bounds.mean(axis=0))
        several = f" with {len(group) - 1} more solids" if len(group) > 1 else ""
        message = (
            f"solid {part.label!r} at {center}{several} floats {1e3 * gap:.3g} mm away from {other.label!r}"
        )
        hint = link.separate or (
            "let it overlap what carries it, make it a link of its own, or say why they "
            "are apart with part(..., separate=...)"
        )
        severity: Severity = "note" if link.separate else "fault"
        yield Finding("tree", message, link.name, value=gap, unit="m", hint=hint, severity=severity)


def _groups(shells: Sequence[Shell]) -> list[list[Shell]]:
    """Return the groups of connected solids."""
    groups = DisjointSet(range(len(shells)))
    for a, b in touching([shell.manifold for shell in shells], _boxes(shells)):
        groups.merge(a, b)
    return [[shells[number] for number in sorted(group)] for group in groups.subsets()]


def _boxes(shells: Sequence[Shell]) -> Array:
    return np.array([shell.bounds for shell in shells]).reshape(-1, 2, 3)


def _nearest(group: Sequence[Shell], others: Sequence[Shell]) -> tuple[float, Shell, Shell]:
    """Return the smallest gap between two groups of solids, and the two solids."""
    apart = box_gaps(_boxes(group), _boxes(others))
    best = (_FAR, group[0], others[0])
    for index in np.argsort(apart, axis=None, kind="stable"):
        first, second = (int(number) for number in np.unravel_index(index, apart.shape))
        if apart[first, second] >= best[0]:
            break
        gap = float(group[first].manifold.min_gap(others[second].manifold, best[0]))
        if gap < best[0]:
            best = (gap, group[first], others[second])
    return best
