"""Check of colliders: simulators accept them, and they represent the solids closely; comparison of kinds."""

import math
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from manifold3d import Manifold, OpType

from artgen._arrays import Array, distinct_rows
from artgen.asset import Asset, Link
from artgen.asset.collision import (
    COLLISIONS,
    collision_of,
    is_detail,
    link_parts,
    made_colliders,
    replace_colliders,
)
from artgen.asset.link import MOST_COLLIDERS
from artgen.asset.record import significant
from artgen.asset.report import CheckResult, Finding
from artgen.asset.shells import TriangleSet, point_text, skins
from artgen.colliders import Convex
from artgen.colliders.openings import BALL
from artgen.colliders.polytope import Polytope
from artgen.colliders.triangles import hull_of
from artgen.errors import ArtgenError, AssetError
from artgen.export.mjcf import write_mjcf
from artgen.proof.fewer import fewer_colliders
from artgen.validate.readback.reading import MOST_VERTICES, dent

CHECK = "colliders"

STICKS_OUT = 0.05e-3
"""Largest distance of a solid outside its colliders [m]."""

STANDS_OFF = {"full": 4.0e-3, "medium": 5.0e-3, "low": math.inf}
"""Largest distance between colliders and solid at each level of detail, as over a rounded edge, not across a
hollow [m]. Facets of low detail leave out more of a round solid than a collider may add."""

STANDS_OFF_MUCH = {"full": 1.0e-3, "medium": 3.0e-3, "low": math.inf}
"""The same for colliders that add more volume than `ADDED` [m]."""

ADDED = 0.03
"""Added volume, as a share of the solid, above which colliders must follow it more closely."""

KEPT = {"full": 0.8, "medium": 0.75, "low": 0.7}
"""Share of the empty volume inside a link's convex hull that colliders must keep empty."""

FACETS = {"full": 0.2e-3, "medium": 0.5e-3, "low": 0.8e-3}
"""Largest distance of facets from round surfaces at each level of detail [m]."""

_FINE = 2.0e-5  # tolerance of the facets of round pieces [m]
_SPREAD = 300  # points on the surfaces of a difference, in addition to its corners
_DOUBTED = 1.0e-5  # tolerance of points of a difference on the solids [m]
_EMPTY = 0.03  # share of a hull's volume; smaller differences are rounded edges, not empty space
_SETTLE = 1.0  # simulated time before the speed is measured [s]
_TIMED = 0.3  # least measured wall-clock time [s]
_BATCH = 50  # steps between two readings of the clock
_DIGITS = 6  # significant digits of numbers in the data
_RIGID = 1e-9  # tolerance of a pose's axes
_INSIDE = 1e-7  # tolerance of vertices inside the hull of the others [m]


_REMEDY_OF_COVERS = "enlarge a cover of bounding_collider(solid, ...) there or add one"
_REMEDY = (
    "make each solid of convex primitives, so that its pieces are known; a part that may collide coarsely "
    "says so with bounding_collider(solid, box(...)) or bounding_collider(solid, hull(solid))"
)

_fault = partial(Finding, CHECK)


@dataclass(frozen=True)
class Fidelity:
    """Differences between convex pieces and their solid."""

    volume_error: float  # volume that only one of them has, as a share of the solid's
    # largest distance between the surfaces of pieces and solid, measured at corners and at several hundred
    # points between them [m]
    surface_error: float
    # share of the empty volume inside the solid's convex hull that the pieces leave empty
    interior_kept: float
    pieces: int  # number of pieces
    vertices: int  # number of their corners; a round piece has none
    added: float = 0.0  # volume that the pieces add, as a share of the solid's
    sticks_out: float = 0.0  # largest distance of the solid outside the pieces [m]
    place: tuple[float, ...] = (0.0, 0.0, 0.0)  # place of that distance [m]
    surface_place: tuple[float, ...] = (0.0, 0.0, 0.0)  # place of the largest difference of the surfaces [m]


def check_colliders(asset: Asset) -> CheckResult:
    """Check the colliders of every link against its solids; for a loaded asset, against its meshes."""
    findings: list[Finding] = []
    measured: list[tuple[float, Fidelity]] = []
    for link in asset.links:
        found = list(_piece_findings(link))
        findings += found
        if found or link.absent:
            continue
        try:
            solid = _solid_of(link)
        except ArtgenError as error:
            message = f"its colliders cannot be compared: {error}"
            findings.append(_fault(message, link.name, severity="note"))
            continue
        convexes = [collider.convex for collider in link.colliders]
        result = fidelity(solid, convexes, link.covers, FACETS[asset.detail])
        measured.append((solid.volume(), result))
        findings += _fidelity_findings(link, result, asset.detail)
    return CheckResult(CHECK, tuple(findings), _detail(asset, measured))


def _solid_of(link: Link) -> Manifold:
    """Return the union of a link's solids without visual details."""
    # read from files: the closed parts of meshes that are no visual details and whose label has a collider
    if link.pieces:
        parts = [piece.shape.manifold for piece in link.pieces if not piece.visual]
    else:
        details = link.to_data().get("details")
        if details is None:
            raise AssetError(
                f"the file of link {link.name!r} does not tell which solids are only seen; export again"
            )
        covered = {label for each in link.colliders for label in (each.label, *each.joined)}
        parts = [
            shell.manifold
            for skin in skins(link)
            for shell in skin.solids
            if shell.label in covered and not is_detail(details, shell.label, shell.bounds)
        ]
    solid = Manifold.batch_boolean(parts, OpType.Add)
    if solid.is_empty():
        raise AssetError("no surface of it closes")
    return solid


def _piece_findings(link: Link) -> Iterator[Finding]:
    """Yield a wrong number of colliders, and those that a simulator would refuse or replace by their hull."""
    count = sum(not collider.spare for collider in link.colliders)
    if not link.colliders:
        hint = "give it a solid that is not a detail"
        yield _fault("it has no colliders", link.name, value=0.0, hint=hint)
    elif count > MOST_COLLIDERS:
        message = f"it has {count} colliders; GPU simulators take at most {MOST_COLLIDERS}"
        hint = "join small solids or make them details"
        yield _fault(message, link.name, value=float(count), hint=hint)
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
            hint = "rebuild it from the solid's own pieces"
            yield _fault(message, link.name, value=value, hint=hint)


def _hull_fault(name: str, points: Array) -> tuple[str, float | None]:
    """Return the fault of the points of a hull and its number; an empty text if there is none."""
    if not 4 <= len(points) <= MOST_VERTICES:
        return f"{name} has {len(points)} vertices; 4 to {MOST_VERTICES} are taken", float(len(points))
    depth = dent(points)
    if depth is None:
        return f"{name} is flat: its vertices lie in one plane", 0.0
    if depth > _INSIDE:
        inside = f"{1e3 * depth:.4g} mm inside the hull of the others"
        return f"{name} is not convex: a vertex lies {inside}", depth
    return "", None


def _fidelity_findings(link: Link, found: Fidelity, detail: str) -> Iterator[Finding]:
    # known only for a link in memory, or in the data of a file
    kind = getattr(link, "collision", None) or ("exact" if link.pieces else link.to_data().get("collision"))
    fault = partial(_fault, link=link.name, hint="by choice of colliders", severity="note")
    if kind in (None, "exact"):
        fault = partial(_fault, link=link.name, hint=_REMEDY_OF_COVERS if link.covers else _REMEDY)
    if found.sticks_out > STICKS_OUT:
        place = point_text(found.place)
        message = f"its solid sticks out of its colliders by {1e3 * found.sticks_out:.3g} mm at {place}"
        yield fault(message, value=found.sticks_out, unit="m")
    allowed = (STANDS_OFF if found.added <= ADDED else STANDS_OFF_MUCH)[detail]
    much = "" if found.added <= ADDED else f" where more than {100.0 * ADDED:.3g} % of volume is added"
    if found.surface_error > max(allowed, found.sticks_out):
        message = (
            f"its colliders add {100.0 * found.added:.3g} % of volume and stand off the surface by "
            f"{1e3 * found.surface_error:.3g} mm at {point_text(found.surface_place)}; "
            f"at most {1e3 * allowed:.3g} mm is allowed{much}"
        )
        yield fault(message, value=found.surface_error, unit="m")
    if found.interior_kept < KEPT[detail]:
        share = f"{100.0 * found.interior_kept:.3g} %"
        message = f"its colliders leave only {share} of the space in its hollows empty"
        yield fault(message, value=found.interior_kept)


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
    coarse = sum(bool(link.covers) for link in asset.links)
    text += f", hollows kept {100.0 * kept:.3g} %"
    return f"{text}, coarse covers on {coarse} links" if coarse else text


def fidelity(
    solid: Manifold, convexes: Sequence[Convex], covers: Sequence[Convex] = (), facets: float = FACETS["full"]
) -> Fidelity:
    """Compare convex pieces with their solid.

    Args:
        solid: The solid.
        convexes: The pieces.
        covers: Places where they may stand off from it.
        facets: Largest distance of the facets of the solid from round surfaces; what is empty between both is
            no hollow [m].
    """
    polytopes = [convex.outer_polytope(_FINE) for convex in convexes]
    cover = Manifold.batch_boolean([hull_of(polytope.points) for polytope in polytopes], OpType.Add)
    missing, faces = solid - cover, TriangleSet.of(solid)
    outside, place = _sticking_out(missing, polytopes, faces)
    if covers:
        solid = Manifold.batch_boolean([solid, *(each.manifold(_FINE) for each in covers)], OpType.Add)
        faces = TriangleSet.of(solid)
    excess, volume, hull = cover - solid, solid.volume(), solid.hull()
    error, surface_place = outside, place
    if not excess.is_empty():
        # films along shared faces exceed the solid by rounding only
        points = TriangleSet.of(excess).spread(_SPREAD)
        points = points[_outside(polytopes, points) < _DOUBTED]
        apart, at = faces.farthest(points, outside=True) if len(points) else (0.0, place)
        if apart > error:
            error, surface_place = apart, at
    empty = hull.volume() - volume
    kept = hull.volume() - (hull ^ cover).volume() - missing.volume()  # `hull - cover` may lose a part
    if _EMPTY * hull.volume() < empty and kept < KEPT["full"] * empty:
        kept += _between_facets(excess ^ hull, faces, facets)
    return Fidelity(
        volume_error=(excess.volume() + missing.volume()) / volume,
        surface_error=error,
        interior_kept=min(max(kept / empty, 0.0), 1.0) if empty > _EMPTY * hull.volume() else 1.0,
        pieces=len(convexes),
        vertices=sum(len(convex.faces.points) for convex in convexes if convex.kind in {"box", "hull"}),
        added=excess.volume() / volume,
        sticks_out=outside,
        place=tuple(place.tolist()),
        surface_place=tuple(surface_place.tolist()),
    )


def _between_facets(excess: Manifold, faces: TriangleSet, facets: float) -> float:
    """Return the volume of the thin parts of an excess that stay within the facets of a solid."""
    thin = (part for part in excess.decompose() if 2.0 * part.volume() <= facets * part.surface_area())
    spread = ((part.volume(), TriangleSet.of(part).spread(_SPREAD)) for part in thin)
    return math.fsum(volume for volume, points in spread if faces.farthest(points, outside=True)[0] <= facets)


def _sticking_out(
    missing: Manifold, polytopes: Sequence[Polytope], faces: TriangleSet
) -> tuple[float, Array]:
    """Return the largest distance of a solid outside its pieces, and its place."""
    # distances are along face normals; films between pieces with a common face do not count
    if missing.is_empty():
        return 0.0, np.zeros(3)
    points, _, _ = distinct_rows(np.round(TriangleSet.of(missing).spread(_SPREAD), 8))
    outside = _outside(polytopes, points)
    worst = int(np.argmax(outside))
    # where many faces coincide, manifold3d may add volume to a difference that is in neither solid
    while outside[worst] > _DOUBTED and faces.farthest(points[[worst]], outside=True)[0] > _DOUBTED:
        outside[worst] = 0.0
        worst = int(np.argmax(outside))
    return max(float(outside[worst]), 0.0), points[worst]


def _outside(polytopes: Sequence[Polytope], points: Array) -> Array:
    """Return the height of points above the faces of the nearest polytope, shape (n,) [m]."""
    outside = np.full(len(points), np.inf)
    for polytope in polytopes:
        near = np.flatnonzero(_least_height(polytope, points) < outside)
        if len(near):
            height = (polytope.planes[:, :3] @ points[near].T - polytope.planes[:, 3:]).max(axis=0)
            outside[near] = np.minimum(outside[near], height)
    return outside


def _least_height(polytope: Polytope, points: Array) -> Array:
    """Return a lower bound of the height above faces for points outside a polytope, shape (n,) [m]."""
    # a ray from the center leaves through a face no nearer than the inscribed ball; at most 0 inside
    middle = polytope.points.mean(axis=0)
    within = (polytope.planes[:, 3] - polytope.planes[:, :3] @ middle).min()
    around = np.linalg.norm(polytope.points - middle, axis=1).max()
    return np.asarray(within * (np.linalg.norm(points - middle, axis=1) / around - 1.0))


def compare_colliders(
    asset: Asset, budgets: Sequence[int] = (), openings: float = BALL, *, speed: bool = True
) -> list[dict[str, Any]]:
    """Compare the colliders of an asset with CoACD's and with plain convex hulls, or with fewer of its own.

    They are compared with the solids, or for an asset that was read from files with the closed parts of its
    visible meshes. Exact colliders are known at construction only, so they are compared only if the asset has
    them.

    Args:
        asset: The asset.
        budgets: Numbers of colliders for `Asset.with_colliders`, instead of CoACD and hulls. For numbers
            below the fewest that were found, these are compared, of the kind `fewest`.
        openings: Width of the openings that fewer colliders leave open [m].
        speed: Whether to measure the speed of MuJoCo.

    Returns:
        JSON data for each kind of colliders: the `kind`, whether the asset has them (`stored`), the numbers
        of `Fidelity` for the asset and for each of its `links`, and `steps_per_second` (None without MuJoCo).
    """
    parts = [link_parts(link) for link in asset.links]
    solids = [Manifold.batch_boolean([part.solid for part in of_link], OpType.Add) for of_link in parts]
    volumes = [solid.volume() for solid in solids]
    empty = [max(solid.hull().volume() - solid.volume(), 0.0) for solid in solids]
    stored = collision_of([link.to_data() for link in asset.links])
    variants = {stored: asset}
    for number in sorted(budgets, reverse=True):
        fewer, missed = fewer_colliders(asset, number, openings)
        variants.setdefault("fewest" if missed else str(number), fewer)
    for kind in () if budgets else (kind for kind in COLLISIONS if kind not in ("exact", stored)):
        made = {
            link.name: made_colliders(of_link, kind) for link, of_link in zip(asset.links, parts, strict=True)
        }
        variants[kind] = replace_colliders(asset, made, kind)
    rows = []
    for kind, variant in variants.items():
        found = [
            fidelity(solid, [collider.convex for collider in link.colliders])
            for solid, link in zip(solids, variant.links, strict=True)
        ]
        total = Fidelity(
            volume_error=_mean([each.volume_error for each in found], volumes),
            surface_error=max(each.surface_error for each in found),
            interior_kept=_mean([each.interior_kept for each in found], empty),
            pieces=sum(each.pieces for each in found),
            vertices=sum(each.vertices for each in found),
        )
        steps = steps_per_second(variant) if speed else None
        rows.append(
            {
                "kind": kind,
                "stored": kind == stored,
                **_numbers(total),
                "steps_per_second": None if steps is None else round(steps),
                "links": {link.name: _numbers(each) for link, each in zip(asset.links, found, strict=True)},
            }
        )
    return rows


def _numbers(measured: Fidelity) -> dict[str, float]:
    shares = ("volume_error", "surface_error", "interior_kept")
    return {
        "pieces": measured.pieces,
        "vertices": measured.vertices,
        **{name: significant(getattr(measured, name), _DIGITS) for name in shares},
    }


def _mean(values: Sequence[float], weights: Sequence[float]) -> float:
    """Return the mean of the values of the links; 1 if all weights are 0, as nothing was lost."""
    total = sum(weights)
    return float(np.dot(values, weights)) / total if total else 1.0


def steps_per_second(asset: Asset) -> float | None:
    """Return MuJoCo's steps per second of wall-clock time, or None if it is not installed.

    The asset first moves from its initial state for one second. The number depends on the machine and its
    load.
    """
    try:
        import mujoco
    except ImportError:
        return None
    files = dict(write_mjcf(asset).files)
    text = files.pop(f"{asset.name}.xml").decode()
    model = mujoco.MjModel.from_xml_string(text, files)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=max(round(_SETTLE / model.opt.timestep), 1))
    steps, start = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - start) < _TIMED:
        mujoco.mj_step(model, data, nstep=_BATCH)
        steps += _BATCH
    return steps / elapsed
