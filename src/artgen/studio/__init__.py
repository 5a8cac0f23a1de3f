"""The studio: a category in the browser with live parameters and joints.

`session` and what it uses know no browser; `app` serves one with viser, of the extra `artgen[studio]`.
"""

from artgen.studio.session import Session
from artgen.studio.source import CategorySource

__all__ = ["CategorySource", "Session"]
