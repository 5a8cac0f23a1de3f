"""Signatures: the parameters that a function declares, checked at decoration."""

import inspect
import typing
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from artgen.errors import BuildError, ParameterError, nearest
from artgen.generator.draw import drawing_order
from artgen.generator.parameter import Parameter, is_optional, is_socket, spelled, supported
from artgen.graph import Handle
from artgen.sampling import Distribution, Fixed, Given
from artgen.sampling.choices import OTHERWISE, By, case_key

RESERVED = (
    *("seed", "name", "base", "cache", "attempts", "certify", "tolerance", "on_collision", "limits"),
    *("topology", "detail", "colliders", "openings", "overrides"),
)
"""Names that parameters cannot have: options of `generate`."""


def read_parameters(function: Callable[..., Any], where: str) -> dict[str, Parameter]:
    """Return the parameters that a function's signature declares, by name.

    An argument without default, or with a handle, None or `given(...)` as its default, is an input.
    """
    hints = typing.get_type_hints(function)
    parameters: dict[str, Parameter] = {}
    for declared in inspect.signature(function).parameters.values():
        place = f"{function.__name__}({declared.name}: ...)"
        parameter = _parameter(declared, hints, place, where)
        if parameter is not None:
            parameters[declared.name] = parameter
    for parameter in parameters.values():
        _check_needs(parameter, parameters, f"{function.__name__}({parameter.name}: ...)", where)
    try:
        drawing_order({name: own.distribution for name, own in parameters.items()}, function.__name__)
    except ParameterError as error:
        raise BuildError(f"{error}\n  at {where}") from None
    return parameters


def _parameter(
    declared: inspect.Parameter, hints: Mapping[str, Any], place: str, where: str
) -> Parameter | None:
    """Check an annotation against its default; return None for an input."""
    name, default = declared.name, declared.default
    if declared.kind in (declared.VAR_POSITIONAL, declared.VAR_KEYWORD, declared.POSITIONAL_ONLY):
        raise BuildError(f"{place} cannot be given by keyword; name every parameter\n  at {where}")
    if name not in hints:
        raise BuildError(f"{place} has no annotation; annotate it Float, int, str, ...\n  at {where}")
    kind = hints[name]
    if default is declared.empty or isinstance(default, Given):
        return None
    if isinstance(default, Handle) or (default is None and is_optional(kind)):
        if isinstance(default, Handle) and is_socket(kind) and not isinstance(default, kind):
            raise BuildError(
                f"{place}: annotated {spelled(kind)}, but its default is a {type(default).__name__}\n"
                f"  at {where}"
            )
        return None
    if name in RESERVED:
        raise BuildError(f"{place}: {name!r} is reserved for generate(); choose another name\n  at {where}")
    if "__" in name:
        raise BuildError(f"{place}: the double underscore means a dot; choose another name\n  at {where}")
    distribution = default if isinstance(default, Distribution) else Fixed(value=default)
    parameter = Parameter(name, kind, distribution)
    _check_type(parameter, place, where)
    if isinstance(distribution, Fixed):
        return Parameter(name, kind, replace(distribution, value=parameter.accept(distribution.value)))
    return parameter


def _check_type(parameter: Parameter, place: str, where: str) -> None:
    """Check that all values of a distribution have the annotated type."""
    kind, distribution = parameter.kind, parameter.distribution
    if parameter.fits(distribution):
        return
    if not supported(kind):
        advice = (
            f"{distribution!r} cannot give that type: annotate it Float, Bool, Vector, int, str, bool, "
            "Literal, Material or Generator"
        )
    elif distribution.numeric and not all(leaf.discrete for leaf in distribution.leaves()):
        advice = f"{distribution!r} is drawn from numbers: annotate it Float"
        if kind is int:
            advice += ", or draw whole numbers, as count(1, 4) does"
    else:
        advice = f"{distribution!r} has values that are not {parameter.allowed}"
        if isinstance(distribution, Fixed) and isinstance(distribution.value, list | tuple | range):
            options = ", ".join(map(repr, distribution.value))
            draw = "choice" if parameter.structural else "uniform"
            advice += f"; to draw one, write {draw}({options})"
    raise BuildError(f"{place}: annotated {spelled(kind)}, but {advice}\n  at {where}")


def _check_needs(parameter: Parameter, parameters: Mapping[str, Parameter], place: str, where: str) -> None:
    """Check that a dependency of a distribution exists, is structural, and has a case for each value."""
    for needed in parameter.distribution.needs():
        other = parameters.get(needed)
        if other is None or not other.structural:
            raise BuildError(
                f"{place}: by({needed!r}, ...) needs a structural parameter of the same generator; "
                f"{needed!r} is none\n  at {where}"
            )
        if isinstance(parameter.distribution, By) and needed == parameter.distribution.parameter:
            _check_cases(parameter.distribution, other, place, where)


def _check_cases(distribution: By, other: Parameter, place: str, where: str) -> None:
    """Check that each value of the structural parameter has a case, and each case a value."""
    allowed = other.options if other.kind is bool or typing.get_origin(other.kind) is typing.Literal else ()
    for key, _ in distribution.cases:
        if allowed and key not in (OTHERWISE, *map(case_key, allowed)):
            raise BuildError(
                f"{place}: by({other.name!r}, {key}=...) never applies: {other.name} is "
                f"{spelled(other.kind)}.{nearest(str(key), list(map(str, allowed)))}\n  at {where}"
            )
    values = list(allowed) if other.kind is not bool else []
    values += [value for leaf in other.distribution.leaves() for value in leaf.support()]
    for value in values:
        if distribution.case(value) is None:
            keys = ", ".join(str(key) for key, _ in distribution.cases)
            raise BuildError(
                f"{place}: by({other.name!r}, ...) has no case for {case_key(value)!r}; give one for each "
                f"value, or otherwise=... Cases: {keys}\n  at {where}"
            )
