"""The program that makes assets with scene-synthesizer, in an environment where it is installed.

It prints the package's version, then for each line of JSON on stdin, `{"kind", "seed", "path"}`, makes that
asset, writes it as URDF and prints the processor time [s] or the error.
"""

import io
import json
import sys
import time
from contextlib import redirect_stdout
from importlib import metadata

import scene_synthesizer
from scene_synthesizer import procedural_assets


def made(kind: str, seed: int, path: str) -> dict[str, float]:
    """Make an asset of a class, with random parameters if the class draws them, and write it."""
    start = time.process_time()
    maker = getattr(procedural_assets, kind)
    asset = maker.random(seed=seed) if hasattr(maker, "random") else maker()
    scene = scene_synthesizer.Scene()
    scene.add_object(asset, kind)
    scene.export(path)
    return {"seconds": time.process_time() - start}


def main() -> None:
    """Answer requests until stdin ends."""
    answers = sys.stdout
    answers.write(json.dumps({"version": metadata.version("scene_synthesizer")}) + "\n")
    answers.flush()
    for line in sys.stdin:
        with redirect_stdout(io.StringIO()):
            try:
                answer: dict[str, object] = {**made(**json.loads(line))}
            except Exception as error:  # noqa: BLE001 - any error of the peer is an answer
                answer = {"error": f"{type(error).__name__}: {error}"}
        answers.write(json.dumps(answer) + "\n")
        answers.flush()


if __name__ == "__main__":
    main()
