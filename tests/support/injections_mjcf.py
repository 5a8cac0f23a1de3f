"""Faults of an MJCF; see `support.injections`."""

from copy import deepcopy
from math import degrees
from typing import Any

from lxml import etree

from support.injections import Absent, Export, fault, named, scaled, shifted


def body(export: Export, root: Any) -> Any:
    return named(root, "worldbody//body", export.link)


def joint(root: Any, name: str) -> Any:
    return named(root, "worldbody//joint", name)


def geom(export: Export, root: Any, what: str) -> Any:
    for element in body(export, root).iterfind("geom"):
        if element.get("class").endswith(what):
            return element
    raise Absent


@fault("mjcf", r"it cannot be read: ValueError: Error: .*inertia", "link")
def mjcf_zero_inertia(export: Export) -> None:
    with export.xml("mjcf") as root:
        body(export, root).find("inertial").set("fullinertia", "0 0 0 0 0 0")


@fault("mjcf", r"it cannot be read: ValueError: Error: .*inertia", "link")
def mjcf_inertia_of_no_body(export: Export) -> None:
    with export.xml("mjcf") as root:
        body(export, root).find("inertial").set("fullinertia", "5 1 1 0 0 0")


@fault("mjcf", r"its mass is 123\.5 kg in", "link")
def mjcf_other_mass(export: Export) -> None:
    with export.xml("mjcf") as root:
        body(export, root).find("inertial").set("mass", "123.5")


@fault("mjcf", r"its center of mass is 10 mm away", "link")
def mjcf_other_center(export: Export) -> None:
    with export.xml("mjcf") as root:
        shifted(body(export, root).find("inertial"), "pos", 0.01)


@fault("mjcf", r"its limits are none in .*, not", "joint")
def mjcf_inverted_limits(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = joint(root, export.joint.name)
        element.set("range", " ".join(reversed(element.get("range").split())))


@fault("mjcf", r"its limits are -?[\d.]+ to [\d.]+ rad in .*, not", "joint")
def mjcf_degrees(export: Export) -> None:
    with export.xml("mjcf") as root:
        scaled(joint(root, export.joint.name), "range", degrees(1.0))


@fault("mjcf", r"its axis differs by (1\.\d+|2) ", "joint")
def mjcf_flipped_axis(export: Export) -> None:
    with export.xml("mjcf") as root:
        scaled(joint(root, export.joint.name), "axis", -1.0)


@fault("mjcf", r"its frame is off by 0\.0[\d]+ ", "link")
def mjcf_shifted_origin(export: Export) -> None:
    with export.xml("mjcf") as root:
        shifted(body(export, root), "pos", 0.01)


@fault("mjcf", r"its friction is 0 N.*\(frictionloss\), not [\d.]+ N", "rubbing")
def mjcf_no_friction(export: Export) -> None:
    with export.xml("mjcf") as root:
        del joint(root, export.rubbing.name).attrib["frictionloss"]


@fault("mjcf", r"its stiffness is 0 N.*\(stiffness\), not [\d.]+ N", "sprung")
def mjcf_no_spring(export: Export) -> None:
    with export.xml("mjcf") as root:
        del joint(root, export.sprung.name).attrib["stiffness"]


@fault("mjcf", r"its damping is 12\.5 N", "joint")
def mjcf_other_damping(export: Export) -> None:
    with export.xml("mjcf") as root:
        joint(root, export.joint.name).set("damping", "12.5")


@fault("mjcf", r"its effort is inf", "joint")
def mjcf_no_effort(export: Export) -> None:
    with export.xml("mjcf") as root:
        del joint(root, export.joint.name).attrib["actuatorfrcrange"]


def coupling(export: Export, root: Any) -> Any:
    for element in root.iterfind("equality/joint"):
        if element.get("joint1") == export.follower.name:
            return element
    raise Absent


@fault("mjcf", r"it follows another joint, but not in", "follower")
def mjcf_coupling_dropped(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = coupling(export, root)
        element.getparent().remove(element)


@fault("mjcf", r"it is -?[\d.]+ \* \w+ \+ .*, not -?[\d.]+ \* ", "follower")
def mjcf_coupling_of_wrong_sign(export: Export) -> None:
    with export.xml("mjcf") as root:
        scaled(coupling(export, root), "polycoef", -1.0)


@fault("mjcf", r"it cannot be read: ValueError: Error: unknown element 'nobody'", "")
def mjcf_coupling_of_no_joint(export: Export) -> None:
    with export.xml("mjcf") as root:
        coupling(export, root).set("joint2", "nobody")


@fault("mjcf", r"it has \d+ colliders in .*, not \d+, but also", "link")
def mjcf_visual_collides(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = geom(export, root, "_visual")
        element.set("contype", "1")
        element.set("conaffinity", "1")


@fault("mjcf", r"it has \d+ colliders in .*, not \d+, without", "link")
def mjcf_collider_does_not_collide(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = geom(export, root, "_collision")
        element.set("contype", "0")
        element.set("conaffinity", "0")


@fault("mjcf", r"it has \d+ colliders in .*, not \d+, without", "link")
def mjcf_collider_dropped(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = geom(export, root, "_collision")
        element.getparent().remove(element)


@fault("mjcf", r"its collider \w+ has friction 1\.75 in .*, not [\d.]+", "link")
def mjcf_slippery_collider(export: Export) -> None:
    with export.xml("mjcf") as root:
        geom(export, root, "_collision").set("friction", "1.75")


@fault("mjcf", r"excludes their contacts, which hides parts", "pair")
def mjcf_excluded_contact(export: Export) -> None:
    with export.xml("mjcf") as root:
        contact = etree.SubElement(root, "contact")
        etree.SubElement(contact, "exclude", body1=export.joint.parent, body2=export.link)


@fault("mjcf", r"the base is (free|fixed) in .*, not (free|fixed)", "base")
def mjcf_other_base(export: Export) -> None:
    with export.xml("mjcf") as root:
        base = root.find("worldbody/body")
        free = base.find("freejoint")
        if free is None:
            base.insert(0, base.makeelement("freejoint", {"name": "loose"}))
        else:
            base.remove(free)


@fault("mjcf", r"it cannot be read: ValueError: .*repeated name", "")
def mjcf_mesh_twice(export: Export) -> None:
    with export.xml("mjcf") as root:
        root.find("asset").append(deepcopy(root.find("asset/mesh")))


@fault("mjcf", r"it cannot be read: ValueError: .*repeated name", "joint")
def mjcf_joint_twice(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = joint(root, export.joint.name)
        element.addnext(deepcopy(element))


@fault("mjcf", r"has no such link with a mass", "link")
def mjcf_link_renamed(export: Export) -> None:
    with export.xml("mjcf") as root:
        body(export, root).set("name", "renamed")


@fault("mjcf", r"has no such joint that can move", "joint")
def mjcf_joint_removed(export: Export) -> None:
    with export.xml("mjcf") as root:
        element = joint(root, export.joint.name)
        element.getparent().remove(element)
        for custom in root.findall("custom"):
            root.remove(custom)  # what hands can do there names the joint
        for other in (*root.findall("equality"), *root.findall("keyframe")):
            root.remove(other)


@fault("mjcf", r"its visible faces .* are off by [\d.e+]+ mm", "link")
def mjcf_mesh_in_millimetres(export: Export) -> None:
    with export.xml("mjcf") as root:
        name = geom(export, root, "_visual").get("mesh")
        named(root, "asset/mesh", name).set("scale", "0.001 0.001 0.001")


@fault("mjcf", r"sets gravity to 0 0 0", "")
def mjcf_without_gravity(export: Export) -> None:
    with export.xml("mjcf") as root:
        root.insert(0, root.makeelement("option", {"gravity": "0 0 0"}))


@fault("mjcf", r"compensates the share 1 of its weight", "link")
def mjcf_weightless(export: Export) -> None:
    with export.xml("mjcf") as root:
        body(export, root).set("gravcomp", "1")


@fault("mjcf", r"it cannot be read: ValueError: .*unobtainium", "")
def mjcf_unknown_material(export: Export) -> None:
    with export.xml("mjcf") as root:
        geom(export, root, "_visual").set("material", "unobtainium")


@fault("mjcf", r"its grasp '\w+' is off by 0\.02 ", "held")
def mjcf_grasp_elsewhere(export: Export) -> None:
    with export.xml("mjcf") as root:
        for grasp in export.asset.affordances:
            if grasp.kind == "grasp":
                shifted(named(root, "worldbody//site", grasp.name), "pos", 0.02)
                return
        raise Absent


@fault("mjcf", r"it cannot be read: XMLSyntaxError", "")
def mjcf_truncated(export: Export) -> None:
    export.cut(export.files["mjcf"])


@fault("files", r"\.xml is not UTF-8 text: byte \d+ is 0xfc", "")
def mjcf_in_latin_letters(export: Export) -> None:
    path = export.files["mjcf"]
    path.write_bytes(path.read_bytes().replace(b"<worldbody>", b"<!-- T\xfcr --><worldbody>", 1))
