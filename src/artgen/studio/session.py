"""A session of the studio without a user interface: requests, the shown asset, joints, and errors."""

import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from artgen.asset import Asset, AssetCondition
from artgen.asset.asset import remember
from artgen.asset.certificate import Certificate, PairResult
from artgen.catalog import is_file
from artgen.errors import ArtgenError, InfeasibleError, ParameterError
from artgen.export.frames import leader_of
from artgen.graph import Cache, Evaluation
from artgen.sampling import Distribution
from artgen.studio.controls import (
    JointControl,
    ParameterControl,
    joint_controls,
    parameters_in_use,
    read_value,
)
from artgen.studio.prover import ProofTask
from artgen.studio.source import CategorySource

_NUDGE = 1e-9  # distance beyond the threshold of a dependency [rad or m]


def moved(
    asset: Asset, q: Mapping[str, float], joint: str, wanted: float
) -> tuple[dict[str, float], tuple[str, ...]]:
    """Move a free joint from its position towards another one, until a dependency stops it."""
    start = asset.positions(q)[joint]
    limits = asset.joint(joint).limits
    end = wanted if limits is None else min(max(wanted, limits[0]), limits[1])
    reached = start
    for place in _places(asset, joint, start, end):
        # a condition at the center of an interval holds up to the next threshold of a dependency
        blocked = asset.blocked({**q, joint: (reached + place) / 2.0})
        if blocked:
            return {**q, joint: reached}, blocked
        back = 0.0 if not asset.blocked({**q, joint: place}) else _NUDGE if end > start else -_NUDGE
        reached = place - back
    blocked = asset.blocked({**q, joint: end})
    return {**q, joint: reached if blocked else end}, blocked


def settled(asset: Asset, q: Mapping[str, float]) -> dict[str, float]:
    """Return allowed positions near given ones, without a search."""
    result = {}
    for joint in asset.free_joints:
        if joint.name in q:
            low, high = joint.limits or (q[joint.name], q[joint.name])
            result[joint.name] = min(max(q[joint.name], low), high)
    for _ in asset.joints:  # closing one joint may block another
        blocked = asset.blocked(result)
        if not blocked:
            break
        result |= {name: asset.joint(name).closed for name in _leaders(asset, blocked)}
    return result


def _leaders(asset: Asset, joints: tuple[str, ...]) -> set[str]:
    names = {leader_of(asset, asset.joint(name))[0] for name in joints}
    return {name for name in names if not asset.joint(name).locked}


def _places(asset: Asset, joint: str, start: float, end: float) -> Iterator[float]:
    """Yield the thresholds of dependencies on the path of a joint in order, and the end of the path."""
    found = {end}
    for other in asset.joints:
        if other.needs is None:
            continue
        leader, ratio, offset = leader_of(asset, other)
        if leader == joint and ratio:
            bounds = (0.0, other.needs.until, other.needs.beyond)
            values = [value for bound in bounds if bound is not None for value in (bound, -bound)]
            found.update((value - offset) / ratio for value in values)
        for name, value in _thresholds(other.needs.condition):
            leader, ratio, offset = leader_of(asset, asset.joint(name))
            if leader == joint and ratio:
                found.add((value - offset) / ratio)
    low, high = min(start, end), max(start, end)
    yield from sorted((place for place in found if low <= place <= high), reverse=end < start)


def _thresholds(condition: AssetCondition) -> Iterator[tuple[str, float]]:
    if condition.joint:
        yield condition.joint, condition.value
    for term in condition.terms:
        yield from _thresholds(term)


_ATTEMPTS = 100  # most draws for a new seed, as in `generate`
_VALUES = 16384  # values in the cache: of the largest category, for several values of a slider


@dataclass(frozen=True)
class Shown:
    """An asset with its parameters and evaluation."""

    asset: Asset  # the asset
    evaluation: Evaluation  # cost of its evaluation
    seconds: float  # duration, including sampling and building [s]
    seed: int  # seed
    overrides: Mapping[str, Any] = field(default_factory=dict)  # overrides by name


class Session:
    """A category with a seed, overrides, and joint positions.

    If a request fails, `fault` has the message, and the previous asset stays.

    Attributes:
        source: The category.
        seed: Seed of the draws.
        overrides: Values by name; those of unselected generators are kept for later.
        shown: The last generated asset; None before the first.
        q: Positions of the free joints that are not at rest [rad or m].
        fault: Error of the last request; empty if it succeeded.
        held: Reason why a joint stops; empty if it does not.
        certificate: Certificate of the asset; None while it is unknown.
    """

    def __init__(
        self, source: CategorySource, seed: int = 0, overrides: Mapping[str, Any] | None = None
    ) -> None:
        """Start a session; `evaluate` generates the asset.

        Raises:
            ParameterError: The seed is negative, or an override is unknown or not allowed.
        """
        source.generator.sample(seed, overrides=overrides)
        self.source = source
        self.seed = seed
        self.overrides: dict[str, Any] = dict(overrides or {})
        self.shown: Shown | None = None
        self.q: dict[str, float] = {}
        self.fault = ""
        self.held = ""
        self.certificate: Certificate | None = None
        self._cache = Cache(_VALUES)
        self._attempts = _ATTEMPTS
        self._controls: tuple[ParameterControl, ...] = ()

    @property
    def asset(self) -> Asset:
        """The shown asset.

        Raises:
            ParameterError: No asset could be generated yet.
        """
        if self.shown is None:
            raise ParameterError(self.fault or f"{self.source.text} is not evaluated yet")
        return self.shown.asset

    # requests

    def set(self, name: str, value: Any) -> None:
        """Set a parameter by its full name, even to its drawn value."""
        control, known = self._control(name), self.source.generator.parameters()
        if name not in known:  # a browser may not have received a change yet
            raise ParameterError(f"{self.source.text} has no parameter {name!r}")
        if control is not None:
            self.overrides.pop(control.short, None)
            value = read_value(control, known[name].kind, value)
        self.overrides[name] = value

    def unset(self, name: str) -> None:
        """Remove the override of a parameter."""
        control = self._control(name)
        self.overrides.pop(name, None)
        if control is not None:
            self.overrides.pop(control.short, None)

    def reset(self) -> None:
        """Remove all overrides."""
        self.overrides.clear()
        self._attempts = _ATTEMPTS

    def resample(self, seed: int) -> None:
        """Use another seed; overrides stay."""
        self.seed = seed
        self._attempts = _ATTEMPTS

    def reload(self) -> bool:
        """Load the category again after its file was saved; return whether that succeeded."""
        try:
            self.source.reload()
        except ArtgenError as error:
            self.fault = message_of(error)
            return False
        known = self.source.generator.parameters()
        short = {".".join(name.split(".")[::2]) for name in known}
        self.overrides = {
            name: value for name, value in self.overrides.items() if name in known or name in short
        }
        self._cache = Cache(_VALUES)  # the file may define operations with changed results
        self._attempts = _ATTEMPTS
        return True

    # results

    def evaluate(self) -> bool:
        """Generate the requested asset, using the cache; return whether that succeeded.

        A new seed is drawn as often as `generate` would. Later overrides are not drawn again, so that an
        infeasible value is an error instead of another asset.
        """
        overrides = self._applicable()
        start = time.perf_counter()
        try:
            asset, evaluation = self.source.generator.evaluate(
                self.seed,
                cache=self._cache,
                attempts=self._attempts,
                certify=False,
                overrides=overrides,
            )
        except Exception as error:  # noqa: BLE001 - whatever an author's file raises is a message
            self.fault = message_of(error)
            if isinstance(error, InfeasibleError) and self._attempts < _ATTEMPTS:
                self.fault = self.fault.partition("; the last: ")[2] or self.fault
            return False
        self.fault = ""
        self._attempts = asset.attempt + 1
        self._controls = parameters_in_use(self.source.generator, asset)
        self.shown = Shown(asset, evaluation, time.perf_counter() - start, self.seed, overrides)
        self.certificate = None
        self.q = settled(asset, self.q)
        self.held = ""
        return True

    def controls(self) -> tuple[ParameterControl, ...]:
        """Return a control for each parameter of the asset."""
        return self._controls

    def is_set(self, control: ParameterControl) -> bool:
        """Tell whether a user set a parameter."""
        return control.name in self.overrides or control.short in self.overrides

    # joints

    def joints(self) -> tuple[JointControl, ...]:
        """Return a control for each joint that can move."""
        return joint_controls(self.asset, self.q) if self.shown is not None else ()

    def move(self, joint: str, wanted: float) -> float:
        """Move a free joint as far as dependencies allow, and return its position [rad or m].

        `held` has the reason if it stops early.
        """
        self.q, blocked = moved(self.asset, self.q, joint, wanted)
        reasons = []
        for name in blocked:
            needs = self.asset.joint(name).needs
            reasons.append(f"{name} waits for {needs}" if name == joint else f"then {name} needs {needs}")
        self.held = f"{joint} is held: {'; '.join(reasons)}" if reasons else ""
        return self.asset.positions(self.q)[joint]

    def pose(self, q: Mapping[str, float]) -> None:
        """Put the joints at given positions, such as those of a witness, regardless of dependencies."""
        self.q = {name: float(position) for name, position in q.items()}
        self.held = ""

    # the certificate

    def task(self) -> ProofTask | None:
        """Return the task for certifying the asset in another process; None without an asset."""
        if self.shown is None or self.fault:
            return None
        source, shown = self.source, self.shown
        attempts = shown.asset.attempt + 1
        return ProofTask(source.reference, source.revision, shown.seed, attempts, dict(shown.overrides))

    def certified(self, certificate: Certificate) -> None:
        """Attach a certificate to the shown asset."""
        self.certificate = certificate
        remember(self.asset, certificate)

    @property
    def collisions(self) -> tuple[PairResult, ...]:
        """The pairs of links that collide somewhere, the deepest first."""
        pairs = self.certificate.failures if self.certificate is not None else ()
        found = [pair for pair in pairs if pair.witness is not None]
        return tuple(sorted(found, key=lambda pair: (pair.verdict != "collision", -_depth(pair))))

    # output

    def python(self) -> str:
        """Return Python source that generates the shown asset."""
        asset, shown, generator = self.asset, self.shown, self.source.generator
        assert shown is not None
        lines = ["import artgen", ""]
        arguments = [f"seed={shown.seed}"]
        for name, value in shown.overrides.items():
            short = self._short(name)
            drawn = asset.parameters.get(short) if isinstance(value, Distribution) else value
            arguments.append(f"{short.replace('.', '__')}={drawn!r}")
        if self.certificate is None:
            arguments.append("certify=False")
        elif not self.certificate.proven:
            arguments.append('on_collision="keep"')
        if is_file(self.source.text):
            lines[0] = "from artgen import catalog"
            made = f"catalog.load_file({self.source.text!r}).generate({', '.join(arguments)})"
        else:
            made = f'artgen.generate("{generator.name}", {", ".join(arguments)})'
        note = f"  # the draw {asset.attempt + 1} of that seed" if asset.attempt else ""
        return "\n".join([*lines, f"asset = {made}{note}"])

    def export(self, folder: str | Path, formats: tuple[str, ...]) -> Path:
        """Write the shown asset; see `artgen.export.export`.

        Raises:
            ParameterError: No folder or no format is given.
            ExportError: The folder cannot be written, or holds other files.
        """
        if not str(folder).strip():
            raise ParameterError("give the folder to export to")
        if not formats:
            raise ParameterError("choose a format to export")
        return self.asset.export(folder, formats=formats)

    def _control(self, name: str) -> ParameterControl | None:
        return next((control for control in self.controls() if control.name == name), None)

    def _applicable(self) -> dict[str, Any]:
        """Return the overrides without those of generators other than the selected one."""
        chosen = {self._short(name): value for name, value in self.overrides.items()}
        result = {}
        for name, value in self.overrides.items():
            parts = name.split(".") if self._short(name) != name else [name]
            owners = [(".".join(parts[:end:2]), parts[end]) for end in range(1, len(parts), 2)]
            if all(chosen.get(owner, generator) == generator for owner, generator in owners):
                result[name] = value
        return result

    def _short(self, name: str) -> str:
        """Return the name of a parameter without the generators; short names stay."""
        known = name in self.source.generator.parameters()
        return ".".join(name.split(".")[::2]) if known else name


def message_of(error: BaseException) -> str:
    """Return the message of an error; for errors of other packages with their type."""
    if isinstance(error, ArtgenError):
        return str(error)
    return f"{type(error).__name__}: {error}"


def _depth(pair: PairResult) -> float:
    return pair.witness.depth if pair.witness is not None else 0.0
