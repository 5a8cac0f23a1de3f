"""Result of a writer: files as bytes and losses of the format; and the description of a layout."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass

from artgen.asset import Asset
from artgen.materials import Material


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


Row = tuple[str, Iterable[str], str]
"""A feature, the names of all that it affects in an asset, and its replacement."""


def losses(*rows: Row) -> tuple[Loss, ...]:
    """Return the losses of a table; a feature that affects nothing is not lost."""
    joined = [(feature, ", ".join(where), instead) for feature, where, instead in rows]
    return tuple(Loss(*row) for row in joined if row[1])


def mechanism_rows(asset: Asset) -> Iterator[Row]:
    """Yield the losses of all formats: dependencies of joints, and the depths of allowed contacts."""
    for joint in asset.joints:
        if joint.needs is not None:
            instead = f"nothing: the parts' contact must hold it unless {joint.needs}"
            yield "joint dependency", [joint.name], instead
    for contact in asset.contacts:
        instead = "nothing: simulators push the parts apart where they touch"
        yield "contact by design", contact.links, instead


def tendon_rows(asset: Asset) -> Iterator[Row]:
    """Yield the losses of formats without detents and soft closing of joints."""
    found = [joint.name for joint in asset.joints if joint.detents is not None]
    yield (
        "joint detents",
        found,
        "positions and torque in artgen_states; `AssetJoint.detent_torque` has the law",
    )
    found = [joint.name for joint in asset.joints if joint.closing is not None]
    yield "soft closing", found, "numbers in artgen_states; `AssetJoint.closing_force` has the law"


def loop_rows(asset: Asset, instead: str) -> Iterator[Row]:
    """Yield the loss of formats that are trees, of the joints of closed chains."""
    found = [joint.name for joint in asset.joints if joint.follows is not None and joint.follows.curve]
    yield "closed chain", found, instead


def affordance_rows(asset: Asset, grasp: str, push: str) -> Iterator[Row]:
    """Yield the losses of grasps and pushes with their replacements."""
    for kind, instead in (("grasp", grasp), ("push", push)):
        yield f"{kind} frame", [each.name for each in asset.affordances if each.kind == kind], instead


def look_rows(asset: Asset, textures: int) -> Iterator[Row]:
    """Yield the losses of the appearance of materials with a number of texels per side of the maps."""
    seen = seen_materials(asset)
    unmapped = [material.name for material in seen if material.texture and not textures]
    yield "texture", unmapped, "the mean color and roughness: maps were not asked for"
    clear = [material.name for material in seen if material.transmission_weight]
    yield "transmission", clear, "an opacity, which does not refract"


def seen_materials(asset: Asset) -> list[Material]:
    """Return the materials of visible surfaces, each once."""
    return list(dict.fromkeys(surface.material for link in asset.links for surface in link.surfaces))


@dataclass(frozen=True)
class Layout:
    """Arrangement of the files of an asset for the readers of one dataset.

    Attributes:
        name: Its name, such as `partnet-mobility`.
        summary: Its readers, in one line.
        formats: Its formats.
        default_formats: The formats that are written by default.
        write: Function that writes one format of an asset with a number of texels per side of its maps; paths
            of files are relative to the directory of the export.
        indices: Files of an asset that a dataset has for all of its assets together.
        library: Function that makes these files of a dataset from those of its assets, by path.
    """

    name: str
    summary: str
    formats: tuple[str, ...]
    default_formats: tuple[str, ...]
    write: Callable[[Asset, str, int], Written]
    indices: tuple[str, ...] = ()
    library: Callable[[Mapping[str, bytes]], Mapping[str, bytes]] = dict
