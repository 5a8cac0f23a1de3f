"""The plan of a dataset: categories, seeds, and how assets are drawn and written."""

import hashlib
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from typing import Any, ClassVar, Literal, NamedTuple, Self, get_args

import numpy as np

from artgen.asset.asset import Asset, Base, DetailName, Limits
from artgen.asset.collision import Collision
from artgen.catalog import Maker, is_file, load_file, maker
from artgen.colliders.openings import BALL
from artgen.dataset.places import Place
from artgen.errors import ExportError, ParameterError
from artgen.export.files import chosen_formats, encode, find_layout
from artgen.export.layouts import TEXTURES
from artgen.export.precision import check_precision
from artgen.generator import Generator, OnCollision
from artgen.generator.generator import check_proof, checked_count
from artgen.generator.overrides import overrides_of
from artgen.materials.textures import check_size
from artgen.proof.fewer import check_budget

TextureMode = Literal["shared", "embedded", "none"]  # shared by the dataset, with each asset, or none
TABLE_DIRECTORY = "parameters"

_COMMON = ("name", "seed", "path", "attempt", "proven", "mass", "links")  # columns of every table


class Source(NamedTuple):
    """A category that a file defines."""

    name: str  # name of the category
    path: str  # absolute path of the file
    digest: str  # digest of the file


@dataclass(frozen=True)
class Item:
    """One asset of a dataset."""

    category: str  # name of the category
    seed: int

    @property
    def name(self) -> str:
        """Name of the asset and of its directory."""
        return f"{self.category}_{self.seed}"

    @property
    def path(self) -> str:
        """Its directory, relative to that of the dataset."""
        return f"{self.category}/{self.name}"


@dataclass(frozen=True)
class BasePlan(ABC):
    """The assets of a folder and how they are drawn; subclasses define the files that are written."""

    FORMAT: ClassVar[str]  # format in the plan file of such folders

    categories: tuple[str, ...]  # names, each once; files that define a category become its name
    count: int  # number of assets, divided evenly among the categories; the first ones get the remainder
    seed: int = 0  # first seed of each category
    overrides: tuple[str, ...] = ()  # `NAME=VALUE` for all categories, or `CATEGORY:NAME=VALUE` for one
    base: Base = "fixed"  # whether assets are fixed to the world
    certify: bool = True  # whether each asset is proven free of collisions
    tolerance: float = 0.0  # required clearance between links [m]
    on_collision: OnCollision = "redraw"  # reaction to a missing proof
    detail: DetailName = "full"  # level of detail of the solids
    sources: Mapping[str, Source] = field(default_factory=dict, kw_only=True, hash=False)  # of those in files

    def __post_init__(self) -> None:
        """Check the plan before anything is written; one name stands for a tuple of one."""
        given: Any = self.categories
        given = (given,) if isinstance(given, str) else given
        texts = isinstance(given, tuple | list) and all(isinstance(text, str) for text in given)
        if not texts or not given:
            raise ParameterError(
                f"a dataset needs the names of its categories, such as ('door', 'drawer'), not {given!r}"
            )
        loaded = {text: _source(load_file(text)) for text in given if is_file(text)}
        names = tuple(loaded[text].name if text in loaded else text for text in given)
        sources = {source.name: source for source in loaded.values()}
        seed = checked_count("seed", self.seed)
        vars(self).update(categories=names, sources={**self.sources, **sources}, seed=seed)
        twice = next((name for name in self.categories if self.categories.count(name) > 1), None)
        if twice is not None:
            raise ParameterError(f"the category {twice!r} is named twice; leave one of them out")
        vars(self)["count"] = check_whole("count", self.count, 1, 10**9)
        if self.detail not in get_args(DetailName):
            raise ParameterError(f"detail is full, medium or low, not {self.detail!r}")
        if self.base not in get_args(Base):
            raise ParameterError(f"base is fixed or free, not {self.base!r}")
        check_proof(self.certify, self.tolerance, self.on_collision)
        _check_texts(self.overrides)
        for name in self.categories:
            made = self.category(name)
            made.sample(self.seed, overrides=self.overrides_of(name))
            if not isinstance(made, Generator) and (self.base != "fixed" or self.tolerance > 0.0):
                raise ParameterError(
                    f"{name} is a room, which is fixed to the world and proven without a tolerance; leave "
                    "the base and the tolerance out, or leave the room out"
                )

    def category(self, name: str) -> Maker:
        """Return a category or kind of room of the plan."""
        return _loaded(self.sources[name]) if name in self.sources else maker(name)

    def items(self) -> Iterator[Item]:
        """Yield the assets, categories in turn: a longer plan begins with the assets of a shorter plan."""
        several = len(self.categories)
        for number in range(self.count):
            yield Item(self.categories[number % several], self.seed + number // several)

    def draw(self, item: Item) -> Asset:
        """Make an asset."""
        return self.category(item.category).generate(
            item.seed,
            base=self.base,
            certify=self.certify,
            tolerance=self.tolerance,
            on_collision=self.on_collision,
            detail=self.detail,
            **self.overrides_of(item.category),
        )

    def overrides_of(self, category: str) -> dict[str, Any]:
        """Return the overrides for a category; its own overrides replace those for all categories."""
        return overrides_of(category, self.overrides, self.categories)

    @property
    def shares_maps(self) -> bool:
        """Whether the assets of the folder share texture maps through links."""
        return False

    @property
    def time_limit(self) -> float:
        """Default time limit for one asset [s]."""
        return 600.0

    @abstractmethod
    def files(self, item: Item) -> dict[str, bytes]:
        """Return the files of an item by path, including its `asset.json`."""

    @abstractmethod
    def finish(self, place: Place, records: Sequence[Mapping[str, Any]]) -> None:
        """Write the files common to all assets."""

    def prepared(self, place: Place) -> Self:
        """Return the plan with the defaults of a place; check the tools that it needs."""
        return self

    def to_data(self) -> dict[str, Any]:
        """Return the plan as JSON data, with the digests of files and without their paths."""
        digests = {name: source.digest for name, source in self.sources.items()}
        data = {
            name: list(value) if isinstance(value, tuple) else value for name, value in asdict(self).items()
        }
        return data | {"sources": digests}


@dataclass(frozen=True)
class Plan(BasePlan):
    """The content of a dataset; two runs with equal plans write the same bytes.

    Attributes:
        formats: File formats of each asset.
        layout: Layout of its files.
        collision: Kind of its colliders.
        colliders: Largest number of its colliders, see `artgen.proof.fewer`; None: as many as it needs.
        openings: Width of the openings that fewer colliders leave open [m].
        textures: Place of its texture maps; by default shared in a folder and embedded at a URL.
        texture_size: Texels per side of a map.
        mesh_precision: Largest deviation of exported meshes from the shape [m].
        limits: Ranges of joints, see `artgen.proof.limits.with_limits`.
        frames: Whether URDF files have a link for each grasp and push.
        states: Number of drawn valid states that each asset brings in `states.npz`.
    """

    FORMAT: ClassVar[str] = "artgen-dataset-1"

    formats: tuple[str, ...] = ()
    layout: str = "flat"
    collision: Collision = "exact"
    textures: TextureMode | None = None
    texture_size: int = TEXTURES
    mesh_precision: float = 0.0
    limits: Limits = "full"
    frames: bool = True
    states: int = 0
    colliders: int | None = None
    openings: float = BALL

    def __post_init__(self) -> None:
        """Check the plan before anything is written.

        Raises:
            ParameterError: A category, number or override is unknown or not allowed.
            ExportError: A layout or format is unknown.
        """
        if self.textures not in (None, *get_args(TextureMode)):
            raise ParameterError(f"textures are shared, embedded or none, not {self.textures!r}")
        check_size(self.texture_size)
        check_precision(self.mesh_precision)
        check_whole("states", self.states, 0, 10**9)
        if self.limits not in get_args(Limits):
            raise ParameterError(f"limits are full or independent, not {self.limits!r}")
        if self.colliders is not None:
            check_budget(self.colliders, self.openings, self.collision)
        vars(self)["formats"] = chosen_formats(find_layout(self.layout), self.formats or None)
        super().__post_init__()

    @property
    def shares_maps(self) -> bool:
        """Whether the assets of the folder share texture maps through links."""
        return self.textures == "shared"

    @property
    def texels(self) -> int:
        """Texels per side of the maps; 0 for none."""
        return 0 if self.textures == "none" else self.texture_size

    def files(self, item: Item) -> dict[str, bytes]:
        """Return the exported files of an asset."""
        asset = self.draw(item)
        if self.colliders is not None:
            asset = asset.with_colliders(self.colliders, self.openings)
        return encode(
            asset,
            self.formats,
            self.collision,
            self.texels,
            self.layout,
            self.mesh_precision,
            limits=self.limits,
            frames=self.frames,
            states=self.states,
        )

    def finish(self, place: Place, records: Sequence[Mapping[str, Any]]) -> None:
        """Write the indices of the layout, and a Parquet table for each category if pyarrow is installed.

        The tables need `pip install artgen[data]`.
        """
        layout = find_layout(self.layout)
        done = [record["path"] for record in records if record["state"] == "done"]
        found = place.contents(f"{path}/{name}" for path in done for name in layout.indices)
        for name, index in layout.library(found).items():
            place.write(name, index)
        if find_spec("pyarrow") is None:
            return
        import pyarrow as pa
        from pyarrow import parquet

        tables: dict[str, list[dict[str, Any]]] = {}
        for record in records:
            if record["state"] == "done":
                tables.setdefault(record["category"], []).append(row_of(record))
        for category, table in tables.items():
            names = dict.fromkeys(name for row in table for name in row)
            content = BytesIO()
            parquet.write_table(pa.table({name: [row.get(name) for row in table] for name in names}), content)
            place.write(f"{TABLE_DIRECTORY}/{category}.parquet", content.getvalue())

    def prepared(self, place: Place) -> Self:
        """Return the plan with the place of texture maps: shared where the target supports links.

        Raises:
            ExportError: Maps shall be shared, but the target does not support links.
        """
        if self.textures == "shared" and not place.links:
            raise ExportError(
                f"maps are shared by links, and {place} has no links; choose the textures 'embedded' or "
                "'none'"
            )
        return replace(self, textures=self.textures or ("shared" if place.links else "embedded"))


def _check_texts(overrides: Any) -> None:
    if not isinstance(overrides, tuple | list) or not all(isinstance(text, str) for text in overrides):
        raise ParameterError(
            f"overrides = {overrides!r} is not allowed: give a tuple of texts, such as ('width=0.4',)"
        )


def _source(category: Generator) -> Source:
    path = category.function.__code__.co_filename
    return Source(category.name, path, _digest(path))


def _digest(path: str) -> str:
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()[:16]


@cache
def _loaded(source: Source) -> Generator:
    """Execute the file of a category, once in a process."""
    try:
        same = _digest(source.path) == source.digest
    except OSError as error:
        raise ParameterError(
            f"{source.path}: {error.strerror or error}; a dataset of a file needs it on every machine. "
            "`artgen new` makes a package, which each machine can install"
        ) from error
    if not same:
        raise ParameterError(f"{source.path} has changed during the run; begin again in another folder")
    return load_file(f"{source.path}:{source.name}")


def check_whole(name: str, value: Any, low: int, high: int) -> int:
    """Return an option that is a whole number in a range, or raise ParameterError."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not low <= value <= high:
        raise ParameterError(f"{name} is a whole number from {low} to {high}, not {value!r}")
    return int(value)


def row_of(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return the row of a finished asset in a table: common columns, then parameters."""
    parameters = {f"parameter.{name}": value for name, value in record["parameters"].items()}
    return {name: record[name] for name in _COMMON} | parameters
