"""What a dataset is to hold: categories, seeds, and how assets are drawn and written."""

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any, ClassVar, Literal, Self, get_args

from artgen._caching import cached_property
from artgen.asset.asset import Asset, Base
from artgen.asset.collision import Collision
from artgen.catalog import find, is_file
from artgen.dataset.target import Target
from artgen.errors import ExportError, ParameterError
from artgen.export.files import chosen_formats, find_layout
from artgen.export.formats import TEXTURES
from artgen.export.precision import check_precision
from artgen.generator import OnCollision
from artgen.generator.overrides import parse_overrides
from artgen.materials.textures import check_size

TextureMode = Literal["shared", "embedded", "none"]
"""Where maps are kept: once for the whole dataset, with each asset, or nowhere."""

_EVERY = ""  # the category of overrides that are for all


@dataclass(frozen=True)
class Item:
    """One asset of a dataset.

    Attributes:
        category: Name of its category.
        seed: Its seed.
    """

    category: str
    seed: int

    @property
    def name(self) -> str:
        """Name of the asset and of its directory."""
        return f"{self.category}_{self.seed}"

    @property
    def path(self) -> str:
        """Its directory, relative to the dataset's."""
        return f"{self.category}/{self.name}"


@dataclass(frozen=True)
class Draws:
    """Which assets a folder is made of, and how they are drawn; what is written of each, subclasses say."""

    FORMAT: ClassVar[str]  # marks the folders of such plans

    categories: tuple[str, ...]  # names of the categories, each once
    count: int  # how many assets, shared evenly among the categories: the first one gets what is left over
    seed: int = 0  # the first seed of each category; the others follow it
    overrides: tuple[str, ...] = ()  # as in `NAME=VALUE` for all categories, or `CATEGORY:NAME=VALUE` for one
    base: Base = "fixed"  # whether assets are fixed to the world
    certify: bool = True  # whether each is proven free of collisions
    tolerance: float = 0.0  # clearance between links that has to be proven [m]
    on_collision: OnCollision = "redraw"  # what to do if that is not proven

    def __post_init__(self) -> None:
        """Refuse what no run could do, before anything is written."""
        if not self.categories:
            raise ParameterError("a dataset needs at least one category")
        twice = next((name for name in self.categories if self.categories.count(name) > 1), None)
        if twice is not None:
            raise ParameterError(f"the category {twice!r} is named twice; leave one of them out")
        if self.count < 1:
            raise ParameterError(f"a dataset holds at least one asset, not {self.count}")
        for name in self.categories:
            if is_file(name):  # its assets are named by it, and other machines may not have it
                raise ParameterError(
                    f"a dataset takes the names of categories, not the file {name}; `artgen new` makes a "
                    "package, which brings its category to every machine that installs it"
                )
            find(name).sample(self.seed, overrides=self.overrides_of(name))

    def items(self) -> Iterator[Item]:
        """Yield its assets, the categories in turn: a longer plan begins with those of a shorter one."""
        several = len(self.categories)
        for number in range(self.count):
            yield Item(self.categories[number % several], self.seed + number // several)

    def draw(self, item: Item) -> Asset:
        """Make an asset as the plan says."""
        asset, _ = find(item.category).evaluate(
            item.seed,
            base=self.base,
            certify=self.certify,
            tolerance=self.tolerance,
            on_collision=self.on_collision,
            overrides=self.overrides_of(item.category),
        )
        return asset

    def overrides_of(self, category: str) -> dict[str, Any]:
        """Return the overrides for a category, those for it alone before those for all."""
        found = self._overrides
        return found.get(_EVERY, {}) | found.get(category, {})

    @cached_property
    def _overrides(self) -> Mapping[str, dict[str, Any]]:
        texts: dict[str, list[str]] = {}
        for text in self.overrides:
            before, colon, after = text.partition(":")
            owner = before.strip() if colon and "=" not in before else _EVERY
            if owner and owner not in self.categories:
                raise ParameterError(
                    f"the override {text!r} is for {owner!r}, of which there are none; there are "
                    f"{', '.join(self.categories)}"
                )
            texts.setdefault(owner, []).append(after if owner else text)
        return {owner: parse_overrides(each) for owner, each in texts.items()}

    def placed(self, target: Target) -> Self:
        """Return the plan as it is done in a place."""
        return self

    def to_data(self) -> dict[str, Any]:
        """Return the plan as JSON data."""
        return {
            name: list(value) if isinstance(value, tuple) else value for name, value in asdict(self).items()
        }

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """Return the plan of JSON data."""
        given: dict[str, Any] = {
            name: tuple(value) if isinstance(value, list) else value for name, value in data.items()
        }
        try:
            return cls(**given)
        except TypeError as error:
            raise ParameterError(f"this is no plan of a dataset: {error}") from error


@dataclass(frozen=True)
class Plan(Draws):
    """What a dataset holds and how it is made; two runs with equal plans write the same bytes.

    Attributes:
        formats: What is written of each asset.
        layout: How its files lie.
        collision: Which colliders it carries.
        textures: Where its maps are kept; by default shared in a folder and embedded at a URL.
        texture_size: Texels on a side of them.
        mesh_precision: How far what is seen may lie from what was made [m].
    """

    FORMAT: ClassVar[str] = "artgen-dataset-1"

    formats: tuple[str, ...] = ()
    layout: str = "flat"
    collision: Collision = "exact"
    textures: TextureMode | None = None
    texture_size: int = TEXTURES
    mesh_precision: float = 0.0

    def __post_init__(self) -> None:
        """Refuse what no run could do, before anything is written.

        Raises:
            ParameterError: A category, number or override is unknown or not allowed.
            ExportError: A layout or format is.
        """
        if self.textures not in (None, *get_args(TextureMode)):
            raise ParameterError(f"textures are shared, embedded or none, not {self.textures!r}")
        check_size(self.texture_size)
        check_precision(self.mesh_precision)
        vars(self)["formats"] = chosen_formats(find_layout(self.layout), self.formats or None)
        super().__post_init__()

    @property
    def texels(self) -> int:
        """Texels on a side of the maps; 0 where there are none."""
        return 0 if self.textures == "none" else self.texture_size

    def placed(self, target: Target) -> Self:
        """Return a plan that says where maps are kept: once for all where the place knows links.

        Raises:
            ExportError: They are to be shared elsewhere.
        """
        if self.textures == "shared" and not target.links:
            raise ExportError(
                f"maps are shared by links, and {target} knows none; choose the textures 'embedded' or 'none'"
            )
        return replace(self, textures=self.textures or ("shared" if target.links else "embedded"))
