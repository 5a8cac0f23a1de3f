"""Parameters in use and free joints as data for any user interface, and the motion of joints."""

import math
import typing
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from artgen.asset import Asset, AssetCondition
from artgen.export.frames import leader_of
from artgen.generator import Parameter
from artgen.generator.parameter import is_variant
from artgen.materials import Material
from artgen.nodes.handles import Bool, Float, Vector
from artgen.sampling import Distribution
from artgen.sampling.choices import By, Choice
from artgen.sampling.distributions import is_number, shown

Kind = Literal["slider", "number", "menu", "checkbox", "vector", "text"]

_STEPS = 400  # least number of steps of a slider
_ROOM = 0.5  # range of a joint without limits in each direction [m]
_NUDGE = 1e-9  # distance beyond the threshold of a dependency [rad or m]


@dataclass(frozen=True)
class StudioControl:
    """Control of a parameter that the asset uses, or of a joint that can move."""

    name: str  # full name of a parameter with generators, `handle.lever_handle.length`; or name of a joint
    short: str  # name in the parameters of an asset, `handle.length`; or name of a joint
    kind: Kind  # kind of its control
    value: Any  # current value: a number, True or False, text, or three numbers
    hint: (
        str  # of a parameter: description, distribution, hard limits; of a joint: links, limits, dependencies
    )
    unit: str = ""  # unit, such as `m`; empty for none
    low: float | None = None  # smallest value of a slider, and of a number with hard limits
    high: float | None = None  # largest value
    step: float = 0.0  # step of a slider or number
    options: tuple[str, ...] = ()  # options of a menu
    follows: bool = False  # whether another joint moves this joint

    @property
    def group(self) -> str:
        """Prefix of the name: the parameter and the generator that it belongs to, if any."""
        return self.name.rpartition(".")[0]

    @property
    def shape(self) -> tuple[Any, ...]:
        """All fields except the value; when they change, a user interface builds the control again."""
        return (self.name, self.kind, self.hint, self.low, self.high, self.options, self.follows)


def parameters_in_use(
    own: Mapping[str, Parameter], values: Mapping[str, Any], short: str = "", full: str = ""
) -> Iterator[StudioControl]:
    """Yield a control for each used parameter of a generator, in order.

    Args:
        own: Parameters of the generator.
        values: Parameters of the asset.
        short: Prefix of their names in `values`; empty for the category itself.
        full: Prefix of their names with generators.
    """
    for name, parameter in own.items():
        value = values[short + name]
        siblings = {sibling: values[short + sibling] for sibling in own}
        yield _control(
            Parameter(full + name, parameter.kind, parameter.distribution), short + name, value, siblings
        )
        chosen = next((item for item in parameter.variants if item.name == value), None)
        if chosen is not None:
            yield from parameters_in_use(
                chosen.own, values, f"{short}{name}.", f"{full}{name}.{chosen.name}."
            )


def _control(parameter: Parameter, short: str, value: Any, siblings: Mapping[str, Any]) -> StudioControl:
    distribution = parameter.distribution
    drawn = _drawn(distribution, siblings)
    hint = _hint(distribution, drawn)
    control = StudioControl(parameter.name, short, "text", str(value), hint, distribution.unit)
    options = _options(parameter, drawn, value)
    if parameter.kind in (Bool, bool):
        return replace(control, kind="checkbox", value=bool(value))
    if options:
        return replace(control, kind="menu", options=options)
    if parameter.kind is Vector:
        return replace(control, kind="vector", value=tuple(value))
    if parameter.kind in (Float, int):
        low, high = _range(distribution, drawn, value)
        kind: Kind = "number" if low == high else "slider"
        width = abs(value) or 1.0 if low is None or high is None or low == high else high - low
        step = 1.0 if parameter.kind is int else _step(width)
        return replace(control, kind=kind, value=value, low=low, high=high, step=step)
    return control


def _drawn(distribution: Distribution, siblings: Mapping[str, Any]) -> Distribution:
    """Return the case of a conditional distribution that applies."""
    while isinstance(distribution, By):
        case = distribution.case(siblings.get(distribution.parameter))
        if case is None:
            break
        distribution = case
    return distribution


def _hint(distribution: Distribution, drawn: Distribution) -> str:
    limits = "" if distribution.within is None else "allowed: {:g} to {:g}".format(*distribution.within)
    weights = drawn.weights if isinstance(drawn, Choice) else None
    weighed = "" if weights is None else "weights " + ", ".join(f"{weight:g}" for weight in weights)
    how = f"{drawn!r} {distribution.unit}".strip()
    return "; ".join(part for part in (distribution.doc, how, weighed, limits) if part)


def _options(parameter: Parameter, drawn: Distribution, value: Any) -> tuple[str, ...]:
    """Return the options of a menu: all allowed names, or for materials all names in the distribution."""
    if is_variant(parameter.kind):
        return tuple(dict.fromkeys(option.name for option in parameter.variants))
    if typing.get_origin(parameter.kind) is Literal:
        return tuple(map(str, typing.get_args(parameter.kind)))
    if parameter.kind in (int, Float) and isinstance(drawn, Choice) and parameter.distribution.within is None:
        numbers = sorted({*drawn.options, value})
        return () if numbers == list(range(numbers[0], numbers[-1] + 1)) else tuple(map(str, numbers))
    if parameter.kind not in (str, Material) or not drawn.discrete or len(drawn.support()) < 2:
        return (str(value),) if parameter.kind is Material else ()
    found = tuple(str(option) if isinstance(option, str) else shown(option) for option in drawn.support())
    return found if value in found else (str(value), *found)  # a material in its own shade has its own name


def _range(
    distribution: Distribution, drawn: Distribution, value: float
) -> tuple[float | None, float | None]:
    """Return the hard limits, or else the range of the distribution with the current value."""
    if distribution.within is not None:
        return distribution.within
    numbers = [float(item) for item in drawn.support() if is_number(item)]
    if len(numbers) < 2:
        return None, None
    return min(*numbers, value), max(*numbers, value)


def _step(width: float) -> float:
    """Return 1, 2 or 5 times a power of ten, such that a width has at least `_STEPS` steps."""
    rough = width / _STEPS
    power = 10.0 ** math.floor(math.log10(rough))
    step = power * next((factor for factor in (5.0, 2.0) if power * factor <= rough), 1.0)
    return float(f"{step:.0e}")


def read_value(kind: Any, value: Any) -> Any:
    """Convert a value from a user interface to a value of a parameter of this kind."""
    if typing.get_origin(kind) is Literal:
        return next((item for item in typing.get_args(kind) if str(item) == value), value)
    if kind is int:
        return int(value)
    if kind is Float:
        return float(value)
    return tuple(float(item) for item in value) if kind is Vector else value


def joint_controls(asset: Asset, q: Mapping[str, float]) -> Iterator[StudioControl]:
    """Yield a control for each joint of an asset that is not locked."""
    positions = asset.positions(q)
    for joint in asset.joints:
        if joint.locked:
            continue
        unit, reach = ("rad", math.pi) if joint.kind == "revolute" else ("m", _ROOM)
        low, high = joint.limits or (-reach, reach)
        limits = f"{low:.4g} to {high:.4g} {unit}" if joint.limits else "no limits"
        parts = [f"{joint.parent} to {joint.child}", limits]
        if joint.follows is not None:
            parts.append(f"follows {joint.follows.leader}")
        if joint.needs is not None:
            parts.append(f"needs {joint.needs}")
        value = float(min(max(positions[joint.name], low), high))
        control = StudioControl(joint.name, joint.name, "slider", value, "; ".join(parts), unit, low, high)
        yield replace(control, step=_step(high - low), follows=joint.follows is not None)


def moved_joint(
    asset: Asset, q: Mapping[str, float], joint: str, position: float
) -> tuple[dict[str, float], tuple[str, ...]]:
    """Move a free joint until a dependency stops it; return all positions and the blocked joints."""
    start = asset.positions(q)[joint]
    limits = asset.joint(joint).limits
    end = position if limits is None else min(max(position, limits[0]), limits[1])
    reached = start
    for place in _stops(asset, joint, start, end):
        # a condition at the center of an interval holds up to the next threshold of a dependency
        blocked = asset.blocked({**q, joint: (reached + place) / 2.0})
        if blocked:
            return {**q, joint: reached}, blocked
        back = 0.0 if not asset.blocked({**q, joint: place}) else _NUDGE if end > start else -_NUDGE
        reached = place - back
    blocked = asset.blocked({**q, joint: end})
    return {**q, joint: reached if blocked else end}, blocked


def allowed_positions(asset: Asset, q: Mapping[str, float]) -> dict[str, float]:
    """Return allowed positions near given ones, without a search."""
    result = {}
    for joint in asset.free_joints:
        if joint.name in q:
            low, high = joint.limits or (q[joint.name], q[joint.name])
            result[joint.name] = min(max(q[joint.name], low), high)
    for _ in asset.joints:  # closing one joint may block another
        blocked = asset.blocked(result)
        if not blocked:
            break
        leaders = [asset.joint(leader_of(asset, asset.joint(name))[0]) for name in blocked]
        result |= {leader.name: leader.closed for leader in leaders if not leader.locked}
    return result


def _stops(asset: Asset, joint: str, start: float, end: float) -> Iterator[float]:
    """Yield the thresholds of dependencies on the path of a joint in order, and the end of the path."""
    found = {end}
    for other in asset.joints:
        if other.needs is None:
            continue
        leader, ratio, offset = leader_of(asset, other)
        if leader == joint and ratio:
            bounds = (0.0, other.needs.until, other.needs.beyond)
            values = [value for bound in bounds if bound is not None for value in (bound, -bound)]
            found.update((value - offset) / ratio for value in values)
        for name, value in _thresholds(other.needs.condition):
            leader, ratio, offset = leader_of(asset, asset.joint(name))
            if leader == joint and ratio:
                found.add((value - offset) / ratio)
    low, high = min(start, end), max(start, end)
    yield from sorted((place for place in found if low <= place <= high), reverse=end < start)


def _thresholds(condition: AssetCondition) -> Iterator[tuple[str, float]]:
    if condition.joint:
        yield condition.joint, condition.value
    for term in condition.terms:
        yield from _thresholds(term)
