"""One asset of a dataset: drawn, proven and written, in a process of its own."""

from dataclasses import dataclass
from typing import Any

from artgen.asset.files import ASSET_FILE
from artgen.catalog import find
from artgen.dataset.plan import Item, Plan
from artgen.dataset.record import failure, record_of
from artgen.dataset.target import Target
from artgen.errors import ArtgenError, ExportError
from artgen.export.files import encode


@dataclass(frozen=True)
class Made:
    """What came of an item.

    Attributes:
        record: Its line in the manifest; None where the disk refused.
        refusal: What the disk said: no fault of the item, and nothing else can be written either.
    """

    record: dict[str, Any] | None
    refusal: str = ""


def make(item: Item, *, plan: Plan, target: Target) -> Made:
    """Make an asset and put it in its place.

    Args:
        item: Which.
        plan: How assets are drawn and written.
        target: Where to.
    """
    try:
        files = _files(item, plan)
    except Exception as error:  # noqa: BLE001 - whatever a category raises, the others go on
        return Made(failure(item.name, item.category, item.seed, _told(error)))
    try:
        target.put(files, item.path, share=plan.textures == "shared")
    except OSError as error:
        return Made(None, error.strerror or str(error))
    return Made(record_of(files[ASSET_FILE], item.path))


def _files(item: Item, plan: Plan) -> dict[str, bytes]:
    asset, _ = find(item.category).evaluate(
        item.seed,
        base=plan.base,
        certify=plan.certify,
        tolerance=plan.tolerance,
        on_collision=plan.on_collision,
        overrides=plan.overrides_of(item.category),
    )
    return encode(asset, plan.formats, plan.collision, plan.texels, plan.layout, plan.mesh_precision)


def _told(error: Exception) -> str:
    """Spell an error, and for one that artgen did not raise on purpose its type."""
    text = " ".join(str(error).split())
    if isinstance(error, ArtgenError) and not isinstance(error, ExportError):
        return text
    return f"{type(error).__name__}: {text}"
