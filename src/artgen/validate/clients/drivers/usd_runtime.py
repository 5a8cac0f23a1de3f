"""Opening a USD of the SimReady layout as its metadata says: with the variant of one simulator enabled."""

import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

# a layer above the asset's own, as a scene that uses the asset has one; the units are the asset's
_SCENE = """#usda 1.0
(
    {metadata}
    subLayers = [@{file}@]
)

over "{asset}" (
    variants = {{
        string {runtime} = "Enabled"
    }}
)
{{
}}
"""

_METADATA = re.compile(r"^    ((?:defaultPrim|kilogramsPerUnit|metersPerUnit|upAxis) = .*)$", re.MULTILINE)


@contextmanager
def enabled(request: dict[str, Any], runtime: str) -> Iterator[str]:
    """Give the path of a stage for a simulator: the asset's file itself where a layout has no variants."""
    if request["layout"] != "simready":
        yield request["file"]
        return
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.usda"
        file = Path(request["file"])
        metadata = "\n    ".join(_METADATA.findall(file.read_text(encoding="utf-8")))
        text = _SCENE.format(asset=request["asset"], file=file.as_posix(), metadata=metadata, runtime=runtime)
        scene.write_text(text, encoding="utf-8")
        yield str(scene)
