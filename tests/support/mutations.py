"""Assets with one fault: what a proof must find where it makes links collide."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset, Link
from artgen.asset import AssetJoint as Joint
from support.brute import Overlap, draw_poses, overlaps

Array = NDArray[np.float64]

STEPS = (0.00107, 0.00223, 0.00493)
"""By how much pivots are shifted and links widened [m].

They are not round, so that they do not close a gap exactly: touching is neither apart nor a collision.
"""

_LIMITS = 1.25  # factor on the range of a joint
_RATIOS = (0.9, 1.1)  # factors on the ratio of a coupling


@dataclass(frozen=True, eq=False)
class Mutant:
    """An asset with one fault.

    Attributes:
        kind: `pivot`, `wide`, `limits`, `coupling` or `dependency`.
        what: What was changed, in a few words.
        asset: The asset with the fault.
    """

    kind: str
    what: str
    asset: Asset


@dataclass(frozen=True, eq=False)
class Outcome:
    """What the proof and the oracle said of a mutant.

    Attributes:
        mutant: The mutant.
        proven: Whether the certificate proves it free of collisions.
        undecided: Whether some pair is neither proven nor in collision, and none is in collision.
        overlap: The first overlap that the oracle found, if any.
    """

    mutant: Mutant
    proven: bool
    undecided: bool
    overlap: Overlap | None

    @property
    def missed(self) -> bool:
        """Whether the proof is wrong: the links collide."""
        return self.proven and self.overlap is not None

    def __str__(self) -> str:
        """Tell the asset, the fault and both verdicts."""
        verdict = "proven" if self.proven else "undecided" if self.undecided else "collision"
        found = "" if self.overlap is None else "; {1} and {2} share {3:.3g} m^3".format(*self.overlap)
        return f"{self.mutant.asset.name}: {self.mutant.what}: {verdict}{found}"


def mutants(asset: Asset) -> Iterator[Mutant]:
    """Yield the asset with each fault: pivots, widths, limits, couplings, dependencies."""
    for joint in asset.joints:
        yield from _shifted(asset, joint)
    for link in asset.links:
        for step in STEPS:
            yield Mutant(
                "wide", f"{link.name} wider by {1e3 * step:.2f} mm", with_wider_link(asset, link, step)
            )
    for joint in asset.free_joints:
        if joint.limits is not None:
            low, high = joint.limits
            more = (_LIMITS - 1.0) * (high - low)
            wider = (low - more if low < 0.0 else low, high + more if high > 0.0 else high)
            yield Mutant(
                "limits", f"limits of {joint.name} wider", _with(asset, replace(joint, limits=wider))
            )
    for joint in asset.joints:
        if joint.follows is not None:
            for factor in _RATIOS:
                follows = replace(joint.follows, ratio=joint.follows.ratio * factor)
                what = f"ratio of {joint.name} times {factor}"
                yield Mutant("coupling", what, _with(asset, replace(joint, follows=follows)))
        if joint.needs is not None:
            what = f"{joint.name} needs nothing"
            yield Mutant("dependency", what, _with(asset, replace(joint, needs=None)))


def judged(mutant: Mutant, poses: int, seed: int = 0) -> Outcome:
    """Ask the proof, then the oracle at a number of poses."""
    asset = mutant.asset
    certificate = asset.certify()
    verdicts = {pair.verdict for pair in certificate.pairs} | {pair.colliders for pair in certificate.pairs}
    undecided = "not proven" in verdicts and "collision" not in verdicts
    found = overlaps(asset, draw_poses(asset, poses, seed), most=1)
    return Outcome(mutant, certificate.proven, undecided, found[0] if found else None)


def with_wider_link(asset: Asset, link: Link, by: float) -> Asset:
    """Return an asset of which one link is scaled about its middle, to be wider by [m] along each axis."""
    boxes = np.array([piece.shape.bounds() for piece in link.pieces])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    factors = 1.0 + by / (high - low)
    matrix = np.diag([*factors, 1.0])
    matrix[:3, 3] = (low + high) / 2.0 * (1.0 - factors)
    pieces = tuple(replace(piece, shape=piece.shape.transformed(matrix)) for piece in link.pieces)
    wider = Link(link.name, link.label, pieces, link.grasps)
    return replace(asset, links=tuple(wider if each is link else each for each in asset.links))


def _shifted(asset: Asset, joint: Joint) -> Iterator[Mutant]:
    """Yield the asset with the pivot of one joint shifted across its axis, both ways in two directions."""
    if joint.kind != "revolute" or joint.locked:
        return
    first = np.cross(joint.axis, np.eye(3)[int(np.argmin(np.abs(joint.axis)))])
    first /= np.linalg.norm(first)
    for number, direction in enumerate(
        (first, -first, np.cross(joint.axis, first), np.cross(first, joint.axis))
    ):
        for step in STEPS:
            what = f"pivot of {joint.name} off by {1e3 * step:.2f} mm, direction {number}"
            moved = replace(joint, pivot=joint.pivot + step * direction)
            yield Mutant("pivot", what, _with(asset, moved))


def _with(asset: Asset, changed: Joint) -> Asset:
    """Return the asset with one joint changed, and with it the ranges of those that follow."""
    joints = {joint.name: joint for joint in asset.joints} | {changed.name: changed}

    def ranged(joint: Joint) -> Joint:
        if joint.follows is None:
            return joint
        limits = ranged(joints[joint.follows.leader]).limits
        if limits is None:
            return replace(joint, limits=None)
        low, high = sorted(joint.follows.ratio * end + joint.follows.offset for end in limits)
        return replace(joint, limits=(low, high))

    return replace(asset, joints=tuple(ranged(joint) for joint in joints.values()))
