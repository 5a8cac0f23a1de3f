"""Conditions on joint positions, and dependencies of joints on them."""

from dataclasses import replace
from typing import Any, ClassVar

from artgen import asset as values
from artgen.graph import Handle, kernel
from artgen.nodes.handles import Scalar


class Condition(Handle):
    """A region of joint space.

    Examples:
        >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
        >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
        >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
        >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
        >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=turn > 1.0)
        >>> case.attach(lever, turn).attach(bolt, slide)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = values.AssetCondition

    def __and__(self, other: "Condition") -> "Condition":
        """Intersect two regions."""
        return Condition.record("condition_all", a=self, b=other)

    def __or__(self, other: "Condition") -> "Condition":
        """Unite two regions."""
        return Condition.record("condition_any", a=self, b=other)

    def until(self, position: Scalar) -> "Dependency":
        """Limit the dependency to positions of the dependent joint below a value [rad or m].

        Examples:
            >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
            >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
            >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
            >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
            >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=(turn > 1.0).until(0.03))
            >>> case.attach(lever, turn).attach(bolt, slide)
        """
        return Dependency.record("dependency", condition=self, until=position)

    def beyond(self, position: Scalar) -> "Dependency":
        """Limit the dependency to positions of the dependent joint beyond a value [rad or m].

        Up to the value the joint is free, like a drawer that stands slightly behind a door.

        Examples:
            >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
            >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
            >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
            >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
            >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=(turn > 1.0).beyond(0.01))
            >>> case.attach(lever, turn).attach(bolt, slide)
        """
        return Dependency.record("dependency_beyond", needs=self, position=position)


class Dependency(Handle):
    """Condition under which a joint may leave its closed position.

    Examples:
        >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
        >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
        >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
        >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
        >>> free = (turn > 1.0).until(0.03)
        >>> case.attach(lever, turn).attach(bolt, Prismatic("slide", axis=X, limits=(0, 0.05), needs=free))
    """

    __slots__ = ()
    value_type: ClassVar[Any] = values.AssetDependency

    def until(self, position: Scalar) -> "Dependency":
        """Limit the dependency to positions of the dependent joint below a value [rad or m].

        Examples:
            >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
            >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
            >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
            >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
            >>> needs = (turn > 1.0).beyond(0.01).until(0.04)
            >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=needs)
            >>> case.attach(lever, turn).attach(bolt, slide)
        """
        return Dependency.record("dependency_until", needs=self, position=position)

    def beyond(self, position: Scalar) -> "Dependency":
        """Limit the dependency to positions of the dependent joint beyond a value [rad or m].

        Examples:
            >>> case = part(box(0.3, 0.1, 0.02), "case", material("walnut"))
            >>> lever = part(box(0.1, 0.02, 0.01).at(-0.08, 0, 0.02), "lever", material("steel"))
            >>> bolt = part(box(0.08, 0.02, 0.01).at(0.08, 0, 0.02), "bolt", material("brass"))
            >>> turn = Revolute("turn", pivot=(-0.08, 0, 0), axis=Z, limits=(0, 1.2))
            >>> needs = (turn > 1.0).until(0.04).beyond(0.01)
            >>> slide = Prismatic("slide", axis=X, limits=(0, 0.05), needs=needs)
            >>> case.attach(lever, turn).attach(bolt, slide)
        """
        return Dependency.record("dependency_beyond", needs=self, position=position)

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Dependency, or a Condition that is always required."""
        if isinstance(value, Condition):
            return Dependency.record("dependency", condition=value, until=None).node
        return super().lift(value)


@kernel
def _joint_above(joint: str, position: float) -> values.AssetCondition:
    return values.AssetCondition("above", joint, position)


@kernel
def _joint_below(joint: str, position: float) -> values.AssetCondition:
    return values.AssetCondition("below", joint, position)


@kernel(spelling="({a} & {b})")
def _condition_all(a: values.AssetCondition, b: values.AssetCondition) -> values.AssetCondition:
    return values.AssetCondition("all", terms=(a, b))


@kernel(spelling="({a} | {b})")
def _condition_any(a: values.AssetCondition, b: values.AssetCondition) -> values.AssetCondition:
    return values.AssetCondition("any", terms=(a, b))


@kernel
def _dependency(condition: values.AssetCondition, until: float | None) -> values.AssetDependency:
    return _checked(values.AssetDependency(condition, until))


@kernel(spelling="{needs}.until({position})")
def _dependency_until(needs: values.AssetDependency, position: float) -> values.AssetDependency:
    if needs.until is not None:
        raise ValueError(f"until is said twice: {needs.until:.6g} and {position:.6g}")
    return _checked(replace(needs, until=position))


@kernel(spelling="{needs}.beyond({position})")
def _dependency_beyond(needs: values.AssetDependency, position: float) -> values.AssetDependency:
    if needs.beyond is not None:
        raise ValueError(f"beyond is said twice: {needs.beyond:.6g} and {position:.6g}")
    return _checked(replace(needs, beyond=position))


def _checked(needs: values.AssetDependency) -> values.AssetDependency:
    """Return a dependency with checked positions."""
    if needs.until is not None and needs.until <= 0.0:
        raise ValueError(f"until must be positive, got {needs.until:.6g}: a joint needs nothing at 0")
    if needs.beyond is not None and needs.beyond <= 0.0:
        raise ValueError(
            f"beyond must be positive, got {needs.beyond:.6g}: leave it out where the condition is needed "
            "from 0 on"
        )
    if needs.until is not None and needs.beyond is not None and needs.until <= needs.beyond:
        raise ValueError(
            f"beyond {needs.beyond:.6g} must be below until {needs.until:.6g}: the condition is needed "
            "between them"
        )
    return needs
