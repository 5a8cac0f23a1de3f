"""The folder of a dataset: its plan, its manifest, a directory for each asset, and the maps that they share.

An asset is made below `.staging` and then renamed to its place, so that its directory is complete or absent.
Its line of the manifest is made from its `asset.json` alone: one that was put in place by a run that was
killed before it wrote the line gets the same line from the next run. While a run goes on, the manifest has
the lines in the order in which assets were done; at its end, in the order of the plan.
"""

import json
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any, TextIO

from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text
from artgen.dataset.lines import lines_of
from artgen.dataset.lock import LOCK_FILE, locked
from artgen.dataset.plan import Item, Plan
from artgen.dataset.record import record_of
from artgen.errors import ExportError, ParameterError
from artgen.version import __version__

PLAN_FILE = "dataset.json"
MANIFEST_FILE = "manifest.jsonl"
TEXTURE_DIRECTORY = "textures"

_FORMAT = "artgen-dataset-1"
_STAGING = ".staging"


class Folder:
    """A folder that a run writes to.

    Attributes:
        path: Where it is.
        plan: What it is to hold.
        records: The line of each asset that is done or failed, by its name.
    """

    def __init__(self, path: Path, plan: Plan) -> None:
        self.path, self.plan = path, plan
        self.records: dict[str, dict[str, Any]] = {}
        self._lines: TextIO | None = None

    @staticmethod
    @contextmanager
    def opened(path: Path, plan: Plan) -> Iterator["Folder"]:
        """Open a folder for one run, made if there is none; what a killed run left is put in order.

        Raises:
            ExportError: It holds other things, or assets of another plan or version, another run writes to
                it, or the disk refuses.
        """
        folder = Folder(path, plan)
        with _writing(path):
            _check_content(path)
            path.mkdir(parents=True, exist_ok=True)
            with locked(path):
                folder._begin()
                try:
                    yield folder
                finally:
                    shutil.rmtree(folder.staging, ignore_errors=True)
                    if folder._lines is not None:
                        folder._lines.close()

    @property
    def staging(self) -> Path:
        """Where assets are made before they are put in their places."""
        return self.path / _STAGING

    def add(self, item: Item, record: dict[str, Any]) -> None:
        """Add the line of an asset that is done or failed."""
        assert self._lines is not None
        self.records[item.name] = record
        with _writing(self.path):
            self._lines.write(_line(record))
            self._lines.flush()

    def finish(self) -> None:
        """Bring the manifest into the order of the plan."""
        with _writing(self.path):
            lines = [
                _line(self.records[item.name]) for item in self.plan.items() if item.name in self.records
            ]
            _write(self.path / MANIFEST_FILE, "".join(lines))

    def _begin(self) -> None:
        before = _read_plan(self.path)
        if before is not None:
            _check_same(self.path, before, self.plan)
        if self.plan != before:
            _write(self.path / PLAN_FILE, _plan_text(self.plan))
        shutil.rmtree(self.staging, ignore_errors=True)
        self.staging.mkdir()
        known = {str(record["name"]): record for record in read_manifest(self.path)}
        for item in self.plan.items():
            line = known.get(item.name, {"state": ""})
            made = self.path / item.path / ASSET_FILE
            if made.is_file():
                done = line["state"] == "done"
                self.records[item.name] = line if done else record_of(made.read_bytes(), item.path)
            elif line["state"] == "failed":
                self.records[item.name] = line
        _write(self.path / MANIFEST_FILE, "".join(_line(record) for record in self.records.values()))
        self._lines = (self.path / MANIFEST_FILE).open("a", encoding="utf-8")


def stored_plan(path: Path) -> dict[str, Any] | None:
    """Return what a folder says of its dataset; None if it holds none.

    Raises:
        ExportError: The file is damaged, or of another format.
    """
    try:
        data = json.loads((path / PLAN_FILE).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except ValueError as error:
        raise ExportError(f"{path / PLAN_FILE} is damaged: {error}; choose another folder") from error
    found = data.get("format") if isinstance(data, dict) else None
    if found != _FORMAT:
        raise ExportError(f"{path / PLAN_FILE} has format {found!r}; this version reads {_FORMAT!r}")
    return dict(data)


def _read_plan(path: Path) -> Plan | None:
    """Return the plan of a folder that a run may go on with; None if it holds no dataset.

    Raises:
        ExportError: It holds one that cannot be read, or of another version.
    """
    data = stored_plan(path)
    if data is None:
        return None
    if data["version"] != __version__:
        raise ExportError(
            f"{path} holds assets of artgen {data['version']}, and this is {__version__}: the same seeds may "
            "give others; choose another folder"
        )
    try:
        return Plan.from_data(data["plan"])
    except ParameterError as error:
        raise ExportError(f"{path / PLAN_FILE}: {error}") from error


def read_manifest(path: Path) -> Iterator[dict[str, Any]]:
    """Yield the lines of a manifest, without the last one if a killed run left it cut off."""
    lines, _ = lines_of(path / MANIFEST_FILE)
    for number, line in enumerate(lines):
        try:
            yield json.loads(line)
        except ValueError as error:
            raise ExportError(
                f"{path / MANIFEST_FILE}: line {number + 1} is damaged; remove the file, and the next run "
                "makes it anew from the assets"
            ) from error


def _check_content(path: Path) -> None:
    """Refuse a folder that holds anything but a dataset."""
    if path.exists() and not path.is_dir():
        raise ExportError(f"cannot write a dataset to {path}: it is a file; choose another folder")
    if path.is_dir() and not (path / PLAN_FILE).exists():
        found = sorted(each.name for each in path.iterdir() if each.name not in (LOCK_FILE, _STAGING))
        if found:
            raise ExportError(
                f"cannot write a dataset to {path}: it holds {found[0]!r} and is none; choose another folder"
            )


def _check_same(path: Path, before: Plan, plan: Plan) -> None:
    """Refuse to add assets of another plan: there may only be more of them."""
    if before.count > plan.count:
        raise ExportError(
            f"{path} holds a dataset of {before.count} assets: ask for as many or for more, or choose "
            "another folder"
        )
    old, new = before.to_data(), replace(plan, count=before.count).to_data()
    different = [name for name in old if old[name] != new[name]]
    if different:
        name = different[0]
        raise ExportError(
            f"{path} holds a dataset with {name} = {_shown(old[name])}, not {_shown(new[name])}: go on with "
            "the same options, or choose another folder"
        )


def _shown(value: Any) -> str:
    return ",".join(map(str, value)) or "none" if isinstance(value, list) else repr(value)


def _plan_text(plan: Plan) -> str:
    return json_text({"format": _FORMAT, "version": __version__, "plan": plan.to_data()})


def _line(record: Mapping[str, Any]) -> str:
    return json.dumps(record, allow_nan=False, ensure_ascii=False) + "\n"


def _write(path: Path, text: str) -> None:
    """Write a file beside its place and then put it there."""
    partial = path.with_name(f".{path.name}.partial")
    partial.write_text(text, encoding="utf-8")
    partial.replace(path)


@contextmanager
def _writing(path: Path) -> Iterator[None]:
    """Say of errors of the disk where they were met, and that nothing is lost."""
    try:
        yield
    except ExportError:
        raise
    except OSError as error:
        raise ExportError(f"cannot write to {path}: {error.strerror or error}; {GO_ON}") from error


GO_ON = "what is done stays, and the same command goes on from there"
"""What messages say of a run that was ended."""


def put(made: Path, place: Path) -> None:
    """Put a complete directory in its place; one that is there already, of an earlier run, stays."""
    place.parent.mkdir(parents=True, exist_ok=True)
    try:
        made.rename(place)
    except OSError:
        if not (place / ASSET_FILE).is_file():
            raise
        with suppress(OSError):
            shutil.rmtree(made)
