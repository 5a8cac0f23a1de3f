"""Check of solids and masses: closed surfaces, orientation, slivers, duplicates, plausible weight."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import groupby

import numpy as np
from manifold3d import Manifold, OpType
from scipy.spatial import cKDTree

from artgen.asset import Asset, Link
from artgen.asset.collision import link_parts
from artgen.asset.report import CheckResult, Finding
from artgen.asset.shells import LinkShells, Shell, point_text, skins
from artgen.errors import ArtgenError

_CHECK = "solids"
_ROUNDING = 1e-3  # relative tolerance; meshes in files are rounded to 0.1 micrometre


def weight_findings(link: Link) -> Iterator[Finding]:
    """Yield a mass outside the range of the densities of the link's materials.

    If all solids of a link have the same density, the range is one value.
    """
    parts = link_parts(link)
    if not parts:
        return
    volume = Manifold.batch_boolean([part.solid for part in parts], OpType.Add).volume()
    labels = {part.label for part in parts}
    densities = {part.material.density for part in parts}
    densities |= {surface.material.density for surface in link.surfaces if surface.label in labels}
    least, most = (density * volume for density in (min(densities), max(densities)))
    mass = link.mass_properties.mass
    if not least * (1.0 - _ROUNDING) <= mass <= most * (1.0 + _ROUNDING):
        span = f"{least:.5g}" if least == most else f"{least:.5g} to {most:.5g}"
        message = f"its mass is {mass:.5g} kg, but its solids of {1e6 * volume:.5g} cm^3 weigh {span} kg"
        yield Finding(_CHECK, message, link.name, value=mass, unit="kg", hint="export the asset again")


CHECK = "solids"

THINNEST = 0.05e-3
"""Mean thickness below which a solid is a sliver [m]."""

SMALLEST = 1e-11
"""Volume below which a solid is a sliver [m^3]."""

_MANY_FLAT = 0.25  # share of flat triangles that clean booleans never exceed
_SAME_PLACE = 1e-6  # distance between the centers of possible duplicates [m]
_SAME_VOLUME = 1e-3  # relative volume difference of duplicates
_INSIDE = 0.5  # winding number around a point: 1 inside, 0 outside


def check_solids(asset: Asset) -> CheckResult:
    """Check the solids of every link, or its visible meshes if it was read from files."""
    findings: list[Finding] = []
    solids = triangles = absent = 0
    for link in asset.links:
        try:
            found = skins(link)
        except ArtgenError as error:
            absent += isinstance(error.__context__, FileNotFoundError)
            hint = "export the asset again with urdf or mjcf among the formats"
            findings.append(Finding(CHECK, f"its meshes cannot be read: {error}", link.name, hint=hint))
            continue
        wrong = list(link_findings(link, found))
        if not wrong:
            # labels whose meshes do not close, which the check of colliders reports
            with suppress(ArtgenError):
                wrong = list(weight_findings(link))
        findings += wrong
        solids += sum(len(skin.shells) for skin in found)
        triangles += sum(skin.triangles for skin in found)
    if absent == len(asset.links):
        return CheckResult(CHECK, skipped="no mesh files; export it with urdf or mjcf among the formats")
    return CheckResult(
        CHECK, tuple(findings), f"{len(asset.links)} links, {solids} solids, {triangles} triangles"
    )


def link_findings(link: Link, found: Sequence[LinkShells]) -> Iterator[Finding]:
    """Yield the faults of the surfaces of a link."""
    if not found:
        yield Finding(CHECK, "it has no surface", link.name, hint="give the link a solid")
    for skin in found:
        yield from _surface_findings(link, skin)
    shells = [shell for skin in found if skin.closed for shell in skin.shells]
    for _, group in groupby(shells, key=lambda shell: shell.piece):
        yield from _orientation_findings(link, list(group))
    for shell in shells:
        yield from _sliver_findings(link, shell)
    yield from _duplicate_findings(link, shells)


def _surface_findings(link: Link, skin: LinkShells) -> Iterator[Finding]:
    name = f"solid {skin.label!r}" if skin.label else "its mesh"
    at = f"first at {point_text(skin.place)}"
    if not skin.finite:
        message = f"{name} has coordinates that are not finite"
        yield Finding(CHECK, message, link.name, hint="look for a division by 0 in its measures")
        return
    if not skin.triangles:
        yield Finding(CHECK, f"{name} has no triangles", link.name, hint="the boolean left nothing of it")
        return
    if skin.open_edges:
        message = f"{name} is not closed: {skin.open_edges} edges have a face on one side only, {at}"
        yield _counted(message, link, skin.open_edges, "close the surface, or export the asset again")
    if skin.turned_edges:
        message = f"{name} has {skin.turned_edges} edges whose faces are wound against each other, {at}"
        yield _counted(message, link, skin.turned_edges, "wind all triangles counter-clockwise from outside")
    if skin.against:
        message = f"{name} has {skin.against} triangles that lean away from their normals, {at}"
        hint = "a corner was moved or a winding turned; normals stand within 60 degrees of their faces"
        yield _counted(message, link, skin.against, hint)
    if skin.doubled:
        message = f"{name} has {skin.doubled} triangles that lie on others of the same winding"
        yield _counted(message, link, skin.doubled, "a solid is there twice: remove one")
    if skin.flat > _MANY_FLAT * skin.triangles:
        message = f"{name} has {skin.flat} triangles without area of {skin.triangles}"
        yield _counted(message, link, skin.flat, "cut it with fewer coplanar faces")


def _orientation_findings(link: Link, shells: Sequence[Shell]) -> Iterator[Finding]:
    """Yield inverted shells, except for the walls of hollows."""
    for shell in shells:
        if shell.volume > 0.0 or not shell.area:
            continue
        around = sum(other.winds_around(shell.points[0]) for other in shells if other is not shell)
        if around < _INSIDE:
            yield Finding(
                CHECK,
                f"solid {shell.label!r} at {point_text(shell.center)} is turned inside out: "
                f"its volume is {1e6 * shell.volume:.4g} cm^3",
                link.name,
                value=shell.volume,
                unit="m^3",
                hint="wind its triangles counter-clockwise seen from outside",
            )


def _sliver_findings(link: Link, shell: Shell) -> Iterator[Finding]:
    place = point_text(shell.bounds.mean(axis=0))
    if shell.thickness < THINNEST:
        yield Finding(
            CHECK,
            f"solid {shell.label!r} at {place} is a sliver, {1e3 * shell.thickness:.4g} mm thick on average",
            link.name,
            value=shell.thickness,
            unit="m",
            hint=f"let solids overlap or keep apart, not graze; at least {1e3 * THINNEST:g} mm",
        )
    elif abs(shell.volume) < SMALLEST:
        yield Finding(
            CHECK,
            f"solid {shell.label!r} at {place} is a crumb of {1e9 * shell.volume:.4g} mm^3",
            link.name,
            value=shell.volume,
            unit="m^3",
            hint=f"cut deeper or leave it out; at least {1e9 * SMALLEST:g} mm^3",
        )


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
            yield Finding(
                CHECK,
                f"solid {names} at {point_text(a.center)} is there twice, {1e6 * a.volume:.4g} cm^3 each",
                link.name,
                value=a.volume,
                unit="m^3",
                hint="weld it once",
            )


def _counted(message: str, link: Link, count: int, hint: str) -> Finding:
    return Finding(CHECK, message, link.name, value=float(count), hint=hint)
