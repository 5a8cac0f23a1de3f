"""Layout of RoboCasa and robosuite: one `model.xml` of an object for their scenes.

Both parse the XML themselves and take the file apart. They support only default classes that are not nested,
files relative to the model, colliders in group 0 and visuals in group 1. The links are below a body `object`
with three sites that give the size; RoboCasa reads geoms whose names begin with `reg_`, and its first version
sites such as `ext_p0`. Its classes of fixtures look for joints, bodies and sites by fixed names, see
`fixtures`; `artgen_names.json` gives the asset's own names for them.

Do not name an object after one of its links: robosuite puts `<name>_` before all names, except those that
begin with it already.
"""

import xml.etree.ElementTree as ET

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.record import json_text
from artgen.errors import ExportError
from artgen.export.frames import seen_box
from artgen.export.layouts.robocasa.fixtures import Fixture, fixture
from artgen.export.layouts.robocasa.regions import interiors
from artgen.export.losses import Layout, Written, losses
from artgen.export.meshes import mesh_files
from artgen.export.mjcf import mjcf_losses, mjcf_tree
from artgen.export.names import NAMES_FILE, Names
from artgen.export.text import add, document

FILE = "model.xml"
"""File that RoboCasa opens in the directory of an object."""

OBJECT = "object"
"""Body of the whole object, in which robosuite looks for it."""

_RESERVED = (OBJECT, "main")  # robosuite renames the first to the second
_CLASSES = {
    "visual": {"type": "mesh", "group": "1", "contype": "0", "conaffinity": "0", "mass": "0"},
    "collision": {"group": "0", "rgba": "0.5 0 0 0.5"},
    "region": {
        "type": "box", "group": "1", "contype": "0", "conaffinity": "0", "mass": "0", "rgba": "0 1 0 0",
    },
}  # fmt: skip
_UNSEEN: dict[str, str] = {"size": "0.005", "rgba": "0 0 0 0"}
_CORNERS = {"p0": (0, 0, 0), "px": (1, 0, 0), "py": (0, 1, 0), "pz": (0, 0, 1)}


def write_robocasa(asset: Asset, name: str, textures: int) -> Written:
    """Write an asset as an object of RoboCasa; see `Layout.write`.

    Raises:
        ExportError: A link has a name that is reserved by robosuite or RoboCasa.
    """
    assert name == "mjcf"
    for link in asset.links:
        if link.name in _RESERVED or link.name.startswith("reg_"):
            raise ExportError(
                f"the layout 'robocasa' cannot hold a link named {link.name!r}: robosuite calls the whole "
                f"object so ({', '.join(_RESERVED)}), and RoboCasa its regions (reg_...); give the part "
                "another label or name"
            )
    meshes = mesh_files(asset, textures)
    root = mjcf_tree(asset, meshes)
    _spell_defaults(root)
    named = _wrap(root, asset)
    _rename(root, named)
    coupled = [joint.name for joint in asset.joints if joint.follows is not None and not joint.locked]
    clicking = [joint.name for joint in asset.joints if joint.detents is not None]
    soft = [joint.name for joint in asset.joints if joint.closing is not None]
    left = "that robosuite leaves behind: append each element of the object's `{0}` to that of the task"
    own = losses(
        ("joint coupling in robosuite", coupled, "an equality " + left.format("equality")),
        ("joint detents in robosuite", clicking, "tendons " + left.format("tendon")),
        ("soft closing in robosuite", soft, "a tendon " + left.format("tendon")),
    )
    files = {FILE: document(root), **meshes.files}
    if named.joints or named.links:
        files[NAMES_FILE] = json_text(_names(asset, named).to_data()).encode()
    return Written(files, (*mjcf_losses(asset, textures), *own), FILE)


def _spell_defaults(root: ET.Element) -> None:
    """Copy defaults to the elements, except for geoms, whose defaults become classes of one level."""
    defaults = _found(root, "default")
    outer = _found(defaults, "default")
    prefix = f"{outer.get('class')}_"
    everywhere = {element.tag: element.attrib for element in outer if element.tag != "default"}
    classes = dict(_CLASSES)
    for inner in outer.iterfind("default"):
        name = inner.attrib["class"].removeprefix(prefix)
        classes[name] = {**_found(inner, "geom").attrib, **_CLASSES[name]}
    defaults.clear()
    for name, attributes in classes.items():
        add(add(defaults, "default", {"class": name}), "geom", attributes)
    for element in _found(root, "worldbody").iter():
        element.attrib.pop("childclass", None)
        if element.tag == "geom":
            element.set("class", element.attrib["class"].removeprefix(prefix))
            if element.get("type") == "sphere":  # RoboCasa cannot scale single numbers
                element.set("size", " ".join([element.attrib["size"]] * 3))
        for key, value in everywhere.get(element.tag, {}).items():
            element.attrib.setdefault(key, value)


def _wrap(root: ET.Element, asset: Asset) -> Fixture:
    """Put the links into the body that the readers expect, with its sites and regions; return the fixture."""
    world = _found(root, "worldbody")
    base = _found(world, "body")
    world.remove(base)
    outer = add(world, "body")
    for joint in base.findall("freejoint"):
        base.remove(joint)
        outer.append(joint)  # the readers drop it and give the object their own joint
    inner = add(outer, "body", name=OBJECT)
    inner.append(base)
    bodies = {body.get("name", ""): body for body in base.iter("body")}
    box, rooms = seen_box(asset), interiors(asset)
    named = fixture(asset, rooms)
    for child in base.findall("body") if named.sites else ():
        base.remove(child)
        inner.append(child)  # RoboCasa looks for dials and spouts right below the object
    regions = {"main": box, "bbox": box}
    regions |= {f"int_{number}" if number else "int": room for number, room in enumerate(rooms)}
    regions |= named.regions
    for name, region in regions.items():
        add(inner, "geom", {"name": f"reg_{name}", "class": "region", **_box(region)})
    for prefix, name in (("ext", "main"), ("int", "int")):
        for corner, where in _CORNERS.items() if name in regions else ():
            position = np.where(where, regions[name][1], regions[name][0])
            add(inner, "site", name=f"{prefix}_{corner}", pos=position, **_UNSEEN)
    for link in asset.links:
        box_of_link = _box(link.bounds() - asset.origin(link.name))
        site = {"name": f"reg_{link.name}", **box_of_link, "type": "box", "group": "4", "rgba": "0 1 0 0"}
        add(bodies[link.name], "site", site)
    # robosuite reads the size from these sites
    (low, high), radii = box[:, 2], np.abs(box[:, :2]).max(axis=0)
    sizes = {"bottom": (0.0, 0.0, low), "top": (0.0, 0.0, high)}
    for name, place in (sizes | {"horizontal_radius": (*radii, (low + high) / 2.0)}).items():
        add(outer, "site", name=f"{name}_site", pos=place, **_UNSEEN)
    bodies[asset.links[0].name] = inner
    for each in named.sites:
        holder = bodies[each.link] if each.link else add(inner, "body", name=f"{each.name}_outlet")
        place = each.place - (asset.origin(each.link) if each.link else 0.0)
        add(
            holder,
            "site",
            name=each.name,
            type="cylinder",
            size=each.size,
            pos=place.round(7),
            rgba=f"{each.rgb} 0",
        )
    return named


def _rename(root: ET.Element, named: Fixture) -> None:
    """Give joints, bodies and geoms the names that RoboCasa looks for."""
    for element in root.iter():
        new = {"joint": named.joints, "body": named.links, "geom": named.geoms}.get(element.tag)
        for key in ("name", "joint1", "joint2"):
            if new and element.get(key) in new:
                element.set(key, new[element.attrib[key]])
        if element.get("objtype") == "joint" and element.get("objname") in named.joints:
            element.set("objname", named.joints[element.attrib["objname"]])


def _names(asset: Asset, named: Fixture) -> Names:
    """Return the asset's names for those of the file."""
    return Names(
        {named.links.get(link.name, link.name): link.name for link in asset.links},
        {named.joints.get(joint.name, joint.name): (joint.name, 1) for joint in asset.joints},
    )


def _box(corners: Array) -> dict[str, Array]:
    """Return center and half lengths of a box."""
    corners = np.round(corners, 6)
    return {"pos": corners.mean(axis=0).round(7), "size": (corners[1] - corners[0]) / 2.0}


def _found(parent: ET.Element, tag: str) -> ET.Element:
    element = parent.find(tag)
    assert element is not None
    return element


ROBOCASA = Layout(
    "robocasa",
    "model.xml of an object or fixture, for robosuite and RoboCasa",
    ("mjcf",),
    ("mjcf",),
    write_robocasa,
)
"""One MJCF object in its own directory."""
