"""Parameters: the values that an annotation accepts, and the check of distributions against it."""

import types
import typing
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from artgen._arrays import cached_property
from artgen.errors import ParameterError
from artgen.graph import Handle
from artgen.materials import MATERIALS, Material
from artgen.nodes.handles import Bool, Float, Vector
from artgen.sampling import Distribution
from artgen.sampling.distributions import is_number

SOCKETS = (Float, Bool, Vector)
"""Handles whose values may be drawn."""

_WORDS = {
    Float: "a number",
    Bool: "True or False",
    Vector: "three numbers",
    int: "a whole number",
    str: "a string",
    bool: "True or False",
    Material: "a material or the name of one",
}


class Variant(ABC):
    """A value of a parameter that has parameters of its own: a generator."""

    name: str  # its name
    # its own parameters by name, without those of the generators that they choose
    own: "Mapping[str, Parameter]"

    @abstractmethod
    def parameters(self, prefix: str = "") -> "dict[str, Parameter]":
        """Return its parameters by full dotted name after the prefix."""


@dataclass(frozen=True)
class Parameter:
    """One parameter of a generator.

    Attributes:
        name: Full name: the parameters and generators on the way to it, in turn, as in
            `handle.lever_handle.length`. Overrides may leave the generators out.
        kind: The annotation: a socket (Float, Bool, Vector) or a structural type.
        distribution: How it is drawn.
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
        """The generators that it chooses between."""
        return variants_in(self.distribution)

    def accept(self, value: Any, name: str = "") -> Any:
        """Return a value in the parameter's type.

        Args:
            value: The value of an override, or one that was drawn.
            name: Name of the parameter as the author of the override wrote it.

        Raises:
            ParameterError: It is of another type or no option.
        """
        accepted = accept(self.kind, value, self.variants)
        if accepted is NotImplemented:
            raise ParameterError(
                f"{name or self.name} = {shown(value)} is not allowed: it must be {self.allowed}"
            )
        return accepted

    def check_override(self, value: Any, name: str) -> None:
        """Check an overriding value or distribution against the type and the hard limits.

        Raises:
            ParameterError: It is of another type, no option, or out of range.
        """
        if isinstance(value, Distribution):
            if not self.fits(value):
                raise ParameterError(f"{name} = {value!r} is not allowed: it must be {self.allowed}")
        else:
            self.accept(value, name)
        self.distribution.check(name, value)

    def fits(self, distribution: Distribution) -> bool:
        """Tell whether every value that a distribution may give is of the parameter's type."""
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
    """Tell whether a type's values are known at evaluation only."""
    return isinstance(kind, type) and issubclass(kind, Handle)


def is_optional(kind: Any) -> bool:
    """Tell whether a type admits None."""
    union = isinstance(kind, types.UnionType) or typing.get_origin(kind) is typing.Union
    return union and types.NoneType in typing.get_args(kind)


def spelled(kind: Any) -> str:
    """Spell a type as authors write it."""
    return kind.__name__ if isinstance(kind, type) else str(kind).replace("typing.", "")


def shown(value: Any) -> str:
    """Spell a value: generators and materials by their names."""
    return repr(value.name) if isinstance(value, Material | Variant) else repr(value)


def variants_in(value: Any) -> tuple[Variant, ...]:
    """Return the generators that a value is, or that a distribution may give."""
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
    """Return the value in the type `kind`, or NotImplemented if it is of another.

    Args:
        kind: An annotation.
        value: Anything.
        variants: The generators that may be given by name.
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
        return MATERIALS.get(value, NotImplemented)
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
