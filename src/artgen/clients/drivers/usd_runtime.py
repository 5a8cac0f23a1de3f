"""Opening a USD of the SimReady layout as its metadata says: with the variant of one simulator enabled."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

# a layer above the asset's own, as a scene that uses the asset has one
_SCENE = """#usda 1.0
(
    defaultPrim = "{asset}"
    kilogramsPerUnit = 1
    metersPerUnit = 1
    subLayers = [@{file}@]
    upAxis = "Z"
)

over "{asset}" (
    variants = {{
        string {runtime} = "Enabled"
    }}
)
{{
}}
"""


@contextmanager
def enabled(request: dict[str, Any], runtime: str) -> Iterator[str]:
    """Give the path of a stage for a simulator: the asset's file itself where a layout has no variants.

    Args:
        request: What the driver is asked.
        runtime: Name of the set of variants of the simulator.
    """
    if request["layout"] != "simready":
        yield request["file"]
        return
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.usda"
        text = _SCENE.format(asset=request["asset"], file=Path(request["file"]).as_posix(), runtime=runtime)
        scene.write_text(text, encoding="utf-8")
        yield str(scene)
