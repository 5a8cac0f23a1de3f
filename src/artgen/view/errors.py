"""What goes wrong with pictures."""

from artgen.errors import RenderError as RenderError
