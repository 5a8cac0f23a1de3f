"""What generators remember together, and how it is let go when the interpreter ends."""

import atexit
import sys

from artgen.graph import Cache

SHARED = Cache()
"""Values of the subgraphs of all generators that were given no cache of their own."""


@atexit.register
def _let_go() -> None:
    """Forget all solids while manifold3d is still there.

    Where torch is loaded, modules outlive the interpreter; the solids that they remember would, too, and
    manifold3d would complain of each.
    """
    SHARED.clear()
    for name, module in list(sys.modules.items()):
        if name.startswith("artgen."):
            for value in vars(module).values():
                if hasattr(value, "cache_clear"):
                    value.cache_clear()
