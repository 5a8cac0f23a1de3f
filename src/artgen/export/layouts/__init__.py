"""Layouts: how the files of an export lie, for simulators and for the readers of well-known datasets."""

from collections.abc import Mapping

from artgen.export.layouts.flat import FLAT
from artgen.export.layouts.layout import Layout

LAYOUTS: Mapping[str, Layout] = {layout.name: layout for layout in (FLAT,)}
"""Every layout by its name."""

__all__ = ["LAYOUTS", "Layout"]
