"""Many assets: a folder of them, made by worker processes, complete or to be gone on with."""

from artgen.dataset.dataset import Dataset
from artgen.dataset.plan import Item, Plan, TextureMode
from artgen.dataset.run import Summary, generate_many
from artgen.dataset.streams import Stream, stream

__all__ = ["Dataset", "Item", "Plan", "Stream", "Summary", "TextureMode", "generate_many", "stream"]
