"""Reading of a dataset: assets are loaded on access."""

import hashlib
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from artgen.asset import Asset
from artgen.asset.joint import is_number
from artgen.dataset.places import is_url, place_of
from artgen.dataset.plan import row_of
from artgen.dataset.run import MANIFEST_FILE, read_manifest, stored_plan
from artgen.errors import ExportError, ParameterError, nearest, needed

if TYPE_CHECKING:
    import pandas as pd

_SHARES = {"train": 0.8, "val": 0.1, "test": 0.1}


class Dataset(Sequence[Asset]):
    """The assets of a folder made by `artgen generate -n`, or a subset of them.

        assets = artgen.Dataset("doors").filter("door", hand="left")
        parts = assets.split()
        for asset in parts["train"]: ...

    Args:
        directory: The folder, or a URL that fsspec can open. From a URL, an asset is fetched on its first
            access, to a folder that is removed at the end of the process. Only finished assets count.

    Raises:
        ExportError: It holds no dataset, or cannot be read.

    Attributes:
        directory: The folder or URL.
        records: The manifest line of each asset, in order.
    """

    def __init__(self, directory: str | Path) -> None:
        self._place = place_of(directory)
        self.directory = directory if is_url(directory) else Path(directory)
        if stored_plan(self._place) is None or self._place.read(MANIFEST_FILE) is None:
            raise ExportError(f"{directory} holds no dataset; `artgen generate CATEGORY -n 100` makes one")
        records = {record["name"]: record for record in read_manifest(self._place)}  # the last line of each
        self.records: tuple[Mapping[str, Any], ...] = tuple(
            record for record in records.values() if record["state"] == "done"
        )

    def __len__(self) -> int:
        """Return the number of assets."""
        return len(self.records)

    @overload
    def __getitem__(self, index: int) -> Asset: ...

    @overload
    def __getitem__(self, index: slice) -> "Dataset": ...

    def __getitem__(self, index: int | slice) -> "Asset | Dataset":
        """Load an asset, or return the dataset of a slice.

        Raises:
            IndexError: There is no asset of that number.
            ParameterError: The index is no whole number.
            ExportError: Its files are missing or damaged.
        """
        if isinstance(index, slice):
            return self._of(self.records[index])
        try:
            number = operator.index(index)
        except TypeError as error:
            raise ParameterError(
                f"an asset of a dataset is found by its number, such as 0, or a slice, not by {index!r}; "
                "`records` has the names of the assets in order"
            ) from error
        if not -len(self) <= number < len(self):
            raise IndexError(f"{self!r} has no number {number}; the numbers are 0 to {len(self) - 1}")
        return Asset.load(self._path(self.records[number]))

    def __iter__(self) -> Iterator[Asset]:
        """Load one asset after another."""
        return map(Asset.load, map(self._path, self.records))

    def __repr__(self) -> str:
        """Return the number of assets and their categories."""
        names = sorted({record["category"] for record in self.records})
        return f"<{len(self)} assets of {', '.join(names) or 'no category'} in {self.directory}>"

    def paths(self) -> list[Path]:
        """Return the directory of each asset; all are fetched from a URL."""
        return [self._path(record) for record in self.records]

    def files(self, file_format: str) -> list[Path]:
        """Return the main file of each asset in a format: `urdf`, `mjcf`, `usd`, `glb` or `sdf`.

        Raises:
            ExportError: The assets were not written in that format.
        """
        known = self.records[0]["files"] if self.records else {file_format: ""}
        if file_format not in known:
            raise ExportError(
                f"{self.directory} has no files in the format {file_format!r}.{nearest(file_format, known)}"
            )
        return [self._path(record) / record["files"][file_format] for record in self.records]

    def filter(
        self,
        category: str | Iterable[str] | None = None,
        *,
        joint: str | None = None,
        where: Callable[[Mapping[str, Any]], bool] | None = None,
        **parameters: Any,
    ) -> "Dataset":
        """Return the dataset of the assets that satisfy all conditions.

        Args:
            category: Name of a category, or several names.
            joint: Kind of a joint: `revolute` or `prismatic`.
            where: Condition on the manifest line of an asset.
            **parameters: Values of drawn parameters: a value, several values in a list or set, or a range as
                a tuple of its lowest and highest value. Assets without the parameter are excluded.

        Raises:
            ParameterError: No asset here has such a category, joint or parameter, or `where` is no function.
        """
        if where is not None and not callable(where):
            raise ParameterError(
                f"where = {where!r} is not allowed: it must be a function of a manifest line, such as "
                "lambda line: line['mass'] > 1"
            )
        several = isinstance(category, Iterable) and not isinstance(category, str)
        wanted = None if category is None else list(category) if several else [category]
        dotted = {name.replace("__", "."): value for name, value in parameters.items()}
        kinds = {kind for record in self.records for kind in record["joints"].values()}
        drawn_names = {name for record in self.records for name in record["parameters"]}
        for noun, names, known in (
            ("category", wanted or (), list({record["category"] for record in self.records})),
            ("kind of joint", () if joint is None else (joint,), list(kinds)),
            ("parameter", dotted, drawn_names),
        ):
            for name in names:
                if name not in known:
                    raise ParameterError(f"no asset here has the {noun} {name!r}.{nearest(name, known)}")
        for name, value in parameters.items():
            _check_wanted(name, value)

        def meets(record: Mapping[str, Any]) -> bool:
            drawn = record["parameters"]
            return (
                (wanted is None or record["category"] in wanted)
                and (joint is None or joint in record["joints"].values())
                and (where is None or where(record))
                and all(name in drawn and _matches(drawn[name], value) for name, value in dotted.items())
            )

        return self._of(tuple(record for record in self.records if meets(record)))

    def split(self, **shares: float) -> dict[str, "Dataset"]:
        """Divide the assets by seed, so that each seed is in one part; by default 80, 10 and 10 %.

        Assets with the same seed share draws, such as materials, even across categories. The part of a seed
        depends only on the seed and the shares: an asset stays in its part when a dataset grows. The sizes of
        the parts match the shares on average.

        Args:
            **shares: Share of each part by name; their sum is 1.

        Raises:
            ParameterError: A share is no number, or their sum is not 1.
        """
        chosen = shares or _SHARES
        if not all(map(is_number, chosen.values())):
            raise ParameterError(f"each share must be a number, got {chosen}")
        if any(share < 0.0 for share in chosen.values()) or not abs(sum(chosen.values()) - 1.0) <= 1e-9:
            raise ParameterError(
                f"the sum of the shares is {sum(chosen.values()):g}; it must be 1, and no share negative"
            )
        parts: dict[str, list[Mapping[str, Any]]] = {name: [] for name in chosen}
        for record in self.records:
            parts[_part_of(record["seed"], chosen)].append(record)
        return {name: self._of(tuple(records)) for name, records in parts.items()}

    def to_pandas(self) -> "pd.DataFrame":
        """Return a table with a row for each asset: its data from the manifest, and its parameters.

        Raises:
            ExportError: pandas is not installed.
        """
        with needed("tables need pandas: pip install 'artgen[data]'"):
            import pandas as pd
        rows = [{"category": record["category"], **row_of(record)} for record in self.records]
        return pd.DataFrame(rows)

    def _of(self, records: tuple[Mapping[str, Any], ...]) -> "Dataset":
        part = object.__new__(Dataset)
        part.directory, part._place, part.records = self.directory, self._place, records
        return part

    def _path(self, record: Mapping[str, Any]) -> Path:
        return self._place.local(str(record["path"]))


def _check_wanted(name: str, value: Any) -> None:
    if isinstance(value, tuple):
        allowed = len(value) == 2 and all(map(is_number, value)) and value[0] <= value[1]
    else:
        allowed = value is None or isinstance(value, (str, int, float, np.generic, list, set, frozenset))
    if not allowed:
        raise ParameterError(
            f"{name} = {value!r} is not allowed: give a value, several values in a list or set, or a range "
            "as a tuple of its lowest and highest number"
        )


def _matches(drawn: Any, wanted: Any) -> bool:
    if isinstance(wanted, tuple):
        low, high = wanted
        return isinstance(drawn, (int, float)) and bool(low <= drawn <= high)
    if isinstance(wanted, (list, set, frozenset)):
        return drawn in wanted
    return bool(drawn == wanted)


def _part_of(seed: int, shares: Mapping[str, float]) -> str:
    """Return the part of a seed, equal on every machine."""
    word = hashlib.blake2b(f"split {seed}".encode(), digest_size=8).digest()
    left = int.from_bytes(word, "big") / 2.0**64
    for name, share in shares.items():
        left -= share
        if left < 0.0:
            return name
    return [name for name, share in shares.items() if share > 0.0][-1]  # after a rounding error
