"""Whether the exported files say what the asset is, as readers understand them that are not artgen's."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import numpy as np

from artgen.asset import Asset, Joint
from artgen.asset.files import main_files
from artgen.check.reading import Reading, expected_frames, sampled_positions
from artgen.check.report import CheckResult, Finding
from artgen.colliders import Convex

_EXACT = 1e-6  # [m, rad], and relative for masses and moments
_VOLUME = 1e-3  # relative: USD has single precision, and pieces are thin
_POSES = 5
_FAR = 1000.0  # [m]: where an unlimited slide ends in URDF, which wants limits of it
_SHOWN = 5  # complaints of one reader
_AGAIN = "the file was changed, or is of another asset: export the asset again"


def check_formats(asset: Asset, directory: str | Path) -> tuple[CheckResult, ...]:
    """Read each exported file with a reader that is not artgen's and compare it with the asset.

    URDF is read by yourdfpy, MJCF by MuJoCo where it is installed, USD by OpenUSD, whose validators judge it
    as well.

    Args:
        asset: What the files should say.
        directory: The directory of the export.

    Returns:
        One result for each format that is there: `urdf`, `mjcf`, `usd`.
    """
    readers: dict[str, Callable[[Asset, Path], Reading]] = {
        "urdf": _read_urdf,
        "mjcf": _read_mjcf,
        "usd": _read_usd,
    }
    files = main_files(directory)
    return tuple(
        _checked(check, asset, files[check], read)
        for check, read in readers.items()
        if check in files and files[check].exists()
    )


def _read_urdf(asset: Asset, path: Path) -> Reading:
    from artgen.check.read_urdf import read_urdf

    return read_urdf(asset, path)


def _read_mjcf(asset: Asset, path: Path) -> Reading:
    from artgen.check.read_mjcf import read_mjcf

    return read_mjcf(asset, path)


def _read_usd(asset: Asset, path: Path) -> Reading:
    from artgen.check.read_usd import read_usd

    return read_usd(asset, path)


def _checked(check: str, asset: Asset, path: Path, read: Callable[[Asset, Path], Reading]) -> CheckResult:
    try:
        reading = read(asset, path)
    except ModuleNotFoundError as error:
        if error.name != "mujoco":
            raise
        return CheckResult(check, skipped="needs artgen[sim]")
    except Exception as error:  # noqa: BLE001 - readers raise whatever they like at a damaged file
        reason = " ".join(str(error).split())
        message = f"it cannot be read: {type(error).__name__}: {reason}"
        return CheckResult(check, (Finding(check, message, hint=_AGAIN),))
    findings = (
        *_complaints(check, reading),
        *_link_findings(check, asset, reading),
        *_joint_findings(check, asset, reading),
        *_coupling_findings(check, asset, reading),
        *_pose_findings(check, asset, reading),
    )
    moving = sum(not joint.locked for joint in asset.joints)
    detail = f"{reading.file}: {len(reading.inertials)} links, {moving} joints, {_POSES + 1} poses"
    return CheckResult(check, findings, detail)


def _complaints(check: str, reading: Reading) -> Iterator[Finding]:
    said = list(dict.fromkeys(" ".join(text.split()) for text in reading.said))
    for text in said[:_SHOWN]:
        yield Finding(check, f"its reader complains: {text}", hint=_AGAIN)
    if len(said) > _SHOWN:
        message = f"its reader has {len(said) - _SHOWN} more complaints"
        yield Finding(check, message, value=float(len(said)), hint=_AGAIN)


def _link_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    for link in asset.links:
        found = reading.inertials.get(link.name)
        if found is None:
            yield Finding(check, f"{reading.file} has no such link with a mass", link.name, hint=_AGAIN)
            continue
        wanted = link.mass_properties
        if not abs(found.mass - wanted.mass) <= _EXACT * wanted.mass:
            message = f"its mass is {found.mass:.7g} kg in {reading.file}, not {wanted.mass:.7g} kg"
            yield Finding(check, message, link.name, value=found.mass, unit="kg", hint=_AGAIN)
        center = wanted.center - asset.origin(link.name)
        away = float(np.abs(found.center - center).max())
        if not away <= _EXACT:
            message = f"its centre of mass is {1e3 * away:.4g} mm away in {reading.file}"
            yield Finding(check, message, link.name, value=away, unit="m", hint=_AGAIN)
        scale = max(float(np.abs(wanted.inertia).max()), 1e-9)
        error = float(np.abs(found.inertia - wanted.inertia).max()) / scale
        if not error <= 2.0 * _EXACT:
            message = f"its inertia differs by {100.0 * error:.4g} % in {reading.file}"
            yield Finding(check, message, link.name, value=error, hint=_AGAIN)
        yield from _collider_findings(check, asset, link.name, reading)


def _collider_findings(check: str, asset: Asset, link: str, reading: Reading) -> Iterator[Finding]:
    convexes = [collider.convex for collider in asset.link(link).colliders]
    count, volume = _expected(convexes, capsules=check != "urdf")
    found, found_volume = reading.colliders.get(link, (0, 0.0))
    if found != count:
        message = f"it has {found} colliders in {reading.file}, not {count}"
        yield Finding(check, message, link, value=float(found), hint=_AGAIN)
    elif not abs(found_volume - volume) <= _VOLUME * volume:
        message = (
            f"its colliders have {1e6 * found_volume:.5g} cm^3 in {reading.file}, not {1e6 * volume:.5g} cm^3"
        )
        yield Finding(check, message, link, value=found_volume, unit="m^3", hint=_AGAIN)


def _expected(convexes: Sequence[Convex], *, capsules: bool) -> tuple[int, float]:
    """Return number and volume of colliders; without capsules, each is a cylinder between two balls."""
    split = [] if capsules else [convex for convex in convexes if convex.kind == "capsule"]
    balls = sum(4.0 / 3.0 * np.pi * convex.size[0] ** 3 for convex in split)
    return len(convexes) + 2 * len(split), sum(convex.volume for convex in convexes) + balls


def _joint_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
    for name in reading.kinds:
        if name not in moving:
            message = f"it can move in {reading.file}, but is no moving joint of the asset"
            yield Finding(check, message, joint=name, hint=_AGAIN)
    for name, joint in moving.items():
        if name not in reading.kinds:
            yield Finding(check, f"{reading.file} has no such joint that can move", joint=name, hint=_AGAIN)
            continue
        if reading.kinds[name] != joint.kind:
            message = f"it is {reading.kinds[name]} in {reading.file}, not {joint.kind}"
            yield Finding(check, message, joint=name, hint=_AGAIN)
            continue
        if name in reading.axes:
            error = float(np.abs(reading.axes[name] - joint.axis).max())
            if not error <= _EXACT:
                message = f"its axis differs by {error:.4g} in {reading.file}"
                yield Finding(check, message, joint=name, value=error, hint=_AGAIN)
        yield from _limit_findings(check, joint, reading)


def _limit_findings(check: str, joint: Joint, reading: Reading) -> Iterator[Finding]:
    found, wanted = reading.limits[joint.name], joint.limits
    if check == "urdf" and joint.kind == "prismatic" and wanted is None:
        wanted = (-_FAR, _FAR)
    same = (found is None) == (wanted is None)
    error = None
    if found is not None and wanted is not None:
        error = float(np.abs(np.subtract(found, wanted)).max())
        same = error <= _EXACT * max(1.0, *map(abs, wanted))
    if not same:
        unit = "rad" if joint.kind == "revolute" else "m"
        message = f"its limits are {_span(found, unit)} in {reading.file}, not {_span(wanted, unit)}"
        yield Finding(check, message, joint=joint.name, value=error, unit=unit, hint=_AGAIN)


def _span(limits: tuple[float, float] | None, unit: str) -> str:
    return "none" if limits is None else f"{limits[0]:.7g} to {limits[1]:.7g} {unit}"


def _coupling_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    following = {joint.name for joint in asset.joints if joint.follows is not None and not joint.locked}
    for name in sorted(following ^ set(reading.couplings)):
        message = (
            f"it follows another joint, but not in {reading.file}"
            if name in following
            else f"it follows {reading.couplings[name][0]!r} in {reading.file}, but not in the asset"
        )
        yield Finding(check, message, joint=name, hint=_AGAIN)
    for name in sorted(following & set(reading.couplings)):
        leader, ratio, offset = reading.couplings[name]
        wanted = _law(asset, name, leader)
        if wanted is None:
            message = f"it follows {leader!r} in {reading.file}, which does not lead it"
            yield Finding(check, message, joint=name, hint=_AGAIN)
        elif not np.allclose((ratio, offset), wanted, rtol=_EXACT, atol=_EXACT):
            message = (
                f"it is {ratio:.7g} * {leader} + {offset:.7g} in {reading.file}, "
                f"not {wanted[0]:.7g} * {leader} + {wanted[1]:.7g}"
            )
            yield Finding(check, message, joint=name, value=ratio, hint=_AGAIN)


def _law(asset: Asset, name: str, leader: str) -> tuple[float, float] | None:
    """Return ratio and offset of a joint to a leader, near or far along its chain; None if it is none."""
    if name == leader:
        return 1.0, 0.0
    follows = asset.joint(name).follows
    above = None if follows is None else _law(asset, follows.leader, leader)
    if follows is None or above is None:
        return None
    return follows.ratio * above[0], follows.ratio * above[1] + follows.offset


def _pose_findings(check: str, asset: Asset, reading: Reading) -> Iterator[Finding]:
    """Yield the links whose frames are elsewhere, each at the pose where it is worst."""
    worst: dict[str, tuple[float, dict[str, float]]] = {}
    for q in sampled_positions(asset, _POSES):
        wanted = expected_frames(asset, q)
        for name, frame in reading.frames(asset.positions(q)).items():
            error = float(np.abs(frame - wanted[name]).max())
            if not error <= worst.get(name, (2.0 * _EXACT, {}))[0]:
                worst[name] = (error, q)
    for name, (error, q) in worst.items():
        message = f"its frame is off by {error:.4g} (m or radians) in {reading.file}"
        yield Finding(check, message, name, value=error, pose=q, hint=_AGAIN)
