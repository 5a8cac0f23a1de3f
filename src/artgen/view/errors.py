"""What goes wrong with pictures."""

from artgen.errors import ArtgenError


class RenderError(ArtgenError, RuntimeError):
    """A picture could not be drawn: a renderer, or a library that it needs, is not there."""
