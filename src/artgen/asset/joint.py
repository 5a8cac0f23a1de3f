"""Joints of an asset: motion, dynamics, couplings, dependencies, and the contacts that they allow."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Triple, affine, cached_property
from artgen.asset.coupling import AssetCoupling
from artgen.asset.record import Record
from artgen.errors import AssetError

JointKind = Literal["revolute", "prismatic"]


@dataclass(frozen=True)
class AssetCondition(Record):
    """A region of joint space."""

    OPTIONAL: ClassVar = frozenset({"joint", "value", "terms"})

    # `above` and `below` compare one joint with `value`; `all` and `any` combine `terms`
    kind: Literal["above", "below", "all", "any"]
    joint: str = ""  # name of the compared joint
    value: float = 0.0  # threshold [rad or m]
    terms: tuple["AssetCondition", ...] = ()  # the combined conditions

    def holds(self, q: Mapping[str, float]) -> bool:
        """Tell whether joint positions `q` lie in the region; `q` has every joint of `joints()`."""
        return self.combined(
            lambda term: q[term.joint] > term.value if term.kind == "above" else q[term.joint] < term.value
        )

    def combined(self, holds: Callable[["AssetCondition"], bool]) -> bool:
        """Tell whether the condition holds, from a function for its comparisons."""
        if not self.terms:
            return holds(self)
        results = (term.combined(holds) for term in self.terms)
        return all(results) if self.kind == "all" else any(results)

    def comparisons(self) -> "list[AssetCondition]":
        """Return the comparisons in the condition, in order of appearance."""
        return [each for term in self.terms for each in term.comparisons()] if self.terms else [self]

    def joints(self) -> tuple[str, ...]:
        """Return the names of the joints in the condition, in order of appearance."""
        return tuple(dict.fromkeys(term.joint for term in self.comparisons()))

    def renamed(self, names: Mapping[str, str]) -> "AssetCondition":
        """Return the condition with joints renamed; names not in `names` stay."""
        terms = tuple(term.renamed(names) for term in self.terms)
        return replace(self, joint=names.get(self.joint, self.joint), terms=terms)

    def __str__(self) -> str:
        if self.kind in ("above", "below"):
            return f"{self.joint} {'>' if self.kind == 'above' else '<'} {self.value:.6g}"
        sign = " & " if self.kind == "all" else " | "
        return sign.join(f"({term})" for term in self.terms)

    def to_data(self) -> dict[str, Any]:
        """Return the condition as JSON data, without the fields that its kind does not use."""
        unused = ("joint", "value") if self.terms else ("terms",)
        return {name: value for name, value in super().to_data().items() if name not in unused}


@dataclass(frozen=True)
class AssetDependency(Record):
    """A joint may leave its closed position (0) only while a condition on other joints holds.

    Attributes:
        condition: The condition.
        until: The dependency ends at this position; farther open, the joint moves freely, like a door whose
            latch has left the strike. None: it never ends [rad or m].
        beyond: The dependency begins at this position; closer to 0, the joint moves freely, like a drawer
            before it reaches the closed door. None: it begins at 0 [rad or m].
    """

    OPTIONAL: ClassVar = frozenset({"beyond"})

    condition: AssetCondition
    until: float | None = None
    beyond: float | None = None

    def allows(self, position: float, q: Mapping[str, float]) -> bool:
        """Tell whether the joint may be at `position` while the other joints are at `q`."""
        near = abs(position) <= max(self.beyond or 0.0, 1e-9)
        far = self.until is not None and abs(position) >= self.until
        return near or far or self.condition.holds(q)

    def __str__(self) -> str:
        if self.until is None and self.beyond is None:
            return str(self.condition)
        beyond = "" if self.beyond is None else f".beyond({self.beyond:.6g})"
        until = "" if self.until is None else f".until({self.until:.6g})"
        return f"({self.condition}){beyond}{until}"


@dataclass(frozen=True)
class AssetDetents(Record):
    """Positions at which a joint clicks into place.

    Between two positions is a ridge. From a position to the ridge beside it the resistance grows, nearly as
    that of a spring, up to `torque`; beyond the ridge it acts towards the next position. On a revolute joint
    without limits, the last position has the first one as its neighbor.

    Attributes:
        positions: Ascending [rad or m].
        torque: Greatest torque or force, on a ridge [N m or N].
    """

    positions: tuple[float, ...]
    torque: float


@dataclass(frozen=True)
class AssetSoftClosing(Record):
    """A damper and a spring that act on a joint near its closed position, and nowhere else.

    Attributes:
        reach: Position at which they begin to act [rad or m].
        preload: Force of the spring at the closed position, towards it [N m or N].
        force: Force of the spring at `reach`; it grows linearly between both [N m or N].
        damping: Viscous damping up to `reach`, additional to that of the joint [N m s/rad or N s/m].
    """

    reach: float
    preload: float
    force: float
    damping: float


@dataclass(frozen=True, eq=False)
class AssetJoint(FrozenArrays, Record):
    """One degree of freedom between two links.

    The same two links may have several joints; they act in order, the first nearest to the parent.

    Attributes:
        name: Identifier, unique in the asset.
        kind: `revolute` [rad] or `prismatic` [m].
        axis: Unit vector in asset coordinates at rest, shape (3,).
        pivot: A point on the axis in asset coordinates at rest, shape (3,) [m].
        limits: Lowest and highest position; equal limits lock the joint, None is unlimited [rad or m].
        stiffness: Spring towards `rest` [N m/rad or N/m].
        damping: [N m s/rad or N s/m].
        friction: Dry friction [N m or N].
        rest: Position at which the spring is relaxed [rad or m].
        armature: Additional inertia at the joint [kg m^2 or kg].
        effort: Largest torque or force of an actuator [N m or N].
        velocity: Largest speed [rad/s or m/s].
        follows: The coupling to another joint, if any.
        needs: The dependency on other joints, if any.
        parent: Name of the parent link; empty until the joint is part of an asset.
        child: Name of the child link; empty until the joint is part of an asset.
        driven: Actuator that moves the joint, such as `a motor`; empty if a hand moves it.
        detents: Positions at which the joint clicks into place, if any.
        closing: Damper and spring that close the joint softly, if any.
    """

    OPTIONAL: ClassVar = frozenset({"driven", "detents", "closing"})
    FIRST: ClassVar = ("name", "kind", "parent", "child")

    name: str
    kind: JointKind
    axis: Triple
    pivot: Triple
    limits: tuple[float, float] | None = None
    stiffness: float = 0.0
    damping: float = 0.0
    friction: float = 0.0
    rest: float = 0.0
    armature: float = 0.0
    effort: float = 100.0
    velocity: float = 10.0
    follows: AssetCoupling | None = None
    needs: AssetDependency | None = None
    parent: str = ""
    child: str = ""
    driven: str = ""
    detents: AssetDetents | None = None
    closing: AssetSoftClosing | None = None

    @property
    def locked(self) -> bool:
        """Whether the limits allow one position only."""
        return self.limits is not None and self.limits[0] == self.limits[1]

    @property
    def closed(self) -> float:
        """The position nearest to 0 within the limits."""
        low, high = self.limits or (0.0, 0.0)
        return min(max(0.0, low), high)

    @property
    def opened(self) -> float:
        """The limit farthest from `closed`; `closed` itself if there are no limits."""
        return max(self.limits or (self.closed,), key=lambda end: abs(end - self.closed))

    @property
    def ridges(self) -> tuple[tuple[float, float], ...]:
        """Position of each ridge between two detents, and the distance of these detents [rad or m]."""
        if self.detents is None:
            return ()
        ends = list(self.detents.positions)
        if self.limits is None and self.kind == "revolute":
            ends.append(ends[0] + math.tau)
        return tuple(((low + high) / 2.0, high - low) for low, high in pairwise(ends))

    def detent_torque(self, q: ArrayLike) -> Array:
        """Return the torque [N m] or force [N] of the detents at positions [rad or m], of the same shape.

        At a distance d from a ridge between detents that are g apart it is, away from the ridge,
        `torque * (1 - 2 d / g)` on a slide, and `torque * (1 - sin(d / 2) / sin(g / 4)) * cos(d / 2)` on a
        revolute joint; beyond the outer detents it is 0. The MJCF has springs with exactly this law.
        """
        positions, result = np.asarray(q, float), np.zeros(np.shape(q))
        for ridge, gap in self.ridges:
            away = positions - ridge
            if self.kind == "revolute":
                away = (away + math.pi) % math.tau - math.pi
                size = (1.0 - _portable.sin(abs(away) / 2.0) / _portable.sin(gap / 4.0)) * _portable.cos(
                    away / 2.0
                )
            else:
                size = 1.0 - 2.0 * abs(away) / gap
            assert self.detents is not None
            result += np.where(abs(away) < gap / 2.0, self.detents.torque * size * np.sign(away), 0.0)
        return result

    def closing_force(self, q: ArrayLike, speed: ArrayLike = 0.0) -> Array:
        """Return the torque [N m] or force [N] of the soft closing, of the shape of both arrays.

        At the share s of the way from the closed position to `reach` it is `preload + (force - preload) * s`
        towards the closed position, and `damping * speed` against the motion; beyond `reach` it is 0. The
        MJCF has a tendon with this law.

        Args:
            q: Positions [rad or m].
            speed: Speeds [rad/s or m/s].
        """
        positions, speeds = np.broadcast_arrays(np.asarray(q, float), np.asarray(speed, float))
        if self.closing is None:
            return np.zeros(positions.shape)
        share = (positions - self.closed) / (self.closing.reach - self.closed)
        spring = self.closing.preload + (self.closing.force - self.closing.preload) * share
        way = math.copysign(1.0, self.closing.reach - self.closed)
        return np.where(share < 1.0, -way * spring - self.closing.damping * speeds, 0.0)

    def motion(self, position: float) -> Array:
        """Return the displacement of the child at a position, shape (4, 4), in asset coordinates at rest."""
        if not position:
            return np.eye(4)
        if self.kind == "prismatic":
            return affine(np.eye(3), self.axis * position)
        turn = _turned(self.rotation_terms, position)
        return affine(turn, self.pivot - turn @ self.pivot)

    @cached_property
    def rotation_terms(self) -> tuple[Array, Array, Array]:
        """Terms a, b and c of its rotation a + sin(angle) b + (1 - cos(angle)) c, shape (3, 3) each."""
        return _rotation_terms(self.axis)

    def moved(self, matrix: Array) -> "AssetJoint":
        """Return the joint carried along by a rigid motion or a reflection, shape (4, 4)."""
        axis = matrix[:3, :3] @ self.axis
        if self.kind == "revolute" and np.linalg.det(matrix[:3, :3]) < 0.0:
            axis = -axis  # a rotation axis is a pseudovector
        return replace(self, axis=axis, pivot=matrix[:3, :3] @ self.pivot + matrix[:3, 3])

    def renamed(self, names: Mapping[str, str]) -> "AssetJoint":
        """Return the joint with its own name and its references to other joints renamed."""
        follows, needs = self.follows, self.needs
        if follows is not None:
            follows = replace(follows, leader=names.get(follows.leader, follows.leader))
        if needs is not None:
            needs = replace(needs, condition=needs.condition.renamed(names))
        return replace(self, name=names.get(self.name, self.name), follows=follows, needs=needs)


DYNAMICS = ("stiffness", "damping", "friction", "rest", "armature", "effort", "velocity")
"""Fields of a joint with one number each, in SI units."""
FEELS = (*DYNAMICS, "driven", "detents", "closing")
"""Fields of a joint that change its forces and not its motion."""


def is_number(value: object) -> bool:
    """Tell whether a value is a real number; booleans do not count."""
    return isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)


def rotation(axis: Array, angle: float) -> Array:
    """Return the rotation about a unit axis, shape (3, 3) (Rodrigues' formula)."""
    return _turned(_rotation_terms(axis), angle)


def _turned(terms: tuple[Array, Array, Array], angle: float) -> Array:
    one, cross, square = terms
    return np.asarray(one + _portable.sin(angle) * cross + (1.0 - _portable.cos(angle)) * square)


def _rotation_terms(axis: Array) -> tuple[Array, Array, Array]:
    """Return the terms of the rotation about a unit axis, see `AssetJoint.rotation_terms`."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3), cross, cross @ cross


def positions_of_followers(joints: Mapping[str, AssetJoint], q: dict[str, float]) -> dict[str, float]:
    """Return the given positions of free joints with the positions of coupled joints."""
    result = dict(q)
    for name in joints:
        couplings: dict[str, AssetCoupling] = {}
        current = name
        while current not in result:
            if current in couplings:
                raise AssetError(
                    f"the couplings of joints {', '.join(sorted(couplings))} form a circle; one must lead",
                    joint=current,
                )
            follows = joints[current].follows
            assert follows is not None, f"joint {current} has no position"
            couplings[current], current = follows, follows.leader
        for follower, coupling in reversed(couplings.items()):
            result[follower] = coupling.at(result[coupling.leader])
    return result


def joints_above(joints: Iterable[AssetJoint], link: str) -> list[AssetJoint]:
    """Return the joints between a link and the base, the nearest to the link first."""
    found: list[AssetJoint] = []
    while above := [joint for joint in joints if joint.child == link]:
        found += reversed(above)
        link = above[0].parent
    return found


@dataclass(frozen=True)
class AllowedContact(Record):
    """A contact that the category allows, between pieces of two links."""

    FIRST: ClassVar = ("links", "labels", "depth", "when")

    links: tuple[str, str]  # names of the two links
    labels: tuple[str, str]  # labels of the pieces on the first and on the second link
    depth: float  # largest allowed penetration [m]
    reason: str  # reason that the author gives
    # condition on the joints under which the contact is allowed; None: always
    when: AssetCondition | None = None

    def renamed(self, links: Mapping[str, str], joints: Mapping[str, str]) -> "AllowedContact":
        """Return the contact with renamed links and joints; names not in the mappings stay."""
        first, second = (links.get(name, name) for name in self.links)
        when = None if self.when is None else self.when.renamed(joints)
        return replace(self, links=(first, second), when=when)

    def __str__(self) -> str:
        (a, b), (first, second) = self.links, self.labels
        where = "" if self.when is None else f" where {self.when}"
        return f"{a}/{first} may press {1e3 * self.depth:.3g} mm into {b}/{second}{where}: {self.reason}"
