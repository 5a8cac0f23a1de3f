"""Parameters: the values of an annotation, and the check of distributions against it."""

import re
import types
import typing
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from artgen._arrays import cached_property
from artgen.errors import ParameterError, nearest
from artgen.graph import Handle
from artgen.materials import MATERIALS, Material, named
from artgen.nodes.handles import Bool, Float, Vector
from artgen.sampling import Distribution
from artgen.sampling.distributions import UNITS, is_number

SOCKETS = (Float, Bool, Vector)
"""Handles whose values can be drawn."""

_WORDS = {
    Float: "a number",
    Bool: "True or False",
    Vector: "three numbers",
    int: "a whole number",
    str: "a string",
    bool: "True or False",
    Material: "a material or the name of one",
}


_WITH_UNIT = re.compile(r"\s*([-+]?\d*\.?\d+)\s*([a-z]*)\s*")  # a number that may have a unit


class Variant(ABC):
    """A parameter value with parameters of its own: a generator."""

    name: str  # its name
    # its own parameters by name, without those of sub-generators
    own: "Mapping[str, Parameter]"

    @abstractmethod
    def parameters(self, prefix: str = "") -> "dict[str, Parameter]":
        """Return its parameters by full dotted name with a prefix."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a generator.

    Attributes:
        name: Full name: the path of parameters and generators, such as `handle.lever_handle.length`.
            Overrides may omit the generators.
        kind: The annotation: a socket (Float, Bool, Vector) or a structural type.
        distribution: Distribution of its values.
    """

    name: str
    kind: Any
    distribution: Distribution

    @property
    def structural(self) -> bool:
        """Whether its value is known while the graph is built."""
        return self.kind not in SOCKETS

    @cached_property
    def variants(self) -> tuple[Variant, ...]:
        """Generators among its values."""
        return variants_in(self.distribution) if is_variant(self.kind) else ()

    @property
    def options(self) -> tuple[Any, ...]:
        """The values that it can have; for numbers from a range, its ends."""
        if self.kind is bool:
            return (False, True)
        if typing.get_origin(self.kind) is Literal:
            return typing.get_args(self.kind)
        return tuple(map(self.accept, self.distribution.support()))

    def accept(self, value: Any, name: str = "") -> Any:
        """Return a value converted to the type of the parameter.

        Args:
            value: The value of an override, or a drawn value.
            name: Name of the parameter in the override.

        Raises:
            ParameterError: The value has another type or is not an option.
        """
        accepted = accept(self.kind, value, self.variants)
        if accepted is NotImplemented:
            raise ParameterError(
                f"{name or self.name} = {shown(value)} is not allowed: it must be {self.allowed}."
                f"{self._advice(value)}".removesuffix(".")
            )
        return accepted

    def _advice(self, value: Any) -> str:
        """Return the likeliest correction of a value that is not allowed."""
        if isinstance(value, str) and self.kind is Material:
            return nearest(value, MATERIALS)
        text = _WITH_UNIT.fullmatch(value) if isinstance(value, str) and self.kind is Float else None
        if text is not None:
            unit = self.distribution.unit
            size = UNITS.get(unit, {}).get(text[2] or unit)
            example = f": {size * float(text[1]):.6g}" if size else ""
            return f" Write the number alone{f', in {unit}' if unit else ''}{example}."
        pair = isinstance(value, tuple | list) and len(value) == 2 and all(map(is_number, value))
        if pair and self.kind is Float:
            return f" For a range, write uniform({value[0]:g}, {value[1]:g})."
        return ""

    def check_override(self, value: Any, name: str) -> None:
        """Check a value or distribution of an override against the type and the hard limits.

        Raises:
            ParameterError: It has another type, is not an option, or is out of range.
        """
        if isinstance(value, Distribution):
            if not self.fits(value):
                raise ParameterError(f"{name} = {value!r} is not allowed: it must be {self.allowed}")
        else:
            self.accept(value, name)
        self.distribution.check(name, value)

    def fits(self, distribution: Distribution) -> bool:
        """Tell whether all values of a distribution have the parameter's type."""
        return all(
            all(accept(self.kind, value, self.variants) is not NotImplemented for value in leaf.support())
            if leaf.discrete
            else self.kind is Float
            for leaf in distribution.leaves()
        )

    @property
    def allowed(self) -> str:
        """The allowed values, in words."""
        if is_variant(self.kind):
            return "one of " + ", ".join(option.name for option in self.variants)
        if typing.get_origin(self.kind) is Literal:
            return "one of " + ", ".join(map(repr, typing.get_args(self.kind)))
        words = _WORDS.get(self.kind, spelled(self.kind))
        return f"{words} (it is structural: a value, or a choice of values)" if self.structural else words


def supported(kind: Any) -> bool:
    """Tell whether parameters of this type can be drawn."""
    return kind in _WORDS or is_variant(kind) or typing.get_origin(kind) is Literal


def is_variant(kind: Any) -> bool:
    """Tell whether a type's values are generators."""
    return isinstance(kind, type) and issubclass(kind, Variant)


def is_socket(kind: Any) -> bool:
    """Tell whether values of a type are known at evaluation only."""
    return isinstance(kind, type) and issubclass(kind, Handle)


def is_optional(kind: Any) -> bool:
    """Tell whether a type admits None."""
    union = isinstance(kind, types.UnionType) or typing.get_origin(kind) is typing.Union
    return union and types.NoneType in typing.get_args(kind)


def spelled(kind: Any) -> str:
    """Format a type as authors write it."""
    return kind.__name__ if isinstance(kind, type) else str(kind).replace("typing.", "")


def shown(value: Any) -> str:
    """Format a value: generators and materials by name."""
    return repr(value.name) if isinstance(value, Material | Variant) else repr(value)


def variants_in(value: Any) -> tuple[Variant, ...]:
    """Return the generators in a value or among the values of a distribution."""
    if isinstance(value, Variant):
        return (value,)
    if not isinstance(value, Distribution):
        return ()
    return tuple(
        item
        for leaf in value.leaves()
        if leaf.discrete
        for item in leaf.support()
        if isinstance(item, Variant)
    )


def accept(kind: Any, value: Any, variants: Sequence[Variant] = ()) -> Any:
    """Return the value converted to the type `kind`, or NotImplemented if it has another type.

    Args:
        kind: An annotation.
        value: Anything.
        variants: Generators that names may refer to.
    """
    if isinstance(value, Handle):
        return NotImplemented
    if typing.get_origin(kind) is Literal:
        items = (item for item in typing.get_args(kind) if type(item) is type(value) and item == value)
        return next(items, NotImplemented)
    if is_variant(kind):
        named = (variant for variant in variants if value == variant.name)
        return value if isinstance(value, Variant) else next(named, NotImplemented)
    return _ACCEPT[kind](value) if kind in _ACCEPT else NotImplemented


def _float(value: Any) -> Any:
    return float(value) if is_number(value) else NotImplemented


def _bool(value: Any) -> Any:
    return bool(value) if isinstance(value, bool | np.bool_) else NotImplemented


def _vector(value: Any) -> Any:
    sequence = isinstance(value, Sequence | np.ndarray) and not isinstance(value, str) and len(value) == 3
    numbers = sequence and all(is_number(item) for item in value)
    return tuple(float(item) for item in value) if numbers else NotImplemented


def _int(value: Any) -> Any:
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return int(value) if whole else NotImplemented


def _str(value: Any) -> Any:
    return value if isinstance(value, str) else NotImplemented


def _material(value: Any) -> Any:
    if isinstance(value, str):
        found = named(value)
        return NotImplemented if found is None else found
    return value if isinstance(value, Material) else NotImplemented


_ACCEPT: Mapping[Any, Any] = {
    Float: _float,
    Bool: _bool,
    bool: _bool,
    Vector: _vector,
    int: _int,
    str: _str,
    Material: _material,
}
