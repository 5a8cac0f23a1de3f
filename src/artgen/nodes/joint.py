"""Joints, couplings between them, conditions on their positions, and dependencies on conditions."""

from __future__ import annotations

import inspect
import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from typing import Any, ClassVar, Literal, NoReturn

import numpy as np

from artgen._names import NAME_RULE, is_identifier
from artgen.asset import (
    AssetCondition,
    AssetCoupling,
    AssetDependency,
    AssetDetents,
    AssetJoint,
    AssetSignal,
    AssetSoftClosing,
)
from artgen.errors import BuildError
from artgen.graph import Handle, kernel
from artgen.graph.node import authors_line
from artgen.nodes.handles import Array3, Float, Scalar, VectorLike
from artgen.nodes.vector import unit

Kind = Literal["revolute", "prismatic"]
_WIDEST = 3.0  # range of a turn that closes softly: a cord around its axis takes the shorter way [rad]


class Condition(Handle):
    """A region of joint space, such as `(turn > 1.0) & (slide < 0.02)`."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetCondition

    def __and__(self, other: Condition) -> Condition:
        """Intersect two regions; with a signal, return the smaller one, see `artgen.signals`."""
        if getattr(other, "value_type", None) is AssetSignal:
            return NotImplemented
        return Condition.record("condition_all", a=self, b=other)

    def __or__(self, other: Condition) -> Condition:
        """Unite two regions; with a signal, return the greater one, see `artgen.signals`."""
        if getattr(other, "value_type", None) is AssetSignal:
            return NotImplemented
        return Condition.record("condition_any", a=self, b=other)

    def __invert__(self) -> NoReturn:
        """Raise BuildError: the opposite of a condition is written as one."""
        raise BuildError(
            "~ on a condition of joints: write the opposite comparison, such as (turn < 0.5) for "
            f"~(turn > 0.5)\n  at {authors_line()}"
        )

    def until(self, position: Scalar) -> Dependency:
        """Limit the dependency to positions of the dependent joint below a value [rad or m]."""
        return Dependency.record("dependency", condition=self, until=position)

    def beyond(self, position: Scalar) -> Dependency:
        """Limit the dependency to positions of the dependent joint beyond a value [rad or m].

        Up to the value the joint is free, like a drawer that is slightly behind a door.
        """
        return Dependency.record("dependency_beyond", needs=self, position=position)


class Dependency(Handle):
    """Condition under which a joint may leave its closed position, such as `(turn > 1.0).until(0.03)`."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetDependency

    def until(self, position: Scalar) -> Dependency:
        """Limit the dependency to positions of the dependent joint below a value [rad or m]."""
        return Dependency.record("dependency_until", needs=self, position=position)

    def beyond(self, position: Scalar) -> Dependency:
        """Limit the dependency to positions of the dependent joint beyond a value [rad or m]."""
        return Dependency.record("dependency_beyond", needs=self, position=position)

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Dependency, or a Condition that is always required."""
        if isinstance(value, Condition):
            return Dependency.record("dependency", condition=value, until=None).node
        return super().lift(value)


@kernel
def _joint_above(joint: str, position: float) -> AssetCondition:
    return AssetCondition("above", joint, position)


@kernel
def _joint_below(joint: str, position: float) -> AssetCondition:
    return AssetCondition("below", joint, position)


@kernel(spelling="({a} & {b})")
def _condition_all(a: AssetCondition, b: AssetCondition) -> AssetCondition:
    return AssetCondition("all", terms=(a, b))


@kernel(spelling="({a} | {b})")
def _condition_any(a: AssetCondition, b: AssetCondition) -> AssetCondition:
    return AssetCondition("any", terms=(a, b))


@kernel
def _dependency(condition: AssetCondition, until: float | None) -> AssetDependency:
    return _checked(AssetDependency(condition, until))


@kernel(spelling="{needs}.until({position})")
def _dependency_until(needs: AssetDependency, position: float) -> AssetDependency:
    if needs.until is not None:
        raise ValueError(f"until is given twice: {needs.until:.6g} and {position:.6g}")
    return _checked(replace(needs, until=position))


@kernel(spelling="{needs}.beyond({position})")
def _dependency_beyond(needs: AssetDependency, position: float) -> AssetDependency:
    if needs.beyond is not None:
        raise ValueError(f"beyond is given twice: {needs.beyond:.6g} and {position:.6g}")
    return _checked(replace(needs, beyond=position))


def _checked(needs: AssetDependency) -> AssetDependency:
    """Return a dependency with checked positions."""
    if needs.until is not None and needs.until <= 0.0:
        raise ValueError(f"until must be positive, got {needs.until:.6g}: no condition applies at position 0")
    if needs.beyond is not None and needs.beyond <= 0.0:
        raise ValueError(
            f"beyond must be positive, got {needs.beyond:.6g}: leave it out if the condition applies "
            "from position 0"
        )
    if needs.until is not None and needs.beyond is not None and needs.until <= needs.beyond:
        raise ValueError(
            f"beyond {needs.beyond:.6g} must be below until {needs.until:.6g}: the condition applies "
            "between them"
        )
    return needs


class Detents(Handle):
    """Positions at which a joint clicks into place; `artgen.feel.detents` makes them."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetDetents


@kernel
def _detents(positions: tuple[float, ...], torque: float) -> AssetDetents:
    places = ", ".join(f"{each:.6g}" for each in positions)
    if not positions or any(high - low < 1e-6 for low, high in pairwise(positions)):
        raise ValueError(f"the positions of detents are {places or 'missing'}: give them from low to high")
    if not torque > 0.0:
        raise ValueError(f"the torque of detents is {torque:.6g}: it must be positive [N m or N]")
    return AssetDetents(positions, torque)


def detents(positions: int | Sequence[Scalar], torque: Scalar) -> Detents:
    """Make the detents of a joint, at which it clicks into place, for `detents=` of a joint.

    Two positions, at both limits or a little beyond them, make a bistable joint, such as a rocker switch: it
    snaps to one of its ends. A turn without limits has the first position after the last one.

    Args:
        positions: Positions from low to high [rad or m]; or a number of equal steps of a whole turn from 0
            on, for a revolute joint without limits.
        torque: Greatest torque or force, halfway between two positions; friction is additional [N m or N].

    Raises:
        BuildError: There are no positions, their order is wrong, or the torque is not positive.

    Examples:
        >>> panel = part(box(0.06, 0.02, 0.06), "panel", material("abs"))
        >>> knob = part(cylinder(0.015, 0.016, axis=Y).at(y=-0.0185), "knob", material("black_abs"))
        >>> panel.attach(knob, Revolute("turn", axis=Y, detents=detents(9, torque=0.04), friction=0.01))
    """
    if isinstance(positions, int):
        positions = [math.tau * number / positions for number in range(positions)]
    return Detents.record("detents", positions=tuple(positions), torque=torque)


class SoftClosing(Handle):
    """Damper and spring near the closed position of a joint; `artgen.feel.soft_closing` makes them."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetSoftClosing


@kernel
def _soft_closing(reach: float, preload: float, force: float, damping: float) -> AssetSoftClosing:
    if preload < 0.0 or force < preload or (force == preload) != (force == 0.0):
        raise ValueError(
            f"the spring of a soft closing has preload {preload:.6g} and force {force:.6g}: its force grows "
            "from the closed position to the reach; both are 0 for a damper alone [N m or N]"
        )
    if not damping > 0.0:
        raise ValueError(f"the damping of a soft closing is {damping:.6g}: it must be positive")
    return AssetSoftClosing(reach, preload, force, damping)


def soft_closing(
    reach: Scalar, *, damping: Scalar, preload: Scalar = 0.0, force: Scalar = 0.0
) -> SoftClosing:
    """Make a damper and a spring that close a joint softly, for `closing=` of a joint.

    They act from `reach` to the closed position, which is one of the limits: released there, the part is
    drawn home slowly; farther open it stays, or falls freely. A damper of a runner or of a hinge brakes only
    the way home; formats damp both ways, so a hand that opens also feels it up to `reach`. The numbers are
    those of catalogs: slides with a damped self-retraction are drawn home over the last 40 mm by 35 N for a
    pair, undamped ones over 22 mm by 30 N (telescopic slides, catalog of Berger); rotary dampers of toilet
    seats take 3-4 N m and are tested by a fall from 70 or 85 degrees (TOK TD100, TD129; NF D12-207).

    Args:
        reach: Position at which they begin to act, between both limits [rad or m].
        damping: Viscous damping, additional to that of the joint [N m s/rad or N s/m].
        preload: Force of the spring at the closed position; more than the friction of the joint [N m or N].
        force: Force of the spring at `reach`, more than `preload`; both are 0 for a damper alone [N m or N].

    Raises:
        BuildError: The forces do not grow, or the damping is not positive.

    Examples:
        >>> case = part(shell(box(0.3, 0.2, 0.1), 0.01, open=-Y), "case", material("walnut"))
        >>> drawer = part(box(0.27, 0.18, 0.07).at(y=-0.01), "drawer", material("oak"))
        >>> soft = soft_closing(0.04, preload=15, force=30, damping=400)
        >>> case.attach(drawer, Prismatic("slide", axis=-Y, limits=(0, 0.15), friction=5, closing=soft))
    """
    return SoftClosing.record("soft_closing", reach=reach, preload=preload, force=force, damping=damping)


class _Leader(Handle):
    """Arithmetic of joints and couplings; it makes couplings for followers."""

    __slots__ = ()

    def __mul__(self, ratio: Scalar) -> Coupling:
        """Multiply the ratio of the follower."""
        return Coupling.record("coupling_scale", coupling=self, factor=ratio)

    def __add__(self, offset: Scalar) -> Coupling:
        """Shift the follower [rad or m]."""
        return Coupling.record("coupling_shift", coupling=self, by=offset)

    def __sub__(self, offset: Scalar) -> Coupling:
        """Shift the follower back [rad or m]."""
        return self + (-offset)

    def __rsub__(self, offset: Scalar) -> Coupling:
        """Reverse the follower and shift it [rad or m]."""
        return -self + offset

    def __truediv__(self, divisor: Scalar) -> Coupling:
        """Divide the ratio of the follower."""
        return self * Float.record("divide", a=1.0, b=divisor)

    def __neg__(self) -> Coupling:
        """Reverse the follower."""
        return self * -1.0

    def __radd__(self, offset: Scalar) -> Coupling:
        """Shift the follower [rad or m]."""
        return self + offset

    def __rmul__(self, ratio: Scalar) -> Coupling:
        """Multiply the ratio of the follower."""
        return self * ratio


class Coupling(_Leader):
    """Law of a joint that follows another: `ratio * leader + offset`, such as `0.04 * turn + 0.005`."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetCoupling

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Coupling, or a Joint that is followed with ratio 1."""
        return (1.0 * value).node if isinstance(value, Joint) else super().lift(value)


class Joint(_Leader):
    """A joint for `attach`. Its arithmetic makes couplings, its comparisons make conditions.

    Examples:
        >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
        >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
        >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
        >>> dial = part(cylinder(0.02, 0.01).at(-0.08, 0, 0.032), "dial", material("copper"))
        >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
        >>> needs = (turn > 1.0).until(0.04).beyond(0.01)
        >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=needs)
        >>> follower = Revolute("dial_turn", pivot=(-0.08, 0, 0), axis=Z, follows=0.5 * turn + 0.1)
        >>> case.attach(lever, turn).attach(bolt, slide).attach(dial, follower)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = AssetJoint

    @property
    def name(self) -> str:
        """The joint's name."""
        name: str = self.node.inputs["name"]
        return name

    @property
    def steps(self) -> tuple[Joint, ...]:
        """The joints of one degree of freedom that make the motion; the first one leads."""
        return (self,)

    def __mul__(self, ratio: Scalar) -> Coupling:
        """Make a coupling with a ratio to this joint."""
        return Coupling.record("coupling", leader=self.name, ratio=ratio, offset=0.0)

    def __gt__(self, position: Scalar) -> Condition:
        """Make the condition that the position of this joint is above a value [rad or m]."""
        return Condition.record("joint_above", joint=self.name, position=position)

    def __lt__(self, position: Scalar) -> Condition:
        """Make the condition that the position of this joint is below a value [rad or m]."""
        return Condition.record("joint_below", joint=self.name, position=position)

    __ge__, __le__ = __gt__, __lt__

    def gear(self, ratio: Scalar, *, reverse: bool = True) -> Coupling:
        """Make the law of a gear that meshes with one on this revolute joint, for `follows=`.

        Args:
            ratio: Teeth of this gear, divided by those of the other one; positive.
            reverse: Whether parallel axes turn in opposite senses, as those of outer gears do; False for a
                ring gear, a belt or a chain.

        Raises:
            BuildError: This joint slides, or the ratio is not positive.

        Examples:
            >>> case = part(box(0.2, 0.1, 0.01), "case", material("walnut"))
            >>> large = part(cylinder(0.04, 0.01).at(-0.04, 0, 0.012), "large", material("brass"))
            >>> small = part(cylinder(0.02, 0.01).at(0.0225, 0, 0.012), "small", material("steel"))
            >>> turn = Revolute("turn", axis=Z, pivot=(-0.04, 0, 0), limits=(0, 1))
            >>> spin = Revolute("spin", axis=Z, pivot=(0.0225, 0, 0), follows=turn.gear(36 / 18))
            >>> case.attach(large, turn).attach(small, spin)
        """
        return Gear.record("gear", leader=self._turning("gear"), ratio=ratio, reverse=reverse)

    def rack(self, radius: Scalar) -> Coupling:
        """Make the law of a rack that meshes with a pinion on this revolute joint, for `follows=`.

        Args:
            radius: Pitch radius of the pinion, half of its teeth times the module; negative for a rack that
                slides against its axis [m].

        Raises:
            BuildError: This joint slides, or the radius is 0.

        Examples:
            >>> bed = part(box(0.2, 0.1, 0.01), "bed", material("walnut"))
            >>> pinion = part(cylinder(0.012, 0.01).at(z=0.012), "pinion", material("brass"))
            >>> bar = part(box(0.1, 0.01, 0.01).at(0, -0.02, 0.012), "rack", material("steel"))
            >>> turn = Revolute("turn", axis=Z, limits=(0, 2))
            >>> slide = Prismatic("slide", axis=X, follows=turn.rack(radius=0.0125))
            >>> bed.attach(pinion, turn).attach(bar, slide)
        """
        return Rack.record("rack", leader=self._turning("rack"), radius=radius)

    def _turning(self, mechanism: str) -> str:
        """Return the name of this joint, which has to turn."""
        if self.node.inputs.get("kind") != "revolute":
            raise BuildError(
                f"{self.name!r} slides, but a {mechanism} is driven by a joint that turns\n"
                f"  at {authors_line()}\n  Take a Revolute joint, or a ratio: follows=2.0 * {self.name}"
            )
        return self.name


class Gear(Coupling):
    """Law of a revolute joint whose gear meshes with that of its leader, from `Joint.gear`."""

    __slots__ = ()


class Rack(Coupling):
    """Law of a prismatic joint whose rack meshes with the pinion of its leader, from `Joint.rack`."""

    __slots__ = ()


_KINDS: dict[type, Kind] = {Gear: "revolute", Rack: "prismatic"}  # of the joints that such laws move


@kernel
def _gear(leader: str, ratio: float, reverse: bool) -> AssetCoupling:
    if not ratio > 0.0:
        raise ValueError(
            f"the gear driven by {leader!r} has ratio {ratio:.6g}: teeth of the leader / teeth of the "
            "follower must be positive; reverse=False turns it in the sense of the leader"
        )
    return AssetCoupling(leader, -ratio if reverse else ratio)


@kernel
def _rack(leader: str, radius: float) -> AssetCoupling:
    if radius == 0.0:
        raise ValueError(
            f"the rack driven by {leader!r} has radius 0: give the pitch radius of its pinion [m]"
        )
    return AssetCoupling(leader, radius)


@kernel
def _coupling(leader: str, ratio: float, offset: float) -> AssetCoupling:
    if ratio == 0.0:
        raise ValueError(
            f"a coupling to {leader!r} with ratio 0 does not move the joint; lock the joint instead"
        )
    return AssetCoupling(leader, ratio, offset)


@kernel(spelling="({coupling} + {by})")
def _coupling_shift(coupling: AssetCoupling, by: float) -> AssetCoupling:
    return AssetCoupling(coupling.leader, coupling.ratio, coupling.offset + by)


@kernel(spelling="({coupling} * {factor})")
def _coupling_scale(coupling: AssetCoupling, factor: float) -> AssetCoupling:
    return _coupling(coupling.leader, coupling.ratio * factor, coupling.offset * factor)


@kernel
def _joint(
    name: str,
    kind: Kind,
    pivot: Array3,
    axis: Array3,
    limits: tuple[float, float] | None,
    stiffness: float,
    damping: float,
    friction: float,
    rest: float,
    armature: float,
    effort: float,
    velocity: float,
    follows: AssetCoupling | None,
    needs: AssetDependency | None,
    driven: str,
    detents: AssetDetents | None,
    closing: AssetSoftClosing | None,
) -> AssetJoint:
    if not is_identifier(name):
        raise ValueError(f"joint name {name!r} is no identifier; use {NAME_RULE}")
    if limits is not None and limits[0] > limits[1]:
        raise ValueError(
            f"joint {name!r} has limits {limits[0]:.6g} to {limits[1]:.6g}: the lower one comes first"
        )
    if follows is not None and limits is not None:
        raise ValueError(
            f"joint {name!r} follows {follows.leader!r}, which gives it its range; leave its limits out"
        )
    beyond = None if needs is None else needs.beyond
    if limits is not None and beyond is not None and beyond >= max(map(abs, limits)):
        raise ValueError(
            f"joint {name!r} has limits {limits[0]:.6g} to {limits[1]:.6g}: it never moves beyond "
            f"{beyond:.6g}; leave needs out, or take a position within the limits"
        )
    made = AssetJoint(
        name,
        kind,
        unit(np.asarray(axis)),
        np.asarray(pivot),
        limits,
        stiffness=stiffness,
        damping=damping,
        friction=friction,
        rest=rest,
        armature=armature,
        effort=effort,
        velocity=velocity,
        follows=follows,
        needs=needs,
        driven=driven,
        detents=detents,
        closing=closing,
    )
    _check_detents(made)
    _check_closing(made)
    for field in ("stiffness", "damping", "friction", "armature"):
        if getattr(made, field) < 0.0:
            hint = "; the force of a Spring must be above its preload" if field == "stiffness" else ""
            raise ValueError(f"joint {name!r}: {field} {getattr(made, field):.6g} must not be negative{hint}")
    for field in ("effort", "velocity"):
        if getattr(made, field) <= 0.0:
            raise ValueError(f"joint {name!r}: {field} {getattr(made, field):.6g} must be positive")
    return made


def _check_detents(joint: AssetJoint) -> None:
    if joint.detents is None:
        return
    start, *_, end = (*joint.detents.positions, joint.detents.positions[-1])
    turns, ring = joint.kind == "revolute", joint.limits is None and joint.kind == "revolute"
    if joint.follows is not None or joint.locked:
        raise ValueError(
            f"joint {joint.name!r} has detents, but does not move by itself; give them its leader"
        )
    if turns and end - start > math.tau - (1e-6 if ring else 0.0):
        raise ValueError(
            f"joint {joint.name!r} has detents from {start:.6g} to {end:.6g} rad: they must lie in one turn"
        )
    low, high = joint.limits or (-math.inf, math.inf)
    if not ring and not any(low < ridge < high for ridge, _ in joint.ridges):
        raise ValueError(
            f"joint {joint.name!r} has limits {low:.6g} to {high:.6g} and no two detents around a position "
            f"between them: its detents are {', '.join(f'{each:.6g}' for each in joint.detents.positions)}"
        )


def _check_closing(joint: AssetJoint) -> None:
    if joint.closing is None:
        return
    if joint.follows is not None or joint.locked:
        raise ValueError(
            f"joint {joint.name!r} closes softly, but does not move by itself; give that to its leader"
        )
    low, high = joint.limits or (-math.inf, math.inf)
    if not low < joint.closing.reach < high or joint.closed not in (low, high):
        raise ValueError(
            f"joint {joint.name!r} has limits {low:.6g} to {high:.6g} and closes softly from "
            f"{joint.closing.reach:.6g} to {joint.closed:.6g}: it closes at a limit, from before the other"
        )
    if joint.kind == "revolute" and high - low > _WIDEST:
        raise ValueError(
            f"joint {joint.name!r} closes softly and turns by {high - low:.6g} rad: by {_WIDEST:g} at most"
        )


@dataclass(frozen=True, kw_only=True)
class Spring:
    """A spring at a joint, given by its forces at both limits, or by its stiffness and rest.

    Args:
        preload: Force at the lower limit, towards it; more than the weight that it carries [N or N m].
        force: Force at the upper limit [N or N m].
        stiffness: Stiffness, in place of the forces [N/m or N m/rad].
        rest: Position at which the spring is relaxed, with `stiffness` [m or rad].

    Raises:
        BuildError: Neither both forces nor a stiffness are given, or both are.

    Examples:
        >>> panel = part(box(0.06, 0.02, 0.06), "panel", material("abs"))
        >>> key = part(cylinder(0.008, 0.006, axis=Y).at(y=-0.0135), "key", material("black_abs"))
        >>> spring = Spring(preload=0.6, force=3.0)
        >>> panel.attach(key, Prismatic("press", axis=Y, limits=(0, 0.002), spring=spring))
    """

    preload: Scalar | None = None
    force: Scalar | None = None
    stiffness: Scalar | None = None
    rest: Scalar = 0.0

    def __post_init__(self) -> None:
        """Check that the spring is given in one of both ways."""
        given = [name for name in ("preload", "force", "stiffness") if getattr(self, name) is not None]
        if given not in (["preload", "force"], ["stiffness"]):
            raise BuildError(
                "Spring needs the forces at both limits or a stiffness, got "
                f"{' and '.join(given) or 'neither'}; preload and force exclude stiffness and rest: write "
                "Spring(preload=0.6, force=3.0), or "
                f"Spring(stiffness=800.0, rest=-0.001)\n  at {authors_line()}"
            )
        preload, force = (getattr(each, "node", each) for each in (self.preload, self.force))
        if isinstance(preload, float | int) and isinstance(force, float | int) and force <= preload:
            raise BuildError(
                f"Spring(preload={preload:.6g}, force={force:.6g}) has no stiffness: force, at the upper "
                f"limit, must be above preload, at the lower limit\n  at {authors_line()}"
            )

    def inputs(self, limits: tuple[Scalar, Scalar] | None) -> tuple[Scalar, Scalar]:
        """Return stiffness and rest for the limits of a joint."""
        if self.preload is None or self.force is None:
            return (0.0 if self.stiffness is None else self.stiffness), self.rest
        if limits is None:
            raise BuildError(
                "a joint without limits has no forces at its limits: give Spring(stiffness=..., rest=...)\n"
                f"  at {authors_line()}"
            )
        stiffness = (self.force - self.preload) / (limits[1] - limits[0])
        return stiffness, limits[0] - self.preload / stiffness


@dataclass(frozen=True, kw_only=True)
class Feel:
    """Resistance of a kind of joint, for `feel=`; presets with their sources are in `artgen.feel`.

    Args:
        damping: Viscous damping [N s/m or N m s/rad].
        friction: Dry friction [N or N m].
        armature: Additional inertia of the mechanism [kg or kg m^2].
        effort: Largest force of a hand or an actuator [N or N m].
        velocity: Largest speed; by default that of the joint [m/s or rad/s].
    """

    damping: Scalar = 0.0
    friction: Scalar = 0.0
    armature: Scalar = 0.0
    effort: Scalar = 100.0
    velocity: Scalar | None = None


_PLAIN = Feel()
_WRITTEN: dict[type, str] = {
    Feel: "write a preset, as feel=artgen.feel.HINGE",
    Spring: "write spring=artgen.Spring(...), or stiffness= and rest=",
}


class _Axial(Joint):
    """A joint that moves about or along an axis."""

    __slots__ = ()
    _kind: ClassVar[Kind]
    _velocity: ClassVar[float]  # default [rad/s or m/s]

    def __init__(
        self,
        name: str,
        *,
        axis: VectorLike,
        pivot: VectorLike = (0.0, 0.0, 0.0),
        limits: tuple[Scalar, Scalar] | None = None,
        spring: Spring | None = None,
        feel: Feel = _PLAIN,
        stiffness: Scalar = 0.0,
        damping: Scalar | None = None,
        friction: Scalar | None = None,
        rest: Scalar = 0.0,
        armature: Scalar | None = None,
        effort: Scalar | None = None,
        velocity: Scalar | None = None,
        follows: Coupling | Joint | None = None,
        needs: Condition | Dependency | None = None,
        driven: str = "",
        detents: Detents | None = None,
        closing: SoftClosing | None = None,
    ) -> None:
        inputs = {
            key: value
            for key, value in locals().items()
            if key not in ("self", "__class__", "spring", "feel")
        }
        for what, value, kind in (("spring", spring, Spring), ("feel", feel, Feel)):
            if value is not None and not isinstance(value, kind):
                raise BuildError(
                    f"joint(..., {what}=...) needs a {kind.__name__}, got {value!r}; {_WRITTEN[kind]}\n"
                    f"  at {authors_line()}"
                )
        if _KINDS.get(type(follows), self._kind) != self._kind:
            meshes = (
                "a gear turns: use Revolute" if isinstance(follows, Gear) else "a rack slides: use Prismatic"
            )
            raise BuildError(f"joint {name!r} follows the wrong kind of law: {meshes}\n  at {authors_line()}")
        if spring is not None:
            inputs["stiffness"], inputs["rest"] = spring.inputs(limits)
        for field in fields(feel):
            if inputs[field.name] is None:
                inputs[field.name] = getattr(feel, field.name)
        if inputs["velocity"] is None:
            inputs["velocity"] = self._velocity
        super().__init__(Joint.record("joint", kind=self._kind, **inputs).node)


_Axial.__init__.__qualname__ = "Revolute, Prismatic"  # Python names it where `axis` is missing


class Revolute(_Axial):
    """A joint that rotates about an axis, counter-clockwise when the axis points to the viewer.

    Args:
        name: Identifier, unique in the asset.
        axis: Direction of the axis in asset coordinates.
        pivot: A point on the axis in asset coordinates at rest [m].
        limits: Lowest and highest angle [rad]; equal limits lock the joint, None is unlimited.
        spring: Spring that returns the joint; it replaces `stiffness` and `rest`.
        feel: Damping, friction, armature, effort and velocity of a kind of joint, such as `feel.HINGE`.
        stiffness: Stiffness of a spring towards `rest` [N m/rad].
        damping: Viscous damping [N m s/rad].
        friction: Dry friction [N m].
        rest: Angle at which the spring is relaxed; outside the limits for a preloaded spring [rad].
        armature: Additional inertia at the joint [kg m^2].
        effort: Largest torque of an actuator; 100 by default [N m].
        velocity: Largest speed; 10 rad/s by default.
        follows: Coupling to another joint, such as `4.0 * pedal + 0.02`; it determines the limits.
        needs: Condition under which the joint may leave 0, such as `handle > 0.5`; `(handle >
            0.5).until(0.06)` applies only below 0.06, `(door > 1.2).beyond(0.03)` only beyond 0.03.
        driven: Actuator that moves the joint, such as `a motor`; grasp checks are skipped.
        detents: Positions at which the joint clicks into place, from `artgen.feel.detents`.
        closing: Damper and spring near the closed position, from `artgen.feel.soft_closing`.

    Examples:
        >>> lid = part(box(0.3, 0.2, 0.01), "lid", material("oak"))
        >>> case = part(box(0.3, 0.2, 0.1).at(z=-0.057), "case", material("walnut"))
        >>> case.attach(lid, Revolute("hinge", pivot=(0, 0.1, -0.006), axis=-X, limits=(0, 1.5)))
    """

    __slots__ = ()
    _kind, _velocity = "revolute", 10.0


class Prismatic(_Axial):
    """A joint that slides along an axis.

    Args:
        name: Identifier, unique in the asset.
        axis: Direction of the slide in asset coordinates.
        limits: Lowest and highest position [m]; equal limits lock the joint, None is unlimited.
        pivot: Origin of the joint's frame in asset coordinates at rest [m].
        spring: Spring that returns the joint; it replaces `stiffness` and `rest`.
        feel: Damping, friction, armature, effort and velocity of a kind of joint, such as `feel.SWITCH`.
        stiffness: Stiffness of a spring towards `rest` [N/m].
        damping: Viscous damping [N s/m].
        friction: Dry friction [N].
        rest: Position at which the spring is relaxed; outside the limits for a preloaded spring [m].
        armature: Additional mass at the joint [kg].
        effort: Largest force of an actuator; 100 by default [N].
        velocity: Largest speed; 1 m/s by default.
        follows: Coupling to another joint, such as `0.02 * handle`; it determines the limits.
        needs: Condition under which the joint may leave 0, such as `door > 1.2`; `(door > 1.2).beyond(0.03)`
            applies only beyond 0.03, `(door > 1.2).until(0.3)` only below 0.3.
        driven: Actuator that moves the joint, such as `a motor`; grasp checks are skipped.
        detents: Positions at which the joint clicks into place, from `artgen.feel.detents`.
        closing: Damper and spring near the closed position, from `artgen.feel.soft_closing`.

    Examples:
        >>> case = part(shell(box(0.3, 0.2, 0.1), 0.01, open=-Y), "case", material("walnut"))
        >>> drawer = part(box(0.27, 0.18, 0.07).at(y=-0.01), "drawer", material("oak"))
        >>> case.attach(drawer, Prismatic("slide", axis=-Y, limits=(0, 0.15)))
    """

    __slots__ = ()
    _kind, _velocity = "prismatic", 1.0


class Screw(Revolute):
    """A joint that turns and advances together along a thread: one degree of freedom, the angle.

    It becomes two joints on one pair of links: a revolute joint, and the prismatic joint `{name}_rise`, which
    follows it. The certificate, the formats and the simulators treat it as any coupling.

    Args:
        name: Identifier, unique in the asset, as is `{name}_rise`.
        pitch: Advance along the axis in a turn; positive for a right-hand thread, negative for a left-hand
            one; for several starts, the lead [m].
        axis: Direction of the axis in asset coordinates; a positive angle advances along it.
        limits: Lowest and highest angle, which may be several turns [rad].
        **options: Other keywords of `Revolute`.

    Raises:
        BuildError: The pitch is 0.

    Examples:
        >>> jar = part(cylinder(0.03, 0.1), "jar", material("glass"))
        >>> cap = part(cylinder(0.032, 0.015).at(z=0.058), "cap", material("steel"))
        >>> jar.attach(cap, Screw("cap_turn", pitch=0.006, axis=Z, limits=(0, 1.6)))
    """

    __slots__ = ("_rise",)

    def __init__(
        self, name: str, *, pitch: Scalar, axis: VectorLike, limits: tuple[Scalar, Scalar], **options: Any
    ) -> None:
        super().__init__(name, axis=axis, limits=limits, **options)
        if not isinstance(pitch, Handle) and pitch == 0.0:
            raise BuildError(
                f"Screw({name!r}, pitch=0) would not advance\n  at {authors_line()}\n"
                "  Use Revolute, or give the advance in a turn [m]: pitch=0.004"
            )
        ratio = Float.record("divide", a=pitch, b=2.0 * math.pi)
        pivot = options.get("pivot", (0.0, 0.0, 0.0))
        self._rise = Prismatic(f"{name}_rise", axis=axis, pivot=pivot, follows=ratio * self)

    @property
    def steps(self) -> tuple[Joint, ...]:
        """The turn and the rise that follows it."""
        return (self, self._rise)


def joint(name: str, kind: Kind, **options: Any) -> Revolute | Prismatic:
    """Make a joint of either kind; `options` are the keywords of `Revolute` and `Prismatic`."""
    return (Revolute if kind == "revolute" else Prismatic)(name, **options)


_NAME, *_OPTIONS = (
    each.replace(default=getattr(_PLAIN, each.name)) if hasattr(_PLAIN, each.name) else each
    for each in inspect.signature(Revolute).parameters.values()
    if each.name not in ("spring", "feel")
)
joint.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
    [_NAME, inspect.signature(joint).parameters["kind"], *_OPTIONS]
)
