"""The categories: importing this package enters them all in the catalog."""

from artgen.categories import dishwasher, door, handle, lamp, refrigerator, toaster, trashcan

__all__ = ["dishwasher", "door", "handle", "lamp", "refrigerator", "toaster", "trashcan"]
