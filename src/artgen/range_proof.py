"""Range proof of a category: certificates of samples and of corners of its parameter ranges."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from artgen.asset import Asset
from artgen.asset.certificate import PairResult
from artgen.asset.record import Record
from artgen.catalog import find
from artgen.errors import AssetError, BuildError, EvaluationError, InfeasibleError, ParameterError
from artgen.generator import Generator
from artgen.generator.corners import corners as corners_of
from artgen.generator.generator import check_proof, checked_count
from artgen.sampling.distributions import shown

Outcome = Literal["proven", "collision", "not proven", "error", "infeasible"]
Progress = Callable[[int, int], None]
"""Called after each sample and corner with the number of finished ones and the total."""

MOST_FAILURES = 10
"""Most failures that are described; all are counted."""

_WORDS: Mapping[Outcome, str] = {
    "proven": "proven",
    "collision": "collide",
    "not proven": "neither collide nor are proven",
    "error": "cannot be made",
    "infeasible": "infeasible",
}
_ATTEMPTS = 100  # draws per seed before its sample counts as infeasible
_HOPELESS = 10  # first samples; if none of them is feasible, the proof stops
_MOST_MEASURED = 16  # assets whose clearance is measured to find the smallest


@dataclass(frozen=True)
class Failure(Record):
    """A sample or corner that is not proven free of collisions.

    Attributes:
        outcome: `collision`, `not proven`, or `error` for an asset that cannot be generated.
        origin: `seed 12` or `corner 3`.
        message: The witness, the unproven region, or the error.
        parameters: All its parameters; as overrides they generate the same asset.
    """

    outcome: Outcome
    origin: str
    message: str
    parameters: Mapping[str, Any]


@dataclass(frozen=True)
class SmallestClearance(Record):
    """The smallest clearance between two links in proven samples and corners.

    Attributes:
        bound: Lower bound of the distance of any two links; negative for an allowed contact [m].
        guaranteed: Lower bound of the distance of these two links [m].
        found: Distance of the convex pieces around them; None if it was not measured [m].
        links: Names of the links.
        positions: Joint positions at that distance [rad or m].
        origin: `seed 12` or `corner 3`.
        parameters: All its parameters; as overrides they generate the same asset.
    """

    bound: float
    guaranteed: float
    found: float | None
    links: tuple[str, str]
    positions: Mapping[str, float]
    origin: str
    parameters: Mapping[str, Any]


@dataclass(frozen=True)
class RangeProof(Record):
    """Certificates of samples and corners of the parameter ranges of a category.

    Attributes:
        category: Name of the category.
        seed: The seed of the first sample.
        tolerance: Required clearance [m].
        overrides: Overrides of parameters, as text.
        samples: Number of samples.
        corners: Number of corners of the parameter ranges.
        counts: Number of samples and corners by outcome.
        clearance: The smallest clearance of the proven ones; None if nothing moves in them.
        failures: The first ones that are not proven.
    """

    category: str
    seed: int
    tolerance: float
    overrides: Mapping[str, str]
    samples: int
    corners: int
    counts: Mapping[Outcome, int]
    clearance: SmallestClearance | None
    failures: tuple[Failure, ...]

    @property
    def tried(self) -> int:
        """Number of samples and corners."""
        return self.samples + self.corners

    @property
    def feasible(self) -> int:
        """Number of feasible samples and corners."""
        return self.tried - self.counts["infeasible"]

    @property
    def fraction(self) -> float:
        """Share of the feasible ones that is proven."""
        return self.counts["proven"] / self.feasible

    @property
    def sound(self) -> bool:
        """Whether all feasible ones are proven."""
        return self.counts["proven"] == self.feasible

    def to_data(self) -> dict[str, Any]:
        """Return the range proof as JSON data."""
        return {**super().to_data(), "tried": self.tried, "fraction": self.fraction}

    def __str__(self) -> str:
        """Summarize the proof: the smallest clearance with its sample, and the failures."""
        return "\n".join([self._summary(), *self._clearance_lines(), *self._failure_lines()])

    def _summary(self) -> str:
        percent = 100.0 if self.sound else min(99.9, 100.0 * self.fraction)
        text = (
            f"{self.category}: {percent:.1f} % proven, {self.counts['proven']} of {self.feasible} "
            f"({self.samples} samples, {self.corners} corners)"
        )
        others = ((outcome, count) for outcome, count in self.counts.items() if outcome != "proven")
        return "; ".join([text, *(f"{count} {_WORDS[outcome]}" for outcome, count in others if count)])

    def _clearance_lines(self) -> list[str]:
        least = self.clearance
        if least is None:
            return []
        found = "" if least.found is None else f" to {1e3 * least.found:.3f}"
        bracket = f"{1e3 * least.guaranteed:.3f}{found} mm"
        where = f"{' and '.join(least.links)} of {least.origin} at {_listed(least.positions) or 'rest'}"
        return [
            f"smallest clearance: {bracket}, {where}; all keep {1e3 * least.bound:.3f} mm",
            f"  {_listed(least.parameters)}",
        ]

    def _failure_lines(self) -> list[str]:
        lines: list[str] = []
        # most failures have one cause
        first = {failure.message: failure for failure in reversed(self.failures)}
        shown_failures = sorted(first.values(), key=self.failures.index)
        for failure in shown_failures:
            lines += [f"{failure.origin}: {failure.message}", f"  {_listed(failure.parameters)}"]
        more = self.feasible - self.counts["proven"] - len(shown_failures)
        return [*lines, f"and {more} more that are not proven"] if more else lines


def prove_range(
    category: str | Generator,
    samples: int = 500,
    *,
    corners: bool = True,
    seed: int = 0,
    overrides: Mapping[str, Any] | None = None,
    tolerance: float = 0.0,
    progress: Progress | None = None,
) -> RangeProof:
    """Certify samples of a category, and the corners of its parameter ranges.

    A range proof does not prove the values between the samples; it shows where a range is too wide.

    Args:
        category: Name of a category, or a category or generator.
        samples: Number of seeds; each gives its first feasible draw.
        corners: Whether to certify the corners of the parameter ranges; see `artgen.generator.corners`.
        seed: The first seed.
        overrides: A value or a distribution by parameter name.
        tolerance: Required clearance [m].
        progress: Callback for the progress.

    Raises:
        ParameterError: The category, the seed, an option or an override is unknown or not allowed, or there
            are neither samples nor corners.
        InfeasibleError: No sample and no corner is feasible.
    """
    generator = find(category) if isinstance(category, str) else category
    if not isinstance(generator, Generator):
        raise ParameterError(f"prove_range takes the name of a category or a generator, got {category!r}")
    check_proof(certify=True, tolerance=tolerance, on_collision="keep")
    wanted = checked_count("samples", samples)
    given = dict(overrides or {})
    generator.sample(seed, overrides=given)
    points = corners_of(generator, seed, given) if corners else []
    if not wanted and not points:
        why = "; no number of it varies, so that there are no corners" if corners else ""
        raise ParameterError(f"samples = 0 leaves nothing of {generator.name} to certify{why}")
    run = _Run(generator, tolerance, given, wanted + len(points), progress)
    for number in range(seed, seed + wanted):
        run.sample(number)
    for number, values in enumerate(points):
        run.corner(number, seed, values)
    return RangeProof(
        category=generator.name,
        seed=seed,
        tolerance=float(tolerance),
        overrides={name: shown(value) for name, value in given.items()},
        samples=wanted,
        corners=len(points),
        counts=run.counts,
        clearance=run.smallest_clearance(),
        failures=tuple(run.failures),
    )


@dataclass(frozen=True)
class _Trial:
    """A sample or corner: the value of each parameter, and the seed of its asset."""

    origin: str
    seed: int
    values: Mapping[str, Any]

    @property
    def parameters(self) -> dict[str, Any]:
        """The values as JSON data: generators and materials by name."""
        named = {name: getattr(value, "name", value) for name, value in self.values.items()}
        return {name: list(value) if isinstance(value, tuple) else value for name, value in named.items()}

    def closest(self, pair: PairResult) -> SmallestClearance:
        """Return the clearance of two links of its asset."""
        return SmallestClearance(
            bound=pair.guaranteed or 0.0,
            guaranteed=pair.guaranteed or 0.0,
            found=pair.found,
            links=pair.links,
            positions=pair.found_at,
            origin=self.origin,
            parameters=self.parameters,
        )


@dataclass
class _Run:
    """A range proof in progress."""

    category: Generator
    tolerance: float
    overrides: Mapping[str, Any]
    total: int
    progress: Progress | None
    counts: dict[Outcome, int] = field(default_factory=lambda: dict.fromkeys(_WORDS, 0))
    failures: list[Failure] = field(default_factory=list)
    _proven: list[tuple[float, _Trial]] = field(default_factory=list)
    _draws: int = 0
    _reason: str = ""

    def sample(self, seed: int) -> None:
        """Certify the first feasible draw of a seed."""
        for attempt in range(_ATTEMPTS):
            values = self.category.sample(seed, attempt=attempt, overrides=self.overrides)
            outcome = self._certify(_Trial(f"seed {seed}", seed, values))
            if outcome != "infeasible":
                break
        self._enter(outcome, min(_HOPELESS, self.total))

    def corner(self, number: int, seed: int, values: Mapping[str, Any]) -> None:
        """Certify a corner."""
        self._enter(self._certify(_Trial(f"corner {number}", seed, values)), self.total)

    def smallest_clearance(self) -> SmallestClearance | None:
        """Measure assets with the smallest guaranteed clearances, until no other can have a smaller one."""
        best: SmallestClearance | None = None
        bounds: list[float] = []
        for number, (bound, trial) in enumerate(sorted(self._proven, key=lambda item: item[0])):
            # without a measurement, the guaranteed clearance may be far below the real one
            if number == _MOST_MEASURED or (best is not None and bound >= _reached(best)):
                bounds.append(bound)
                break
            measured = self._asset(trial).certify(self.tolerance, measure=True).pairs
            closest = min(map(trial.closest, measured), key=_reached)
            bounds.append(max(bound, min(pair.guaranteed or 0.0 for pair in measured)))
            if best is None or _reached(closest) < _reached(best):
                best = closest
        return None if best is None else replace(best, bound=min(bounds))

    def _asset(self, trial: _Trial) -> Asset:
        asset, _ = self.category.evaluate(trial.seed, attempts=1, certify=False, overrides=trial.values)
        return asset

    def _certify(self, trial: _Trial) -> Outcome:
        """Certify a draw; record the result."""
        self._draws += 1
        try:
            certificate = self._asset(trial).certify(self.tolerance)
        except InfeasibleError as error:
            self._reason = str(error)
            return "infeasible"
        except (AssetError, BuildError, EvaluationError) as error:
            return self._failed(trial, "error", str(error))
        if certificate.proven:
            if certificate.clearance is not None:
                self._proven.append((certificate.clearance.guaranteed or 0.0, trial))
            return "proven"
        verdicts = [verdict for pair in certificate.pairs for verdict in (pair.verdict, pair.colliders)]
        outcome: Outcome = "collision" if "collision" in verdicts else "not proven"
        return self._failed(trial, outcome, "; ".join(map(str, certificate.failures)))

    def _failed(self, trial: _Trial, outcome: Outcome, message: str) -> Outcome:
        if len(self.failures) < MOST_FAILURES:
            self.failures.append(Failure(outcome, trial.origin, message, trial.parameters))
        return outcome

    def _enter(self, outcome: Outcome, hopeless: int) -> None:
        """Count a sample or corner; give up after several infeasible ones without any feasible one."""
        self.counts[outcome] += 1
        done = sum(self.counts.values())
        if self.counts["infeasible"] == done >= hopeless:
            raise InfeasibleError(
                f"{self.category.name}: none of the first {self._draws} draws is feasible; the last: "
                f"{self._reason}"
            )
        if self.progress is not None:
            self.progress(done, self.total)


def _reached(clearance: SmallestClearance) -> float:
    return clearance.guaranteed if clearance.found is None else clearance.found


def _listed(values: Mapping[str, Any]) -> str:
    """Format values like the command line, with 6 digits."""
    return ", ".join(
        f"{name}={value:.6g}" if isinstance(value, float) else f"{name}={value}"
        for name, value in values.items()
    )
