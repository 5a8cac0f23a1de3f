"""The program that steps files in MuJoCo Warp, in an environment where it is installed.

It prints the package's version, then answers each line of JSON on stdin, `{"paths", "worlds", "steps",
"rounds"}`: it steps so many copies of each MJCF from rest, one file after another in each round, and prints
for each file the median number of steps of single worlds per second of the processor, or the error. Compiling
kernels does not count.
"""

import json
import statistics
import sys
import time
from importlib import metadata
from typing import Any

import mujoco
import mujoco_warp
import warp

warp.config.log_level = warp.LOG_ERROR  # answers are alone on stdout

_ROOM = {"nconmax": 256, "njmax": 1024}  # for contacts and constraints of a world


def stepped(paths: list[str], worlds: int, steps: int, rounds: int) -> dict[str, list[float]]:
    """Return the steps of single worlds per second for each file."""
    pairs = []
    for path in paths:
        model = mujoco.MjModel.from_xml_path(path)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        state = mujoco_warp.put_data(model, data, nworld=worlds, **_ROOM)
        pairs.append((mujoco_warp.put_model(model), state))
        mujoco_warp.step(*pairs[-1])
    found: list[list[float]] = [[] for _ in paths]
    for _ in range(rounds):
        for number, (model, data) in enumerate(pairs):
            start = time.process_time()
            for _ in range(steps):
                mujoco_warp.step(model, data)
            found[number].append(worlds * steps / (time.process_time() - start))
    return {"steps": [statistics.median(each) for each in found]}


def main() -> None:
    """Answer requests until stdin ends."""
    sys.stdout.write(json.dumps({"version": metadata.version("mujoco-warp")}) + "\n")
    sys.stdout.flush()
    for line in sys.stdin:
        try:
            answer: dict[str, Any] = stepped(**json.loads(line))
        except Exception as error:  # noqa: BLE001 - any error of the package is an answer
            answer = {"error": f"{type(error).__name__}: {error}"}
        sys.stdout.write(json.dumps(answer) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
