"""Check that independent readers find the values of the asset in exported files."""

import re
from collections.abc import Iterator
from contextlib import nullcontext
from importlib import import_module
from pathlib import Path

from artgen._arrays import OPENUSD
from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.asset.report import CHANGED, CheckResult, Finding
from artgen.errors import AssetError
from artgen.export.layouts import DEFAULT_FORMATS
from artgen.validate.readback.compare import POSES, Comparison, Expected
from artgen.validate.readback.reading import Reading

_SHOWN = 5  # most complaints of one reader in a report


def check_formats(asset: Asset, directory: str | Path) -> tuple[CheckResult, ...]:
    """Read each exported file with an independent reader and compare it with the asset.

    yourdfpy reads URDF, MuJoCo reads MJCF if it is installed, OpenUSD reads and validates USD.

    Args:
        asset: The asset that the files should describe.
        directory: The directory of the export.

    Returns:
        One result for each existing format of `urdf`, `mjcf` and `usd`.
    """
    expected, files = Expected(asset), main_files(directory)
    checks = [check for check in DEFAULT_FORMATS if check in files and files[check].exists()]
    return tuple(check_format(check, expected, directory) for check in checks)


def check_format(check: str, expected: Expected, directory: str | Path) -> CheckResult:
    """Compare the main file of one format with the asset; see `check_formats`."""
    path = main_files(directory).get(check)
    if path is None or not path.exists():
        return CheckResult(check, (Finding(check, "its main file is missing", hint=CHANGED),))
    asset = expected.asset
    found: list[Finding] = []
    try:
        with OPENUSD if check == "usd" else nullcontext():
            module = import_module(f"{__name__}.{check}")  # its library may be missing
            if check != "usd":  # the faults of a stage are found when it is read
                found += module.element_findings(path)
            reading: Reading = module.read(asset, path)
        found += [*_complaints(check, reading), *reading.findings]
        found += Comparison(check, expected, reading, check).differences()
    except ModuleNotFoundError as error:
        if error.name != "mujoco":
            raise
        return CheckResult(check, tuple(found), skipped="" if found else "needs artgen[sim]")
    except Exception as error:  # noqa: BLE001 - readers may raise anything at a damaged file
        return CheckResult(check, (*found, _unreadable(check, asset, error)))
    moving = sum(not joint.locked for joint in asset.joints)
    detail = f"{reading.file}: {len(reading.inertials)} links, {moving} joints, {POSES + 1} poses"
    return CheckResult(check, tuple(found), detail)


def _unreadable(check: str, asset: Asset, error: Exception) -> Finding:
    """Return the finding for an exception of a reader, with the link or joint that it names."""
    reason = " ".join(str(error).split())
    words = set(re.findall(r"\w+", reason))
    link = next((link.name for link in asset.links if f"'{link.name}'" in reason), "")
    joint = next((joint.name for joint in asset.joints if joint.name in words), "")
    kind = "" if isinstance(error, AssetError) else f"{type(error).__name__}: "
    message = f"it cannot be read: {kind}{reason}"
    return Finding(check, message, link, "" if link else joint, hint=CHANGED)


def _complaints(check: str, reading: Reading) -> Iterator[Finding]:
    texts = list(dict.fromkeys(" ".join(text.split()) for text in reading.complaints))
    for text in texts[:_SHOWN]:
        yield Finding(check, f"its reader complains: {text}", hint=CHANGED)
    if len(texts) > _SHOWN:
        message = f"its reader has {len(texts) - _SHOWN} more complaints"
        yield Finding(check, message, value=float(len(texts)), hint=CHANGED)
