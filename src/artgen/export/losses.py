"""The result of a writer (files as bytes, and the losses of its format), and the description of a layout."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass

from artgen.asset import Asset, AssetJoint


@dataclass(frozen=True)
class Loss:
    """A feature that a format cannot say.

    Attributes:
        feature: What is lost, e.g. `joint armature`.
        where: Names of the joints, links or grasps that it concerns, separated by commas.
        instead: What was written in its place.
    """

    feature: str
    where: str
    instead: str

    def to_data(self) -> dict[str, str]:
        """Return the loss as JSON data."""
        return asdict(self)


@dataclass(frozen=True)
class Written:
    """An asset in one format.

    Attributes:
        files: Content by path relative to the asset's directory, with forward slashes.
        losses: What the format cannot say.
        main: Path of the file that a client opens.
    """

    files: Mapping[str, bytes]
    losses: tuple[Loss, ...] = ()
    main: str = ""


def loss(feature: str, where: Iterable[str], instead: str) -> tuple[Loss, ...]:
    """Return one loss if it concerns anything, else none."""
    names = ", ".join(where)
    return (Loss(feature, names, instead),) if names else ()


def joints_where(asset: Asset, condition: Callable[[AssetJoint], bool]) -> list[str]:
    """Return the names of the joints for which a condition holds."""
    return [joint.name for joint in asset.joints if condition(joint)]


def dependency_losses(asset: Asset) -> tuple[Loss, ...]:
    """List the joints that depend on others: no format has a word for it."""
    return tuple(
        Loss(
            "joint dependency",
            joint.name,
            f"nothing: the parts' contact must hold it unless {joint.needs}",
        )
        for joint in asset.joints
        if joint.needs is not None
    )


def contact_losses(asset: Asset) -> tuple[Loss, ...]:
    """List the links that touch by design: no format has a word for how deep."""
    return tuple(
        Loss(
            "contact by design",
            f"{contact.links[0]}, {contact.links[1]}",
            "nothing: simulators push the parts apart where they touch",
        )
        for contact in asset.contacts
    )


def label_losses(asset: Asset) -> tuple[Loss, ...]:
    """List the links with semantic labels, for formats that have no word for them."""
    return loss("semantic labels", [link.name for link in asset.links], "nothing; they are in asset.json")


def look_losses(asset: Asset, textures: int, *, coat: str = "") -> tuple[Loss, ...]:
    """List the losses of the appearance of materials.

    Args:
        asset: The asset.
        textures: Texels on a side of the maps that are written; 0 for none.
        coat: What is written instead of a coat; empty where the format has a word for it.
    """
    seen = list(dict.fromkeys(surface.material for link in asset.links for surface in link.surfaces))
    return (
        *loss(
            "texture",
            [material.name for material in seen if material.texture and not textures],
            "the mean color and roughness: maps were not asked for",
        ),
        *loss(
            "transmission",
            [material.name for material in seen if material.transmission_weight],
            "an opacity, which does not refract",
        ),
        *loss("coat", [material.name for material in seen if material.coat_weight and coat], coat),
    )


@dataclass(frozen=True)
class Layout:
    """A way to lay out the files of an asset, as the readers of one dataset expect them.

    Attributes:
        name: Its name, such as `partnet-mobility`.
        summary: Who reads it, in one line.
        formats: The formats that it can hold; those written by default come first.
        default: How many of them are written by default.
        write: Writes one format of an asset with so many texels on a side of its maps; paths of files are
            relative to the directory of the export.
    """

    name: str
    summary: str
    formats: tuple[str, ...]
    default: int
    write: Callable[[Asset, str, int], Written]

    @property
    def default_formats(self) -> tuple[str, ...]:
        """The formats that are written unless others are asked for."""
        return self.formats[: self.default]
