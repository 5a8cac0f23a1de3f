"""The generator: it samples parameters, builds and caches graphs, and evaluates them to assets."""

from __future__ import annotations

import atexit
import functools
import inspect
import math
import operator
import re
import sys
from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Literal, get_args

from artgen._arrays import without_collector
from artgen._names import check_name
from artgen._progress import progress
from artgen.asset import Asset, Tree
from artgen.asset.asset import Base, DetailName, Limits, certify_later, check_base, find_parameters_later
from artgen.asset.certificate import MOST_TOLERANCE, Certificate
from artgen.asset.tree import Reduction
from artgen.colliders.openings import BALL
from artgen.errors import (
    ArtgenError,
    AssetError,
    BuildError,
    CheckError,
    EvaluationError,
    InfeasibleError,
    ParameterError,
    nearest,
)
from artgen.generator.draw import Draw, Overrides, Probability, meets, probability
from artgen.generator.parameter import Parameter, Variant, is_variant
from artgen.generator.signature import read_parameters
from artgen.generator.source import is_dropped, unused
from artgen.graph import DETAILS, FULL, Cache, Detail, Evaluation, Graph, Handle, operation, reached
from artgen.graph.handle import check_options, folding, recording
from artgen.graph.node import Node, line_in, topological
from artgen.nodes.handles import Body, Solid
from artgen.sampling import Fixed, Given
from artgen.sampling.distributions import is_number
from artgen.topology import Topology
from artgen.version import __version__

OnCollision = Literal["redraw", "fail", "keep"]
"""Treatment of samples with links that are not proven apart."""

Certification = bool | Literal["later"]
"""Whether to prove an asset at once, not at all, or when its certificate is needed."""

SAME_PAIR = 5
"""First draws with the same pair of links not proven apart, after which no other is made."""

_ATTEMPTS = 100  # draws of a seed, unless the caller gives their number
_SAME_REQUIREMENT = 25  # first draws that violate the same requirement, which may be meant to rule out many

_REMEDY = (
    "give the parts more clearance, or declare a contact by design with body.allow_contact(...); "
    'on_collision="keep" returns the asset all the same, and its safe_limits() tell how far its joints may go'
)


def check_proof(certify: Any, tolerance: Any, on_collision: Any) -> None:
    """Check the options of the proof."""
    if not isinstance(certify, bool) and certify != "later":
        raise ParameterError(f"certify = {certify!r} is not allowed: it must be True, False or 'later'")
    if not is_number(tolerance) or not 0.0 <= tolerance <= MOST_TOLERANCE:
        raise ParameterError(
            f"tolerance = {tolerance!r} is not allowed: it is the clearance to prove, a number of metres "
            f"(not mm) that is not negative and at most {MOST_TOLERANCE:g}"
        )
    if on_collision not in get_args(OnCollision):
        allowed = ", ".join(map(repr, get_args(OnCollision)))
        raise ParameterError(f"on_collision = {on_collision!r} is not allowed: it must be one of {allowed}")


def check_flag(name: str, value: Any) -> None:
    """Check that an option is a boolean."""
    if not isinstance(value, bool):
        raise ParameterError(f"{name} = {value!r} is not allowed: it must be True or False")


def _prove(asset: Asset, certify: Certification, tolerance: float, on_collision: OnCollision) -> None:
    """Prove that the links of an asset never collide: at once, on access to its certificate, or not."""
    if certify == "later":
        from artgen.proof import certify as proof

        after: OnCollision = "keep" if on_collision == "keep" else "fail"
        certify_later(asset, lambda: _checked(asset, proof.certify(asset, tolerance), after))
    elif certify:
        _checked(asset, asset.certify(tolerance), on_collision)


def _checked(asset: Asset, certificate: Certificate, on_collision: OnCollision) -> Certificate:
    if certificate.proven or on_collision == "keep":
        return certificate
    if on_collision == "redraw":
        raise InfeasibleError(f"{certificate}\n  {_REMEDY}", pair=certificate.failures[0].alike)
    raise CheckError(f"{asset.name}: {certificate}\n  {_REMEDY}")


def fail_alike(failures: Sequence[InfeasibleError]) -> bool:
    """Tell whether the first draws of a seed all failed alike, so that others will hardly succeed."""
    how = {error.pair or str(error) for error in failures}
    return len(how) == 1 and len(failures) >= (SAME_PAIR if failures[0].pair else _SAME_REQUIREMENT)


SHARED = Cache()
"""Values of the subgraphs of all generators without a cache of their own."""


@atexit.register
def _release() -> None:
    """Release all solids before manifold3d is unloaded."""
    # modules outlive the interpreter if torch is loaded, and manifold3d reports a leak for each cached solid
    SHARED.clear()
    for name, module in list(sys.modules.items()):
        if name.startswith("artgen."):
            for value in vars(module).values():
                if hasattr(value, "cache_clear"):
                    value.cache_clear()


# Python's message for an unknown keyword; both kinds of joints share a constructor
_UNKNOWN = re.compile(r"(?:\w+, )*(?P<function>\w+)\(\) got an unexpected keyword argument '(?P<name>\w+)'")
_MOVES = ("translate", "translated", "move", "moved", "position")  # other names of `at`
_MOST = 4  # most bodies in the cache
_MOST_OPTIONS = 8  # most options of a structural parameter that are tried for whether it acts
_DRAWS = 500  # draws for an estimated probability


class Built:
    """Builds the graphs of a generator and keeps the last ones, which do not depend on socket values."""

    def __init__(self, own: Mapping[str, Parameter], build: Callable[[Mapping[str, Any]], Any]) -> None:
        self._own = own
        self._build = build
        self._bodies: OrderedDict[tuple[Any, ...], Any] = OrderedDict()

    def of(self, values: Mapping[str, Any]) -> Any:
        """Return the handle of the result; exceptions of the function pass through."""
        key = tuple(_structural(self._own, values, ""))
        body = self._bodies.get(key)
        if body is None:
            self._bodies[key] = body = self._build(values)
            if len(self._bodies) > _MOST:
                self._bodies.popitem(last=False)
        return body


def _structural(
    own: Mapping[str, Parameter], values: Mapping[str, Any], prefix: str
) -> Iterator[tuple[str, Any]]:
    """Yield the structural values by name, including those of chosen sub-generators."""
    for name, parameter in own.items():
        value = values[prefix + name]
        if parameter.structural:
            yield prefix + name, value
        if isinstance(value, Variant):
            yield from _structural(value.own, values, f"{prefix}{name}.")


def call_author(
    name: str, function: Callable[..., Any], arguments: Mapping[str, Any], own: Mapping[str, Parameter]
) -> Any:
    """Call the function of a generator and return its result."""
    file = function.__code__.co_filename
    try:
        return function(**arguments)
    except ArtgenError as error:
        if isinstance(error, BuildError | ParameterError) and "\n  at " not in str(error):
            error.args = (f"{error}\n  at {line_in(file, error)}",)
        raise
    except (Exception, SystemExit) as error:
        reason = f"{type(error).__name__}: {error}{_correction(error)}{_never_drawn(arguments, own)}"
        raise BuildError(f"{name} cannot be built: {reason}\n  at {line_in(file, error)}") from error


def _never_drawn(arguments: Mapping[str, Any], own: Mapping[str, Parameter]) -> str:
    """Return the whole numbers that are never drawn, the likely cause of an error, with their options."""
    found = [
        f"; {name} = {arguments[name]} is not one of its options: {', '.join(map(str, options[:8]))}"
        + (f" to {options[-1]}" if len(options) > 8 else "")
        for name, parameter in own.items()
        if parameter.kind is int and isinstance(arguments[name], int)
        if arguments[name] not in (options := sorted(parameter.options)) and len(options) > 1
    ]
    return "".join(found)


def _correction(error: BaseException) -> str:
    """Return the likeliest correction of an error in an author's function."""
    if isinstance(error, AttributeError) and error.obj is not None:
        if error.name in _MOVES and hasattr(error.obj, "at"):
            return ". Did you mean 'at'?"
        near = nearest(error.name or "", [name for name in dir(error.obj) if not name.startswith("_")])
        return f".{near}" if near.endswith("?") else ""
    if isinstance(error, TypeError) and "positional arguments but" in str(error):
        return "; give the others by name, as in axis=Z"
    unknown = _UNKNOWN.match(str(error)) if isinstance(error, TypeError) else None
    called = getattr(sys.modules["artgen"], unknown["function"], None) if unknown else None
    if unknown and callable(called):
        names = [name for name in inspect.signature(called).parameters if name not in ("self", "options")]
        return f".{nearest(unknown['name'], names)}"
    return "; use artgen's sin, sqrt, min_, ... instead of numpy's" if "__array_ufunc__" in str(error) else ""


class Generator(Variant):
    """A function that builds a graph, with the distributions of its parameters.

    An argument with a distribution or a plain value as its default is a parameter. An argument without
    default, or with a handle, None or `given(...)` as its default, is an input that callers provide.

    Attributes:
        function: The author's function.
        name: Name of the function.
        labels: Semantic labels of the parts that it can make; empty for sub-generators.
        joints: Minimum and maximum joint count; None if it is not declared.
        where: File and line of the function.
        signature: The function's signature.
        own: Its own parameters by name, without those of sub-generators.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        labels: tuple[str, ...] = (),
        joints: tuple[int, int] | None = None,
    ) -> None:
        functools.update_wrapper(self, function)
        self.function = function
        self.name: str = function.__name__
        self.labels = labels
        self.joints = joints
        self.where = f"{function.__code__.co_filename}:{function.__code__.co_firstlineno}"
        self.signature = inspect.signature(function)
        self.own = read_parameters(function, self.where)
        self._built = Built(self.own, self.build)

    def __reduce__(self) -> str:
        """Pickle it by name, as functions are: another process imports its module."""
        return self.function.__qualname__

    def parameters(self, prefix: str = "") -> dict[str, Parameter]:
        """Return every parameter by its full dotted name, including those of all sub-generators."""
        result: dict[str, Parameter] = {}
        for name, own in self.own.items():
            full = prefix + name
            result[full] = Parameter(full, own.kind, own.distribution)
            for variant in own.variants:
                result |= variant.parameters(f"{full}.{variant.name}.")
        return result

    def sample(
        self, seed: int, *, attempt: int = 0, overrides: Mapping[str, Any] | None = None
    ) -> dict[str, Any]:
        """Draw the parameters.

        Args:
            seed: Seed of the asset.
            attempt: Number of infeasible draws before this one.
            overrides: Values or other distributions by name.

        Returns:
            The value of each used parameter. Parameters of a chosen sub-generator have names such as
            `handle.length`.

        Raises:
            ParameterError: The seed is negative, or an override is unknown or not allowed.
        """
        return self._drawn(seed, attempt, overrides).values

    def _drawn(self, seed: int, attempt: int, overrides: Mapping[str, Any] | None) -> Draw:
        draw = Draw(self.name, checked_count("seed", seed), attempt, Overrides(self, overrides or {}))
        draw.sample(self.own)
        return draw

    def inert(
        self, seed: int, *, attempt: int = 0, overrides: Mapping[str, Any], cache: Cache | None = None
    ) -> set[str]:
        """Return the overridden parameters that do not act on a sample; its asset does not record them.

        A number acts if the graph of the sample uses it. A structural value acts if another allowed
        option makes another graph.

        Args:
            seed: Seed of the asset.
            attempt: Number of infeasible draws before this one.
            overrides: Values or other distributions by name.
            cache: Values from earlier evaluations.
        """
        draw = self._drawn(seed, attempt, overrides)
        return self._inert_numbers(draw, cache) | self._inert_structure(
            draw, self._folded(draw.values).node.key
        )

    def _acting(self, draw: Draw, cache: Cache | None, drawn: str | None) -> dict[str, Any]:
        """Return the values of a draw without overrides that do not act, as an asset records them."""
        # without the key of the drawn graph, only numbers may not act
        inert = self._inert_numbers(draw, cache)
        if drawn is not None:
            inert |= self._inert_structure(draw, drawn)
        acting = {key: value for key, value in draw.values.items() if key not in inert}
        named = {key: getattr(value, "name", value) for key, value in acting.items()}
        return {key: list(value) if isinstance(value, tuple) else value for key, value in named.items()}

    def _inert_numbers(self, draw: Draw, cache: Cache | None) -> set[str]:
        numbers = {name for name, parameter in draw.overridden.items() if not parameter.structural}
        return numbers - reached(self._built.of(draw.values), draw.values, cache) if numbers else set()

    def _inert_structure(self, draw: Draw, drawn: str) -> set[str]:
        inert = set()
        options = {
            name: [option for option in parameter.options if option != draw.values[name]][:_MOST_OPTIONS]
            for name, parameter in draw.overridden.items()
            if parameter.structural and not is_variant(parameter.kind)
        }
        for name, others in options.items():
            keys = filter(None, (self._with_option(draw, draw.overridden[name], each) for each in others))
            if next(keys, "") == drawn and all(key == drawn for key in keys):
                inert.add(name)
        return inert

    def _with_option(self, draw: Draw, parameter: Parameter, option: Any) -> str:
        """Return the key of the graph of a sample with another option; empty if it is not allowed."""
        other = replace(draw, overrides=draw.overrides.replaced(parameter, option))
        try:
            other.sample(self.own, again=False)
            return str(self._folded(other.values).node.key)
        except ArtgenError:
            return ""

    def probability(self, /, **wanted: Any) -> Probability:
        """Return the probability that a draw has the wanted values: `probability(hand="left")`.

        It is that of a draw, before draws that are infeasible or collide are drawn again.

        Args:
            **wanted: A value by parameter name, or a distribution for its range or its options:
                `width=uniform(0.85, 0.92)`; write `handle__length` for `handle.length`.

        Returns:
            A float, exact for the generator's own parameters. Parameters of sub-generators, and distributions
            without `shares` or `share_below`, are estimated by 500 draws; `error` is the standard error.

        Raises:
            ParameterError: A name or value is unknown or not allowed, or a number is wanted exactly that is
                drawn from a range.
        """
        Overrides(self, wanted)  # checks the names and values
        named = {name.replace("__", "."): value for name, value in wanted.items()}
        if set(named) <= set(self.own):
            with suppress(NotImplementedError):
                return probability(self.own, named)
        draws = [self.sample(seed) for seed in range(_DRAWS)]
        hits = [all(n in draw and meets(draw[n], value) for n, value in named.items()) for draw in draws]
        share = sum(hits) / _DRAWS
        return Probability(share, max(share * (1.0 - share), 1.0 / _DRAWS) ** 0.5 / _DRAWS**0.5)

    def build(self, values: Mapping[str, Any], prefix: str = "", /, **inputs: Any) -> Any:
        """Call the function with sockets for its parameters and return the handle of the result.

        Args:
            values: The value of each parameter, as returned by `sample`.
            prefix: Prefix of this generator's parameters in `values`.
            **inputs: Inputs of the function; they replace parameters of the same name.

        Raises:
            BuildError: An input is unknown or missing, the function fails, it does not return a handle, or a
                statement drops the result of an operation.
        """
        if prefix:  # a sub-generator: its caller sees what is unused
            return self._built_with(values, prefix, inputs)
        result, made = self.traced(values, inputs)
        for node in unused(result, made):
            if is_dropped(node):
                raise BuildError(
                    f"{self.name}: the result of {node.op} is dropped; bodies and solids never change, their "
                    f"methods return others\n  at {node.where}\n"
                    "  Keep the result, as in body = body.attach(child, joint), and return the last one"
                )
        return result

    def traced(self, values: Mapping[str, Any], inputs: Mapping[str, Any]) -> tuple[Any, list[Node]]:
        """Call the function like `build`; return its result, and all nodes that it made."""
        with recording() as made:
            result = self._built_with(values, "", inputs)
        return result, made

    def _built_with(self, values: Mapping[str, Any], prefix: str, inputs: Mapping[str, Any]) -> Any:
        """Call the function with the caller's inputs and with drawn values."""

        def given(parameter: Parameter) -> Any:
            full = prefix + parameter.name
            if is_variant(parameter.kind):
                return Chosen(values[full], values, f"{full}.")
            value = values[full]
            return value if parameter.structural else parameter.kind.socket(full, self.where, value)

        return self._called(inputs, given)

    def __call__(self, /, **inputs: Any) -> Any:
        """Build the graph with all parameters given by the caller.

        Raises:
            BuildError: A drawn parameter is not given: its draw would be missing in the caller's signature.
        """

        def given(parameter: Parameter) -> Any:
            if isinstance(parameter.distribution, Fixed):
                return parameter.distribution.value
            raise BuildError(
                f"{self.name}(...) needs a value for {parameter.name!r}, which it would draw\n"
                f"  defined at {self.where}\n"
                f"  Pass {parameter.name}=..., or make the generator a parameter: "
                f"{self.name}: Generator = one_of({self.name})"
            )

        return self._called(inputs, given)

    def _called(self, inputs: Mapping[str, Any], given: Callable[[Parameter], Any]) -> Any:
        """Call the function with the caller's inputs and the `given` values of its other parameters."""
        for name in inputs:
            if name not in self.signature.parameters:
                raise BuildError(
                    f"{self.name} has no input {name!r}.{nearest(name, self.signature.parameters)}"
                )
        check_options(self.function, inputs)
        arguments = dict(inputs)
        for name, declared in self.signature.parameters.items():
            if name in inputs:
                continue
            if name in self.own:
                arguments[name] = given(self.own[name])
            elif declared.default is declared.empty:
                raise BuildError(f"{self.name} needs the input {name!r}\n  defined at {self.where}")
            elif isinstance(declared.default, Given):
                arguments[name] = declared.default.value
        result = call_author(self.name, self.function, arguments, self.own)
        if not isinstance(result, Handle):
            raise BuildError(
                f"{self.name} returned {result!r}; it must return a handle such as a Body\n  at {self.where}"
            )
        return result

    def graph(self, /, seed: int = 0, **overrides: Any) -> Graph:
        """Draw the parameters and return the graph that the function builds.

        Raises:
            ParameterError: The seed is negative, or an override is unknown or not allowed.
            InfeasibleError: A structural requirement excludes the sample.
        """
        return Graph(self.build(self.sample(seed, overrides=overrides)))

    def generate(
        self,
        /,
        seed: int = 0,
        *,
        name: str = "",
        base: Base = "fixed",
        cache: Cache | None = None,
        attempts: int | None = None,
        certify: Certification = True,
        tolerance: float = 0.0,
        on_collision: OnCollision = "redraw",
        limits: Limits = "full",
        topology: Topology | Literal["own", "fixed"] = "own",
        detail: DetailName = "full",
        colliders: int | Mapping[str, int] | None = None,
        openings: float = BALL,
        **overrides: Any,
    ) -> Asset:
        """Draw the parameters, build and evaluate the graph, certify the asset and return it.

        Its certificate states that no two links collide anywhere in the joint ranges.

        Args:
            seed: Seed of all draws.
            name: Name of the asset; by default the category and the seed.
            base: Whether the base is fixed to the world or free.
            cache: Values from earlier evaluations; by default a cache shared by the process.
            attempts: Number of draws before a category counts as infeasible; by default 100, and less where
                the first five all collide alike, or the first 25 violate the same requirement.
            certify: Whether to prove that no two links collide. `False`: `certificate` is None. `"later"`:
                the first access to `certificate`, also by `export`, proves it, without another draw.
            tolerance: Clearance to prove [m].
            on_collision: Treatment of a sample without a proof: `redraw` draws again, `fail` raises an error,
                `keep` returns the asset with a certificate of its collisions.
            limits: Ranges of joints: `full` with dependencies, or `independent` ranges in which every state
                is free, see `artgen.proof.limits.with_limits`.
            topology: Links, joints and colliders: `own`, those of a topology, or `fixed` for the recorded
                topology of the category, so that all seeds have the same, see `Topology.pad`.
            detail: Level of detail of the solids: `medium` has coarser curves, and `low` at most about 2,000
                triangles, without print and small details. Parameters, joints, limits, grasps and names are
                those of `full`.
            colliders: Largest number of colliders of the asset, or of single links by name, see
                `artgen.proof.fewer.with_colliders`; they are proven in any case. By default as many as the
                solids need. A topology has to hold them, as one of such assets does.
            openings: Diameter of the widest ball whose ways from outside fewer colliders leave open [m].
            **overrides: A value or a distribution by parameter name; write `handle__length` for
                `handle.length`.

        Raises:
            ParameterError: The seed, name, base, tolerance or another option is not allowed, or an override
                is unknown or not allowed.
            EvaluationError: A kernel failed.
            InfeasibleError: No draw met the requirements of the category, or none is proven free of
                collisions.
            CheckError: The links are not proven apart, and `on_collision` is `fail`; with `certify="later"`,
                the access to `certificate` raises it unless `on_collision` is `keep`.
            AssetError: The parts do not form an asset; for example, a joint refers to an unknown joint. Or
                the asset does not fit the topology, or none is recorded.
        """
        joins = colliders is not None
        pad = self._padding(topology if joins else "own")  # after the colliders are joined
        asset, _ = self.evaluate(
            seed,
            name=name,
            base=base,
            cache=cache,
            attempts=attempts,
            certify=certify,
            tolerance=tolerance,
            on_collision=on_collision,
            detail=detail,
            overrides=overrides,
            topology="own" if joins else topology,
        )
        if colliders is not None:
            asset = pad(asset.with_colliders(colliders, openings))
            if certify and asset.certificate is None:  # a padded asset
                _prove(asset, True, tolerance, on_collision)
        return asset if limits == "full" else asset.with_limits(limits)

    @without_collector()
    def evaluate(
        self,
        seed: int = 0,
        *,
        name: str = "",
        base: Base = "fixed",
        cache: Cache | None = None,
        attempts: int | None = None,
        certify: Certification = True,
        tolerance: float = 0.0,
        on_collision: OnCollision = "redraw",
        detail: DetailName = "full",
        overrides: Mapping[str, Any] | None = None,
        keep_graph: bool = False,
        topology: Topology | Literal["own", "fixed"] = "own",
    ) -> tuple[Asset, Evaluation]:
        """Generate an asset like `generate`, and return it with the cost of its evaluation.

        With `keep_graph`, evaluations with other values of parameters that are not structural use the same
        graph again. That is faster with a cache that holds most of the values, and slower otherwise. Then the
        asset records all structural overrides, whether they act or not.
        """
        seed = checked_count("seed", seed)
        name = name or f"{self.name}_{seed}"
        _check_options(name, base, attempts, detail)
        if cache is not None and not isinstance(cache, Cache):
            raise ParameterError(
                f"cache = {cache!r} is not allowed: it must be an artgen.graph.Cache, or None"
            )
        padded = self._padding(topology)
        check_proof(certify, tolerance, on_collision)
        prove = partial(_prove, certify=certify, tolerance=tolerance, on_collision=on_collision)
        cache = SHARED if cache is None else cache
        most = attempts or _ATTEMPTS
        refused: list[Mapping[str, Any]] = []
        failures: list[InfeasibleError] = []
        with progress(name) as update:
            for attempt in range(most):
                draw = self._drawn(seed, attempt, overrides)
                if draw.values in refused:  # few parameters, or few values of them, repeat the same sample
                    continue
                try:
                    return self._evaluated(
                        draw, name, base, detail, cache, prove, padded, keep_graph=keep_graph
                    )
                except InfeasibleError as error:
                    refused.append(draw.values)
                    failures.append(error)
                    update(text=f"{name}, draw {attempt + 2}, after: {error.cause}")
                    if attempts is None and fail_alike(failures):
                        tried = f"{len(failures)} were tried for seed {seed}"
                        raise InfeasibleError(
                            f"{self.name}: every draw fails alike ({tried}): {failures[0]}"
                        ) from None
                except ArtgenError as error:
                    error.add_note(f"while generating {self.name} from seed {seed}, attempt {attempt}")
                    raise
        raise InfeasibleError(
            f"{self.name}: none of {most} draws for seed {seed} is feasible; the last: {failures[-1]}"
        )

    def _evaluated(
        self,
        draw: Draw,
        name: str,
        base: Base,
        detail: DetailName,
        cache: Cache,
        prove: Callable[[Asset], None],
        padded: Callable[[Asset], Asset],
        *,
        keep_graph: bool,
    ) -> tuple[Asset, Evaluation]:
        """Build and evaluate the graph of a draw, and prove the asset."""
        body = self._built.of(draw.values) if keep_graph else self._folded(draw.values)
        # a graph that is kept is not that of the sample alone, and a graph for each option takes long
        acting = partial(self._acting, draw, cache, None if keep_graph else body.node.key)
        for level, evaluation, tree in _evaluations(body, draw.values, cache, DETAILS[detail]):
            try:
                origin: dict[str, Any] = {"seed": draw.seed, "attempt": draw.attempt, "detail": detail}
                asset = padded(self._asset(body, evaluation, tree, name, base, **origin))
                find_parameters_later(asset, acting)
                prove(asset)
            except AssetError as error:
                message = f"{error}\n  at {_place(body, error) or self.where}"
                raise AssetError(message, joint=error.joint, link=error.link) from None
            except (InfeasibleError, CheckError):
                if level is FULL:
                    raise
                continue
            found = None if asset.certified_later else asset.certificate
            if level is FULL or found is None or found.proven:
                break
        return asset, evaluation

    @property
    def topology_file(self) -> Path:
        """The file with the recorded topology of the category, beside its module."""
        module = Path(self.function.__code__.co_filename)
        return module.with_name(
            "topology.json" if module.stem == "__init__" else f"{self.name}.topology.json"
        )

    def _padding(self, topology: Topology | str) -> Callable[[Asset], Asset]:
        """Return the function that pads an asset."""
        if isinstance(topology, Topology):
            return topology.pad
        if topology == "own":
            return lambda asset: asset
        if topology != "fixed":
            raise ParameterError(
                f"topology = {topology!r} is not allowed: it must be 'own', 'fixed' or a Topology"
            )
        file = self.topology_file
        if not file.exists():
            raise AssetError(
                f"{self.name} has no recorded topology; make one: assets = (generate({self.name!r}, seed, "
                "certify=False) for seed in range(100)); Topology.of(assets).save(file), with the file "
                f"{str(file)!r}"
            )
        return _recorded(file, file.stat().st_mtime_ns).pad

    def _folded(self, values: Mapping[str, Any]) -> Any:
        """Build the graph of one sample; the literals of its numbers have no places for errors to name."""
        try:
            with folding():
                body = self.build(values)
        except BuildError:
            return self.build(values)
        return body if isinstance(body.node, Node) else self.build(values)

    def _asset(
        self, body: Handle, evaluation: Evaluation, tree: Tree, name: str, base: Base, **origin: Any
    ) -> Asset:
        if not isinstance(body, Body):
            raise BuildError(
                f"{self.name} returns a {type(body).__name__}; an asset needs a Body\n  at {self.where}"
            )
        self._check_labels(evaluation.value)  # those of all details
        return Asset.from_tree(
            tree, name, self.name, base=base, version=__version__, labels=self.labels, **origin
        )

    def _check_labels(self, tree: Tree) -> None:
        if not self.labels:
            return
        carried = [(label, link.name) for link in tree.links() for label in link.labels]
        missing = {label: link for label, link in reversed(carried) if label not in self.labels}
        if not missing:
            return
        (label, link), *others = reversed(missing.items())
        more = f" Nor does it declare {', '.join(repr(other) for other, _ in others)}." if others else ""
        raise AssetError(
            f"link {link!r} carries the label {label!r}, which {self.name} does not declare."
            f"{nearest(label, self.labels)}{more}",
            link=label,
        )

    def __repr__(self) -> str:
        return f"<generator {self.name} at {self.where}>"


_COARSEST = 0.0024  # distance of facets from a round surface at which no coarser solids are tried [m]
_FILLED = 0.85  # share of the triangles that a level aims at, above which solids leave little for details
_LIKELY = 18  # triangles of each operation that makes a solid, above which solids are coarser from the start
# up to a multiple of the triangles that a level aims at: the factor by which its solids become coarser
_COARSER: tuple[tuple[float, float], ...] = ((1.1, 1.25), (1.3, 1.5), (1.6, 2.0), (math.inf, 3.0))


def _evaluations(
    body: Handle, values: Mapping[str, Any], cache: Cache, level: Detail
) -> Iterator[tuple[Detail, Evaluation, Tree]]:
    """Yield a level of detail, the evaluation of a graph and its tree; finer ones if it is not proven."""
    # too many triangles of solids make them coarser, unless coarser solids failed
    most, coarsest, steps = level.most, _COARSEST, _COARSER
    if most < math.inf and _LIKELY * _solids(body) > most:
        level = level.scaled(2.0)
    while True:
        try:
            evaluation = Graph(body).evaluate(values, cache, level)
        except EvaluationError:  # a solid vanished, or does not fit any more
            if level is FULL:
                raise
        else:
            tree = evaluation.value
            if most < math.inf and isinstance(body, Body):
                reduction = Reduction(tree, most, level.thin)
                if level.chord < coarsest:
                    least = tree.solid_triangles()
                    if _FILLED * most < least <= most and level.chord < 0.5 * coarsest:
                        # little is left for details
                        least = reduction.least
                    if least > most:
                        level = level.scaled(next(by for times, by in steps if least <= times * most))
                        steps = _COARSER[1:]
                        continue
                tree = reduction.result
            yield level, evaluation, tree
        coarsest = 0.0
        level = level.finer


def _solids(body: Handle) -> int:
    """Return the number of operations that make solids, without those of visual details only."""
    count, seen, stack = 0, {body.node.key}, [body.node]
    while stack:
        node = stack.pop()
        count += Handle.HANDLES[operation(node.op).result] is Solid
        for child in node.children if node.op != "detail" else ():
            if child.key not in seen:
                seen.add(child.key)
                stack.append(child)
    return count


@dataclass(frozen=True, eq=False)
class Chosen:
    """A sub-generator with its drawn parameters, as an argument of the caller's function."""

    generator: Generator  # the generator
    values: Mapping[str, Any]  # the value of each parameter of the category
    prefix: str  # prefix of the generator's parameters in `values`

    @property
    def name(self) -> str:
        """The generator's name."""
        return self.generator.name

    def __call__(self, /, **inputs: Any) -> Any:
        """Build its graph; see `Generator.build`."""
        return self.generator.build(self.values, self.prefix, **inputs)

    def __eq__(self, other: object) -> bool:
        """Tell whether it is that generator."""
        return self.generator is (other.generator if isinstance(other, Chosen) else other)

    def __hash__(self) -> int:
        """Hash like the generator."""
        return hash(self.generator)


@functools.lru_cache(maxsize=64)
def _recorded(file: Path, changed: int) -> Topology:
    """Return the topology in a file; `changed` is the time of its last change [ns]."""
    return Topology.load(file)


def checked_count(name: str, value: Any) -> int:
    """Return a whole number that is not negative."""
    try:
        number = operator.index(value)
    except TypeError:
        number = -1
    if isinstance(value, bool) or number < 0:
        raise ParameterError(f"{name} must be a whole number that is not negative, got {value!r}")
    return number


def _check_options(name: str, base: Any, attempts: int | None, detail: Any) -> None:
    check_name(name)
    check_base(base)
    if detail not in DETAILS:
        allowed = ", ".join(map(repr, DETAILS))
        raise ParameterError(f"detail = {detail!r} is not allowed: it must be one of {allowed}")
    if attempts is not None and checked_count("attempts", attempts) < 1:
        raise ParameterError(f"attempts must be at least 1, got {attempts!r}")


def _place(body: Handle, error: AssetError) -> str:
    """Return the author's line of the joint, part or contact of an error."""
    # names of copies begin with the name in the author's code
    about, found, place = error.joint or error.link, "", ""
    for node in Graph(body).nodes:
        for name in _names_given(node, error):
            if about.startswith(name) and len(name) > len(found):
                found, place = name, node.where
    return place


def _names_given(node: Node, error: AssetError) -> list[str]:
    """Return the parameter names that an error message should mention."""
    if error.joint and error.link:  # a contact between links that depends on a joint
        when = node.inputs["when"] if node.op == "allow_contact" else None
        below = topological(when) if isinstance(when, Node) else []
        return [other.inputs["joint"] for other in below if "joint" in other.inputs]
    if node.op not in (("joint",) if error.joint else ("part", "detail")):
        return []
    names = (node.inputs.get("name"), node.inputs.get("label"))
    return [name for name in names if name]
