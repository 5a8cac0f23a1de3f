"""Datasets: many assets in a folder, made by worker processes in interruptible runs."""

from artgen.dataset.card import write_card
from artgen.dataset.plan import Item, Plan, TextureMode
from artgen.dataset.reading import Dataset
from artgen.dataset.run import Summary, generate_many
from artgen.dataset.streams import Stream, stream

__all__ = [
    "Dataset", "Item", "Plan", "Stream", "Summary", "TextureMode", "generate_many", "stream", "write_card",
]  # fmt: skip
