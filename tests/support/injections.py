"""Faults of exports, each a small edit of the files as a hand or a bad script would make it.

`FAULTS` has them all. Each finds what it edits in any export: the first free joint that turns, the link that
it moves, the first joint that follows, the first collider that is a hull.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from lxml import etree

from artgen.asset import Asset
from artgen.asset import AssetJoint as Joint
from artgen.asset.files import main_files


@dataclass(frozen=True)
class Fault:
    """A fault.

    Attributes:
        name: What is wrong, as the name of a test.
        check: The check that must tell.
        says: Part of its message, a regular expression.
        where: `link` or `joint` that the finding must name: the edited one; empty for none.
        inject: Edits an export.
    """

    name: str
    check: str
    says: str
    where: str
    inject: Callable[["Export"], None]


FAULTS: dict[str, Fault] = {}


def fault(check: str, says: str, where: str = "") -> Callable[[Callable[["Export"], None]], Fault]:
    """Add a function that edits an export to the faults."""

    def add(inject: Callable[["Export"], None]) -> Fault:
        made = Fault(inject.__name__, check, says, where, inject)
        assert made.name not in FAULTS
        FAULTS[made.name] = made
        return made

    return add


class Absent(Exception):  # noqa: N818 - it is no error: some exports have nothing that a fault could spoil
    """The export has nothing that the fault could spoil."""


class Export:
    """An export that may be edited, and what is edited in it."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        self.asset = Asset.load(directory)
        self.files = main_files(directory)

    @cached_property
    def joint(self) -> Joint:
        """The first free joint that turns within limits."""
        return self._first(
            lambda joint: joint.kind == "revolute" and joint.limits is not None and not joint.follows
        )

    @cached_property
    def sprung(self) -> Joint:
        """The first joint with a spring."""
        return self._first(lambda joint: joint.stiffness > 0.0)

    @cached_property
    def rubbing(self) -> Joint:
        """The first joint with friction."""
        return self._first(lambda joint: joint.friction > 0.0)

    @cached_property
    def follower(self) -> Joint:
        """The first joint that follows another."""
        return self._first(lambda joint: joint.follows is not None)

    def _first(self, condition: Callable[[Joint], bool]) -> Joint:
        for joint in self.asset.joints:
            if not joint.locked and condition(joint):
                return joint
        raise Absent

    @property
    def link(self) -> str:
        """The link that the joint moves."""
        return self.joint.child

    @property
    def base(self) -> str:
        """The base link."""
        return self.asset.links[0].name

    @cached_property
    def hull(self) -> tuple[str, Path]:
        """A link and the file of a collider of it that is a hull."""
        for link in self.asset.links:
            for number, collider in enumerate(link.colliders):
                path = self.directory / f"meshes/{link.name}_collider_{number}.obj"
                if collider.convex.kind == "hull" and path.exists():
                    return link.name, path
        raise Absent

    @cached_property
    def texture(self) -> Path:
        """The first map."""
        for path in sorted(self.directory.glob("meshes/textures/*.png")):
            return path
        raise Absent

    @cached_property
    def surface(self) -> Path:
        """The first file of visible faces of the link."""
        return min(
            path
            for path in (self.directory / "meshes").glob(f"{self.link}_*.obj")
            if "_collider_" not in path.name
        )

    @contextmanager
    def xml(self, name: str) -> Iterator[Any]:
        """Edit the tree of the URDF or MJCF."""
        tree = etree.parse(self.files[name])
        yield tree.getroot()
        tree.write(self.files[name], xml_declaration=True, encoding="utf-8")

    @contextmanager
    def layer(self, suffix: str = ".usda") -> Iterator[Any]:
        """Edit the layer of the USD that has joints and bodies; or the other, of the meshes."""
        from pxr import Sdf

        path = self.files["usd"] if suffix == ".usda" else next(self.directory.glob("*.usdc"))
        layer = Sdf.Layer.OpenAsAnonymous(str(path))
        yield layer
        layer.Export(str(path))

    def prim(self, layer: Any, name: str) -> Any:
        """Return the spec of a body or joint by its name."""
        found = []
        layer.Traverse(
            "/", lambda path: found.append(path) if path.IsPrimPath() and path.name == name else None
        )
        specs = [layer.GetPrimAtPath(path) for path in sorted(found)]
        return min((spec for spec in specs if spec.typeName), key=lambda spec: spec.path.pathElementCount)

    def rewrite(self, path: Path, old: str, new: str) -> None:
        """Replace the first occurrence of a text."""
        text = path.read_text(encoding="utf-8")
        if old not in text:
            raise Absent
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    def cut(self, path: Path) -> None:
        """Leave the first half of a file."""
        content = path.read_bytes()
        path.write_bytes(content[: len(content) // 2])


def named(root: Any, path: str, name: str) -> Any:
    """Return the first element at a path that has a name."""
    for element in root.iterfind(path):
        if element.get("name") == name:
            return element
    raise Absent


def scaled(element: Any, key: str, *factors: float) -> None:
    """Multiply the numbers of an attribute, each by a factor of its own, or all by one."""
    numbers = [float(word) for word in element.get(key).split()]
    factors = factors * len(numbers) if len(factors) == 1 else factors
    element.set(
        key, " ".join(f"{number * factor:.9g}" for number, factor in zip(numbers, factors, strict=True))
    )


def shifted(element: Any, key: str, away: float) -> None:
    """Add to the first number of an attribute."""
    first, *rest = (element.get(key) or "0 0 0").split()
    element.set(key, " ".join([f"{float(first) + away:.9g}", *rest]))


def place(fault: Fault, export: Export) -> tuple[str, str]:
    """Return the link and the joint that a finding must name; look before the edit."""
    joints = {"joint": "joint", "sprung": "sprung", "rubbing": "rubbing", "follower": "follower"}
    if fault.where in joints:
        return "", getattr(export, joints[fault.where]).name
    links = {
        "": lambda: "",
        "link": lambda: export.link,
        "base": lambda: export.base,
        "hull": lambda: export.hull[0],
        "pair": lambda: f"{export.joint.parent}, {export.link}",
        "held": lambda: next((each.link for each in export.asset.affordances if each.kind == "grasp"), ""),
    }
    return links[fault.where](), ""
