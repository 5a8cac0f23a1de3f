"""Result of a writer: files as bytes and losses of the format; and the description of a layout."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass

from artgen.asset import Asset, AssetJoint


@dataclass(frozen=True)
class Loss:
    """A feature that a format cannot express.

    Attributes:
        feature: The lost feature, e.g. `joint armature`.
        where: Names of the affected joints, links or grasps, separated by commas.
        instead: The replacement in the file.
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
        losses: Losses of the format.
        main: Path of the main file, which simulators open.
    """

    files: Mapping[str, bytes]
    losses: tuple[Loss, ...] = ()
    main: str = ""


def loss(feature: str, where: Iterable[str], instead: str) -> tuple[Loss, ...]:
    """Return one loss if it affects anything, else none."""
    names = ", ".join(where)
    return (Loss(feature, names, instead),) if names else ()


def joints_where(asset: Asset, condition: Callable[[AssetJoint], bool]) -> list[str]:
    """Return the names of the joints that satisfy a condition."""
    return [joint.name for joint in asset.joints if condition(joint)]


def dependency_losses(asset: Asset) -> tuple[Loss, ...]:
    """Return the loss of dependencies, which no format can express."""
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
    """Return the loss of allowed contacts, whose depth no format can express."""
    return tuple(
        Loss(
            "contact by design",
            f"{contact.links[0]}, {contact.links[1]}",
            "nothing: simulators push the parts apart where they touch",
        )
        for contact in asset.contacts
    )


def label_losses(asset: Asset) -> tuple[Loss, ...]:
    """Return the loss of semantic labels, for formats without them."""
    return loss("semantic labels", [link.name for link in asset.links], "nothing; they are in asset.json")


def look_losses(asset: Asset, textures: int, *, coat: str = "") -> tuple[Loss, ...]:
    """Return the losses of the appearance of materials.

    Args:
        asset: The asset.
        textures: Texels per side of the written maps; 0 for none.
        coat: Replacement of a coat; empty if the format supports coats.
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
    """Arrangement of the files of an asset for the readers of one dataset.

    Attributes:
        name: Its name, such as `partnet-mobility`.
        summary: Its readers, in one line.
        formats: Its formats, the default ones first.
        default: Number of default formats.
        write: Function that writes one format of an asset with a number of texels per side of its maps; paths
            of files are relative to the directory of the export.
    """

    name: str
    summary: str
    formats: tuple[str, ...]
    default: int
    write: Callable[[Asset, str, int], Written]

    @property
    def default_formats(self) -> tuple[str, ...]:
        """The default formats."""
        return self.formats[: self.default]
