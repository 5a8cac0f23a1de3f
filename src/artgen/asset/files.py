"""Loading of assets from an export directory, and pickling in the same form."""

import errno
import json
import math
import os
import stat
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, NoReturn, NotRequired, TypedDict

import numpy as np

from artgen._arrays import Array, Matrix, Pose, Triple, cached_property
from artgen._names import ByName, check_names, checked_path
from artgen.asset.affordance import Grasp, Push
from artgen.asset.asset import (
    FORMAT,
    OUTDATED,
    PLAIN,
    Asset,
    Base,
    DetailName,
    Limits,
    check_references,
    remember,
    subject,
)
from artgen.asset.certificate import Certificate
from artgen.asset.coupling import AssetLoop
from artgen.asset.joint import AllowedContact, AssetJoint
from artgen.asset.link import Collider, Link, Surface
from artgen.asset.mass import MassProperties
from artgen.asset.placed import PlacedAsset
from artgen.asset.record import read, refused
from artgen.asset.shape import Mesh
from artgen.asset.signals import AssetOutput, checked_outputs
from artgen.asset.surface import metric_coordinates
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.errors import ArtgenError, AssetError, ExportError
from artgen.materials import Material

ASSET_FILE = "asset.json"
CERTIFICATE_FILE = "certificate.json"
MESH_DIRECTORY = "meshes"

_LENGTHS = {
    "box": 3,
    "cylinder": 2,
    "sphere": 1,
    "capsule": 2,
    "hull": 0,
}  # numbers of the size of a collider
_TRIANGLE = 1e-3  # by which rounded moments of flat parts may exceed the sum of the others
_UNIT = 1e-6  # largest error of the length of an axis, and of the axes of a pose
_FARTHEST = 1e6  # largest coordinate [m]
_MOST_BYTES = 1 << 29  # largest file that is read


class _Piece(TypedDict):
    kind: Kind
    pose: Pose
    size: tuple[float, ...]
    points: Annotated[Array, (0, 3)]


class _Collider(_Piece):
    label: str
    material: str
    spare: NotRequired[bool]
    joined: NotRequired[tuple[str, ...]]


class _Surface(TypedDict):
    name: str
    label: str
    material: str
    triangles: NotRequired[int]


class _Detail(TypedDict):
    label: str
    bounds: Annotated[Array, (2, 3)]


class _Link(TypedDict):
    name: str
    label: str
    labels: tuple[str, ...]
    mass: float
    center: Triple
    inertia: Matrix
    grasps: tuple[Grasp, ...]
    pushes: NotRequired[tuple[Push, ...]]
    colliders: tuple[_Collider, ...]
    surfaces: tuple[_Surface, ...]
    details: NotRequired[tuple[_Detail, ...]]
    separate: NotRequired[str]
    covers: NotRequired[tuple[_Piece, ...]]
    absent: NotRequired[bool]
    mesh_precision: NotRequired[float]


class _Files(TypedDict):
    main: str
    files: tuple[str, ...]


class _Asset(TypedDict):
    """The form of `asset.json`."""

    name: str
    category: str
    seed: NotRequired[int | None]
    attempt: NotRequired[int]
    version: NotRequired[str]
    base: NotRequired[Base]
    limits: NotRequired[Limits]
    detail: NotRequired[DetailName]
    labels: tuple[str, ...]
    parameters: Mapping[str, Any]
    materials: tuple[Material, ...]
    links: tuple[_Link, ...]
    joints: tuple[AssetJoint, ...]
    contacts: NotRequired[tuple[AllowedContact, ...]]
    originals: NotRequired[Mapping[str, str]]
    loose: NotRequired[tuple[str, ...]]
    placed: NotRequired[tuple[PlacedAsset, ...]]
    loops: NotRequired[tuple[AssetLoop, ...]]
    outputs: NotRequired[tuple[AssetOutput, ...]]
    certificate: NotRequired[Certificate | None]
    certified: NotRequired[str]
    layout: NotRequired[str]
    formats: NotRequired[Mapping[str, _Files]]
    digests: NotRequired[Mapping[str, str]]


def load(directory: str | Path) -> Asset:
    """Read an asset that was exported to a directory.

    Numbers come from `asset.json`; visible faces are read from `meshes/` on first access. If an export was
    killed before its directory was in place, the previous asset is read. A certificate is
    left out if colliders, motions of joints or contacts were changed in `asset.json` after the proof.

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
    try:
        if not path.exists() and before.exists():
            path = before
        data = json.loads(file_content(path))
    except (OSError, ValueError, RecursionError) as error:
        reason = getattr(error, "strerror", None) or error  # the message without the path
        raise ExportError(f"cannot read {path}: {reason}; {_advice(path, error)}") from error
    found = data.get("format") if isinstance(data, dict) else None
    if found != FORMAT:
        raise AssetError(
            f"{path} has format {found!r:.60}; this version reads {FORMAT!r}; export the asset again"
        )
    try:
        form = read(_Asset, data)
        check_names(data, path)
        return _asset(form, data, path.parent)
    except RecursionError:
        raise AssetError(f"{path}: its values are nested too deeply; export the asset again") from None
    except ArtgenError as error:
        known = str(error).startswith(str(path))
        raise AssetError(f"{'' if known else f'{path}: '}{error}; export the asset again") from error


def _advice(path: Path, error: Exception) -> str:
    """Return what to do about an `asset.json` that cannot be read."""
    directory = path.parent
    if isinstance(error, OSError) and error.errno == errno.ENAMETOOLONG:
        return "give a directory that artgen exported"
    if path.is_file():
        return "export the asset again"
    if not directory.exists() and not directory.suffix:
        return f"there is no directory {directory}; `artgen generate CATEGORY --out {directory}` makes one"
    inside = min(
        (path.parent for pattern in ("*", "*/*") for path in directory.glob(f"{pattern}/{ASSET_FILE}")),
        default=None,
    )
    if inside is not None:
        return f"{directory} holds several assets; give one, such as {inside}"
    return "is this a directory that artgen exported?"


def exports_in(directories: Iterable[Path]) -> list[Path]:
    """Return the directories of exported assets: given ones, and all below given directories, sorted.

    Raises:
        ExportError: A directory does not exist or holds no asset.
    """
    found: dict[str, Path] = {}
    for directory in directories:
        if not directory.is_dir():
            raise ExportError(
                f"there is no directory {str(directory)!r}; give one that holds an exported asset"
            )
        files = {*directory.glob(f"*/{ASSET_FILE}"), *directory.rglob(ASSET_FILE)}  # links at the first level
        inside = [
            path.parent
            for path in sorted(files)
            # not unfinished and replaced exports
            if not any(part.startswith(".") for part in path.relative_to(directory).parts)
        ]
        if (directory / ASSET_FILE).is_file():
            inside = [directory]
        if not inside:
            raise ExportError(
                f"{str(directory)!r} holds no exported asset; "
                f"`artgen generate CATEGORY -n 10 --out {directory}` makes some"
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
        record = json.loads(file_content(path))["formats"]
        check_names({"formats": record}, path)
        return {str(name): path.parent / each["main"] for name, each in record.items()}
    except AssetError:
        raise
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        raise ExportError(
            f"cannot read the formats of {path}: {error!r}; is this a directory that artgen exported?"
        ) from error


def file_content(path: Path) -> bytes:
    """Read an ordinary file of a size that artgen writes; a device or a pipe may never end.

    Raises:
        OSError: It cannot be read, is no ordinary file, or is too large.
    """
    status = path.stat()
    if not stat.S_ISREG(status.st_mode) and not stat.S_ISDIR(
        status.st_mode
    ):  # the system refuses directories
        raise OSError(errno.EINVAL, "it is a device, a pipe or a socket, not an ordinary file")
    if status.st_size > _MOST_BYTES:
        raise OSError(errno.EFBIG, f"it has more than {_MOST_BYTES >> 20} MiB")
    return path.read_bytes()


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


def _asset(form: _Asset, data: Mapping[str, Any], directory: Path) -> Asset:
    """Make an asset of its JSON data, also in the form; its surfaces are read on first access."""
    materials = {each.name: each for each in form["materials"]}
    files = mesh_names({item["name"]: [each["name"] for each in item["surfaces"]] for item in form["links"]})
    # the origin of a link lies on its last joint; the base has the asset's frame
    origins = {joint.child: joint.pivot for joint in form["joints"]}
    _check_unique("materials[{}].name", [each.name for each in form["materials"]])
    for number, item in enumerate(form["links"]):
        _check_link(item, materials, f"links[{number}]")
    links = ByName(
        _StoredLink(
            item["name"],
            item["label"],
            grasps=item["grasps"],
            separate=item.get("separate", ""),
            pushes=item.get("pushes", ()),
            data=data["links"][number],
            form=item,
            materials=materials,
            meshes=tuple(directory / MESH_DIRECTORY / file for file in files[item["name"]]),
            origin=origins.get(item["name"], np.zeros(3)),
        )
        for number, item in enumerate(form["links"])
    )
    contacts = form.get("contacts", ())
    _check_tree(links, form["joints"])
    for number, name in enumerate(form.get("loose", ())):
        if name not in links.by_name:
            raise refused(name, f"loose[{number}]", "the name of one of the links")
    check_references(links, form["joints"], contacts, form.get("loops", ()))
    asset = Asset(
        links=links,
        joints=ByName(form["joints"]),
        labels=form["labels"],
        parameters=data["parameters"],
        contacts=contacts,
        originals=form.get("originals", {}),
        loose=form.get("loose", ()),
        placed=form.get("placed", ()),
        loops=form.get("loops", ()),
        outputs=checked_outputs(form.get("outputs", ()), {each.name: each for each in form["joints"]}),
        **{name: data[name] for name in (*PLAIN, "detail") if name in data},
    )
    # preset the cached property: otherwise it would be derived from the surfaces
    vars(asset)["materials"] = form["materials"]
    certificate = form.get("certificate")
    if certificate is None or form.get("certified") not in (None, subject(asset)):
        vars(asset)[OUTDATED] = certificate is not None
        return asset
    return remember(asset, replace(certificate, leaves=_leaves(directory / CERTIFICATE_FILE)))


def _check_weight(form: _Link, place: str) -> None:
    if not form["mass"] > 0.0:
        raise refused(form["mass"], f"{place}.mass", "positive [kg]")
    low, middle, high = np.linalg.eigvalsh(form["inertia"])
    if low <= 0.0 or high > (1.0 + _TRIANGLE) * (low + middle):
        allowed = "a tensor of positive moments, each at most the sum of the others"
        raise refused(form["inertia"].tolist(), f"{place}.inertia", allowed)


def _check_link(form: _Link, materials: Mapping[str, Material], place: str) -> None:
    """Check what kinds of values leave open: weights, sizes of colliders, and names of materials."""
    _check_weight(form, place)
    lists = {"labels": form["labels"], "colliders": form["colliders"], "surfaces": form["surfaces"]}
    for name, items in lists.items():
        if not items and not form.get("absent", False):
            raise refused([], f"{place}.{name}", "a list of at least one")
    used = [(f"colliders[{number}]", item["material"]) for number, item in enumerate(form["colliders"])]
    used += [(f"surfaces[{number}]", item["material"]) for number, item in enumerate(form["surfaces"])]
    for at, name in used:
        if name not in materials:
            raise refused(name, f"{place}.{at}.material", "the name of one of the materials")
    pieces: Sequence[_Piece] = form["colliders"]
    for kind, these in (("colliders", pieces), ("covers", form.get("covers", ()))):
        for number, piece in enumerate(these):
            _check_piece(piece, f"{place}.{kind}[{number}]")
    for number, grasp in enumerate(form["grasps"]):
        if not grasp.width >= 0.0:
            raise refused(grasp.width, f"{place}.grasps[{number}].width", "0 or more [m]")


def _check_piece(form: _Piece, place: str) -> None:
    kind, size, points = form["kind"], form["size"], form["points"]
    if len(size) != _LENGTHS[kind] or not all(0.0 < length < _FARTHEST for length in size):
        raise refused(list(size), f"{place}.size", f"{_LENGTHS[kind]} positive lengths of a {kind} [m]")
    turn = form["pose"][:3, :3]
    if np.abs(turn @ turn.T - np.eye(3)).max() > _UNIT or (form["pose"][3] != (0.0, 0.0, 0.0, 1.0)).any():
        raise refused(
            form["pose"].tolist(), f"{place}.pose", "a rotation or reflection and a shift, shape (4, 4)"
        )
    if np.abs(points).max(initial=0.0) > _FARTHEST or np.abs(form["pose"]).max() > _FARTHEST:
        raise refused(points.tolist(), f"{place}.points", f"within {_FARTHEST:g} m")
    if kind == "hull" and (len(points) < 4 or np.linalg.matrix_rank(points - points[:1]) < 3):
        raise refused(points.tolist(), f"{place}.points", "4 or more points that do not lie in one plane")


def _check_tree(links: Sequence[Link], joints: Sequence[AssetJoint]) -> None:
    """Check that the joints make one tree of the links, parents first, and can move."""
    names = [link.name for link in links]
    if not names:
        raise refused([], "links", "a list of at least one link")
    _check_unique("links[{}].name", names)
    _check_unique("joints[{}].name", [joint.name for joint in joints])
    holds = [[hold.name for hold in (*link.grasps, *link.pushes)] for link in links]
    _check_unique("grasp or push {}", [name for each in holds for name in each])
    for number, joint in enumerate(joints):
        if joint.parent not in names:
            raise refused(joint.parent, f"joints[{number}].parent", "the name of one of the links")
        after = names[names.index(joint.parent) + 1 :]
        if joint.child not in after:
            allowed = f"the name of a link that follows {joint.parent!r}"
            raise refused(joint.child, f"joints[{number}].child", allowed)
        _check_joint(joint, joints[:number], f"joints[{number}]")
    children = [names[0], *(joint.child for joint in joints)]
    for number, name in enumerate(names):
        if name not in children:
            raise refused(name, f"links[{number}].name", "the child of a joint, or the first link")


def _check_joint(joint: AssetJoint, before: Sequence[AssetJoint], place: str) -> None:
    same = [other for other in before if other.child == joint.child]
    if same and same[-1] is not before[-1]:
        raise refused(joint.child, f"{place}.child", "next to the other joints of that link")
    if same and same[-1].parent != joint.parent:
        allowed = f"{same[-1].parent!r}, like that of the other joints of {joint.child!r}"
        raise refused(joint.parent, f"{place}.parent", allowed)
    if abs(math.hypot(*joint.axis) - 1.0) > _UNIT:
        raise refused(joint.axis.tolist(), f"{place}.axis", "a vector of length 1")
    for name in ("stiffness", "damping", "friction", "armature", "effort", "velocity"):
        if (value := getattr(joint, name)) is not None and value < 0.0:
            raise refused(value, f"{place}.{name}", "0 or more")
    if joint.limits is not None and joint.limits[0] > joint.limits[1]:
        raise refused(list(joint.limits), f"{place}.limits", "the lowest and the highest position")


def _check_unique(place: str, names: Sequence[str]) -> None:
    for number, name in enumerate(names):
        if name in names[:number]:
            raise refused(name, place.format(number), "another name: it is taken")


def _leaves(path: Path) -> dict[str, Any] | None:
    """Read the proof of a certificate; a damaged proof is left to the check of certificates."""
    try:
        data = json.loads(file_content(path))
        json.dumps(data, allow_nan=False)  # NaN and 1e999, which no JSON has, raise ValueError
    except FileNotFoundError:
        return None
    except (OSError, ValueError, RecursionError) as error:
        return {"format": f"unreadable: {error}"}
    return data if isinstance(data, dict) else {"format": "unreadable: no JSON object"}


@dataclass(frozen=True, eq=False, repr=False)
class _StoredLink(Link):
    """A link whose values come from files instead of solids."""

    data: Mapping[str, Any] = field(kw_only=True)  # data from `Link.to_data`
    form: _Link = field(kw_only=True)  # the same, with arrays and records
    materials: Mapping[str, Material] = field(kw_only=True)  # the asset's materials by name
    meshes: tuple[Path, ...] = field(kw_only=True)  # the OBJ file of each surface
    origin: Array = field(kw_only=True)  # of its frame in asset coordinates at rest, shape (3,) [m]
    rounded: ClassVar = True

    @property
    def absent(self) -> bool:  # type: ignore[override]
        return self.form.get("absent", False)

    @cached_property
    def labels(self) -> tuple[str, ...]:
        return self.form["labels"]

    @cached_property
    def mass_properties(self) -> MassProperties:
        return MassProperties(self.form["mass"], self.form["center"], self.form["inertia"])

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        return tuple(
            Collider(
                _convex(item),
                item["label"],
                self.materials[item["material"]],
                item.get("spare", False),
                item.get("joined", ()),
            )
            for item in self.form["colliders"]
        )

    @property
    def covers(self) -> tuple[Convex, ...]:
        return tuple(map(_convex, self.form.get("covers", ())))

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        result = []
        for item, path in zip(self.form["surfaces"], self.meshes, strict=True):
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

    def renamed(self, rename: Callable[[str], str], joints: Mapping[str, str]) -> NoReturn:
        self.moved(np.eye(4))


def _convex(form: _Piece) -> Convex:
    return Convex(form["kind"], form["pose"], tuple(map(float, form["size"])), form["points"])


def read_obj(path: Path, origin: Array) -> Mesh:
    """Read a mesh from an OBJ file that artgen wrote; `origin` is the origin of its frame, shape (3,) [m]."""
    try:
        lines = file_content(path).splitlines()
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
    fault = f"{path} is not a mesh that artgen wrote"
    try:
        vertices, normals, uvs = (_numbers(rows[key], n) for key, n in ((b"v", 3), (b"vn", 3), (b"vt", 2)))
        corners = _numbers(rows[b"f"], 9).reshape(-1, 3)
    except ValueError as error:
        raise AssetError(f"{fault}: {error}") from error
    for name, values in (("v", vertices), ("vn", normals), ("vt", uvs)):
        if not (np.abs(values) <= _FARTHEST).all():
            raise AssetError(f"{fault}: a number of a line '{name}' is not in {-_FARTHEST:g}..{_FARTHEST:g}")
    counts = [len(vertices), len(uvs), len(normals)]
    if not (len(corners) and ((corners >= 1) & (corners <= counts) & (corners % 1 == 0)).all()):
        raise AssetError(
            f"{fault}: it needs lines 'f' whose numbers are those of 'v', 'vt' and 'vn', from 1 on"
        )
    index = corners.astype(np.int64) - 1
    # files number values in ascending order: sorted keys sort by position, normal and coordinates
    keys = (index[:, 0] * len(normals) + index[:, 2]) * len(uvs) + index[:, 1]
    _, first, numbers = np.unique(keys, return_index=True, return_inverse=True)
    place, uv, normal = index[first].T
    vertices, normals, uvs = vertices[place] + origin, normals[normal], uvs[uv]
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
    asset = _asset(read(_Asset, {**data, "certificate": None}), data, Path())
    for link in asset.links:
        # preset the cached property: no file is read
        vars(link)["surfaces"] = surfaces[link.name]
    return remember(asset, certificate)
