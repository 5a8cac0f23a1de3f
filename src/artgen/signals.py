"""Signals: numbers from 0 to 1 that follow from the motion of controls, for the outputs of a body.

    from artgen import signals
    on = signals.toggle(signals.pressed(button))
    body.output("bulb", on, kind="light", material=opal, color=(1.0, 0.85, 0.6))

`a & b` is the smaller and `a | b` the greater one of two signals, `~a` is 1 - a, `0.5 * a` is half of it. A
condition of joints, such as `door > 0.05`, is a signal, too: 1 where it holds. A signal rises when it passes
from below a half to above it. `asset.controller()` computes outputs over time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, ClassVar, Literal

from artgen._names import NAME_RULE, is_identifier
from artgen.asset import AssetCondition, AssetOutput, AssetSignal, Tree
from artgen.asset.signals import OutputKind
from artgen.errors import BuildError
from artgen.graph import Handle, kernel
from artgen.graph.node import authors_line
from artgen.nodes.handles import Scalar
from artgen.nodes.joint import Condition, Joint

__all__ = ["Signal", "latest", "level", "pressed", "timer", "toggle"]


class Signal(Handle):
    """A number from 0 to 1 that follows from the motion of joints."""

    __slots__ = ()
    value_type: ClassVar[Any] = AssetSignal

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Signal, or a Condition, which is 1 where it holds."""
        if isinstance(value, Condition):
            return cls.record("signal_where", condition=value).node
        return super().lift(value)

    def __and__(self, other: Signal | Condition) -> Signal:
        """Return the smaller one of two signals."""
        return Signal.record("signal_all", a=self, b=other)

    def __or__(self, other: Signal | Condition) -> Signal:
        """Return the greater one of two signals."""
        return Signal.record("signal_any", a=self, b=other)

    def __invert__(self) -> Signal:
        """Return 1 minus the signal."""
        return Signal.record("signal_not", a=self)

    def __mul__(self, factor: Scalar) -> Signal:
        """Scale the signal by a factor from 0 to 1."""
        return Signal.record("signal_scaled", a=self, factor=factor)

    __rand__, __ror__, __rmul__ = __and__, __or__, __mul__


@kernel
def _level(joint: str, ends: tuple[float, ...]) -> AssetSignal:
    return AssetSignal("level", joint, _ends(joint, ends))


@kernel
def _pressed(joint: str, ends: tuple[float, ...]) -> AssetSignal:
    return AssetSignal("pressed", joint, _ends(joint, ends))


def _ends(joint: str, ends: tuple[float, ...]) -> tuple[float, float] | None:
    if ends and (len(ends) != 2 or ends[0] == ends[1]):
        raise ValueError(f"ends of joint {joint!r} are {ends}; give two positions, at level 0 and 1")
    return (ends[0], ends[1]) if ends else None


@kernel
def _signal_where(condition: AssetCondition) -> AssetSignal:
    return AssetSignal("where", condition=condition)


@kernel(spelling="({a} & {b})")
def _signal_all(a: AssetSignal, b: AssetSignal) -> AssetSignal:
    return _joined("all", a, b)


@kernel(spelling="({a} | {b})")
def _signal_any(a: AssetSignal, b: AssetSignal) -> AssetSignal:
    return _joined("any", a, b)


def _joined(kind: Literal["all", "any"], *signals: AssetSignal) -> AssetSignal:
    """Return one flat signal of a chain such as `a | b | c`, so that a hundred keys are no deep tree."""
    terms = [part for each in signals for part in (each.terms or () if each.kind == kind else (each,))]
    return AssetSignal(kind, terms=tuple(terms))


@kernel(spelling="~{a}")
def _signal_not(a: AssetSignal) -> AssetSignal:
    return AssetSignal("not", terms=(a,))


@kernel(spelling="({factor} * {a})")
def _signal_scaled(a: AssetSignal, factor: float) -> AssetSignal:
    return AssetSignal("scaled", terms=(a,), factor=_share("the factor of a signal", factor))


@kernel
def _toggle(signal: AssetSignal, unless: AssetSignal | None) -> AssetSignal:
    return AssetSignal("toggle", terms=(signal,), unless=unless)


@kernel
def _timer(signal: AssetSignal, seconds: float, unless: AssetSignal | None) -> AssetSignal:
    if not seconds > 0.0:
        raise ValueError(f"a timer of {seconds:.6g} s never runs; give a positive time")
    return AssetSignal("timer", terms=(signal,), unless=unless, seconds=seconds)


@kernel
def _latest(
    signals: tuple[AssetSignal, ...], values: tuple[float, ...], unless: AssetSignal | None
) -> AssetSignal:
    if not signals or len(signals) != len(values):
        raise ValueError(f"latest has {len(signals)} signals and {len(values)} values; give a value for each")
    shares = tuple(_share("a value of latest", each) for each in values)
    return AssetSignal("latest", terms=signals, unless=unless, values=shares)


def _share(what: str, value: float) -> float:
    if not 0.0 <= value <= 1.0:
        raise ValueError(f"{what} is {value:.6g}; it must be from 0 to 1")
    return value


_COLORS = {"light": (1.0, 0.84, 0.62), "heat": (0.6, 0.045, 0.005)}
"""Emission of a warm white lamp and of a heating coil that glows, linear RGB."""


@kernel
def _output(
    body: Tree,
    name: str,
    signal: AssetSignal,
    kind: OutputKind,
    material: str | None,
    color: tuple[float, ...],
    joint: str | None,
    speed: float | None,
) -> Tree:
    if not is_identifier(name):
        raise ValueError(f"output name {name!r} is not allowed; use {NAME_RULE}")
    if color and (material is None or len(color) != 3 or not all(0.0 <= each <= 1.0 for each in color)):
        raise ValueError(
            f"output {name!r}: a material shines in a color of three numbers from 0 to 1: "
            "material=bulb, color=(1.0, 0.85, 0.6)"
        )
    if (joint is not None, speed is not None) != ((kind == "motor"),) * 2:
        raise ValueError(
            f"output {name!r}: a motor moves a joint at a speed: give kind='motor', moves=joint, speed=12.0"
        )
    shines = (color[0], color[1], color[2]) if color else _COLORS.get(kind, (1.0, 1.0, 1.0))
    made = AssetOutput(name, kind, signal, material, None if material is None else shines, joint, speed)
    return replace(body, outputs=(*body.outputs, made))


def level(joint: Joint | str, ends: tuple[Scalar, Scalar] | tuple[()] = ()) -> Signal:
    """Return the position of a control as a share of its range: 0 closed, 1 at its other limit.

    Args:
        joint: The joint, or the name that it has in the body.
        ends: Positions at level 0 and 1; by default 0, and the limit farthest from it [rad or m].

    Examples:
        >>> level(knob)
    """
    return Signal.record("level", joint=_name(joint), ends=ends)


def pressed(joint: Joint | str, ends: tuple[Scalar, Scalar] | tuple[()] = ()) -> Signal:
    """Return 1 from two thirds of the range of a control on, until it is back below a third.

    Args:
        joint: The joint, or the name that it has in the body.
        ends: Positions at level 0 and 1; by default 0, and the limit farthest from it [rad or m].

    Examples:
        >>> pressed(key)
    """
    return Signal.record("pressed", joint=_name(joint), ends=ends)


def _name(joint: Joint | str) -> str:
    if not isinstance(joint, Joint | str):
        raise BuildError(f"a signal reads a Joint, or the name of one, not {joint!r}\n  at {authors_line()}")
    return joint if isinstance(joint, str) else joint.name


def toggle(signal: Signal | Condition, *, unless: Signal | Condition | None = None) -> Signal:
    """Return a signal that changes between 0 and 1 whenever another one rises.

    Args:
        signal: The signal that rises.
        unless: Signal that switches it off and keeps it off, such as an open door.

    Examples:
        >>> toggle(pressed(key), unless=door > 0.05)
    """
    return Signal.record("toggle", signal=signal, unless=unless)


def timer(signal: Signal | Condition, seconds: Scalar, *, unless: Signal | Condition | None = None) -> Signal:
    """Return a signal that is 1 for a time whenever another one rises.

    Args:
        signal: The signal that rises, and starts the time again.
        seconds: The time [s].
        unless: Signal that ends the time, such as an open door.

    Examples:
        >>> timer(pressed(key), 30.0, unless=(door > 0.05) | pressed(stop))
    """
    return Signal.record("timer", signal=signal, seconds=seconds, unless=unless)


def latest(
    signals: Sequence[Signal | Condition],
    values: Sequence[Scalar],
    *,
    unless: Signal | Condition | None = None,
) -> Signal:
    """Return the value of the signal that rose last, 0 before any did: keys for off, low and high.

    Args:
        signals: The signals.
        values: The value of each, from 0 to 1.
        unless: Signal that sets the value to 0.

    Examples:
        >>> latest([pressed(off), pressed(low), pressed(high)], [0.0, 0.4, 1.0])
    """
    return Signal.record("latest", signals=tuple(signals), values=tuple(values), unless=unless)
