"""The folder of a dataset: its plan, its manifest, a directory for each asset, and the maps that they share.

The directory of an asset is complete or absent. Its line of the manifest is made from its `asset.json` alone:
one that was put in place by a run that was killed before it wrote the line gets the same line from the next
run. While a run goes on, the manifest has the lines in the order in which assets were done; at its end, in
the order of the plan.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text
from artgen.dataset.lines import lines_in
from artgen.dataset.plan import Draws, Item, Plan
from artgen.dataset.record import record_of
from artgen.dataset.target import GO_ON, PLAN_FILE, Lines, Target
from artgen.errors import ExportError, ParameterError
from artgen.version import __version__

MANIFEST_FILE = "manifest.jsonl"

_TOGETHER = 256  # files that are read at once


class Folder:
    """A folder that a run writes to.

    Attributes:
        target: Where it is.
        plan: What it is to hold.
        records: The line of each asset that is done or failed, by its name.
    """

    def __init__(self, target: Target, plan: Draws) -> None:
        self.target, self.plan = target, plan
        self.records: dict[str, dict[str, Any]] = {}
        self._lines: Lines | None = None

    @staticmethod
    @contextmanager
    def opened(target: Target, plan: Draws) -> Iterator["Folder"]:
        """Open a folder for one run, made if there is none; what a killed run left is put in order."""
        folder = Folder(target, plan.placed(target))
        with writing(target):
            _check_content(target)
            with target.opened():
                folder._begin()
                try:
                    yield folder
                finally:
                    if folder._lines is not None:
                        folder._lines.close()

    def add(self, item: Item, record: dict[str, Any]) -> None:
        """Add the line of an asset that is done or failed."""
        assert self._lines is not None
        self.records[item.name] = record
        with writing(self.target):
            self._lines.add(_line(record))

    def finish(self) -> None:
        """Bring the manifest into the order of the plan."""
        assert self._lines is not None
        with writing(self.target):
            self._lines.close()
            ordered = (
                _line(self.records[item.name]) for item in self.plan.items() if item.name in self.records
            )
            self.target.write(MANIFEST_FILE, "".join(ordered).encode())

    def _begin(self) -> None:
        before = _read_plan(self.target, type(self.plan))
        if before is not None:
            _check_same(self.target, before, self.plan)
        if self.plan != before:
            self.target.write(PLAN_FILE, _plan_text(self.plan).encode())
        known = {str(record["name"]): record for record in read_manifest(self.target)}
        items = list(self.plan.items())
        made = self.target.complete(item.path for item in items) if before is not None else set()
        untold = [item.path for item in items if item.path in made and _state(known, item) != "done"]
        told = dict(_read_records(self.target, untold))
        for item in items:
            if item.path in told:
                self.records[item.name] = told[item.path]
            elif _state(known, item) == ("done" if item.path in made else "failed"):
                self.records[item.name] = known[item.name]
        text = "".join(_line(record) for record in self.records.values())
        self._lines = self.target.lines(MANIFEST_FILE, text)


def _state(known: Mapping[str, dict[str, Any]], item: Item) -> str:
    """Return the state of an asset in the manifest; empty if it is not in it."""
    return str(known[item.name]["state"]) if item.name in known else ""


def stored_plan(target: Target, form: str = Plan.FORMAT) -> dict[str, Any] | None:
    """Return what a folder says of its dataset; None if it holds none."""
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
    """Return the plan of a folder that a run may go on with; None if it holds no dataset."""
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


def read_manifest(target: Target) -> Iterator[dict[str, Any]]:
    """Yield the lines of a manifest, without the last one if a killed run left it cut off."""
    lines, _ = lines_in((target.read(MANIFEST_FILE) or b"").decode(errors="replace"))
    for number, line in enumerate(lines):
        try:
            record = json.loads(line)
            inside(Path(), record.get("path", "none"))
            yield record
        except (AttributeError, ValueError, ExportError) as error:
            raise ExportError(
                f"{target}/{MANIFEST_FILE}: line {number + 1} is damaged ({error}); remove the file, and the "
                "next run writes it again from the assets"
            ) from error


def _read_records(target: Target, paths: Sequence[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the line of each asset that is there, with its directory."""
    for start in range(0, len(paths), _TOGETHER):
        texts = target.contents(f"{path}/{ASSET_FILE}" for path in paths[start : start + _TOGETHER])
        for name, text in texts.items():
            path = name.rpartition("/")[0]
            try:
                yield path, record_of(text, path)
            except (ValueError, LookupError) as error:
                raise ExportError(
                    f"{target}/{name} is damaged: {error!r}; remove {target}/{path}, and the same command "
                    "makes the asset anew"
                ) from error


def _check_content(target: Target) -> None:
    """Refuse a folder that holds anything but a dataset."""
    found = sorted(target.names())
    if found and PLAN_FILE not in found:
        raise ExportError(
            f"cannot write a dataset to {target}: it holds {found[0]!r} and is none; choose another folder"
        )


def _check_same(target: Target, before: Draws, plan: Draws) -> None:
    """Refuse to add assets of another plan: there may only be more of them."""
    if before.count > plan.count:
        raise ExportError(
            f"{target} holds a dataset of {before.count} assets: ask for as many or for more, or choose "
            "another folder"
        )
    old, new = before.to_data(), replace(plan, count=before.count).to_data()
    different = [name for name in old if old[name] != new[name]]
    if different:
        name = different[0]
        raise ExportError(
            f"{target} holds a dataset with {name} = {_shown(old[name])}, not {_shown(new[name])}: go on "
            "with the same options, or choose another folder"
        )


def _shown(value: Any) -> str:
    return ",".join(map(str, value)) or "none" if isinstance(value, list) else repr(value)


def _plan_text(plan: Draws) -> str:
    return json_text({"format": plan.FORMAT, "version": __version__, "plan": plan.to_data()})


def _line(record: Mapping[str, Any]) -> str:
    return json.dumps(record, allow_nan=False, ensure_ascii=False) + "\n"


@contextmanager
def writing(target: Target) -> Iterator[None]:
    """Say of errors of the disk where they were met, and that nothing is lost."""
    try:
        yield
    except ExportError:
        raise
    except OSError as error:
        raise ExportError(f"cannot write to {target}: {error.strerror or error}; {GO_ON}") from error
