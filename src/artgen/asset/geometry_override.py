"""Links that are written with other colliders or surfaces than they were made with."""

from dataclasses import dataclass, field
from typing import Any

from artgen._caching import cached_property
from artgen.asset import Asset, Collider, Link, Surface
from artgen.asset.mass import MassProperties
from artgen.errors import AssetError


@dataclass(frozen=True, eq=False)
class DerivedLink(Link):
    """A link that is another one but for what a subclass says."""

    source: Link = field(kw_only=True)  # the link before

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """The semantic labels on the link, its own first."""
        return self.source.labels

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, centre and inertia of the source: of its solids."""
        return self.source.mass_properties

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source."""
        return self.source.colliders

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces of the source."""
        return self.source.surfaces

    def to_data(self) -> dict[str, Any]:
        """Return everything but the triangles as JSON data."""
        return self.source.to_data()


def fields_of(link: Link) -> tuple[Any, ...]:
    """Return what every link is made of, in the order of its fields."""
    return link.name, link.label, link.pieces, link.grasps, link.separate, link.pushes


def need_solids(asset: Asset, refused: str, instead: str) -> None:
    """Refuse an asset that was read from files."""
    for link in asset.links:
        if not link.pieces:
            raise AssetError(
                f"asset {asset.name!r} was read from files, which keep no solids, so {refused}; generate the "
                f"asset again, or write it with {instead}",
                link=link.name,
            )
