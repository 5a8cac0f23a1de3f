"""Check of exported files: independent readers find the values of the asset."""

import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from artgen._arrays import OPENUSD
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.asset.report import CHANGED, CheckResult, Finding
from artgen.validate.readback.compare import POSES, Expected, differences
from artgen.validate.readback.reading import Reading

_SHOWN = 5  # complaints of one reader


class FormatChecks:
    """The checks of the formats of one export; each file is read when its result is first asked for.

    URDF is read by yourdfpy, MJCF by MuJoCo where it is installed, USD by OpenUSD, whose validators judge it
    as well.

    Args:
        asset: What the files should say.
        directory: The directory of the export.
    """

    def __init__(self, asset: Asset, directory: str | Path) -> None:
        self._expected = Expected(asset)
        self._files = {name: path for name, path in main_files(directory).items() if path.exists()}

    @property
    def checks(self) -> tuple[str, ...]:
        """The formats that are there, of `urdf`, `mjcf` and `usd`."""
        return tuple(check for check in _READERS if check in self._files)

    def result(self, check: str) -> CheckResult:
        """Compare the main file of a format with the asset."""
        if check not in self._files:
            finding = Finding(check, "its main file is missing", hint=CHANGED)
            return CheckResult(check, (finding,))
        return _checked(check, self._expected, self._files[check], _READERS[check])


def check_formats(asset: Asset, directory: str | Path) -> tuple[CheckResult, ...]:
    """Read each exported file with a reader that is not artgen's and compare it with the asset.

    Args:
        asset: What the files should say.
        directory: The directory of the export.

    Returns:
        One result for each format that is there: `urdf`, `mjcf`, `usd`.
    """
    checks = FormatChecks(asset, directory)
    return tuple(checks.result(check) for check in checks.checks)


def _read_urdf(asset: Asset, path: Path) -> Reading:
    from artgen.validate.readback.urdf import read_urdf

    return read_urdf(asset, path)


def _read_mjcf(asset: Asset, path: Path) -> Reading:
    from artgen.validate.readback.mjcf import read_mjcf

    return read_mjcf(asset, path)


def _read_usd(asset: Asset, path: Path) -> Reading:
    with OPENUSD:
        from artgen.validate.readback.usd import read_usd

        return read_usd(asset, path)


_READERS: Mapping[str, Callable[[Asset, Path], Reading]] = {
    "urdf": _read_urdf,
    "mjcf": _read_mjcf,
    "usd": _read_usd,
}


def _structure(check: str, path: Path) -> list[Finding]:
    """Return what is wrong with a file whatever the asset is; of USD its reader tells."""
    from artgen.validate.readback.mjcf_structure import mjcf_findings
    from artgen.validate.readback.urdf_structure import urdf_findings

    judges = {"urdf": urdf_findings, "mjcf": mjcf_findings}
    return list(judges[check](path)) if check in judges else []


def _checked(
    check: str, expected: Expected, path: Path, read: Callable[[Asset, Path], Reading]
) -> CheckResult:
    asset = expected.asset
    found: list[Finding] = []
    try:
        found += _structure(check, path)
        reading = read(asset, path)
        found += [*_complaints(check, reading), *reading.findings, *differences(check, expected, reading)]
    except ModuleNotFoundError as error:
        if error.name != "mujoco":
            raise
        return CheckResult(check, tuple(found), skipped="" if found else "needs artgen[sim]")
    except Exception as error:  # noqa: BLE001 - readers raise whatever they like at a damaged file
        return CheckResult(check, (*found, _unreadable(check, asset, error)))
    moving = sum(not joint.locked for joint in asset.joints)
    detail = f"{reading.file}: {len(reading.inertials)} links, {moving} joints, {POSES + 1} poses"
    return CheckResult(check, tuple(found), detail)


def _unreadable(check: str, asset: Asset, error: Exception) -> Finding:
    """Tell what a reader raised, and of which link or joint it speaks."""
    reason = " ".join(str(error).split())
    words = set(re.findall(r"\w+", reason))
    link = next((link.name for link in asset.links if f"'{link.name}'" in reason), "")
    joint = next((joint.name for joint in asset.joints if joint.name in words), "")
    message = f"it cannot be read: {type(error).__name__}: {reason}"
    return Finding(check, message, link, "" if link else joint, hint=CHANGED)


def _complaints(check: str, reading: Reading) -> Iterator[Finding]:
    said = list(dict.fromkeys(" ".join(text.split()) for text in reading.said))
    for text in said[:_SHOWN]:
        yield Finding(check, f"its reader complains: {text}", hint=CHANGED)
    if len(said) > _SHOWN:
        message = f"its reader has {len(said) - _SHOWN} more complaints"
        yield Finding(check, message, value=float(len(said)), hint=CHANGED)
