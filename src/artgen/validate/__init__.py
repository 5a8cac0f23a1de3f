"""Checks of exported assets: solids, tree, colliders, files, formats, hands, behavior, simulators."""

import math
import tempfile
from collections.abc import Callable, Collection
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from artgen._arrays import cached_property
from artgen._progress import progress
from artgen.asset import Asset
from artgen.asset.collision import mesh_precision
from artgen.asset.report import CheckResult, Finding, Report
from artgen.errors import ArtgenError, ParameterError, nearest
from artgen.export.layouts import DEFAULT_FORMATS
from artgen.validate.files import Exported, read_export

if TYPE_CHECKING:
    from artgen.validate.readback.compare import Expected


CHECKS = (
    "files",
    "solids",
    "tree",
    "colliders",
    *DEFAULT_FORMATS,
    "certificate",
    "grasps",
    "outputs",
    "room",
    "behavior",
)
"""Names of the checks, in the order in which they run."""

_MODULES = {"certificate": "files", "grasps": "hands"}  # of other names than the check
_MESH_CHECKS = ("solids", "colliders", "grasps")


def validate(
    target: Asset | str | Path, *, behavior: bool = True, checks: Collection[str] | None = None
) -> Report:
    """Run the checks of an asset on its exported files."""
    for name in checks or ():
        if name not in CHECKS:
            raise ParameterError(f"there is no check {name!r}.{nearest(name, CHECKS)}")
    if not isinstance(target, Asset):
        return Examination(target, behavior=behavior).report(checks)
    with tempfile.TemporaryDirectory(prefix="artgen_") as folder:
        directory = target.export(Path(folder) / target.name)
        return Examination(directory, behavior=behavior).report(checks)


class Examination:
    """Checks of one exported asset; each runs on first request."""

    def __init__(self, directory: str | Path, *, behavior: bool = True) -> None:
        self.directory = Path(directory)
        self._behavior = behavior
        self._exported: Exported = read_export(self.directory)
        self._results: dict[str, CheckResult] = {"files": self._exported.result}

    @property
    def name(self) -> str:
        """Name of the asset, or of its directory if the asset cannot be read."""
        asset = self._exported.asset
        return self.directory.resolve().name if asset is None else asset.name

    @property
    def checks(self) -> tuple[str, ...]:
        """Names of the checks that apply to the export, in order."""
        asset, formats = self._exported.asset, self._exported.formats
        left_out = {*DEFAULT_FORMATS} - {*formats}
        if asset is None or not asset.is_room:
            left_out.add("room")
        return tuple(name for name in CHECKS if name not in left_out)

    def report(self, checks: Collection[str] | None = None) -> Report:
        """Run the named checks, by default all, in the order of `CHECKS`."""
        chosen = [name for name in CHECKS if name in (self.checks if checks is None else checks)]
        asset = self._exported.asset
        near: dict[str, tuple[float, float]] = {}
        for joint in asset.joints if asset is not None else ():
            low, high = joint.limits or (-math.pi, math.pi)
            near[joint.name] = (joint.closed - 0.01 * (high - low), joint.closed + 0.01 * (high - low))
        return Report(self.name, tuple(self.result(name) for name in chosen), near=near)

    def result(self, check: str) -> CheckResult:
        """Return the result of a check; it runs on first request."""
        if check not in self._results:
            why_not = self._why_not(check)
            with progress(f"check {check}"):
                skipped = CheckResult(check, skipped=why_not)
                self._results[check] = skipped if why_not else guarded(check, lambda: self._run(check))
        return self._results[check]

    def _why_not(self, check: str) -> str:
        """Return the reason why a check cannot run; empty if it can."""
        formats = self._exported.formats
        if self._exported.asset is None:
            return "the asset cannot be read"
        if self._special is not None:  # a reader would wait for it for ever
            return f"{self._special} is a device, a pipe or a socket"
        if check in DEFAULT_FORMATS and check not in formats:
            return f"the export has no {check}"
        if check in (*DEFAULT_FORMATS, "room", "behavior") and self._exported.layout == "parts":
            return "the layout parts has files of single assets"
        if check in _MESH_CHECKS and not self._exported.meshes:
            return "the export has no meshes to read back: those of urdf and mjcf in the layout flat have"
        if check in _MESH_CHECKS and (precision := mesh_precision(*self._exported.asset.links)):
            return f"its meshes, precise to {1e3 * precision:g} mm, are not those of the solids"
        if check == "grasps" and self._exported.asset.detail == "low":
            return "its solids have low detail; fingers are checked at full detail"
        if check == "behavior" and not self._behavior:
            certificate = self._exported.asset.certificate
            proven = certificate is None or certificate.proven
            return "not requested" if proven else "not simulated, because its links are not proven apart"
        return "the export has no mjcf" if check == "behavior" and "mjcf" not in formats else ""

    def _run(self, check: str) -> CheckResult:
        asset = self._exported.asset
        assert asset is not None
        if check in DEFAULT_FORMATS:
            from artgen.validate.readback import check_format

            return check_format(check, self._expected, self.directory)
        # each check imports its packages on first use
        module = import_module(f"artgen.validate.{_MODULES.get(check, check)}")
        run: Callable[..., CheckResult] = getattr(module, f"check_{check}")
        if check == "certificate":
            return run(asset, meshes=self._exported.meshes)
        return run(asset, self.directory) if check == "behavior" else run(asset)

    @cached_property
    def _special(self) -> Path | None:
        """A path of the export that is neither a file nor a directory; None if there is none."""
        paths = sorted(self.directory.rglob("*"))
        return next(
            (each for each in paths if each.exists() and not each.is_file() and not each.is_dir()), None
        )

    @cached_property
    def _expected(self) -> "Expected":
        from artgen.validate.readback.compare import Expected

        assert self._exported.asset is not None
        return Expected(self._exported.asset)


def guarded(check: str, run: Callable[[], CheckResult]) -> CheckResult:
    """Run a check; an exception becomes a fault, and the other checks still run."""
    try:
        return run()
    except Exception as error:  # noqa: BLE001 - a damaged file may make a check raise anything
        reason = str(error) if isinstance(error, ArtgenError) else f"{type(error).__name__}: {error}"
        hint = "correct the faults of the other checks, or export the asset again"
        return CheckResult(check, (Finding(check, f"the check could not run: {reason}", hint=hint),))
