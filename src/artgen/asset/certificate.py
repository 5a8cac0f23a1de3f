"""The certificate of an asset: the proof about collisions of its links over all joint positions."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from artgen.asset.joint import AllowedContact
from artgen.asset.record import Record, plain

PROOF_FORMAT = "artgen-certificate-1"
"""Marks the proofs that this version can verify."""

AXIS_FRAME = -2
"""Frame of a leaf that is proven by heights and distances about the common axis, not by a plane."""

MOST_TOLERANCE = 0.1
"""Clearance that can be asked for, at most [m]."""

Verdict = Literal["proven", "collision", "not proven"]
Region = Mapping[str, tuple[float, float]]
"""An interval for each free joint [rad or m]."""


@dataclass(frozen=True)
class Witness(Record):
    """A pose at which two links overlap.

    Attributes:
        pose: Position of every free joint that moves the pair [rad or m].
        first_contact: Where on the straight way from rest to `pose` they first touch; equal to the rest
            position if they overlap there [rad or m].
        depth: How far the two pieces press into each other at `pose` [m].
        volume: What the two links have in common at `pose` [m^3].
        place: Middle of what they have in common, in asset coordinates at `pose` [m].
        labels: Labels of the two pieces.
    """

    pose: Mapping[str, float]
    first_contact: Mapping[str, float]
    depth: float
    volume: float
    place: tuple[float, float, float]
    labels: tuple[str, str]


@dataclass(frozen=True)
class OpenCell(Record):
    """A region of joint space in which two pieces were proven neither apart nor in collision."""

    region: Region  # interval of each free joint that moves the pair [rad or m]
    labels: tuple[str, str]  # labels of the two pieces
    distance: float  # distance of the pieces in the middle of the region [m]


@dataclass(frozen=True)
class PairResult(Record):
    """The result of the proof for two links.

    Attributes:
        links: Their names.
        joints: The free joints that move one against the other.
        verdict: `proven`: the solids stay apart at every position. `collision`: they overlap at the
            witness. `not proven`: neither; counts as a failure.
        colliders: The same of the colliders, which contain the solids.
        guaranteed: The solids are never closer than this, pieces apart that may touch by design; None if
            all may, or not all is proven [m].
        found: The convex pieces around them are that close at `found_at`; None if not measured [m].
        found_at: Positions of the free joints there [rad or m].
        witness: Where they overlap, if they do (the colliders, where only those do).
        open_cells: Where nothing was proven, the first few.
        open_fraction: Share of the joint space of the pair in which nothing was proven.
    """

    links: tuple[str, str]
    joints: tuple[str, ...]
    verdict: Verdict
    colliders: Verdict
    guaranteed: float | None = None
    found: float | None = None
    found_at: Mapping[str, float] = field(default_factory=dict)
    witness: Witness | None = None
    open_cells: tuple[OpenCell, ...] = ()
    open_fraction: float = 0.0

    @property
    def clear(self) -> bool:
        """Whether both the solids and the colliders are proven."""
        return self.verdict == "proven" and self.colliders == "proven"

    def __str__(self) -> str:
        """Tell the verdict in one line."""
        names = f"{self.links[0]} and {self.links[1]}"
        if self.clear:
            if self.guaranteed is None:
                return f"{names}: proven to touch as their contacts by design allow only"
            return f"{names}: proven apart, at least {_mm(self.guaranteed)}"
        if self.witness is not None:
            what = "collide" if self.verdict == "collision" else "collide in their colliders only"
            witness = self.witness
            first, second = witness.labels
            x, y, z = witness.place
            return (
                f"{names} {what} at {_pose(witness.pose)}: {first} presses {_mm(witness.depth)} into "
                f"{second} at ({x:.3f}, {y:.3f}, {z:.3f}) m; first contact at {_pose(witness.first_contact)}"
            )
        place = ""
        for cell in self.open_cells[:1]:
            first, second = cell.labels
            where = f"where {first} is {_mm(cell.distance)} from {second}"
            place = f", such as {spelled_region(cell.region)}, {where}"
        which = "not proven" if self.verdict != "proven" else "not proven for the colliders"
        return f"{names}: {which} in {100 * self.open_fraction:.3g} % of their joint space{place}"


@dataclass(frozen=True)
class Certificate(Record):
    """The results of the proof for all pairs of links that move against each other.

    Attributes:
        tolerance: Clearance that had to be proven [m].
        pairs: The result of each pair.
        contacts: The contacts that the category allows.
        leaves: The proof, which `artgen.proof.recheck` verifies; None where it was not kept.
    """

    OPTIONAL: ClassVar = frozenset({"leaves"})

    tolerance: float
    pairs: tuple[PairResult, ...]
    contacts: tuple[AllowedContact, ...] = ()
    leaves: Mapping[str, Any] | None = field(default=None, repr=False, compare=False)

    @property
    def proven(self) -> bool:
        """Whether every pair is proven, the solids and the colliders."""
        return all(pair.clear for pair in self.pairs)

    @property
    def failures(self) -> tuple[PairResult, ...]:
        """The pairs that are not proven, those that collide first."""
        order = {"collision": 0, "not proven": 1, "proven": 2}
        failed = [pair for pair in self.pairs if not pair.clear]
        return tuple(sorted(failed, key=lambda pair: (order[pair.verdict], order[pair.colliders])))

    @property
    def clearance(self) -> PairResult | None:
        """The pair with the smallest guaranteed clearance; None if there is none, or not all is proven."""
        known = [(pair.guaranteed, pair.links, pair) for pair in self.pairs if pair.guaranteed is not None]
        return min(known)[2] if self.proven and known else None

    def __str__(self) -> str:
        """Tell the verdict in one line, and each failure in one more."""
        if not self.pairs:
            return "nothing moves: there is nothing to prove"
        count, failed = len(self.pairs), len(self.failures)
        pairs = f"{count} pair{'' if count == 1 else 's'}"
        apart = f" with {_mm(self.tolerance)} to spare" if self.tolerance else ""
        if self.proven:
            verb = "collide as contacts by design allow only" if self.contacts else "never collide"
            text = f"proven: {pairs} of links {verb}{apart}"
        else:
            text = f"not proven{apart}: {failed} of {pairs} fail{'s' if failed == 1 else ''}"
        contacts = (f"  allowed: {contact}" for contact in self.contacts)
        return "\n".join([text, *(f"  {pair}" for pair in self.failures), *contacts])

    def to_data(self) -> dict[str, Any]:
        """Return everything but the leaves as JSON data."""
        proven = {"tolerance": self.tolerance, "proven": self.proven}
        return {**proven, "pairs": plain(self.pairs), "contacts": plain(self.contacts)}


def _mm(length: float) -> str:
    return f"{1e3 * length:.3f} mm"


def _pose(pose: Mapping[str, float]) -> str:
    return ", ".join(f"{name}={position:.4g}" for name, position in pose.items()) or "rest"


def spelled_region(region: Region) -> str:
    """Spell a box in joint space."""
    return ", ".join(f"{name} in {low:.4g}..{high:.4g}" for name, (low, high) in region.items())
