"""Pictures of assets: colors, segmentation, depth and normals, sheets of many samples, and pages."""

from artgen.errors import RenderError
from artgen.view.camera import VIEWS, Camera, View
from artgen.view.opening import opened
from artgen.view.page import Page
from artgen.view.picture import Picture, Segmentation
from artgen.view.rendering import render
from artgen.view.viewer import page_of

__all__ = [
    "VIEWS", "Camera", "Page", "Picture", "RenderError", "Segmentation", "View", "opened", "page_of",
    "render",
]  # fmt: skip
