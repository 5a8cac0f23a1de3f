"""Check of colliders: simulators accept them, and they contain the solids closely."""

from collections.abc import Iterator, Sequence

import numpy as np
from manifold3d import Manifold, OpType
from scipy.spatial import ConvexHull, QhullError

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.collision import is_detail
from artgen.asset.link import MOST_COLLIDERS
from artgen.asset.report import CheckResult, Finding, Severity
from artgen.asset.shells import point_text, skins
from artgen.errors import ArtgenError, AssetError
from artgen.validate.fidelity import Fidelity, fidelity

CHECK = "colliders"

MOST_VERTICES = 64
"""Most vertices of a hull; a common limit of GPU simulators."""

STICKS_OUT = 0.05e-3
"""Largest distance of a solid outside its colliders [m]."""

STANDS_OFF = 4.0e-3
"""Largest distance between colliders and solid, as over a rounded edge, not across a hollow [m]."""

STANDS_OFF_MUCH = 1.0e-3
"""The same for colliders that add more volume than `ADDED` [m]."""

ADDED = 0.03
"""Added volume, as a share of the solid, above which colliders must follow it more closely."""

KEPT = 0.8
"""Share of the empty volume inside a link's convex hull that colliders must keep empty."""

_RIGID = 1e-9  # tolerance of a pose's axes
_INSIDE = 1e-7  # tolerance of vertices inside the hull of the others [m]


def check_colliders(asset: Asset) -> CheckResult:
    """Check the colliders of every link against its solids; for a loaded asset, against its meshes."""
    findings: list[Finding] = []
    measured: list[tuple[float, Fidelity]] = []
    for link in asset.links:
        found = [*_budget_findings(link), *_piece_findings(link)]
        findings += found
        if found:
            continue
        try:
            solid = solid_of(link)
        except ArtgenError as error:
            message = f"its colliders cannot be compared: {error}"
            findings.append(Finding(CHECK, message, link.name, severity="note"))
            continue
        if solid.is_empty():
            message = "its colliders cannot be compared: no surface of it closes"
            findings.append(Finding(CHECK, message, link.name, severity="note"))
            continue
        result = fidelity(solid, [collider.convex for collider in link.colliders])
        measured.append((solid.volume(), result))
        findings += _fidelity_findings(link, result)
    return CheckResult(CHECK, tuple(findings), _detail(asset, measured))


def solid_of(link: Link) -> Manifold:
    """Return the union of a link's solids without visual details; empty if no surface closes.

    For a link that was read from files, the closed parts of its meshes, without those that the file records
    as visual details or whose label no collider has.
    """
    if link.pieces:
        parts = [piece.shape.manifold for piece in link.pieces if not piece.visual]
    else:
        details = link.to_data().get("details")
        if details is None:
            raise AssetError(
                f"the file of link {link.name!r} does not tell which solids are only seen; export again"
            )
        covered = {collider.label for collider in link.colliders}
        parts = [
            shell.manifold
            for skin in skins(link)
            for shell in skin.solids
            if shell.label in covered and not is_detail(details, shell.label, shell.bounds)
        ]
    return Manifold.batch_boolean(parts, OpType.Add)


def _budget_findings(link: Link) -> Iterator[Finding]:
    count = len(link.colliders)
    if not count:
        yield Finding(
            CHECK, "it has no colliders", link.name, value=0.0, hint="give it a solid that is not a detail"
        )
    elif count > MOST_COLLIDERS:
        message = f"it has {count} colliders; GPU simulators take at most {MOST_COLLIDERS}"
        yield Finding(
            CHECK, message, link.name, value=float(count), hint="join small solids or make them details"
        )


def _piece_findings(link: Link) -> Iterator[Finding]:
    """Yield the colliders that a simulator would refuse or replace by their hull."""
    for number, collider in enumerate(link.colliders):
        convex = collider.convex
        name = f"collider {number} ({convex.kind} of {collider.label!r})"
        numbers = [*convex.pose.ravel(), *convex.size, *convex.points.ravel()]
        rotation = convex.pose[:3, :3]
        if not np.isfinite(numbers).all():
            message, value = f"{name} has numbers that are not finite", None
        elif np.abs(rotation @ rotation.T - np.eye(3)).max() > _RIGID or np.linalg.det(rotation) < 0.0:
            message, value = f"{name} is scaled or mirrored by its pose", float(np.linalg.det(rotation))
        elif convex.kind == "hull":
            message, value = _hull_fault(name, convex.points)
        else:
            value = float(min(convex.size))
            message = "" if value > 0.0 else f"{name} has a length of {value:.4g} m"
        if message:
            yield Finding(
                CHECK, message, link.name, value=value, hint="rebuild it from the solid's own pieces"
            )


def _hull_fault(name: str, points: Array) -> tuple[str, float | None]:
    """Return the fault of the points of a hull and its number; an empty text if there is none."""
    if not 4 <= len(points) <= MOST_VERTICES:
        return f"{name} has {len(points)} vertices; 4 to {MOST_VERTICES} are taken", float(len(points))
    try:
        hull = ConvexHull(points)
    except QhullError:
        return f"{name} is flat: its vertices lie in one plane", 0.0
    depth = -(hull.equations[:, :3] @ points.T + hull.equations[:, 3:]).max(axis=0)
    if depth.max() > _INSIDE:
        inside = float(depth.max())
        return (
            f"{name} is not convex: a vertex lies {1e3 * inside:.4g} mm inside the hull of the others",
            inside,
        )
    return "", None


def _fidelity_findings(link: Link, found: Fidelity) -> Iterator[Finding]:
    exact = _kind(link) == "exact"
    severity: Severity = "fault" if exact else "note"
    hint = (
        "make each solid of convex primitives, so that its pieces are known"
        if exact
        else "by choice of colliders"
    )
    if found.sticks_out > STICKS_OUT:
        place = point_text(found.place)
        message = f"its solid sticks out of its colliders by {1e3 * found.sticks_out:.3g} mm at {place}"
        yield Finding(
            CHECK, message, link.name, value=found.sticks_out, unit="m", hint=hint, severity=severity
        )
    allowed = STANDS_OFF if found.added <= ADDED else STANDS_OFF_MUCH
    if found.surface_error > max(allowed, found.sticks_out):
        message = (
            f"its colliders add {100.0 * found.added:.3g} % of volume and stand off the surface by "
            f"{1e3 * found.surface_error:.3g} mm at {point_text(found.surface_place)}"
        )
        yield Finding(
            CHECK, message, link.name, value=found.surface_error, unit="m", hint=hint, severity=severity
        )
    if found.interior_kept < KEPT:
        message = (
            f"its colliders leave only {100.0 * found.interior_kept:.3g} % of the space in its hollows empty"
        )
        yield Finding(CHECK, message, link.name, value=found.interior_kept, hint=hint, severity=severity)


def _kind(link: Link) -> str:
    """Return the kind of the colliders of a link."""
    known = getattr(link, "collision", None)
    return str(known or ("exact" if link.pieces else link.to_data().get("collision", "exact")))


def _detail(asset: Asset, measured: Sequence[tuple[float, Fidelity]]) -> str:
    count = sum(len(link.colliders) for link in asset.links)
    text = f"{count} colliders, {sum(found.vertices for _, found in measured)} vertices"
    total = sum(volume for volume, _ in measured)
    if not total:
        return text
    added = sum(volume * found.added for volume, found in measured) / total
    farthest = max(found.surface_error for _, found in measured)
    kept = min(found.interior_kept for _, found in measured)
    text += f", volume +{100.0 * added:.2g} %, farthest {1e3 * farthest:.2g} mm"
    return f"{text}, hollows kept {100.0 * kept:.3g} %"
