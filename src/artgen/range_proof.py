"""Range proof of a category: certificates of samples and of corners of its parameter ranges."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from artgen._progress import Update
from artgen._progress import progress as shown_progress
from artgen.asset import Asset
from artgen.asset.certificate import PairResult
from artgen.asset.record import Record
from artgen.catalog import find
from artgen.errors import AssetError, BuildError, EvaluationError, InfeasibleError, ParameterError
from artgen.generator import Generator
from artgen.generator.corners import corners as corners_of
from artgen.generator.generator import SAME_PAIR, check_flag, check_proof, checked_count
from artgen.sampling.distributions import is_number, shown

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
        stopped: Reason why the proof ended early; empty if it did not.
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
    stopped: str = ""

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
        stopped = [f"stopped early: {self.stopped}"] if self.stopped else []
        return "\n".join([self._summary(), *self._clearance_lines(), *self._failure_lines(), *stopped])

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
    seconds: float = 60.0,
    fail_fast: bool = False,
    progress: Progress | bool = True,
    failed: Callable[[Failure], None] | None = None,
) -> RangeProof:
    """Certify samples of a category, and the corners of its parameter ranges.

    A range proof does not prove the values between the samples; it shows where a range is too wide. It ends
    early where the first five samples all fail alike.

    Args:
        category: Name of a category, or a category or generator.
        samples: Number of seeds; each gives its first feasible draw.
        corners: Whether to certify the corners of the parameter ranges; see `artgen.generator.corners`.
        seed: The first seed.
        overrides: A value or a distribution by parameter name.
        tolerance: Required clearance [m].
        seconds: Time limit for the proof of a sample or corner; pairs of links that are left after it count
            as not proven [s].
        fail_fast: Whether to end with the first failure.
        progress: Whether to show the progress in a terminal or notebook, or a callback for it.
        failed: Called with each failure.

    Raises:
        ParameterError: The category, the seed, an option or an override is unknown or not allowed, or there
            are neither samples nor corners.
        InfeasibleError: No sample and no corner is feasible.
    """
    generator = find(category) if isinstance(category, str) else category
    if not isinstance(generator, Generator):
        raise ParameterError(f"prove_range takes the name of a category or a generator, got {category!r}")
    check_proof(certify=True, tolerance=tolerance, on_collision="keep")
    check_flag("corners", corners)
    check_flag("fail_fast", fail_fast)
    wanted = checked_count("samples", samples)
    given = dict(overrides or {})
    generator.sample(seed, overrides=given)
    points = corners_of(generator, seed, given) if corners else []
    if not wanted and not points:
        why = "; no number of it varies, so that there are no corners" if corners else ""
        raise ParameterError(f"samples = 0 leaves nothing of {generator.name} to certify{why}")
    if not (is_number(seconds) and seconds > 0.0):
        raise ParameterError(f"seconds = {seconds!r} is not allowed: it is a time limit, a number above 0")
    total, told = wanted + len(points), progress if callable(progress) else None
    with shown_progress(generator.name, None if told else total, shown=progress is True) as update:
        run = _Run(generator, tolerance, given, total, seconds, update, fail_fast, told, failed)
        run.of(seed, wanted, points)
        clearance = run.smallest_clearance()
    tried = sum(run.counts.values())
    return RangeProof(
        category=generator.name,
        seed=seed,
        tolerance=float(tolerance),
        overrides={name: shown(value) for name, value in given.items()},
        samples=min(tried, wanted),
        corners=max(tried - wanted, 0),
        counts=run.counts,
        clearance=clearance,
        failures=tuple(run.failures),
        stopped=run.stopped,
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
    seconds: float
    update: Update
    fail_fast: bool
    told: Progress | None
    failed: Callable[[Failure], None] | None
    counts: dict[Outcome, int] = field(default_factory=lambda: dict.fromkeys(_WORDS, 0))
    failures: list[Failure] = field(default_factory=list)
    stopped: str = ""
    _proven: list[tuple[float, _Trial]] = field(default_factory=list)
    _pairs: list[str] = field(default_factory=list)
    _draws: int = 0
    _reason: str = ""

    def of(self, seed: int, samples: int, corners: Sequence[Mapping[str, Any]]) -> None:
        """Certify samples and corners, until one of them stops the proof."""
        for number in range(seed, seed + samples):
            self._sample(number)
            if self.stopped:
                return
        for number, values in enumerate(corners):
            self._enter(self._certify(_Trial(f"corner {number}", seed, values)), self.total)
            if self.stopped:
                return

    def _sample(self, seed: int) -> None:
        """Certify the first feasible draw of a seed."""
        for attempt in range(_ATTEMPTS):
            values = self.category.sample(seed, attempt=attempt, overrides=self.overrides)
            outcome = self._certify(_Trial(f"seed {seed}", seed, values))
            if outcome != "infeasible":
                break
        self._enter(outcome, min(_HOPELESS, self.total))

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
            self.update(text=trial.origin)
            certificate = self._asset(trial).certify(self.tolerance, seconds=self.seconds)
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
        self._pairs.append(certificate.failures[0].alike)
        return self._failed(trial, outcome, "; ".join(map(str, certificate.failures)))

    def _failed(self, trial: _Trial, outcome: Outcome, message: str) -> Outcome:
        failure = Failure(outcome, trial.origin, message, trial.parameters)
        if len(self.failures) < MOST_FAILURES:
            self.failures.append(failure)
        if self.failed is not None:
            self.failed(failure)
        if self.fail_fast:
            self.stopped = f"{trial.origin} fails"
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
        if len(self._pairs) == done == SAME_PAIR < self.total and len(set(self._pairs)) == 1:
            self.stopped = f"the first {done} of {self.total} all fail alike"
        if self.told is not None:
            self.told(done, self.total)
        else:
            self.update(completed=done, failed=f"{len(self.failures)} failed" if self.failures else "")


def _reached(clearance: SmallestClearance) -> float:
    return clearance.guaranteed if clearance.found is None else clearance.found


def _listed(values: Mapping[str, Any]) -> str:
    """Format values like the command line, with 6 digits."""
    return ", ".join(
        f"{name}={value:.6g}" if isinstance(value, float) else f"{name}={value}"
        for name, value in values.items()
    )
