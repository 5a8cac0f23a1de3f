"""The studio: a category in the browser with live parameters and joints.

`session` and its modules are independent of a browser; `app` serves a session with viser, from the extra
`artgen[studio]`.
"""

from artgen.studio.session import Session

__all__ = ["Session"]
