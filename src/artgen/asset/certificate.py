"""Certificate of an asset: results of the collision proof over all joint positions."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from artgen.asset.joint import AllowedContact
from artgen.asset.record import Record, plain

PROOF_FORMAT = "artgen-certificate-1"  # format of the proofs that this version can verify
AXIS_FRAME = -2  # frame number of a cell that heights and radii about a common axis prove, instead of a plane
MOST_TOLERANCE = 0.1  # largest clearance that `certify` accepts [m]

Verdict = Literal["proven", "collision", "not proven"]
Region = Mapping[str, tuple[float, float]]
"""An interval for each free joint [rad or m]."""


@dataclass(frozen=True)
class Witness(Record):
    """A pose at which two links overlap.

    Attributes:
        pose: Position of every free joint that moves the pair [rad or m].
        first_contact: First touching position on the straight line from rest to `pose`; the rest position
            if they overlap there [rad or m].
        depth: Penetration depth of the two pieces at `pose` [m].
        volume: Volume of the overlap at `pose` [m^3].
        place: Center of the overlap in asset coordinates at `pose` [m].
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
    """A region of joint space in which two pieces were proven neither separate nor colliding."""

    region: Region  # interval of each free joint that moves the pair [rad or m]
    labels: tuple[str, str]  # labels of the two pieces
    distance: float  # distance of the pieces at the center of the region [m]


@dataclass(frozen=True)
class PairResult(Record):
    """The result of the proof for two links.

    Attributes:
        links: Their names.
        joints: Names of the free joints that move one link against the other.
        verdict: Verdict on the solids. `proven`: separate at every position. `collision`: they overlap at
            the witness. `not proven`: neither could be shown; this counts as a failure.
        colliders: Verdict on the colliders, which contain the solids.
        guaranteed: Lower bound of the distance of the solids, without pieces that may touch; None if all
            pieces may touch or the pair is not proven [m].
        found: Distance of the convex pieces at `found_at`; None if it was not measured [m].
        found_at: Positions of the free joints at that distance [rad or m].
        witness: An overlap of the solids, or of the colliders if only they overlap.
        open_cells: The first few regions in which nothing was proven.
        open_fraction: Share of the joint space of the pair in which nothing was proven.
        seconds: Time limit that ended the proof, or time after which the pair was given up to leave some for
            the others; None if there was no limit, or the proof needed less [s].
    """

    OPTIONAL: ClassVar = frozenset({"seconds"})

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
    seconds: float | None = None

    @property
    def clear(self) -> bool:
        """Whether both the solids and the colliders are proven."""
        return self.verdict == "proven" and self.colliders == "proven"

    @property
    def alike(self) -> str:
        """Links, verdicts and labels of the pieces: the same for samples that fail for the same reason."""
        labels = (
            [cell.labels for cell in self.open_cells[:1]] if self.witness is None else self.witness.labels
        )
        return f"{self.links} {self.verdict} {self.colliders} {labels}"

    def __str__(self) -> str:
        names = f"{self.links[0]} and {self.links[1]}"
        if self.clear:
            if self.guaranteed is None:
                return f"{names}: proven to touch only as their allowed contacts permit"
            return f"{names}: proven apart, at least {_mm(self.guaranteed)}"
        if self.witness is not None:
            verb = "collide" if self.verdict == "collision" else "collide in their colliders only"
            witness = self.witness
            first, second = witness.labels
            x, y, z = witness.place
            return (
                f"{names} {verb} at {_pose(witness.pose)}: {first} presses {_mm(witness.depth)} into "
                f"{second} at ({x:.3f}, {y:.3f}, {z:.3f}) m; first contact at {_pose(witness.first_contact)}"
            )
        place = ""
        for cell in self.open_cells[:1]:
            first, second = cell.labels
            if self.seconds is not None:
                where = spelled_region(cell.region)
                return f"{names}: not proven after {self.seconds:g} s: {first} and {second}, with {where}"
            where = f"where {first} is {_mm(cell.distance)} from {second}"
            place = f", such as {spelled_region(cell.region)}, {where}"
        which = "not proven" if self.verdict != "proven" else "not proven for the colliders"
        return f"{names}: {which} in {100 * self.open_fraction:.3g} % of their joint space{place}"


@dataclass(frozen=True)
class Certificate(Record):
    """The results of the proof for all pairs of links that move against each other.

    Attributes:
        tolerance: Required clearance [m].
        pairs: Result of each pair.
        contacts: Contacts that the category allows.
        leaves: The proof, which `artgen.proof.recheck` verifies; None if it was not stored.
        slots: Of a padded asset, the link around each link in an empty slot, see `artgen.topology`.
    """

    OPTIONAL: ClassVar = frozenset({"leaves", "slots"})

    tolerance: float
    pairs: tuple[PairResult, ...]
    contacts: tuple[AllowedContact, ...] = ()
    leaves: Mapping[str, Any] | None = field(default=None, repr=False, compare=False)
    slots: Mapping[str, str] = field(default_factory=dict)

    @property
    def proven(self) -> bool:
        """Whether every pair is proven, the solids and the colliders."""
        return all(pair.clear for pair in self.pairs)

    @property
    def failures(self) -> tuple[PairResult, ...]:
        """The pairs that are not proven, collisions first."""
        order = {"collision": 0, "not proven": 1, "proven": 2}
        failed = [pair for pair in self.pairs if not pair.clear]
        return tuple(sorted(failed, key=lambda pair: (order[pair.verdict], order[pair.colliders])))

    @property
    def clearance(self) -> PairResult | None:
        """The pair with the smallest guaranteed clearance; None if no pair has one, or not all are proven."""
        known = [(pair.guaranteed, pair.links, pair) for pair in self.pairs if pair.guaranteed is not None]
        return min(known)[2] if self.proven and known else None

    def __str__(self) -> str:
        if not self.pairs:
            return "nothing moves: there is nothing to prove"
        count, failed = len(self.pairs), len(self.failures)
        pairs = f"{count} pair{'' if count == 1 else 's'}"
        apart = f" with {_mm(self.tolerance)} to spare" if self.tolerance else ""
        if self.proven:
            verb = "touch only as allowed contacts permit" if self.contacts else "never collide"
            text = f"proven: {pairs} of links {verb}{apart}"
        else:
            text = f"not proven{apart}: {failed} of {pairs} fail{'s' if failed == 1 else ''}"
        contacts = (f"  allowed: {contact}" for contact in self.contacts)
        slots = (f"  empty slot {name}: lies inside {host}" for name, host in self.slots.items())
        return "\n".join([text, *(f"  {pair}" for pair in self.failures), *contacts, *slots])

    def to_data(self) -> dict[str, Any]:
        """Return everything but the leaves as JSON data."""
        proven = {"tolerance": self.tolerance, "proven": self.proven}
        slots = {"slots": dict(self.slots)} if self.slots else {}
        return {**proven, "pairs": plain(self.pairs), "contacts": plain(self.contacts), **slots}


def _mm(length: float) -> str:
    return f"{1e3 * length:.3f} mm"


def _pose(pose: Mapping[str, float]) -> str:
    return ", ".join(f"{name}={position:.4g}" for name, position in pose.items()) or "rest"


def spelled_region(region: Region) -> str:
    """Format a box in joint space."""
    return ", ".join(f"{name} in {low:.4g}..{high:.4g}" for name, (low, high) in region.items())
