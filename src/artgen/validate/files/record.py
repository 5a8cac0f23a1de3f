"""Check of the part of `asset.json` that describes the export."""

from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from artgen.asset import Asset
from artgen.asset.affordance import affordance_data
from artgen.asset.files import ASSET_FILE
from artgen.asset.report import AGAIN, Finding
from artgen.errors import nearest
from artgen.export.layouts import LAYOUTS

_ROUNDING = 1e-9  # of numbers in asset.json [m or rad]
_SHOWN = 3  # files in one message


def record_findings(
    data: Mapping[str, Any],
    asset: Asset,
    formats: Mapping[str, tuple[str, ...]],
    digests: Mapping[str, str],
    there: Collection[str],
) -> Iterator[Finding]:
    """Yield wrong, contradictory and missing fields of the record of an export.

    Args:
        data: The content of `asset.json`.
        asset: What it describes.
        formats: The files of each format.
        digests: Digest of each file when it was exported.
        there: The listed files that can be read.
    """
    yield from _layout_findings(data, formats)
    yield from _digest_findings(formats, digests, there)
    yield from _mass_findings(data, asset)
    yield from _affordance_findings(data, asset)


def _layout_findings(data: Mapping[str, Any], formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    """Find a layout that clients do not know, by which they choose what they read."""
    name = str(data.get("layout", "flat"))
    if name not in LAYOUTS:
        message = f"{ASSET_FILE} says the layout {name!r}, which no client reads.{nearest(name, LAYOUTS)}"
        yield Finding("files", message, hint=AGAIN)
        return
    strange = [each for each in formats if each not in LAYOUTS[name].formats]
    if strange:
        message = f"{ASSET_FILE} says the layout {name!r}, which has no {', '.join(strange)}"
        yield Finding("files", message, hint=AGAIN)
    if not formats:
        yield Finding("files", f"{ASSET_FILE} lists no format, so nobody can read the asset", hint=AGAIN)


def _digest_findings(
    formats: Mapping[str, tuple[str, ...]], digests: Mapping[str, str], there: Collection[str]
) -> Iterator[Finding]:
    """Find files of which nobody can tell whether they were changed, and those that are listed no more."""
    listed = {path for files in formats.values() for path in files}
    for paths, says in (
        (set(there) - set(digests), "has no digest of {}, so nobody can tell whether it was changed"),
        (set(digests) - listed, "has a digest of {}, which is in the list of no format"),
    ):
        if paths:
            named = ", ".join(sorted(paths)[:_SHOWN])
            named += f" and {len(paths) - _SHOWN} more" if len(paths) > _SHOWN else ""
            message = f"{ASSET_FILE} {says.format(named)}"
            yield Finding("files", message, value=float(len(paths)), hint=AGAIN)


def _mass_findings(data: Mapping[str, Any], asset: Asset) -> Iterator[Finding]:
    mass = data.get("mass")
    total = sum(link.mass_properties.mass for link in asset.links)
    if isinstance(mass, int | float) and not abs(mass - total) <= 1e-6 * total:
        message = f"{ASSET_FILE} has a mass of {mass:.7g} kg, its links together have {total:.7g} kg"
        yield Finding("files", message, value=float(mass), unit="kg", hint=AGAIN)


def _affordance_findings(data: Mapping[str, Any], asset: Asset) -> Iterator[Finding]:
    """Compare the list of affordances with the grasps and pushes of the links."""
    stored = {each["name"]: each for each in data.get("affordances", ())}
    wanted = {each.name: each for each in asset.affordances}
    for name in sorted(stored.keys() ^ wanted.keys()):
        message = (
            f"the affordance {name!r} is in one of the lists of links and affordances of {ASSET_FILE} only"
        )
        yield Finding("files", message, hint=AGAIN)
    for name in sorted(stored.keys() & wanted.keys()):
        away = float(np.abs(np.array(stored[name]["frame"], float) - wanted[name].frame).max())
        if not away <= _ROUNDING or stored[name]["link"] != wanted[name].link:
            message = (
                f"the affordance {name!r} differs by {away:.4g} from the one of the link in {ASSET_FILE}"
            )
            yield Finding("files", message, wanted[name].link, value=away, hint=AGAIN)
            continue
        own = affordance_data(wanted[name], asset)
        differing = [key for key in own if not _same(stored[name].get(key), own[key])]
        if differing:
            message = (
                f"the affordance {name!r} has another {' and '.join(differing)} than links and joints in "
                f"{ASSET_FILE} give it"
            )
            yield Finding("files", message, wanted[name].link, hint=AGAIN)


def _same(found: Any, wanted: Any) -> bool:
    """Tell whether two pieces of JSON data are the same but for rounding."""
    if isinstance(wanted, Mapping):
        return (
            isinstance(found, Mapping)
            and found.keys() == wanted.keys()
            and all(_same(found[key], wanted[key]) for key in wanted)
        )
    if isinstance(wanted, list | tuple):
        return (
            isinstance(found, list)
            and len(found) == len(wanted)
            and all(_same(first, second) for first, second in zip(found, wanted, strict=True))
        )
    if isinstance(wanted, float) and isinstance(found, int | float):
        return abs(found - wanted) <= _ROUNDING * max(1.0, abs(wanted))
    return bool(found == wanted)
