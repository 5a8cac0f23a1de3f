"""One asset of a dataset: drawn, proven and written, in a process of its own."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from artgen.asset.files import ASSET_FILE
from artgen.dataset.plan import Item, Plan
from artgen.dataset.record import failure, record_of
from artgen.dataset.target import Target
from artgen.errors import ArtgenError, ExportError
from artgen.export.files import encode


@dataclass(frozen=True)
class Made:
    """What came of an item."""

    record: dict[str, Any] | None  # its line in the manifest; None where the disk refused
    refusal: str = ""  # what the disk said: no fault of the item, and nothing else can be written either


def make(item: Item, *, plan: Plan, target: Target) -> Made:
    """Make an asset and put it in its place."""
    return put(item, lambda: _files(item, plan), target, share=plan.textures == "shared")


def put(item: Item, files_of: Callable[[], dict[str, bytes]], target: Target, *, share: bool) -> Made:
    """Make the files of an item and put them in its place."""
    try:
        files = files_of()
    except Exception as error:  # noqa: BLE001 - whatever a category raises, the others go on
        return Made(failure(item.name, item.category, item.seed, _told(error)))
    try:
        target.put(files, item.path, share=share)
    except OSError as error:
        return Made(None, error.strerror or str(error))
    return Made(record_of(files[ASSET_FILE], item.path))


def _files(item: Item, plan: Plan) -> dict[str, bytes]:
    return encode(
        plan.draw(item), plan.formats, plan.collision, plan.texels, plan.layout, plan.mesh_precision
    )


def _told(error: Exception) -> str:
    """Spell an error, and for one that artgen did not raise on purpose its type."""
    text = " ".join(str(error).split())
    if isinstance(error, ArtgenError) and not isinstance(error, ExportError):
        return text
    return f"{type(error).__name__}: {text}"
