"""Check of the tree of links: connected solids, joints and masses."""

from collections import Counter
from collections.abc import Iterator, Sequence

import numpy as np

from artgen._arrays import Array
from artgen._names import is_identifier
from artgen.asset import Asset, Grasp, Link
from artgen.asset.collision import mesh_precision
from artgen.asset.report import CheckResult, Finding
from artgen.asset.shells import Shell, point_text, skins
from artgen.errors import ArtgenError, nearest
from artgen.validate.joints import joint_findings

JOINED = 0.5e-3
"""Largest gap between connected solids of a link [m]."""

_FAR = 10.0  # largest measured gap [m]


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
    """Return the numbers of connected solids."""
    count = len(shells)
    group = list(range(count))

    def leader(number: int) -> int:
        while group[number] != number:
            group[number] = group[group[number]]
            number = group[number]
        return number

    apart = _box_gaps(shells, shells)
    first, second = np.nonzero(np.triu(apart <= JOINED, 1))
    # nearest boxes first: most overlap, and pairs that are already connected cost nothing
    for index in np.argsort(apart[first, second], kind="stable"):
        a, b = leader(int(first[index])), leader(int(second[index]))
        if a != b and _joined(shells[first[index]], shells[second[index]]):
            group[max(a, b)] = min(a, b)
    result: dict[int, list[int]] = {}
    for number in range(count):
        result.setdefault(leader(number), []).append(number)
    return list(result.values())


def _box_gaps(a: Sequence[Shell], b: Sequence[Shell]) -> Array:
    """Return the distances between bounding boxes, shape (n, m) [m]."""
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


CHECK = "tree"

LIGHTEST, HEAVIEST = 5.0, 20000.0
"""Range of plausible mean densities of a link: foam to tungsten [kg/m^3]."""

_ROUNDING = 1e-9  # relative tolerance of moments of inertia
_GRASP = 1e-6  # tolerance of a grasp's axes


def check_tree(asset: Asset) -> CheckResult:
    """Check the tree of an asset: names, labels, joints, masses, and floating parts."""
    if not asset.links:
        finding = Finding(CHECK, "the asset has no links", hint="generate it again")
        return CheckResult(CHECK, (finding,))
    findings = [*_structure_findings(asset), *_name_findings(asset), *_label_findings(asset)]
    findings += joint_findings(asset)
    for link in asset.links:
        findings += _grasp_findings(link)
        try:
            findings += () if mesh_precision(link) else floating_findings(link)
            findings += _mass_findings(link)
        except ArtgenError as error:
            # the check of solids reports missing files
            message = f"its connection and mass cannot be judged: {error}"
            findings.append(Finding(CHECK, message, link.name, severity="note"))
    return CheckResult(CHECK, tuple(findings), f"{len(asset.links)} links, {len(asset.joints)} joints")


def _structure_findings(asset: Asset) -> Iterator[Finding]:
    """Yield the faults of the tree of links, whose root is the first link."""
    known = {link.name for link in asset.links}
    position = {link.name: number for number, link in reversed(list(enumerate(asset.links)))}
    parents: dict[str, str] = {}
    for joint in asset.joints:
        ends = [end for end in (joint.parent, joint.child) if end not in known]
        for end in ends:
            message = f"it joins {end!r}, which is no link.{nearest(end, known)}"
            yield Finding(CHECK, message, joint=joint.name, hint="name a link of the asset")
        if ends:
            continue
        if joint.child in parents and parents[joint.child] != joint.parent:
            message = f"it hangs on {parents[joint.child]!r} and on {joint.parent!r}; a link has one parent"
            yield Finding(CHECK, message, joint.child, joint.name, hint="attach it once")
        elif position[joint.parent] >= position[joint.child]:
            message = (
                f"its parent {joint.parent!r} does not come before it; the links go round or are in disorder"
            )
            yield Finding(CHECK, message, joint.child, joint.name, hint="list parents before their children")
        parents.setdefault(joint.child, joint.parent)
    root = asset.links[0].name
    if root in parents:
        yield Finding(
            CHECK, f"the base hangs on {parents[root]!r}", root, hint="list the link without a parent first"
        )
    for link in asset.links[1:]:
        if link.name not in parents:
            message = "no joint joins it to the others: the asset has more than one root"
            yield Finding(CHECK, message, link.name, hint="attach it to a parent, or weld it")


def _name_findings(asset: Asset) -> Iterator[Finding]:
    grasps = [hold.name for link in asset.links for hold in (*link.grasps, *link.pushes)]
    kinds = {
        "link": [link.name for link in asset.links],
        "joint": [joint.name for joint in asset.joints],
        "grasp": grasps,
    }
    for kind, names in kinds.items():
        for name, count in Counter(names).items():
            link, joint = name if kind == "link" else "", name if kind == "joint" else ""
            if count > 1:
                message = f"{count} {kind}s are named {name!r}"
                yield Finding(CHECK, message, link, joint, float(count), hint="give each a name of its own")
            if not is_identifier(name):
                message = f"the {kind} name {name!r} is no identifier"
                yield Finding(CHECK, message, link, joint, hint="use letters, digits and _")


def _label_findings(asset: Asset) -> Iterator[Finding]:
    if not asset.labels:
        return
    for link in asset.links:
        for label in link.labels:
            if label not in asset.labels:
                message = f"its label {label!r} is not declared by category {asset.category!r}"
                hint = f"declare it in @category(labels=...).{nearest(label, asset.labels)}"
                yield Finding(CHECK, message, link.name, hint=hint)


def _grasp_findings(link: Link) -> Iterator[Finding]:
    for grasp in (*link.grasps, *link.pushes):
        turn = grasp.frame[:3, :3]
        error = float(np.abs(turn.T @ turn - np.eye(3)).max())
        if not (error <= _GRASP and np.linalg.det(turn) > 0.0 and np.isfinite(grasp.frame).all()):
            message = f"the axes of grasp {grasp.name!r} are no rotation: they miss it by {error:.3g}"
            yield Finding(
                CHECK, message, link.name, value=error, hint="make the frame of unit axes at right angles"
            )
        if isinstance(grasp, Grasp) and not grasp.width > 0.0:
            message = f"grasp {grasp.name!r} has width {grasp.width:.4g} m"
            yield Finding(
                CHECK, message, link.name, value=grasp.width, unit="m", hint="give the opening of the fingers"
            )


def _mass_findings(link: Link) -> Iterator[Finding]:
    """Yield impossible mass, center or inertia for the bounds of a link."""
    properties = link.mass_properties
    mass, inertia = properties.mass, properties.inertia
    finite = np.isfinite(mass) and np.isfinite(properties.center).all() and np.isfinite(inertia).all()
    if not (finite and mass > 0.0):
        message = f"its mass is {mass:.4g} kg, or its center or inertia is not finite"
        yield Finding(CHECK, message, link.name, value=mass, unit="kg", hint="give it a solid with a density")
        return
    low, high = link.bounds()
    yield from _density_findings(link, mass, float(np.prod(high - low)))
    slack = 1e-6 * float(np.linalg.norm(high - low))
    if (properties.center < low - slack).any() or (properties.center > high + slack).any():
        center = ", ".join(f"{value:.4g}" for value in properties.center)
        message = f"its center of mass ({center}) m lies outside its bounding box"
        yield Finding(CHECK, message, link.name, hint="derive it from the solids")
    moments = np.linalg.eigvalsh(inertia)
    shown = ", ".join(f"{moment:.4g}" for moment in moments)
    if moments[0] <= 0.0 or moments[0] + moments[1] < moments[2] * (1.0 - _ROUNDING):
        message = f"its principal moments {shown} kg m^2 are not those of a body"
        hint = "each must be positive and no larger than the sum of the others"
        yield Finding(CHECK, message, link.name, value=float(moments[0]), unit="kg m^2", hint=hint)
    largest = mass * float(np.sum((high - low) ** 2))
    if moments[2] > largest:
        message = f"its moment {moments[2]:.4g} kg m^2 exceeds what its mass and size allow, {largest:.4g}"
        yield Finding(
            CHECK,
            message,
            link.name,
            value=float(moments[2]),
            unit="kg m^2",
            hint="derive it from the solids",
        )


def _density_findings(link: Link, mass: float, room: float) -> Iterator[Finding]:
    """Yield implausible mean densities; of the bounding box if the solids are unknown."""
    volume = sum(piece.shape.manifold.volume() for piece in link.pieces if not piece.visual)
    what, size, least = ("solids", volume, LIGHTEST) if volume > 0.0 else ("bounding box", room, 0.0)
    density = mass / size if size > 0.0 else np.inf
    # overlapping solids count twice in the volume, which makes the density too low by at most half
    if not 0.5 * least <= density <= HEAVIEST:
        yield Finding(
            CHECK,
            f"its mass of {mass:.4g} kg makes a density of {density:.4g} kg/m^3 of its {what}",
            link.name,
            value=float(density),
            unit="kg/m^3",
            hint=f"between {LIGHTEST:g} and {HEAVIEST:g} is plausible; check material and measures",
        )
