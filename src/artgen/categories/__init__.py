"""The categories: importing this package enters them all in the catalog."""

from artgen.categories import door, handle

__all__ = ["door", "handle"]
