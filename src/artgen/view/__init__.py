"""Pictures of assets: colours, segmentation, depth and normals, and sheets of many samples."""

from artgen.errors import RenderError
from artgen.view.camera import VIEWS, Camera, View
from artgen.view.opening import opened
from artgen.view.picture import Picture, Segmentation
from artgen.view.rendering import close, render

__all__ = ["VIEWS", "Camera", "Picture", "RenderError", "Segmentation", "View", "close", "opened", "render"]
