"""Where an asset comes from and what it is, in the words of SimReady."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from pxr import Gf

from artgen.asset import Asset
from artgen.asset.wikidata import category_code
from artgen.export.frames import chain, seen_box

PROFILE = ("Robotics-Prop", "4.0.0")
"""The profile that the layout is made for, and its version."""

LICENCE = "Apache-2.0"
"""Of artgen, under which also stands what it makes."""

UNDATED = "undated: equal bytes for equal seeds, whenever they are made"
"""In the place of a date, which would make two exports of one asset differ."""


def metadata(asset: Asset, variants: Sequence[str]) -> dict[str, Any]:
    """Return the metadata of the layer that is opened."""
    found = _simready(asset, variants)
    # the oldest version of the profile's core wants these outside as well
    outside = ("asset_name", "asset_type", "source_file", "usd_date_generated")
    return {"SimReady_Metadata": found, **{name: found[name] for name in outside}}


def _simready(asset: Asset, variants: Sequence[str]) -> dict[str, Any]:
    profile, version = PROFILE
    return {
        "Variants": {
            "Physics": {
                name: {"activateOption": "Enabled", "prim": f"/{asset.name}", "variantSetName": name}
                for name in sorted(variants)
            }
        },
        "artgen_version": asset.version,
        "asset_extents": Gf.Vec3f(*np.ptp(seen_box(asset), axis=0).round(6).tolist()),
        "asset_license": LICENCE,
        "asset_name": asset.name,
        "asset_type": "prop",
        "author": "artgen",
        "category": asset.category,
        "mass": float(f"{asset.mass:.6g}"),
        "qcode": category_code(asset.category),
        "rigid_body_count": 1 + len(chain(asset)),
        "seed": str(asset.seed),
        "source_file": f"artgen.generate({asset.category!r}, seed={asset.seed})",
        "usd_date_generated": UNDATED,
        "validation": {"profile": profile, "profile_version": version},
    }
