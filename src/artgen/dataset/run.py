"""The run that fills the place of a dataset: plan, manifest, a directory for each asset, and shared maps.

The directory of an asset is complete or absent. The manifest line of an asset depends on its `asset.json`
only: if a run is killed between both, the next run writes the same line. During a run, the lines are in the
order of completion; at its end, in the order of the plan.
"""

import hashlib
import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import NoneType
from typing import Any

from artgen._names import inside
from artgen._progress import progress as shown_progress
from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text
from artgen.dataset.places import PLAN_FILE, RESUME, Place, place_of
from artgen.dataset.plan import BasePlan, Item, Plan, check_whole
from artgen.dataset.workers import Ending, EngineName, engine_of, run_job
from artgen.errors import ArtgenError, ExportError, ParameterError
from artgen.version import __version__

MANIFEST_FILE = "manifest.jsonl"

_TRIES = 3  # tries of an item that ends its process or exceeds the time limit
_BATCH = 256  # number of files that are read at once
_DIGEST = 16  # characters of a digest

Record = dict[str, Any]  # a line of the manifest
_Kinds = dict[str, type | tuple[type, ...]]

_KINDS: _Kinds = {"name": str, "category": str, "seed": int, "state": str}  # types in a line of the manifest
_MADE_KINDS: _Kinds = {  # further ones of a finished asset
    "path": str,
    "files": dict,
    "attempt": int,
    "proven": (bool, NoneType),
    "mass": (int, float),
    "links": int,
    "joints": dict,
    "parameters": dict,
}


@dataclass(frozen=True)
class Summary:
    """The result of a run.

    Attributes:
        made: Number of assets made in this run.
        existing: Number of assets made by earlier runs.
        failed: Manifest lines of the assets that failed, in this run and earlier ones.
        seconds: Duration of the run [s].
    """

    made: int
    existing: int
    failed: tuple[Record, ...] = ()
    seconds: float = 0.0


def generate_many(
    plan: BasePlan,
    directory: str | Path,
    *,
    jobs: int | None = None,
    engine: EngineName = "local",
    address: str | None = None,
    limit: float | None = None,
    progress: Callable[[Record], None] | bool = True,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Make all assets of a plan in a folder or at a URL, with a manifest and the tables of the plan.

    The files depend only on the plan, not on the number of processes or interruptions: a run in a folder with
    the same plan makes the missing assets. A failed asset is a line of the manifest with its error. An asset
    that ended its process or exceeded the time limit is tried twice again, and by the next run.

    Args:
        plan: A `Plan`, or an `ImagePlan` for pictures instead of files of the assets, with the files
            `train.json`, `val.json` and `test.json` in the format of COCO.
        directory: A folder, or a URL that fsspec can open; created if necessary. An existing one must be
            empty or hold a dataset with the same plan.
        jobs: Number of processes; by default the number of cores of this process or of the cluster.
        engine: `local` processes, or `ray`.
        address: Address of a running Ray cluster; by default that of the variable RAY_ADDRESS, or a cluster
            is started here.
        limit: Time limit for one asset; by default ten minutes, and one more per picture [s].
        progress: Whether to show the progress in a terminal or notebook, or a function that is called with
            each new line of the manifest.
        begin: Called at the beginning with the number of missing assets.

    Raises:
        ParameterError: The plan is no plan, `jobs` is less than one, or there is no such engine.
        ExportError: The folder holds something else, another run writes to it, the disk reports an error, or
            there is no such cluster; finished assets stay.
        RenderError: MuJoCo, OpenGL or a package for pictures is missing; nothing was written.
    """
    if not isinstance(plan, BasePlan):
        raise ParameterError(f"generate_many takes a plan such as Plan('door', 100), not {plan!r}")
    if jobs is not None:
        check_whole("jobs", jobs, 1, 10**6)
    start = time.monotonic()
    limit = plan.time_limit if limit is None else limit
    place = place_of(directory)
    with engine_of(engine, jobs=jobs, address=address) as run, Folder.opened(place, plan) as folder:
        existing = sum(record["state"] == "done" for record in folder.records.values())
        if begin is not None:
            begin(len(folder.left()))
        made, left = 0, folder.left()
        with shown_progress(
            str(place), None if callable(progress) else len(left), shown=progress is True
        ) as tell:
            for record in run_job(folder.task, left, folder.add, run, limit=limit, tries=_TRIES):
                made += record["state"] == "done"
                if callable(progress):
                    progress(record)
                tell(advance=1)
        failed = tuple(record for record in folder.finish() if record["state"] != "done")
    return Summary(made, existing, failed, time.monotonic() - start)


class Folder:
    """A place that a run fills."""

    def __init__(self, place: Place, plan: BasePlan) -> None:
        self.place, self.plan = place, plan.prepared(place)
        self.records: dict[str, Record] = {}  # manifest line of each finished or failed asset, by name
        self.task: Callable[[Item], Record] = partial(make, plan=self.plan, place=place)

    @staticmethod
    @contextmanager
    def opened(place: Place, plan: BasePlan) -> Iterator["Folder"]:
        """Open a place for one run; create it if necessary, and repair the remains of a killed run."""
        folder = Folder(place, plan)
        with _disk_errors(place):
            names = sorted(place.names())
            if names and PLAN_FILE not in names:
                raise ExportError(
                    f"cannot write a dataset to {place}: it holds {names[0]!r} and no dataset; choose "
                    "another folder"
                )
            with place.opened():
                folder._begin()
                yield folder

    def left(self) -> list[Item]:
        """Return the items that have no record."""
        return [item for item in self.plan.items() if item.name not in self.records]

    def add(self, ending: Ending) -> Record:
        """Add the line of a finished or failed asset, and return it."""
        record: Record = ending.value
        if ending.state != "done":
            record = failure(ending.item, ending.reason, state="lost")
        elif record["state"] == "refused":
            path = f"{self.place}/{ending.item.path}"
            raise ExportError(f"{path} cannot be written: {record['error']}; {RESUME}")
        self.records[ending.item.name] = record
        self.place.append(MANIFEST_FILE, _line(record))
        return record

    def finish(self) -> list[Record]:
        """Sort the manifest in the order of the plan, write the files of all assets, and return its lines."""
        records = [self.records[item.name] for item in self.plan.items() if item.name in self.records]
        self.place.write(MANIFEST_FILE, "".join(map(_line, records)).encode())
        self.plan.finish(self.place, records)
        return records

    def _begin(self) -> None:
        """Write plan and manifest; the manifest has a line for each asset that is complete or failed."""
        before, plan = _earlier_plan(self.place, self.plan), self.plan.to_data()
        if plan != before:
            data = {"format": self.plan.FORMAT, "version": __version__, "plan": plan}
            self.place.write(PLAN_FILE, json_text(data).encode())
        items = list(self.plan.items())
        named = {item.name: item for item in items}
        records = read_manifest(self.place)
        known = {record["name"]: record for record in records if _is_of(record, named.get(record["name"]))}
        states = {name: record["state"] for name, record in known.items()}
        made = self.place.complete(item.path for item in items) if before is not None else set()
        unlisted = [item.path for item in items if item.path in made and states.get(item.name) != "done"]
        listed = dict(_read_records(self.place, unlisted))
        for item in items:
            if item.path in listed:
                self.records[item.name] = listed[item.path]
            elif states.get(item.name) == ("done" if item.path in made else "failed"):
                self.records[item.name] = known[item.name]
        self.place.write(MANIFEST_FILE, "".join(map(_line, self.records.values())).encode())


def _is_of(record: Record, item: Item | None) -> bool:
    """Tell whether a line, which may have been edited, belongs to an item."""
    if item is None:
        return False
    found = record["category"], record["seed"], record.get("path", item.path)
    return found == (item.category, item.seed, item.path)


@contextmanager
def _disk_errors(place: Place) -> Iterator[None]:
    """Convert a disk error to an ExportError that names the place."""
    try:
        yield
    except ExportError:
        raise
    except OSError as error:
        raise ExportError(f"cannot write to {place}: {error.strerror or error}; {RESUME}") from error


def make(item: Item, *, plan: BasePlan, place: Place) -> Record:
    """Make the files of an item, put them in its directory, and return its line of the manifest."""
    try:
        files = plan.files(item)
    except Exception as error:  # noqa: BLE001 - a category may raise anything; the other items go on
        text = " ".join(str(error).split())
        expected = isinstance(error, ArtgenError) and not isinstance(error, ExportError)
        return failure(item, text if expected else f"{type(error).__name__}: {text}")
    try:
        place.put(files, item.path, share=plan.shares_maps)
    except OSError as error:  # nothing else can be written
        return failure(item, error.strerror or str(error), state="refused")
    return record_of(files[ASSET_FILE], item.path)


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
        **({"detail": data["detail"]} if "detail" in data else {}),
        "digest": hashlib.sha256(text).hexdigest()[:_DIGEST],
    }


def failure(item: Item, error: str, *, state: str = "failed") -> Record:
    """Return the manifest line of an asset that is not made."""
    return {"name": item.name, "category": item.category, "seed": item.seed, "state": state, "error": error}


def stored_plan(place: Place, form: str = Plan.FORMAT) -> dict[str, Any] | None:
    """Return the content of the plan file of a place; None if it holds no dataset."""
    text = place.read(PLAN_FILE)
    if text is None:
        return None
    try:
        data = json.loads(text)
    except ValueError as error:
        raise ExportError(f"{place}/{PLAN_FILE} is damaged: {error}; choose another folder") from error
    found = data.get("format") if isinstance(data, dict) else None
    if found != form:
        raise ExportError(f"{place}/{PLAN_FILE} has format {found!r}, not {form!r}; choose another folder")
    if not isinstance(data.get("version"), str) or not isinstance(data.get("plan"), dict):
        raise ExportError(f"{place}/{PLAN_FILE} has no version or no plan; choose another folder")
    return dict(data)


def _earlier_plan(place: Place, plan: BasePlan) -> dict[str, Any] | None:
    """Return the data of the plan in a place, which may differ only in a smaller count; None if none."""
    data = stored_plan(place, plan.FORMAT)
    if data is None:
        return None
    if data["version"] != __version__:
        raise ExportError(
            f"{place} holds assets of artgen {data['version']}, but {__version__} is installed, which may "
            "generate others from the same seeds; choose another folder"
        )
    old, new = dict(data["plan"]), plan.to_data()
    typed = isinstance(old.get("count"), int) and isinstance(old.get("sources", {}), dict)
    if not set(old) <= set(new) or not typed:
        raise ExportError(f"{place}/{PLAN_FILE} is no plan of such a dataset; choose another folder")
    if old["count"] > plan.count:
        raise ExportError(
            f"{place} holds a dataset of {old['count']} assets, but only {plan.count} are requested; request "
            f"at least {old['count']}, or choose another folder"
        )
    for name, value in old.items():
        if name == "sources" and value != new[name]:
            other = [each for each in {**value, **new[name]} if value.get(each) != new[name].get(each)]
            raise ExportError(
                f"{place} holds assets of {_format(other)} from another text of its file: restore the file, "
                "or choose another folder"
            )
        if name != "count" and value != new[name]:
            raise ExportError(
                f"{place} holds a dataset with {name} = {_format(value)}, not {_format(new[name])}: use "
                "the same options, or choose another folder"
            )
    return old


def _format(value: Any) -> str:
    return ",".join(map(str, value)) or "none" if isinstance(value, list) else repr(value)


def read_manifest(place: Place) -> Iterator[Record]:
    """Yield the lines of a manifest; an incomplete last line of a killed run is skipped."""
    *lines, last = (place.read(MANIFEST_FILE) or b"").decode(errors="replace").split("\n")
    with suppress(ValueError):
        json.loads(last)
        lines.append(last)
    for number, line in enumerate(lines):
        try:
            yield _parsed(line)
        except (AttributeError, ValueError, ExportError) as error:
            raise ExportError(
                f"{place}/{MANIFEST_FILE}: line {number + 1} is damaged ({error}); remove the file, and the "
                "next run makes it again from the assets"
            ) from error


def _parsed(line: str) -> Record:
    """Return a line of a manifest after a check of its types."""
    record: Record = json.loads(line, parse_constant=_refuse_constant)
    kinds = _KINDS | (_MADE_KINDS if record.get("state") == "done" else {"error": str})
    wrong = [name for name, kind in kinds.items() if not isinstance(record.get(name), kind)]
    if wrong:
        raise ValueError(f"{wrong[0]!r} is missing or has a wrong type")
    inside(Path(), record.get("path", "none"))
    return record


def _refuse_constant(text: str) -> None:
    raise ValueError(f"{text} is no number")


def _read_records(place: Place, paths: Sequence[str]) -> Iterator[tuple[str, Record]]:
    """Yield the directory and the line of each existing asset."""
    for start in range(0, len(paths), _BATCH):
        texts = place.contents(f"{path}/{ASSET_FILE}" for path in paths[start : start + _BATCH])
        for name, text in texts.items():
            path = name.rpartition("/")[0]
            try:
                yield path, record_of(text, path)
            except (ValueError, LookupError) as error:
                raise ExportError(
                    f"{place}/{name} is damaged: {error!r}; remove {place}/{path}, and the same command "
                    "makes the asset again"
                ) from error


def _line(record: Mapping[str, Any]) -> str:
    return json.dumps(record, allow_nan=False, ensure_ascii=False) + "\n"
