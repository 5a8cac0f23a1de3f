"""Facts of an asset for a person: `print(asset)`, and the card that notebooks show."""

import math
from collections.abc import Collection, Iterable
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from artgen.asset.joint import AssetJoint
from artgen.errors import AssetError

if TYPE_CHECKING:
    from artgen.asset.asset import Asset

_WIDTH = 100  # columns of a line
_MOST_JOINTS = 4  # lines of joints


def facts(asset: "Asset") -> list[tuple[str, list[str]]]:
    """Return what a person wants to know of an asset: the name of each fact, and its lines."""
    low, high = asset.bounds()
    size = " x ".join(f"{length:.3g}" for length in high - low)
    base = "fixed to the world" if asset.base == "fixed" else "free to move"
    certificate = "not certified: certify() proves that no two links collide"
    if asset.certified_later:
        certificate = "not certified yet: the first use of its certificate proves that no two links collide"
    elif asset.certificate is not None:
        certificate = str(asset.certificate).partition("\n")[0]
    colliders = sum(len(link.colliders) for link in asset.links)
    outputs = [each.name for each in asset.outputs]
    return [
        ("size", [f"{size} m (width, depth, height), {asset.mass:.3g} kg, {base}"]),
        (_counted(asset.links, "link"), [_listed(asset.links.names)]),
        (_counted(asset.joints, "joint"), _joint_lines(asset)),
        *((_counted(asset.outputs, "output"), [_listed(names)]) for names in [outputs] if names),
        ("proof", [certificate]),
        ("shape", [f"{colliders:,} convex colliders{_triangles(asset)}"]),
        (
            _counted(asset.parameters, "parameter"),
            [_listed(f"{name}={_value(value)}" for name, value in asset.parameters.items())],
        ),
    ]


def text(asset: "Asset") -> str:
    """Return the facts of an asset as about ten lines of text."""
    rows = facts(asset)
    wide = max(len(name) for name, _ in rows)
    result = [title(asset)]
    for name, lines in rows:
        labels = [name, *[""] * (len(lines) - 1)]
        result += [f"  {label:<{wide}}  {line}" for label, line in zip(labels, lines, strict=True)]
    return "\n".join(result)


def title(asset: "Asset") -> str:
    """Return name, category and seed of an asset."""
    seed = "" if asset.seed is None else f", seed {asset.seed}"
    attempt = f", draw {asset.attempt + 1} of that seed" if asset.attempt else ""
    return f"{asset.name}: {asset.category}{seed}{attempt}"


def _counted(items: Collection[Any], noun: str) -> str:
    return f"{len(items)} {noun}{'' if len(items) == 1 else 's'}"


def _joint_lines(asset: "Asset") -> list[str]:
    """Return a line for each of the first joints."""
    shown = asset.joints if len(asset.joints) <= _MOST_JOINTS else asset.joints[: _MOST_JOINTS - 1]
    if not shown:
        return ["none"]
    wide = max(len(joint.name) for joint in shown)
    lines = [f"{joint.name:<{wide}}  {range_text(joint)}" for joint in shown]
    rest = asset.joints.names[len(shown) :]
    return lines + ([f"and {len(rest)} more: {_listed(rest)}"] if rest else [])


def range_text(joint: AssetJoint) -> str:
    """Return the range of a joint with its unit, its coupling and its dependency."""
    unit = "m" if joint.kind == "prismatic" else "rad"
    if joint.limits is None:
        text = f"unlimited [{unit}]"
    elif joint.locked:
        text = f"locked at {joint.limits[0]:.3g} {unit}"
    else:
        low, high = joint.limits
        degrees = f" ({math.degrees(low):.0f} to {math.degrees(high):.0f} degrees)" * (unit == "rad")
        text = f"{low:.3g} to {high:.3g} {unit}{degrees}"
    follows = "" if joint.follows is None else f", follows {joint.follows.leader}"
    needs = "" if joint.needs is None else f", needs {joint.needs.condition}"
    return f"{joint.kind} {text}{follows}{needs}"


def _triangles(asset: "Asset") -> str:
    with suppress(AssetError):  # an asset that was read from files without surfaces
        return (
            f", {sum(len(each.mesh.triangles) for link in asset.links for each in link.surfaces):,} triangles"
        )
    return ""


def _value(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _listed(texts: Iterable[str]) -> str:
    """Return texts on one line, as many as it holds."""
    found = list(texts)
    line = ", ".join(found)
    while len(line) > _WIDTH and len(found) > 1:
        found = found[:-1]
        line = ", ".join([*found, "..."])
    return line
