"""Demonstrations as a LeRobotDataset 3.0: tables of frames and episodes; pictures are in the frames.

meta/info.json        features with types and shapes, rate, numbers of episodes and frames
meta/stats.json       statistics of each feature, for its normalization
meta/tasks.parquet    the sentence that describes the task
meta/episodes/        for each episode: frames, asset, seed, file, and its own statistics
data/                 frames: observation.state, observation.images.*, action, applied, next.reward, next.done
"""

import json
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from artgen.errors import needed

INFO_FILE = "meta/info.json"

_DATA = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
_EPISODES = "meta/episodes/chunk-000/file-000.parquet"
_PICTURES = {"rgb": "observation.images.front", "hand_rgb": "observation.images.hand"}
_COUNTERS = ("frame_index", "episode_index", "index", "task_index")  # columns of whole numbers
_QUANTILES = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
_FILE_SIZE = 100  # of a table of frames [MB]
_FILES = 1000  # files of a folder
_SAMPLES = 100  # frames of an episode, and pixels along a side, in the statistics of pictures

Stats = dict[str, NDArray[np.float64]]  # of one feature in one or several episodes


def write_lerobot(folder: Path, demos: Iterable[Any], environment: str, task: str, rate: int) -> int:
    """Write a LeRobotDataset of demonstrations to a new folder, and return the number of their steps.

    Args:
        folder: The new folder.
        demos: Demonstrations, instances of `Demo`.
        environment: Name of the environment.
        task: The sentence that describes the task.
        rate: Steps per second.

    Raises:
        ExportError: pandas or pyarrow is not installed.
    """
    pd, arrow, parquet = _tables()
    rows: list[dict[str, Any]] = []
    stats: list[dict[str, Stats]] = []
    features: dict[str, dict[str, Any]] = {}
    file, path, total = -1, folder, 0
    with ExitStack() as opened:
        writer: Any = None
        for episode, demo in enumerate(demos):
            columns = dict(_columns(demo, episode, total, rate))
            features = features or {name: _feature(name, values) for name, values in columns.items()}
            table = arrow.table({name: _array(arrow, values) for name, values in columns.items()})
            if writer is None or path.stat().st_size > _FILE_SIZE * 2**20:
                file += 1
                path = folder / _DATA.format(chunk_index=file // _FILES, file_index=file % _FILES)
                path.parent.mkdir(parents=True, exist_ok=True)
                opened.close()
                writer = opened.enter_context(parquet.ParquetWriter(path, _described(table.schema, features)))
            writer.write_table(table.cast(writer.schema))
            stats.append({name: _stats(values) for name, values in columns.items()})
            rows.append(
                {
                    "episode_index": episode,
                    "tasks": [task],
                    "length": len(demo),
                    "asset": demo.asset,
                    "seed": demo.seed,
                    "data/chunk_index": file // _FILES,
                    "data/file_index": file % _FILES,
                    "dataset_from_index": total,
                    "dataset_to_index": total + len(demo),
                    "meta/episodes/chunk_index": 0,
                    "meta/episodes/file_index": 0,
                }
                | {
                    f"stats/{name}/{kind}": value.tolist()
                    for name, each in stats[-1].items()
                    for kind, value in each.items()
                }
            )
            total += len(demo)
    info = {
        "codebase_version": "v3.0",
        "robot_type": "panda",
        "environment": environment,
        "total_episodes": len(rows),
        "total_frames": total,
        "total_tasks": 1,
        "chunks_size": _FILES,
        "data_files_size_in_mb": _FILE_SIZE,
        "video_files_size_in_mb": 200,
        "fps": rate,
        "splits": {"train": f"0:{len(rows)}"},
        "data_path": _DATA,
        "video_path": None,
        "features": features,
    }
    (folder / _EPISODES).parent.mkdir(parents=True, exist_ok=True)
    parquet.write_table(arrow.Table.from_pylist(rows), folder / _EPISODES)
    tasks = pd.DataFrame({"task_index": [0]}, index=pd.Index([task], name="task"))
    tasks.to_parquet(folder / "meta/tasks.parquet")
    together = {name: _together([each[name] for each in stats]) for name in features}
    plain = {name: {kind: each.tolist() for kind, each in of.items()} for name, of in together.items()}
    (folder / "meta/stats.json").write_text(json.dumps(plain, indent=4))
    (folder / INFO_FILE).write_text(json.dumps(info, indent=4))
    return total


def is_lerobot(folder: Path, environment: str) -> bool:
    """Tell whether there is no such folder, or one with demonstrations in an environment."""
    _tables()
    if not folder.exists():
        return True
    try:
        return bool(json.loads((folder / INFO_FILE).read_bytes())["environment"] == environment)
    except (OSError, KeyError, ValueError, TypeError):
        return False


def _columns(demo: Any, episode: int, start: int, rate: int) -> Iterator[tuple[str, NDArray[Any]]]:
    """Yield the features of the frames of an episode; the last observation has no action and is left out."""
    count = len(demo)
    yield "observation.state", demo.observations["state"][:-1].astype(np.float32)
    for name, feature in _PICTURES.items():
        if name in demo.observations:
            yield feature, demo.observations[name][:-1]
    yield "action", demo.actions.astype(np.float32)
    yield "applied", demo.applied.astype(np.float32)
    yield "next.reward", demo.rewards.astype(np.float32)
    yield "next.done", demo.dones.astype(bool)
    yield "timestamp", (np.arange(count) / rate).astype(np.float32)
    numbers = np.arange(count), np.full(count, episode), np.arange(start, start + count), np.zeros(count)
    for name, values in zip(_COUNTERS, numbers, strict=True):
        yield name, values.astype(np.int64)


def _feature(name: str, values: NDArray[Any]) -> dict[str, Any]:
    """Return the type and shape of a feature."""
    if name in _PICTURES.values():
        axes = ["height", "width", "channels"]
        return {"dtype": "image", "shape": list(values.shape[1:]), "names": axes}
    return {"dtype": str(values.dtype), "shape": list(values.shape[1:]) or [1], "names": None}


def _array(arrow: Any, values: NDArray[Any]) -> Any:
    """Return the column of a table; pictures are PNG files."""
    if values.ndim == 4:
        files = [{"bytes": _png(each), "path": None} for each in values]
        return arrow.array(files, arrow.struct({"bytes": arrow.binary(), "path": arrow.string()}))
    if values.ndim == 2:
        return arrow.FixedSizeListArray.from_arrays(arrow.array(values.ravel()), values.shape[1])
    return arrow.array(values)


def _png(picture: NDArray[np.uint8]) -> bytes:
    file = BytesIO()
    Image.fromarray(picture).save(file, "PNG")
    return file.getvalue()


def _described(schema: Any, features: Mapping[str, Mapping[str, Any]]) -> Any:
    """Return a schema that tells the package `datasets` the features."""
    of = {}
    for name, each in features.items():
        value: dict[str, Any] = {"dtype": each["dtype"], "_type": "Value"}
        if each["dtype"] == "image":
            value = {"_type": "Image"}
        elif each["shape"] != [1]:
            value = {"feature": value, "length": each["shape"][0], "_type": "Sequence"}
        of[name] = value
    return schema.with_metadata({"huggingface": json.dumps({"info": {"features": of}})})


def _stats(values: NDArray[Any]) -> Stats:
    """Return statistics over the frames of an episode, for pictures of each color in [0, 1]."""
    axes: tuple[int, ...] = (0,)
    if values.ndim == 4:
        step, coarser = -(-len(values) // _SAMPLES), max(1, values.shape[1] // _SAMPLES)
        values = np.moveaxis(values[::step, ::coarser, ::coarser], 3, 1) / 255.0
        axes = (0, 2, 3)
    values = values.astype(np.float64)
    values = values if values.ndim > 1 else values[:, None]
    keep = values.ndim > 2
    kinds: dict[str, Any] = {"min": np.min, "max": np.max, "mean": np.mean, "std": np.std}
    result = {name: np.asarray(kind(values, axis=axes, keepdims=keep)) for name, kind in kinds.items()}
    result |= {
        name: np.quantile(values, share, axis=axes, keepdims=keep) for name, share in _QUANTILES.items()
    }
    result = {name: each[0] if keep else each for name, each in result.items()}
    return result | {"count": np.array([len(values)], np.int64)}


def _together(stats: list[Stats]) -> Stats:
    """Return the statistics of all episodes; their quantiles are means of those of the episodes."""
    counts = [float(each["count"][0]) for each in stats]

    def mean(name: str) -> NDArray[np.float64]:
        return np.average([each[name] for each in stats], axis=0, weights=counts)

    squares = [each["std"] ** 2 + each["mean"] ** 2 for each in stats]
    variance = np.average(squares, axis=0, weights=counts) - mean("mean") ** 2
    return {
        "min": np.min([each["min"] for each in stats], axis=0),
        "max": np.max([each["max"] for each in stats], axis=0),
        "mean": mean("mean"),
        "std": np.sqrt(np.maximum(variance, 0.0)),
        **{name: mean(name) for name in _QUANTILES},
        "count": np.sum([each["count"] for each in stats], axis=0),
    }


def _tables() -> tuple[Any, Any, Any]:
    with needed("a LeRobotDataset needs pandas and pyarrow ({error}): pip install 'artgen[demos,data]'"):
        import pandas as pd
        import pyarrow as pa
        from pyarrow import parquet
    return pd, pa, parquet
