"""Loading of assets from an export directory, and pickling in the same form."""

import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar, NoReturn, get_args

import numpy as np

from artgen._arrays import Array, cached_property
from artgen._names import ByName, check_names, checked_path
from artgen.asset.affordance import Grasp, Push
from artgen.asset.asset import FORMAT, PLAIN, Asset, remember
from artgen.asset.certificate import Certificate
from artgen.asset.joint import AllowedContact, AssetJoint
from artgen.asset.link import Collider, Link, Surface
from artgen.asset.mass import MassProperties
from artgen.asset.shape import Mesh
from artgen.asset.surface import metric_coordinates
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.errors import ArtgenError, AssetError, ExportError
from artgen.materials import Material

ASSET_FILE = "asset.json"
CERTIFICATE_FILE = "certificate.json"
MESH_DIRECTORY = "meshes"

_DAMAGES = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)  # of readers of data
_TYPES = {"name": str, "category": str, "attempt": int, "version": str, "parameters": dict}


def load(directory: str | Path) -> Asset:
    """Read an asset that was exported to a directory.

    Numbers come from `asset.json`; visible faces are read from `meshes/` on first access. If an export was
    killed before its directory was in place, the previous asset is read.

    Args:
        directory: The directory, or its `asset.json`.

    Raises:
        ExportError: There is no readable `asset.json`.
        AssetError: The file has another format, or names or paths that artgen does not write.
        ParameterError: The directory is no path.
    """
    path = checked_path(directory, "directory")
    path = path / ASSET_FILE if path.suffix != ".json" else path
    before = previous_directory(path.parent) / path.name
    if not path.exists() and before.exists():
        path = before
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error  # the message without the path
        raise ExportError(
            f"cannot read {path}: {reason}; is this a directory that artgen exported?"
        ) from error
    found = data.get("format") if isinstance(data, dict) else None
    if found != FORMAT:
        raise AssetError(f"{path} has format {found!r}; this version reads {FORMAT!r}")
    try:
        check_names(data, path)
        return asset_from_data(data, path.parent)
    except ArtgenError:
        raise
    except _DAMAGES as error:
        raise AssetError(f"{path} is damaged ({error!r}); export the asset again") from error


def exports_in(directories: Iterable[Path]) -> list[Path]:
    """Return the directories of exported assets: given ones, and those directly inside given directories.

    Raises:
        ExportError: A directory does not exist or holds no asset.
    """
    found: dict[str, Path] = {}
    for directory in directories:
        if not directory.is_dir():
            raise ExportError(
                f"there is no directory {str(directory)!r}; give one that holds an exported asset"
            )
        inside = sorted(path.parent for path in directory.glob(f"*/{ASSET_FILE}"))
        inside = [path for path in inside if not path.name.startswith(".")]  # unfinished and replaced exports
        if (directory / ASSET_FILE).is_file():
            inside = [directory]
        if not inside:
            raise ExportError(
                f"{str(directory)!r} holds no exported asset: no {ASSET_FILE} in it or in a directory in it"
            )
        for each in inside:
            found.setdefault(os.path.realpath(each), each)
    return list(found.values())


def main_files(directory: str | Path) -> dict[str, Path]:
    """Return the main file of each format of an export, which simulators open.

    Raises:
        ExportError: There is no readable `asset.json`.
        AssetError: A path leaves the directory.
    """
    path = Path(directory) / ASSET_FILE
    try:
        record = json.loads(path.read_text(encoding="utf-8"))["formats"]
        check_names({"formats": record}, path)
        return {str(name): path.parent / each["main"] for name, each in record.items()}
    except AssetError:
        raise
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        raise ExportError(
            f"cannot read the formats of {path}: {error!r}; is this a directory that artgen exported?"
        ) from error


def previous_directory(directory: Path) -> Path:
    """Return the path of the earlier asset while a new one is put into its directory."""
    target = Path(os.path.realpath(directory))
    return target.parent / f".{target.name}.previous"


def mesh_names(names: Mapping[str, Sequence[str]], taken: Iterable[str] = ()) -> dict[str, tuple[str, ...]]:
    """Return a unique file name for each mesh of each link.

    Names differ in more than case, also from names that are taken: some simulators search meshes by base
    name, and some file systems ignore case.
    """
    used = {name.lower() for name in taken}
    result = {}
    for link, of_link in names.items():
        files = []
        for name in of_link:
            file = f"{link}_{name}.obj"
            while file.lower() in used:
                file = file.replace(".obj", "_.obj")
            used.add(file.lower())
            files.append(file)
        result[link] = tuple(files)
    return result


def asset_from_data(data: Mapping[str, Any], directory: Path) -> Asset:
    """Make an asset of its JSON data; its surfaces are read from the directory on first access."""
    for name, kind in _TYPES.items():
        if name in data and not isinstance(data[name], kind):
            raise TypeError(f"{name} is {data[name]!r:.40}")
    materials = {item["name"]: Material.from_data(item) for item in data["materials"]}
    joints = ByName(AssetJoint.from_data(item) for item in data["joints"])
    files = mesh_names({item["name"]: [each["name"] for each in item["surfaces"]] for item in data["links"]})
    # the origin of a link lies on its last joint; the base has the asset's frame
    origins = {joint.child: joint.pivot for joint in joints}
    links = ByName(
        _StoredLink(
            item["name"],
            item["label"],
            grasps=tuple(map(Grasp.from_data, item["grasps"])),
            separate=item.get("separate", ""),
            pushes=tuple(map(Push.from_data, item.get("pushes", ()))),
            data=item,
            materials=materials,
            meshes=tuple(directory / MESH_DIRECTORY / file for file in files[item["name"]]),
            origin=origins.get(item["name"], np.zeros(3)),
        )
        for item in data["links"]
    )
    asset = Asset(
        links=links,
        joints=joints,
        labels=tuple(data["labels"]),
        parameters=data["parameters"],
        contacts=tuple(map(AllowedContact.from_data, data.get("contacts", ()))),
        originals=data.get("originals", {}),
        **{name: data[name] for name in (*PLAIN, "detail") if name in data},
    )
    # preset the cached property: otherwise it would be derived from the surfaces
    vars(asset)["materials"] = tuple(materials.values())
    if data.get("certificate") is None:
        return asset
    certificate = Certificate.from_data(data["certificate"])
    return remember(asset, replace(certificate, leaves=_leaves(directory / CERTIFICATE_FILE)))


def _leaves(path: Path) -> dict[str, Any] | None:
    """Read the proof of a certificate; a damaged proof is left to the check of certificates."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        return {"format": f"unreadable: {error}"}
    return data if isinstance(data, dict) else {"format": "unreadable: no JSON object"}


@dataclass(frozen=True, eq=False)
class _StoredLink(Link):
    """A link whose values come from files instead of solids."""

    data: Mapping[str, Any] = field(kw_only=True)  # data from `Link.to_data`
    materials: Mapping[str, Material] = field(kw_only=True)  # the asset's materials by name
    meshes: tuple[Path, ...] = field(kw_only=True)  # the OBJ file of each surface
    origin: Array = field(kw_only=True)  # of its frame in asset coordinates at rest, shape (3,) [m]
    rounded: ClassVar = True

    @property
    def absent(self) -> bool:  # type: ignore[override]
        return bool(self.data.get("absent", False))

    @cached_property
    def labels(self) -> tuple[str, ...]:
        return tuple(self.data["labels"])

    @cached_property
    def mass_properties(self) -> MassProperties:
        with self._reading():
            return MassProperties.from_data(self.data)

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        with self._reading():
            return tuple(
                Collider(
                    _convex(item),
                    item["label"],
                    self.materials[item["material"]],
                    item.get("spare", False),
                    tuple(item.get("joined", ())),
                )
                for item in self.data["colliders"]
            )

    @property
    def covers(self) -> tuple[Convex, ...]:
        with self._reading():
            return tuple(map(_convex, self.data.get("covers", ())))

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        with self._reading():
            return self._surfaces()

    @contextmanager
    def _reading(self) -> Iterator[None]:
        """Name the link in errors of damaged data."""
        try:
            yield
        except ArtgenError:
            raise
        except _DAMAGES as error:
            raise AssetError(
                f"link {self.name!r} is damaged in {ASSET_FILE} ({error!r}); export the asset again"
            ) from error

    def _surfaces(self) -> tuple[Surface, ...]:
        result = []
        for item, path in zip(self.data["surfaces"], self.meshes, strict=True):
            material, mesh = self.materials[item["material"]], read_obj(path, self.origin)
            # files have texture coordinates in repeats of the maps
            mesh = replace(mesh, uvs=metric_coordinates(mesh.uvs, material))
            result.append(Surface(item["name"], item["label"], material, mesh))
        return tuple(result)

    def to_data(self) -> dict[str, Any]:
        return dict(self.data)

    def moved(self, matrix: Array) -> NoReturn:
        raise AssetError(
            f"link {self.name!r} was read from files and cannot be changed; generate the asset again"
        )

    def renamed(self, suffix: str, joints: Mapping[str, str]) -> NoReturn:
        self.moved(np.eye(4))


def _convex(data: Mapping[str, Any]) -> Convex:
    points, pose = (
        np.array(data[name], float).reshape(-1, side) for name, side in (("points", 3), ("pose", 4))
    )
    if data["kind"] not in get_args(Kind) or pose.shape != (4, 4):
        raise ValueError(f"no collider is a {data['kind']!r:.40} at {data['pose']!r:.40}")
    return Convex(data["kind"], pose, tuple(map(float, data["size"])), points)


def read_obj(path: Path, origin: Array) -> Mesh:
    """Read a mesh from an OBJ file that artgen wrote; `origin` is the origin of its frame, shape (3,) [m]."""
    try:
        lines = path.read_bytes().splitlines()
    except FileNotFoundError:
        raise AssetError(
            f"there is no {path}: surfaces are read back from an export in the layout 'flat' or 'robocasa' "
            "with 'urdf' or 'mjcf' among its formats; export the asset so, or generate it again"
        ) from None
    except OSError as error:
        raise ExportError(f"cannot read {path}: {error.strerror}") from error
    rows: dict[bytes, list[bytes]] = {b"v": [], b"vn": [], b"vt": [], b"f": []}
    for line in lines:
        keyword, _, rest = line.partition(b" ")
        if keyword in rows:
            rows[keyword].append(rest)
    try:
        corners = _numbers(rows[b"f"], 9).astype(np.int64).reshape(-1, 3) - 1
        # files number values in ascending order: sorted keys sort by position, normal and coordinates
        keys = (corners[:, 0] * len(rows[b"vn"]) + corners[:, 2]) * len(rows[b"vt"]) + corners[:, 1]
        _, first, numbers = np.unique(keys, return_index=True, return_inverse=True)
        place, uv, normal = corners[first].T
        vertices = _numbers(rows[b"v"], 3)[place] + origin
        normals, uvs = _numbers(rows[b"vn"], 3)[normal], _numbers(rows[b"vt"], 2)[uv]
    except (ValueError, IndexError) as error:
        raise AssetError(f"{path} is not a mesh that artgen wrote: {error}") from error
    return Mesh(vertices, normals, uvs, np.zeros(len(vertices), np.int64), numbers.reshape(-1, 3))


def _numbers(rows: Sequence[bytes], columns: int) -> Array:
    return np.array(b" ".join(rows).replace(b"/", b" ").split(), float).reshape(-1, columns)


def pack(asset: Asset) -> tuple[Any, ...]:
    """Return the parts of an asset that are pickled: data, surfaces of its links, certificate."""
    stored = asset.rounded()
    return stored.to_data(), {link.name: link.surfaces for link in stored.links}, asset.certificate


def unpack(
    data: Mapping[str, Any], surfaces: Mapping[str, tuple[Surface, ...]], certificate: Certificate | None
) -> Asset:
    """Return the asset from the parts of `pack`; like a loaded asset, it has no solids."""
    asset = asset_from_data({**data, "certificate": None}, Path())
    for link in asset.links:
        # preset the cached property: no file is read
        vars(link)["surfaces"] = surfaces[link.name]
    return remember(asset, certificate)
