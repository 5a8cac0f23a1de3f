"""Check of a category: it generates sound assets and keeps the promises of every category."""

import json
from collections.abc import Collection, Iterable, Mapping
from functools import partial
from typing import Any, Literal

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import ArtgenError, BuildError, InfeasibleError, ParameterError
from artgen.generator import Generator
from artgen.generator.source import check_source
from artgen.graph import Cache, Graph
from artgen.validate import validate


def check_category(
    generator: Generator | str,
    seeds: Iterable[int] = range(8),
    *,
    checks: Collection[str] | None = None,
    behavior: bool = False,
    on_collision: Literal["keep", "redraw"] = "keep",
    overrides: Mapping[str, Any] | None = None,
) -> None:
    """Check that a category generates sound assets.

    For each seed, the asset is generated and certified. Generating it again must give the same asset, its
    graph must survive a round trip through JSON, and every check of `artgen validate` must pass on its files,
    which are written to a temporary directory.

    Args:
        generator: A category or generator, the name of a category, or a file that defines one, such as
            `stool.py`.
        seeds: The seeds.
        checks: Names of the checks to run; all by default.
        behavior: Whether to simulate each asset in MuJoCo, which takes seconds.
        on_collision: `keep` fails for a sample with colliding parts. `redraw` checks the sample that is drawn
            instead, as users of the category get it.
        overrides: Values or distributions by parameter name.

    Raises:
        AssertionError: An asset has faults; the text has its seed, parameters and findings.
        ParameterError: A category, check or override is unknown, or there are no seeds.
    """
    __tracebackhide__ = True
    chosen = found_generator(generator)
    numbers = list(seeds)
    if not numbers:
        raise ParameterError(f"check_category({chosen.name}): seeds is empty, so nothing would be checked")
    options = dict(overrides or {})
    failures = []
    for seed in numbers:
        try:
            parameters, faults = _faults(chosen, seed, options, checks, behavior, on_collision)
        except Exception as error:
            error.add_note(f"while checking {chosen.name}, seed {seed}")
            raise
        if faults:
            failures.append(_described(seed, parameters, faults))
    if failures:
        summary = f"{chosen.name}: {len(failures)} of {len(numbers)} seeds fail"
        raise AssertionError("\n".join([summary, *failures]))


def found_generator(generator: Generator | str) -> Generator:
    """Return a generator, or the one of a name or file.

    Raises:
        ParameterError: There is no category of that name, or it is not a generator.
    """
    found = find(generator) if isinstance(generator, str) else generator
    if not isinstance(found, Generator):
        raise ParameterError(f"a generator or the name of a category is needed, got {generator!r}")
    return found


def _faults(
    generator: Generator,
    seed: int,
    overrides: Mapping[str, Any],
    checks: Collection[str] | None,
    behavior: bool,  # noqa: FBT001 - passed on
    on_collision: Literal["keep", "redraw"],
) -> tuple[Mapping[str, Any], list[str]]:
    """Return the parameters of the asset of a seed, and its faults."""
    generated = partial(generator.evaluate, seed, on_collision=on_collision, overrides=overrides)
    try:
        asset, _ = generated()
    except ParameterError:
        raise
    except ArtgenError as error:
        mistake = error.__cause__
        if isinstance(error, BuildError) and not (mistake is None or isinstance(mistake, ArtgenError)):
            raise mistake from None  # a mistake of the author: its traceback explains it best
        # parameters of the first draw, unless no draw was feasible
        infeasible = isinstance(error, InfeasibleError)
        parameters = {} if infeasible else generator.sample(seed, overrides=overrides)
        return parameters, [f"generate: {error}"]
    faults = _round_trip(generator, asset, overrides)
    source = check_source(generator, generator, asset, overrides=overrides)
    faults += [f"source: {fault}" for fault in source.faults]
    again = json.loads(generated(cache=Cache(), keep_graph=True)[0].to_json())
    # with a kept graph, overrides that do not act are recorded as well
    again["parameters"] = {
        name: each for name, each in again["parameters"].items() if name in asset.parameters
    }
    if json.dumps(again) != json.dumps(json.loads(asset.to_json())):
        faults.append(
            "same seed, same bytes: generated again, the asset is another; draw only from the signature, and "
            "use no time, process or set order"
        )
    try:
        report = validate(asset, behavior=behavior, checks=checks)
    except ParameterError:
        raise
    except ArtgenError as error:
        faults.append(f"export: {error}")
    else:
        findings = [each for result in report.results for each in result.findings]
        # notes may explain a fault
        faults += [f"{each.check}: {each}" for each in findings if faults or not report.passed]
    return asset.parameters, faults


def _round_trip(generator: Generator, asset: Asset, overrides: Mapping[str, Any]) -> list[str]:
    assert asset.seed is not None
    values = generator.sample(asset.seed, attempt=asset.attempt, overrides=overrides)
    graph = Graph(generator.build(values))
    try:
        same = Graph.from_json(graph.to_json()).key == graph.key
    except ArtgenError as error:
        return [f"graph round trip: {error}"]
    return [] if same else ["graph round trip: the graph that was read back from JSON is another"]


def _described(seed: int, parameters: Mapping[str, Any], faults: list[str]) -> str:
    lines = [f"seed {seed}:", *(f"  {fault}" for fault in faults)]
    if parameters:  # generators and materials by name
        values = ", ".join(f"{name}={getattr(value, 'name', value)!r}" for name, value in parameters.items())
        lines.append(f"  with {values}")
    return "\n".join(lines)
