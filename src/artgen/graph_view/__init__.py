"""The node graph of a category as a page: values, times, cache and geometry of every node."""

from artgen.graph_view.page import graph_page

__all__ = ["graph_page"]
