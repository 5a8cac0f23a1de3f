"""A session of the studio without a user interface: requests, the shown asset, joints, and errors."""

import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from artgen.asset import Asset
from artgen.asset.asset import remember
from artgen.asset.certificate import Certificate, PairResult
from artgen.catalog import find, is_file, load_file
from artgen.errors import ArtgenError, InfeasibleError, ParameterError
from artgen.generator import Generator
from artgen.graph import Cache, Evaluation
from artgen.sampling import Distribution
from artgen.studio.controls import (
    StudioControl,
    allowed_positions,
    joint_controls,
    moved_joint,
    parameters_in_use,
    read_value,
)

_ATTEMPTS = 100  # most draws for a new seed, as in `generate`
_VALUES = 16384  # values in the cache: of the largest category, for several values of a slider


@dataclass(frozen=True)
class ProofTask:
    """The description of an asset for another process."""

    reference: str  # argument for `artgen.catalog.find`
    revision: int  # number of reloads of its file
    seed: int  # seed
    attempts: int  # most draws
    overrides: Mapping[str, Any]  # overrides by name


@dataclass(frozen=True)
class Shown:
    """An asset with its parameters and evaluation."""

    asset: Asset  # the asset
    evaluation: Evaluation  # cost of its evaluation
    seconds: float  # duration, including sampling and building [s]
    task: ProofTask  # its description for another process
    controls: tuple[StudioControl, ...]  # a control for each parameter


@lru_cache(maxsize=1)
def _category(reference: str, revision: int) -> Generator:
    """Return the category, loaded again if its file was."""
    return find(reference)


def prove(task: ProofTask) -> Certificate:
    """Generate the asset and certify it."""
    generator = _category(task.reference, task.revision)
    asset, _ = generator.evaluate(task.seed, attempts=task.attempts, certify=False, overrides=task.overrides)
    return asset.certify()


class Session:
    """A category with a seed, overrides, and joint positions.

    If a request fails, `error` has the message, and the previous asset stays.

    Attributes:
        category: Name of the category, or its file, as given by the user.
        generator: The category at its last load.
        path: The file that defines it.
        seed: Seed of the draws.
        overrides: Values by name; also those of generators that are not selected now.
        stale: Whether the asset has to be evaluated again.
        shown: The last generated asset; None before the first.
        q: Positions of the free joints that are not at rest [rad or m].
        error: Error of the last request; empty if it succeeded.
        blocked: Reason why a joint stops; empty if it does not.
        certificate: Certificate of the asset; None while it is unknown.
    """

    def __init__(self, category: str, seed: int = 0, overrides: Mapping[str, Any] | None = None) -> None:
        """Load the category; `evaluate` generates the asset.

        Raises:
            ParameterError: There is no such category or file, the seed is negative, or an override is unknown
                or not allowed.
            BuildError: The file has an error, or defines no category.
        """
        self.category = category
        self.generator: Generator = find(category)
        self.generator.sample(seed, overrides=overrides)
        self.path = Path(self.generator.function.__code__.co_filename)
        self.seed = seed
        self.overrides: dict[str, Any] = dict(overrides or {})
        self.stale = True
        self.shown: Shown | None = None
        self.q: dict[str, float] = {}
        self.error = ""
        self.blocked = ""
        self.certificate: Certificate | None = None
        self._reference = category  # argument for `artgen.catalog.find`
        self._revision = 0
        self._saved_at = (0, 0)  # time [ns] and size of the file
        self.saved()
        self._cache = Cache(_VALUES)
        self._attempts = _ATTEMPTS

    @property
    def asset(self) -> Asset:
        """The shown asset.

        Raises:
            ParameterError: No asset could be generated yet.
        """
        if self.shown is None:
            raise ParameterError(self.error or f"{self.category} is not evaluated yet")
        return self.shown.asset

    # requests

    def set(self, name: str, value: Any) -> None:
        """Set a parameter by its full name, even to its drawn value."""
        known = self.generator.parameters()
        if name not in known:  # a browser may not have received a change yet
            raise ParameterError(f"{self.category} has no parameter {name!r}")
        if any(control.name == name for control in self.controls()):
            self.overrides.pop(_without_generators(name), None)
        self.overrides[name] = read_value(known[name].kind, value)
        self.stale = True

    def reset(self) -> None:
        """Remove all overrides."""
        self.overrides.clear()
        self.resample(self.seed)

    def resample(self, seed: int) -> None:
        """Use another seed; overrides stay."""
        self.seed = seed
        self._attempts = _ATTEMPTS
        self.stale = True

    def saved(self) -> bool:
        """Tell whether the file of the category was saved since the last call."""
        before = self._saved_at
        with suppress(OSError):  # while an editor replaces the file, there is none
            found = self.path.stat()
            self._saved_at = found.st_mtime_ns, found.st_size
        return self._saved_at != before

    def reload(self) -> bool:
        """Load the category again after its file was saved; return True on success."""
        reference = self.category if is_file(self.category) else f"{self.path}:{self.generator.name}"
        try:
            self.generator = load_file(reference)
        except ArtgenError as error:
            self.error = message_of(error)
            return False
        self._reference = reference
        self._revision += 1
        names = self.generator.parameters()
        known = {*names, *map(_without_generators, names)}
        self.overrides = {name: value for name, value in self.overrides.items() if name in known}
        self._cache = Cache(_VALUES)  # the file may define operations with changed results
        self.resample(self.seed)
        return True

    # results

    def evaluate(self) -> bool:
        """Generate the requested asset, using the cache; return True on success.

        A new seed may need several draws, as in `generate`. An infeasible override of a shown asset is an
        error instead of a new draw.
        """
        self.stale = False
        overrides = self._applicable()
        start = time.perf_counter()
        try:
            asset, evaluation = self.generator.evaluate(
                self.seed,
                cache=self._cache,
                attempts=self._attempts,
                certify=False,
                overrides=overrides,
                keep_graph=True,
            )
        except Exception as error:  # noqa: BLE001 - the file of an author may raise any exception
            self.error = message_of(error)
            if isinstance(error, InfeasibleError) and self._attempts < _ATTEMPTS:
                self.error = self.error.partition("; the last: ")[2] or self.error
            return False
        self.error = ""
        self._attempts = asset.attempt + 1
        task = ProofTask(self._reference, self._revision, self.seed, self._attempts, overrides)
        values = self.generator.sample(self.seed, attempt=asset.attempt, overrides=overrides)
        drawn = {name: getattr(value, "name", value) for name, value in values.items()}
        controls = tuple(parameters_in_use(self.generator.own, drawn))
        seconds = time.perf_counter() - start
        self.shown = Shown(asset, evaluation, seconds, task, controls)
        self.certificate = None
        self.q = allowed_positions(asset, self.q)
        self.blocked = ""
        return True

    def controls(self) -> tuple[StudioControl, ...]:
        """Return a control for each parameter of the asset."""
        return () if self.shown is None else self.shown.controls

    def is_set(self, control: StudioControl) -> bool:
        """Tell whether a user set a parameter."""
        return control.name in self.overrides or control.short in self.overrides

    # joints

    def joints(self) -> tuple[StudioControl, ...]:
        """Return a control for each joint that can move."""
        return tuple(joint_controls(self.asset, self.q)) if self.shown is not None else ()

    def move(self, joint: str, position: float) -> float:
        """Move a free joint as far as dependencies allow, and return its position [rad or m].

        `blocked` has the reason if it stops early.
        """
        self.q, blocked = moved_joint(self.asset, self.q, joint, position)
        reasons = [
            f"{'it' if name == joint else name} needs {self.asset.joint(name).needs}" for name in blocked
        ]
        self.blocked = f"{joint} is blocked: {'; '.join(reasons)}" if reasons else ""
        return self.asset.positions(self.q)[joint]

    def pose(self, q: Mapping[str, float]) -> None:
        """Put the joints at given positions, such as those of a witness, regardless of dependencies."""
        self.q = {name: float(position) for name, position in q.items()}
        self.blocked = ""

    # the certificate

    def task(self) -> ProofTask | None:
        """Return the task for certifying the asset in another process; None without an asset."""
        return None if self.shown is None or self.error else self.shown.task

    def certified(self, certificate: Certificate) -> None:
        """Attach a certificate to the shown asset."""
        self.certificate = certificate
        remember(self.asset, certificate)

    @property
    def collisions(self) -> tuple[PairResult, ...]:
        """The pairs of links that collide somewhere, the deepest first."""
        pairs = self.certificate.failures if self.certificate is not None else ()
        found = [(pair, pair.witness.depth) for pair in pairs if pair.witness is not None]
        found.sort(key=lambda each: (each[0].verdict != "collision", -each[1]))
        return tuple(pair for pair, _ in found)

    # output

    def python(self) -> str:
        """Return Python source that generates the shown asset."""
        asset = self.asset
        assert self.shown is not None
        arguments = [f"seed={asset.seed}"]
        for name, value in self.shown.task.overrides.items():
            short = self._short(name)
            if isinstance(value, Distribution) and short not in asset.parameters:
                continue  # it does not act
            drawn = asset.parameters[short] if isinstance(value, Distribution) else value
            arguments.append(f"{short.replace('.', '__')}={drawn!r}")
        if self.certificate is None:
            arguments.append("certify=False")
        elif not self.certificate.proven:
            arguments.append('on_collision="keep"')
        if is_file(self.category):
            module = "from artgen import catalog"
            made = f"catalog.load_file({self.category!r}).generate({', '.join(arguments)})"
        else:
            module = "import artgen"
            made = f'artgen.generate("{self.generator.name}", {", ".join(arguments)})'
        note = f"  # draw {asset.attempt + 1} of this seed" if asset.attempt else ""
        return f"{module}\n\nasset = {made}{note}"

    def export(self, folder: str | Path, formats: tuple[str, ...]) -> Path:
        """Write the shown asset; see `artgen.export.export`.

        Raises:
            ParameterError: No folder or no format is given.
            ExportError: The folder cannot be written, or holds other files.
        """
        if not str(folder).strip():
            raise ParameterError("no folder is given: enter a folder to export to")
        if not formats:
            raise ParameterError("no format is selected: select at least one")
        return self.asset.export(folder, formats=formats)

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
        return _without_generators(name) if name in self.generator.parameters() else name


def _without_generators(name: str) -> str:
    return ".".join(name.split(".")[::2])


def message_of(error: BaseException) -> str:
    """Return the message of an error; for errors of other packages with their type."""
    return str(error) if isinstance(error, ArtgenError) else f"{type(error).__name__}: {error}"
