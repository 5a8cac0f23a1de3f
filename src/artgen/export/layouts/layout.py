"""What a layout is: which files an export consists of, and where they lie."""

from collections.abc import Callable
from dataclasses import dataclass

from artgen.asset import Asset
from artgen.export.losses import Written


@dataclass(frozen=True)
class Layout:
    """A way to lay out the files of an asset, as the readers of one dataset expect them.

    Attributes:
        name: Its name, such as `partnet-mobility`.
        summary: Who reads it, in one line.
        formats: The formats that it can hold; those written by default come first.
        default: How many of them are written by default.
        write: Writes one format of an asset with so many texels on a side of its maps; paths of files are
            relative to the directory of the export.
    """

    name: str
    summary: str
    formats: tuple[str, ...]
    default: int
    write: Callable[[Asset, str, int], Written]

    @property
    def default_formats(self) -> tuple[str, ...]:
        """The formats that are written unless others are asked for."""
        return self.formats[: self.default]
