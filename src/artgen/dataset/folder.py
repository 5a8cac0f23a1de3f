"""The folder of a dataset: its plan, its manifest, a directory for each asset, and shared maps.

The directory of an asset is complete or absent. The manifest line of an asset depends on its `asset.json`
only: if a run is killed between both, the next run writes the same line. During a run, the lines are in the
order of completion; at its end, in the order of the plan.
"""

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text
from artgen.dataset.disk import GO_ON, PLAN_FILE, Lines
from artgen.dataset.plan import Draws, Item, Plan
from artgen.dataset.store import StoreLines, Target
from artgen.dataset.workers import Ending
from artgen.errors import ArtgenError, ExportError, ParameterError
from artgen.version import __version__

MANIFEST_FILE = "manifest.jsonl"

_BATCH = 256  # number of files that are read at once
_DIGEST = 16  # characters of a digest

Record = dict[str, Any]
"""A line of the manifest."""


class Folder:
    """A folder that a run fills; as a `Job`, its items are those of the plan without a record.

    Attributes:
        target: The place of the folder.
        plan: The plan of its content.
        records: Manifest line of each finished or failed asset, by name.
        task: Function that makes an item in a worker process.
    """

    def __init__(self, target: Target, plan: Draws) -> None:
        self.target, self.plan = target, plan
        self.records: dict[str, Record] = {}
        self.task: Callable[[Item], Made] = partial(make, plan=plan, target=target)
        self._lines: Lines | StoreLines | None = None

    @staticmethod
    @contextmanager
    def opened(target: Target, plan: Draws) -> Iterator["Folder"]:
        """Open a folder for one run; create it if necessary, and repair the remains of a killed run."""
        folder = Folder(target, plan.placed(target))
        with writing(target):
            names = sorted(target.names())
            if names and PLAN_FILE not in names:
                raise ExportError(
                    f"cannot write a dataset to {target}: it holds {names[0]!r} and no dataset; choose "
                    "another folder"
                )
            with target.opened():
                folder._begin()
                try:
                    yield folder
                finally:
                    if folder._lines is not None:
                        folder._lines.close()

    def left(self) -> list[Item]:
        """Return the items that have no record."""
        return [item for item in self.plan.items() if item.name not in self.records]

    def add(self, ending: Ending) -> Record:
        """Add the line of a finished or failed asset, and return it."""
        assert self._lines is not None
        item: Item = ending.item
        if ending.state != "done":
            record = failure(item, ending.reason) | {"state": "lost"}
        elif ending.value.record is None:
            raise ExportError(f"an asset cannot be written: {ending.value.refusal}; {GO_ON}")
        else:
            record = ending.value.record
        self.records[item.name] = record
        with writing(self.target):
            self._lines.add(_line(record))
        return record

    def finish(self) -> list[Record]:
        """Sort the manifest in the order of the plan, and return its lines."""
        assert self._lines is not None
        records = [self.records[item.name] for item in self.plan.items() if item.name in self.records]
        with writing(self.target):
            self._lines.close()
            self.target.write(MANIFEST_FILE, "".join(map(_line, records)).encode())
        return records

    def _begin(self) -> None:
        before = _read_plan(self.target, type(self.plan))
        if before is not None:
            _check_same(self.target, before, self.plan)
        if self.plan != before:
            data = {"format": self.plan.FORMAT, "version": __version__, "plan": self.plan.to_data()}
            self.target.write(PLAN_FILE, json_text(data).encode())
        known = {str(record["name"]): record for record in read_manifest(self.target)}
        states = {name: record["state"] for name, record in known.items()}
        items = list(self.plan.items())
        made = self.target.complete(item.path for item in items) if before is not None else set()
        unlisted = [item.path for item in items if item.path in made and states.get(item.name) != "done"]
        listed = dict(_read_records(self.target, unlisted))
        for item in items:
            if item.path in listed:
                self.records[item.name] = listed[item.path]
            elif states.get(item.name) == ("done" if item.path in made else "failed"):
                self.records[item.name] = known[item.name]
        text = "".join(map(_line, self.records.values()))
        self._lines = self.target.lines(MANIFEST_FILE, text)


@dataclass(frozen=True)
class Made:
    """The result of an item in a worker process."""

    record: Record | None  # line in the manifest; None for a disk error
    refusal: str = ""  # message of the disk: nothing else can be written


def make(item: Item, *, plan: Draws, target: Target) -> Made:
    """Make the files of an item and put them in its directory."""
    try:
        files = plan.files(item)
    except Exception as error:  # noqa: BLE001 - a category may raise anything; the other items go on
        text = " ".join(str(error).split())
        expected = isinstance(error, ArtgenError) and not isinstance(error, ExportError)
        return Made(failure(item, text if expected else f"{type(error).__name__}: {text}"))
    try:
        target.put(files, item.path, share=plan.shares_maps)
    except OSError as error:
        return Made(None, error.strerror or str(error))
    return Made(record_of(files[ASSET_FILE], item.path))


def record_of(text: bytes, path: str) -> Record:
    """Return the manifest line of an asset, from its `asset.json` alone."""
    data = json.loads(text)
    certificate = data["certificate"]
    return {
        "name": data["name"],
        "category": data["category"],
        "seed": data["seed"],
        "state": "done",
        "path": path,
        "files": {name: each["main"] for name, each in data["formats"].items()},
        "attempt": data["attempt"],
        "proven": None if certificate is None else certificate["proven"],
        "mass": data["mass"],
        "links": len(data["links"]),
        "joints": {joint["name"]: joint["kind"] for joint in data["joints"]},
        "parameters": data["parameters"],
        "digest": hashlib.sha256(text).hexdigest()[:_DIGEST],
    }


def failure(item: Item, error: str) -> Record:
    """Return the manifest line of an asset that cannot be made."""
    return {
        "name": item.name,
        "category": item.category,
        "seed": item.seed,
        "state": "failed",
        "error": error,
    }


def stored_plan(target: Target, form: str = Plan.FORMAT) -> dict[str, Any] | None:
    """Return the content of the plan file of a folder; None if the folder holds no dataset."""
    text = target.read(PLAN_FILE)
    if text is None:
        return None
    try:
        data = json.loads(text)
    except ValueError as error:
        raise ExportError(f"{target}/{PLAN_FILE} is damaged: {error}; choose another folder") from error
    found = data.get("format") if isinstance(data, dict) else None
    if found != form:
        raise ExportError(f"{target}/{PLAN_FILE} has format {found!r}, not {form!r}; choose another folder")
    return dict(data)


def _read_plan(target: Target, kind: type[Draws]) -> Draws | None:
    """Return the plan of a folder that a run may continue; None if it holds no dataset."""
    data = stored_plan(target, kind.FORMAT)
    if data is None:
        return None
    if data["version"] != __version__:
        raise ExportError(
            f"{target} holds assets of artgen {data['version']}, and this is {__version__}: the same seeds "
            "may give others; choose another folder"
        )
    try:
        return kind.from_data(data["plan"])
    except ParameterError as error:
        raise ExportError(f"{target}/{PLAN_FILE}: {error}") from error


def read_manifest(target: Target) -> Iterator[Record]:
    """Yield the lines of a manifest; an incomplete last line of a killed run is skipped."""
    *lines, _ = (target.read(MANIFEST_FILE) or b"").decode(errors="replace").split("\n")
    for number, line in enumerate(lines):
        try:
            record = json.loads(line)
            inside(Path(), record.get("path", "none"))
            yield record
        except (AttributeError, ValueError, ExportError) as error:
            raise ExportError(
                f"{target}/{MANIFEST_FILE}: line {number + 1} is damaged ({error}); remove the file, and the "
                "next run makes it again from the assets"
            ) from error


def _read_records(target: Target, paths: Sequence[str]) -> Iterator[tuple[str, Record]]:
    """Yield the directory and the line of each existing asset."""
    for start in range(0, len(paths), _BATCH):
        texts = target.contents(f"{path}/{ASSET_FILE}" for path in paths[start : start + _BATCH])
        for name, text in texts.items():
            path = name.rpartition("/")[0]
            try:
                yield path, record_of(text, path)
            except (ValueError, LookupError) as error:
                raise ExportError(
                    f"{target}/{name} is damaged: {error!r}; remove {target}/{path}, and the same command "
                    "makes the asset again"
                ) from error


def _check_same(target: Target, before: Draws, plan: Draws) -> None:
    """Raise ExportError for a plan that differs from the stored one in more than a larger count."""
    if before.count > plan.count:
        raise ExportError(
            f"{target} holds a dataset of {before.count} assets: ask for as many or for more, or choose "
            "another folder"
        )
    old, new = before.to_data(), replace(plan, count=before.count).to_data()
    for name, value in old.items():
        if value != new[name]:
            raise ExportError(
                f"{target} holds a dataset with {name} = {_shown(value)}, not {_shown(new[name])}: go on "
                "with the same options, or choose another folder"
            )


def _shown(value: Any) -> str:
    return ",".join(map(str, value)) or "none" if isinstance(value, list) else repr(value)


def _line(record: Mapping[str, Any]) -> str:
    return json.dumps(record, allow_nan=False, ensure_ascii=False) + "\n"


@contextmanager
def writing(target: Target) -> Iterator[None]:
    """Convert a disk error to an ExportError that names the place."""
    try:
        yield
    except ExportError:
        raise
    except OSError as error:
        raise ExportError(f"cannot write to {target}: {error.strerror or error}; {GO_ON}") from error
