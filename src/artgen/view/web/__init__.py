"""The web viewer: an asset, or a gallery of many, as offline pages."""

from artgen.view.web.page import TEXTURES, Page, check_page, page_of

__all__ = ["TEXTURES", "Page", "check_page", "page_of"]
