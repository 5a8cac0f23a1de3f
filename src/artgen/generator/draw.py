"""Drawing of parameters: overrides by name, one pass in the order of dependence, and probabilities."""

import difflib
import re
from collections.abc import Iterable, Mapping
from copy import copy
from dataclasses import dataclass, field
from typing import Any, Self

from artgen.errors import ParameterError, nearest
from artgen.generator.parameter import Parameter, Variant, is_variant
from artgen.sampling import Distribution, Fixed, stream
from artgen.sampling.choices import By, case_key

_LIKE = 0.8  # likeness of names from which a description is not searched
_REDRAWS = 100  # most redraws of options that conflict with overrides


class Overrides:
    """Overrides by name, checked against the existing parameters."""

    def __init__(self, category: Variant, overrides: Mapping[str, Any]) -> None:
        self._values: dict[str, Any] = {}
        self._faults: dict[str, ParameterError] = {}
        given: dict[str, Any] = {}
        for name, value in overrides.items():
            dotted = name.replace("__", ".")
            if dotted in given:
                raise ParameterError(f"the parameter {dotted!r} is given twice")
            given[dotted] = value
        known = every = category.parameters()
        # outer names first: the choice of a generator decides which parameters inner names can mean; longer
        # names last: they are more specific
        for dotted in sorted(given, key=lambda name: (name.count("."), name)):
            matching = [parameter for parameter in known.values() if _means(dotted, parameter.name)]
            if not matching:
                other = any(_means(dotted, full) for full in every)
                raise ParameterError(
                    f"{category.name} has no parameter {dotted!r}"
                    f"{' with the generators that are chosen' if other else ''}.{_hint(dotted, known)}"
                )
            value = given[dotted]
            faults: dict[str, ParameterError] = {}
            for parameter in matching:
                self._values[parameter.name] = value
                try:
                    parameter.check_override(value, dotted)
                    _check_needs(parameter, dotted, value, known)
                except ParameterError as error:
                    faults[parameter.name] = error
                    continue
                if is_variant(parameter.kind):
                    known = _with_variants(known, parameter, value)
            # `handle.length` may be valid for the lever and not for the pull; it is an error if the pull is
            # drawn
            if len(faults) == len(matching):
                raise next(iter(faults.values()))
            self._faults |= faults

    def __contains__(self, parameter: Parameter) -> bool:
        return parameter.name in self._values

    def fixes(self, parameter: Parameter) -> bool:
        """Tell whether a parameter is overridden by a value, not by a distribution."""
        return parameter in self and not isinstance(self._values[parameter.name], Distribution)

    def replaced(self, parameter: Parameter, value: Any) -> "Overrides":
        """Return the overrides with another value of an overridden parameter."""
        result = copy(self)
        result._values = {**self._values, parameter.name: value}
        return result

    def distribution(self, parameter: Parameter) -> Distribution:
        """Return the distribution of a parameter by its full name."""
        if parameter.name not in self._values:
            return parameter.distribution
        if parameter.name in self._faults:
            raise self._faults[parameter.name]
        value = self._values[parameter.name]
        return value if isinstance(value, Distribution) else Fixed(value=value)


def _hint(dotted: str, known: Mapping[str, Parameter]) -> str:
    """Return the parameter with a like name, or the one whose description has the word."""
    short = {".".join(full.split(".")[::2]): parameter.distribution.doc for full, parameter in known.items()}
    word = dotted.rpartition(".")[2].replace("_", " ").lower()
    if not difflib.get_close_matches(dotted, short, 1, cutoff=_LIKE):
        for name, doc in short.items():
            if re.search(rf"\b{re.escape(word)}s?\b", doc.lower()):
                return f" Did you mean {name!r} ({doc})?"
    return nearest(dotted, short)


def _check_needs(parameter: Parameter, dotted: str, value: Any, known: Mapping[str, Parameter]) -> None:
    prefix = parameter.name.rpartition(".")[0]
    for needed in value.needs() if isinstance(value, Distribution) else ():
        sibling = known.get(f"{prefix}.{needed}" if prefix else needed)
        if sibling is None or not sibling.structural:
            raise ParameterError(
                f"{dotted} = {value!r} needs a structural parameter {needed!r} of the same generator; "
                "there is none"
            )


def _with_variants(known: Mapping[str, Parameter], parameter: Parameter, value: Any) -> dict[str, Parameter]:
    """Return the parameters that exist if an override chooses a generator."""
    inner = f"{parameter.name}."
    result = {name: other for name, other in known.items() if not name.startswith(inner)}
    for leaf in value.leaves() if isinstance(value, Distribution) else (Fixed(value=value),):
        for item in leaf.support():
            variant: Variant = parameter.accept(item)
            result |= variant.parameters(f"{inner}{variant.name}.")
    return result


def _means(dotted: str, full: str) -> bool:
    """Tell whether an override's name refers to a parameter; the name may omit generators."""
    return _parts_mean(dotted.split("."), full.split("."))


def _parts_mean(dotted: list[str], full: list[str]) -> bool:
    if dotted[0] != full[0]:
        return False
    if len(dotted) == 1 or len(full) == 1:
        return len(dotted) == len(full)
    through_generator = len(dotted) > 2 and dotted[1] == full[1] and _parts_mean(dotted[2:], full[2:])
    return through_generator or _parts_mean(dotted[1:], full[2:])


class _ConflictError(Exception):
    """Overrides conflict with drawn options."""

    def __init__(self, error: ParameterError, options: Iterable[Parameter], overrides: Overrides) -> None:
        super().__init__()
        self.error = error
        self.again = [each.name for each in options if not overrides.fixes(each)]  # options to draw again


@dataclass
class Draw:
    """One draw of all parameters."""

    category: str  # name of the category, the first part of the name of every random stream
    seed: int  # seed of the asset
    attempt: int  # number of infeasible draws before this one
    overrides: Overrides  # values and distributions that replace the drawn ones
    # drawn values by names without generators, such as `handle.length`
    values: dict[str, Any] = field(default_factory=dict)
    overridden: dict[str, Parameter] = field(default_factory=dict)  # those of `values` with an override
    turns: dict[str, int] = field(default_factory=dict)  # how often an option was drawn again, by full name

    def sample(self, own: Mapping[str, Parameter], *, again: bool = True) -> None:
        """Draw the parameters of a generator and of the generators that it chooses.

        Args:
            own: The generator's parameters by name.
            again: Whether to draw options again that conflict with overrides; all else stays as drawn.

        Raises:
            ParameterError: A value is not allowed, or overrides conflict with each other.
        """
        for left in range(_REDRAWS if again else 0, -1, -1):
            self.values, self.overridden = {}, {}
            try:
                self._sample(own)
            except _ConflictError as conflict:
                if not left or not conflict.again:
                    raise conflict.error from None
                self.turns |= {name: self.turns.get(name, 0) + 1 for name in conflict.again}
            else:
                return

    def _sample(
        self, own: Mapping[str, Parameter], short: str = "", full: str = "", chosen: Iterable[Parameter] = ()
    ) -> None:
        """Draw the parameters of one generator, and of those that it chooses; `chosen` led to it."""
        parameters = {
            name: Parameter(full + name, parameter.kind, parameter.distribution) if full else parameter
            for name, parameter in own.items()
        }
        try:
            distributions = {
                name: self.overrides.distribution(parameter) for name, parameter in parameters.items()
            }
        except ParameterError as error:
            raise _ConflictError(error, chosen, self.overrides) from None
        drawn: dict[str, Any] = {}
        for name in drawing_order(distributions, full or self.category):
            parameter = parameters[name]
            turn = self.turns.get(parameter.name, 0)
            path = f"{self.category}/{parameter.name}" + (f"#{turn}" if turn else "")
            try:
                value = parameter.accept(
                    distributions[name].draw(stream(self.seed, path, self.attempt), drawn)
                )
            except ParameterError as error:
                _, *options = _with_leading(distributions, [name])
                given = [each for each in options if parameters[each] in self.overrides]
                if parameter in self.overrides or not given:
                    raise
                shown = " and ".join(f"{short}{each} = {case_key(drawn[each])!r}" for each in given)
                why = ParameterError(f"{shown} cannot be drawn: for {short}{name}, {error}")
                raise _ConflictError(why, [parameters[each] for each in options], self.overrides) from None
            drawn[name] = self.values[short + name] = value
            if parameter in self.overrides:
                self.overridden[short + name] = parameter
            if isinstance(value, Variant):
                led = [*chosen, *(parameters[each] for each in _with_leading(distributions, [name]))]
                self._sample(value.own, f"{short}{name}.", f"{parameter.name}.{value.name}.", led)


def _with_leading(distributions: Mapping[str, Distribution], names: Iterable[str]) -> list[str]:
    """Return the names, then those of the options that their draws depend on."""
    found = list(names)
    for each in found:  # grows
        found += [other for other in distributions[each].needs() if other not in found]
    return found


def drawing_order(distributions: Mapping[str, Distribution], owner: str) -> list[str]:
    """Return the names in an order in which parameters follow those they depend on."""
    remaining = {name: made.needs() for name, made in distributions.items()}
    order: list[str] = []
    while remaining:
        ready = [name for name, needs in remaining.items() if not any(each in remaining for each in needs)]
        if not ready:
            raise ParameterError(f"{owner}: the parameters {', '.join(remaining)} depend on each other")
        order += ready
        for name in ready:
            del remaining[name]
    return order


class Probability(float):
    """A probability, as a number from 0 to 1.

    Attributes:
        error: Standard error if it was estimated by draws; 0 if it is exact.
    """

    def __new__(cls, value: float, error: float = 0.0) -> Self:
        """Make a probability."""
        made = super().__new__(cls, value)
        made.error = error
        return made

    error: float

    def __repr__(self) -> str:
        return f"{float(self):.4g}" + (f" +- {self.error:.2g} (estimated)" if self.error else "")


def probability(own: Mapping[str, Parameter], wanted: Mapping[str, Any]) -> Probability:
    """Return the probability that the draw of a generator meets values and ranges.

    Args:
        own: The generator's parameters by name.
        wanted: Value or distribution by name; a distribution stands for its range or its options.

    Raises:
        ParameterError: A number is wanted exactly that is drawn from a range.
        NotImplementedError: A distribution does not know its probabilities.
    """
    needed = _with_leading({name: each.distribution for name, each in own.items()}, wanted)
    order = drawing_order({name: own[name].distribution for name in needed}, "")
    leading = {other for name in needed for other in own[name].distribution.needs()}

    def met(place: int, given: Mapping[str, Any]) -> float:
        if place == len(order):
            return 1.0
        name = order[place]
        distribution = own[name].distribution
        while isinstance(distribution, By):
            distribution = distribution.case(given[distribution.parameter]) or Fixed()
        if not distribution.discrete:
            return _share_within(name, distribution, wanted[name]) * met(place + 1, given)
        kept = [
            (value, share)
            for value, share in distribution.shares()
            if name not in wanted or meets(value, wanted[name])
        ]
        if name in leading:
            return sum(share * met(place + 1, {**given, name: value}) for value, share in kept)
        share = sum(share for _, share in kept)
        return share * met(place + 1, given) if share else 0.0

    return Probability(min(met(0, {}), 1.0))


def _share_within(name: str, distribution: Distribution, wanted: Any) -> float:
    if not isinstance(wanted, Distribution):
        raise ParameterError(
            f"{name} is drawn from {distribution!r}: a single number has no probability; give a range, "
            f"such as {name}={distribution!r}"
        )
    low, high = min(wanted.support()), max(wanted.support())
    return distribution.share_below(high) - distribution.share_below(low)


def meets(value: Any, wanted: Any) -> bool:
    """Tell whether a drawn value is the wanted value, or lies in the range of the wanted distribution."""
    if isinstance(wanted, Distribution) and not wanted.discrete:
        return bool(min(wanted.support()) <= value <= max(wanted.support()))
    options = wanted.support() if isinstance(wanted, Distribution) else (wanted,)
    key = case_key(value)
    return any(case_key(each) == key and isinstance(each, bool) == isinstance(key, bool) for each in options)
