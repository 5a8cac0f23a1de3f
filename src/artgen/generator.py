"""Generators: typed functions whose signatures say what varies and how."""

import functools
import inspect
import math
import typing
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from artgen.asset import Asset, Base
from artgen.errors import AssetError, BuildError, InfeasibleError, ParameterError, nearest
from artgen.graph import Cache, Evaluation, Graph, Handle
from artgen.materials import MATERIALS, Material
from artgen.nodes.handles import Body, Bool, Float
from artgen.sampling import Distribution, choice, stream
from artgen.sampling.distributions import By, Choice
from artgen.version import __version__

_STRUCTURAL = (int, str, bool, Material)
_RESERVED = ("seed", "name", "base", "cache", "attempts")
_SHARED_CACHE = Cache()


@dataclass(frozen=True)
class Fixed(Distribution):
    """A value that does not vary unless it is overridden."""

    value: Any = None

    def draw(self, generator: Any, given: Mapping[str, Any]) -> Any:
        """Return the value."""
        return self.value

    def support(self) -> tuple[Any, ...]:
        """Return the value."""
        return (self.value,)

    @property
    def numeric(self) -> bool:
        """Whether the value is a number."""
        return isinstance(self.value, int | float) and not isinstance(self.value, bool)

    def __repr__(self) -> str:
        return repr(getattr(self.value, "name", self.value))


@dataclass(frozen=True)
class Parameter:
    """One parameter of a generator.

    Attributes:
        name: Name as overrides spell it, dotted for those of sub-generators.
        path: Name of its random stream within the category.
        kind: The annotation: a socket (Float, Bool) or a structural type.
        distribution: How it is drawn.
    """

    name: str
    path: str
    kind: Any
    distribution: Distribution

    @property
    def structural(self) -> bool:
        """Whether its value is known while the graph is built."""
        return not (isinstance(self.kind, type) and issubclass(self.kind, Handle))

    def check(self, value: Any) -> Any:
        """Return an overriding value in the parameter's type.

        Raises:
            ParameterError: It is of another type, no option, or out of range.
        """
        accepted = _accept(self.kind, value, self.distribution)
        if accepted is NotImplemented:
            raise ParameterError(f"{self.name} = {_shown(value)} is not allowed: it must be {_allowed(self)}")
        self.distribution.check(self.name, accepted)
        return accepted


def _shown(value: Any) -> str:
    return repr(value.name) if isinstance(value, Material | Generator) else repr(value)


def _allowed(parameter: Parameter) -> str:
    kind = parameter.kind
    if kind is Generator:
        return "one of " + ", ".join(option.name for option in _options(parameter.distribution))
    if typing.get_origin(kind) is Literal:
        return "one of " + ", ".join(map(repr, typing.get_args(kind)))
    words = {Float: "a number", Bool: "True or False", int: "a whole number", str: "a string", bool: "True or False"}
    suffix = " (it is structural: a value, or a choice of values)" if parameter.structural else ""
    return words.get(kind, f"a {getattr(kind, '__name__', kind)}") + suffix


def _accept(kind: Any, value: Any, distribution: Distribution) -> Any:
    """Return the value in the type `kind`, or NotImplemented."""
    if kind is Float:
        fits = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        return float(value) if fits else NotImplemented
    if kind in (Bool, bool):
        return value if isinstance(value, bool) else NotImplemented
    if kind is int:
        return value if isinstance(value, int) and not isinstance(value, bool) else NotImplemented
    if kind is str:
        return value if isinstance(value, str) else NotImplemented
    if kind is Material:
        return MATERIALS.get(value, NotImplemented) if isinstance(value, str) else value
    if kind is Generator:
        for option in _options(distribution):
            if value is option or value == option.name:
                return option
        return value if isinstance(value, Generator) else NotImplemented
    if typing.get_origin(kind) is Literal:
        fits = any(value == item and type(value) is type(item) for item in typing.get_args(kind))
        return value if fits else NotImplemented
    return NotImplemented


def _options(distribution: Distribution) -> tuple[Any, ...]:
    """Return the generators that a parameter may choose."""
    return tuple(item for item in distribution.support() if isinstance(item, Generator))


class Generator:
    """A function that builds a graph, with the distributions of its parameters.

    Attributes:
        function: The author's function.
        name: Its name.
        labels: Semantic labels of the parts that it may make; empty for sub-generators.
    """

    def __init__(self, function: Callable[..., Handle], labels: tuple[str, ...] = ()) -> None:
        functools.update_wrapper(self, function)
        self.function = function
        self.name: str = function.__name__
        self.labels = labels
        self.where = f"{function.__code__.co_filename}:{function.__code__.co_firstlineno}"
        self.signature = inspect.signature(function)
        self._hints = typing.get_type_hints(function)
        self._own = {name: self._parameter(name) for name in self.signature.parameters}

    def _parameter(self, name: str) -> Parameter | None:
        """Check annotation against distribution; None for an input that callers give."""
        default = self.signature.parameters[name].default
        place = f"{self.name}({name}: ...)"
        if name not in self._hints:
            raise BuildError(f"{place} has no annotation; annotate it Float, int, str, ...\n  at {self.where}")
        kind = self._hints[name]
        if default is inspect.Parameter.empty:
            return None
        if name in _RESERVED:
            raise BuildError(f"{place}: {name!r} is reserved for generate(); choose another name\n  at {self.where}")
        distribution = default if isinstance(default, Distribution) else Fixed(value=default)
        parameter = Parameter(name, name, kind, distribution)
        if not _matches(parameter):
            shown = getattr(kind, "__name__", str(kind))
            advice = (
                "is drawn from numbers: annotate it Float"
                if distribution.numeric and not isinstance(distribution, Choice | Fixed)
                else f"has values that are not {_allowed(parameter)}"
            )
            raise BuildError(f"{place}: annotated {shown}, but {distribution!r} {advice}\n  at {self.where}")
        for needed in distribution.needs():
            structural = needed in self.signature.parameters and not (
                isinstance(self._hints.get(needed), type) and issubclass(self._hints[needed], Handle)
            )
            if not structural:
                raise BuildError(
                    f"{place}: by({needed!r}, ...) needs a structural parameter of {self.name}; "
                    f"{needed!r} is none\n  at {self.where}"
                )
        return parameter

    def parameters(self, prefix: str = "") -> dict[str, Parameter]:
        """Return every parameter by its full dotted name, those of all sub-generators included."""
        result: dict[str, Parameter] = {}
        for name, own in self._own.items():
            if own is None:
                continue
            full = prefix + name
            result[full] = Parameter(full, full, own.kind, own.distribution)
            if own.kind is Generator:
                for option in _options(own.distribution):
                    result |= option.parameters(f"{full}.{option.name}.")
        return result

    def sample(self, seed: int, *, attempt: int = 0, overrides: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """Draw the parameters.

        Args:
            seed: Seed of the asset.
            attempt: Number of infeasible draws before.
            overrides: Values or other distributions by name.

        Returns:
            The value of each parameter in use. Those of a chosen sub-generator are named `handle.length`.

        Raises:
            ParameterError: A name is unknown, or a value is not allowed.
        """
        given = _Overrides(self, overrides or {})
        values: dict[str, Any] = {}
        self._sample_into(values, "", f"{self.name}/", seed, attempt, given)
        return values

    def _sample_into(
        self, values: dict[str, Any], prefix: str, path: str, seed: int, attempt: int, given: "_Overrides"
    ) -> None:
        own: dict[str, Any] = {}
        for name, parameter in self._drawing_order():
            full = prefix + name
            override = given.find(full, path + name)
            if override is None:
                value = parameter.distribution.draw(stream(seed, path + name, attempt), own)
            elif isinstance(override, Distribution):
                value = override.draw(stream(seed, path + name, attempt), own)
                value = Parameter(full, path, parameter.kind, parameter.distribution).check(value)
            else:
                value = Parameter(full, path, parameter.kind, parameter.distribution).check(override)
            own[name] = value
            values[full] = value
            if isinstance(value, Generator):
                value._sample_into(values, f"{full}.", f"{path}{name}.{value.name}.", seed, attempt, given)

    def _drawing_order(self) -> list[tuple[str, Parameter]]:
        """Return the parameters, those that others depend on before them."""
        remaining = {name: own for name, own in self._own.items() if own is not None}
        ordered: list[tuple[str, Parameter]] = []
        while remaining:
            ready = [
                name for name, own in remaining.items() if not set(own.distribution.needs()) & set(remaining)
            ]
            if not ready:
                raise BuildError(f"{self.name}: parameters {', '.join(remaining)} depend on each other")
            ordered += [(name, remaining.pop(name)) for name in ready]
        return ordered

    def build(self, values: Mapping[str, Any], prefix: str = "", **inputs: Any) -> Any:
        """Call the function with sockets for its parameters and return the handle of the result.

        Args:
            values: The value of each parameter, as `sample` gives them.
            prefix: What stands before this generator's parameters in `values`.
            **inputs: What the caller gives; takes the place of parameters of the same name.

        Raises:
            BuildError: An input is unknown or missing.
        """
        self._check_inputs(inputs)
        arguments = dict(inputs)
        for name, own in self._own.items():
            if name in arguments:
                continue
            if own is None:
                raise BuildError(f"{self.name} needs the input {name!r}\n  defined at {self.where}")
            full = prefix + name
            if own.kind is Generator:
                arguments[name] = functools.partial(values[full].build, values, f"{full}.")
            elif own.structural:
                arguments[name] = values[full]
            else:
                arguments[name] = own.kind.parameter(full)
        result = self.function(**arguments)
        if not isinstance(result, Handle):
            raise BuildError(f"{self.name} returned {result!r}; it must return a handle such as a Body\n  at {self.where}")
        return result

    def __call__(self, **inputs: Any) -> Any:
        """Build the graph with every parameter given by the caller.

        Raises:
            BuildError: A parameter that is drawn is not given: it would be hidden from the caller's signature.
        """
        self._check_inputs(inputs)
        for name, own in self._own.items():
            if name in inputs or own is None:
                continue
            if not isinstance(own.distribution, Fixed):
                raise BuildError(
                    f"{self.name}(...) draws {name!r}, which nothing gives it here\n  defined at {self.where}\n"
                    f"  Pass {name}=..., or make the generator a parameter: {self.name}: Generator = one_of({self.name})"
                )
            inputs[name] = own.distribution.value
        return self.function(**inputs)

    def _check_inputs(self, inputs: Mapping[str, Any]) -> None:
        for name in inputs:
            if name not in self.signature.parameters:
                raise BuildError(f"{self.name} has no input {name!r}.{nearest(name, self.signature.parameters)}")

    def graph(self, seed: int = 0, **overrides: Any) -> Graph:
        """Draw the parameters and return the graph that they build.

        Raises:
            ParameterError: An override is unknown or not allowed.
            InfeasibleError: A structural requirement rules the sample out.
        """
        return Graph(self.build(self.sample(seed, overrides=overrides)))

    def generate(
        self,
        seed: int = 0,
        *,
        name: str = "",
        base: Base = "fixed",
        cache: Cache | None = None,
        attempts: int = 100,
        **overrides: Any,
    ) -> Asset:
        """Draw the parameters, build and evaluate the graph, and return the asset.

        Args:
            seed: Decides every draw.
            name: Name of the asset; by default the category and the seed.
            base: Whether the base is fixed to the world or free.
            cache: Values known from earlier evaluations; by default one that the process shares.
            attempts: How many draws are made before a category counts as infeasible.
            **overrides: A value or a distribution by parameter name; `handle__length` stands for `handle.length`.

        Raises:
            ParameterError: An override is unknown or not allowed.
            EvaluationError: A kernel failed.
            InfeasibleError: No draw met the category's requirements.
        """
        asset, _ = self.evaluate(
            seed, name=name, base=base, cache=cache, attempts=attempts, overrides=overrides
        )
        return asset

    def evaluate(
        self,
        seed: int = 0,
        *,
        name: str = "",
        base: Base = "fixed",
        cache: Cache | None = None,
        attempts: int = 100,
        overrides: Mapping[str, Any] | None = None,
    ) -> tuple[Asset, Evaluation]:
        """Generate like `generate`, and return with the asset what its evaluation cost."""
        if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
            raise ParameterError(f"seed must be a whole number that is not negative, got {seed!r}")
        if name and not (name.isidentifier() and name.isascii()):
            raise ParameterError(f"name {name!r} is no identifier; use letters, digits and _")
        reason = ""
        for attempt in range(attempts):
            values = self.sample(seed, attempt=attempt, overrides=overrides)
            try:
                body = self.build(values)
                numbers = {key: value for key, value in values.items() if isinstance(value, int | float)}
                evaluation = Graph(body).evaluate(numbers, _SHARED_CACHE if cache is None else cache)
            except InfeasibleError as error:
                reason = str(error)
                continue
            return self._asset(body, evaluation, values, seed, attempt, name, base), evaluation
        raise InfeasibleError(f"{self.name}: none of {attempts} draws for seed {seed} is feasible; the last: {reason}")

    def _asset(
        self,
        body: Handle,
        evaluation: Evaluation,
        values: Mapping[str, Any],
        seed: int,
        attempt: int,
        name: str,
        base: Base,
    ) -> Asset:
        if not isinstance(body, Body):
            raise BuildError(f"{self.name} returns a {type(body).__name__}; an asset needs a Body\n  at {self.where}")
        if base not in ("fixed", "free"):
            raise ParameterError(f"base = {base!r} is not allowed: it must be 'fixed' or 'free'")
        asset = Asset.from_tree(
            evaluation.value,
            name or f"{self.name}_{seed}",
            self.name,
            seed=seed,
            attempt=attempt,
            base=base,
            version=__version__,
            parameters={key: getattr(value, "name", value) for key, value in values.items()},
            labels=self.labels,
        )
        if self.labels:
            for link in asset.links:
                for label in link.labels:
                    if label not in self.labels:
                        raise AssetError(
                            f"link {link.name!r} carries the label {label!r}, which {self.name} does not declare."
                            f"{nearest(label, self.labels)}"
                        )
        return asset

    def __repr__(self) -> str:
        return f"<generator {self.name} at {self.where}>"


def _matches(parameter: Parameter) -> bool:
    """Tell whether every value that the distribution may give is of the annotated type."""
    distribution = parameter.distribution
    if isinstance(distribution, By):
        return all(
            _matches(
                Parameter(
                    parameter.name,
                    parameter.path,
                    parameter.kind,
                    case if isinstance(case, Distribution) else Fixed(value=case),
                )
            )
            for _, case in distribution.cases
        )
    if isinstance(distribution, Choice | Fixed):
        return all(
            _accept(parameter.kind, value, distribution) is not NotImplemented
            for value in distribution.support()
        )
    return parameter.kind is Float


class _Overrides:
    """Overrides by name, checked against the parameters that exist."""

    def __init__(self, generator: Generator, overrides: Mapping[str, Any]) -> None:
        self._prefix = f"{generator.name}/"
        known = generator.parameters()
        extra = {
            name: parameter
            for value in overrides.values()
            if isinstance(value, Generator)
            for name, parameter in value.parameters("*.").items()
        }
        self._values: dict[str, Any] = {}
        for name, value in overrides.items():
            dotted = name.replace("__", ".")
            matching = [parameter for full, parameter in known.items() if _names(dotted, full)]
            if not matching and not any(dotted.endswith(full[1:]) for full in extra):
                short = {_short(full, known) for full in known}
                raise ParameterError(f"{generator.name} has no parameter {dotted!r}.{nearest(dotted, short)}")
            for parameter in matching:
                self._check(parameter, dotted, value)
            self._values[dotted] = value

    @staticmethod
    def _check(parameter: Parameter, name: str, value: Any) -> None:
        named = Parameter(name, parameter.path, parameter.kind, parameter.distribution)
        if not isinstance(value, Distribution):
            named.check(value)
        elif parameter.kind is Generator and isinstance(value, Choice):
            for option in value.options:  # by name too, as for a single value
                named.check(option)
        elif not _matches(Parameter(name, parameter.path, parameter.kind, value)):
            raise ParameterError(f"{name} = {value!r} is not allowed: it must be {_allowed(named)}")

    def find(self, full: str, path: str) -> Any:
        """Return the override of the parameter in use that is named `full` and drawn from `path`."""
        exact = path.removeprefix(self._prefix)
        return self._values.get(exact, self._values.get(full))


def _names(dotted: str, full: str) -> bool:
    """Tell whether an override's name means a parameter, with or without its generator's name."""
    if dotted == full:
        return True
    parts = full.split(".")
    # full names alternate parameter, generator, parameter, ...; short ones leave the generators out
    return dotted.split(".") == parts[::2]


def _short(full: str, known: Mapping[str, Parameter]) -> str:
    return ".".join(full.split(".")[::2])


def generator(function: Callable[..., Handle]) -> Generator:
    """Make a generator of a function: its signature says what varies."""
    return Generator(function)


def category(*, labels: tuple[str, ...]) -> Callable[[Callable[..., Handle]], Generator]:
    """Make a category of a function and enter it in the catalog under its name.

    Args:
        labels: Every semantic label that its parts may carry.

    Raises:
        BuildError: Another category has that name.
    """

    def register(function: Callable[..., Handle]) -> Generator:
        made = Generator(function, labels)
        other = CATEGORIES.get(made.name)
        if other is not None and other.where != made.where:
            raise BuildError(f"the category {made.name!r} is defined twice, at {other.where} and {made.where}")
        CATEGORIES[made.name] = made
        return made

    return register


CATEGORIES: dict[str, Generator] = {}
"""The categories by name, filled when the modules that define them are imported."""


def one_of(*generators: Generator, weights: tuple[float, ...] | None = None, doc: str = "") -> Any:
    """Draw one of some generators, whose parameters become parameters of the caller.

    Raises:
        ParameterError: Something else than a generator is among them.
    """
    for option in generators:
        if not isinstance(option, Generator):
            raise ParameterError(f"one_of chooses between generators; {option!r} is none")
    return choice(*generators, weights=weights, doc=doc)
