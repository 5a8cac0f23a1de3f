"""Layouts: how the files of an export lie, for simulators and for the readers of well-known datasets."""

from collections.abc import Mapping

from artgen.export.formats import FLAT
from artgen.export.layouts.partnet import PARTNET_MOBILITY
from artgen.export.layouts.robocasa import ROBOCASA
from artgen.export.layouts.simready import SIMREADY
from artgen.export.losses import Layout

LAYOUTS: Mapping[str, Layout] = {
    layout.name: layout for layout in (FLAT, SIMREADY, PARTNET_MOBILITY, ROBOCASA)
}
"""Every layout by its name."""

__all__ = ["LAYOUTS", "Layout"]
