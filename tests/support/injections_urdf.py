"""Faults of a URDF; see `support.injections`."""

from copy import deepcopy
from math import degrees
from typing import Any

from support.injections import Absent, Export, fault, named, scaled, shifted


def inertia(export: Export, root: Any) -> Any:
    return named(root, "link", export.link).find("inertial/inertia")


@fault("urdf", r"^line \d+: <color rgba> is 'nan 0 0 1', which is not a finite number", "")
def urdf_color_that_is_no_number(export: Export) -> None:
    with export.xml("urdf") as root:
        next(root.iter("color")).set("rgba", "nan 0 0 1")


@fault("urdf", r"line \d+: <limit effort> is '1e999', which is not a finite number", "joint")
def urdf_infinite_effort(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.joint.name).find("limit").set("effort", "1e999")


@fault("urdf", r"its inertia differs by 100 % .* not all positive", "link")
def urdf_zero_inertia(export: Export) -> None:
    with export.xml("urdf") as root:
        for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"):
            inertia(export, root).set(key, "0")


@fault("urdf", r"its inertia differs by .* % .* violate the triangle inequality", "link")
def urdf_inertia_of_no_body(export: Export) -> None:
    with export.xml("urdf") as root:
        element = inertia(export, root)
        element.set("ixx", str(3.0 * (float(element.get("iyy")) + float(element.get("izz")))))


@fault("urdf", r"its mass is 123\.5 kg in", "link")
def urdf_other_mass(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "link", export.link).find("inertial/mass").set("value", "123.5")


@fault("urdf", r"its center of mass is 10 mm away", "link")
def urdf_other_center(export: Export) -> None:
    with export.xml("urdf") as root:
        shifted(named(root, "link", export.link).find("inertial/origin"), "xyz", 0.01)


@fault("urdf", r"its limits are inverted or empty: from [\d.]+ to", "joint")
def urdf_inverted_limits(export: Export) -> None:
    with export.xml("urdf") as root:
        limit = named(root, "joint", export.joint.name).find("limit")
        low, high = limit.get("lower"), limit.get("upper")
        limit.set("lower", high)
        limit.set("upper", low)


@fault("urdf", r"its limits are -?[\d.]+ to [\d.]+ rad in .*, not", "joint")
def urdf_degrees(export: Export) -> None:
    with export.xml("urdf") as root:
        for key in ("lower", "upper"):
            scaled(named(root, "joint", export.joint.name).find("limit"), key, degrees(1.0))


@fault("urdf", r"its axis differs by (1\.\d+|2)", "joint")
def urdf_flipped_axis(export: Export) -> None:
    with export.xml("urdf") as root:
        scaled(named(root, "joint", export.joint.name).find("axis"), "xyz", -1.0)


@fault("urdf", r"its axis differs by", "joint")
def urdf_wrong_axis(export: Export) -> None:
    with export.xml("urdf") as root:
        axis = named(root, "joint", export.joint.name).find("axis")
        x, y, z = axis.get("xyz").split()
        axis.set("xyz", f"{y} {z} {x}")


@fault("urdf", r"its frame is off by 0\.0[\d]+ ", "link")
def urdf_shifted_origin(export: Export) -> None:
    with export.xml("urdf") as root:
        shifted(named(root, "joint", export.joint.name).find("origin"), "xyz", 0.01)


@fault("urdf", r"its effort limit is 0", "joint")
def urdf_no_effort(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.joint.name).find("limit").set("effort", "0")


@fault("urdf", r"its velocity limit is 0", "joint")
def urdf_no_velocity(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.joint.name).find("limit").set("velocity", "0")


@fault("urdf", r"does not state its friction, which is [\d.]+ N", "rubbing")
def urdf_no_friction(export: Export) -> None:
    with export.xml("urdf") as root:
        joint = named(root, "joint", export.rubbing.name)
        joint.remove(joint.find("dynamics"))


@fault("urdf", r"does not state its stiffness, which is [\d.]+ N", "sprung")
def urdf_no_spring(export: Export) -> None:
    with export.xml("urdf") as root:
        for spring in root.findall("gazebo"):
            if spring.get("reference") == export.sprung.name:
                root.remove(spring)


@fault("urdf", r"its damping is 12\.5 N", "joint")
def urdf_other_damping(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.joint.name).find("dynamics").set("damping", "12.5")


@fault("urdf", r"it follows another joint, but not in", "follower")
def urdf_coupling_dropped(export: Export) -> None:
    with export.xml("urdf") as root:
        joint = named(root, "joint", export.follower.name)
        joint.remove(joint.find("mimic"))


@fault("urdf", r"it is -?[\d.]+ \* \w+ \+ .*, not -?[\d.]+ \* ", "follower")
def urdf_coupling_of_wrong_sign(export: Export) -> None:
    with export.xml("urdf") as root:
        scaled(named(root, "joint", export.follower.name).find("mimic"), "multiplier", -1.0)


@fault("urdf", r"its mimic 'nobody' is not a joint of the file", "follower")
def urdf_mimic_of_no_joint(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.follower.name).find("mimic").set("joint", "nobody")


@fault("urdf", r"2 joints are named", "joint")
def urdf_joint_twice(export: Export) -> None:
    with export.xml("urdf") as root:
        root.append(deepcopy(named(root, "joint", export.joint.name)))


@fault("urdf", r"2 links are named", "link")
def urdf_link_twice(export: Export) -> None:
    with export.xml("urdf") as root:
        root.append(deepcopy(named(root, "link", export.link)))


@fault("urdf", r"2 collisions are named", "")
def urdf_collider_twice(export: Export) -> None:
    with export.xml("urdf") as root:
        link = named(root, "link", export.link)
        link.append(deepcopy(link.find("collision")))


@fault("urdf", r"its child '\w+' is not a link of the file", "joint")
def urdf_link_removed(export: Export) -> None:
    with export.xml("urdf") as root:
        root.remove(named(root, "link", export.link))


@fault("urdf", r"has no such joint that can move", "joint")
def urdf_joint_removed(export: Export) -> None:
    with export.xml("urdf") as root:
        root.remove(named(root, "joint", export.joint.name))


@fault("urdf", r"has no such joint that can move", "joint")
def urdf_joint_fixed(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "joint", export.joint.name).set("type", "fixed")


@fault("urdf", r"bodies that are not links of the asset weigh 5 kg", "")
def urdf_heavy_stranger(export: Export) -> None:
    with export.xml("urdf") as root:
        link = deepcopy(named(root, "link", export.link))
        for element in link.findall("visual") + link.findall("collision"):
            link.remove(element)
        link.set("name", "stranger")
        link.find("inertial/mass").set("value", "5")
        root.append(link)
        mount = deepcopy(named(root, "joint", export.joint.name))
        mount.set("name", "strange_mount")
        mount.set("type", "fixed")
        mount.find("child").set("link", "stranger")
        root.append(mount)


@fault("urdf", r"its visible faces .* are off by [\d.e+]+ mm", "link")
def urdf_visual_in_millimetres(export: Export) -> None:
    with export.xml("urdf") as root:
        named(root, "link", export.link).find("visual/geometry/mesh").set("scale", "0.001 0.001 0.001")


@fault("urdf", r"its visible faces .* are off by 20 mm", "link")
def urdf_visual_shifted(export: Export) -> None:
    with export.xml("urdf") as root:
        shifted(named(root, "link", export.link).find("visual/origin"), "xyz", 0.02)


@fault("urdf", r"it has \d+ meshes of visible faces in .*, not \d+", "link")
def urdf_visual_dropped(export: Export) -> None:
    with export.xml("urdf") as root:
        link = named(root, "link", export.link)
        link.remove(link.find("visual"))


@fault("urdf", r"it has \d+ colliders in .*, not \d+, without \d+ \(", "link")
def urdf_collider_dropped(export: Export) -> None:
    with export.xml("urdf") as root:
        link = named(root, "link", export.link)
        link.remove(link.find("collision"))


@fault("urdf", r"its collider \w+ is off by 30 mm", "link")
def urdf_collider_shifted(export: Export) -> None:
    with export.xml("urdf") as root:
        shifted(named(root, "link", export.link).find("collision/origin"), "xyz", 0.03)


@fault("urdf", r"its material 'unobtainium' is not defined in the file", "")
def urdf_unknown_material(export: Export) -> None:
    with export.xml("urdf") as root:
        for material in root.iterfind("link/visual/material"):
            material.set("name", "unobtainium")
            return
        raise Absent


@fault("urdf", r"its grasp '\w+' is off by 0\.02 ", "held")
def urdf_grasp_elsewhere(export: Export) -> None:
    with export.xml("urdf") as root:
        for joint in root.iterfind("joint"):
            if joint.find("child").get("link").startswith("grasp_"):
                shifted(joint.find("origin"), "xyz", 0.02)
                return
        raise Absent


@fault("files", r"\.urdf is not UTF-8 text: byte \d+ is 0xfc", "")
def urdf_in_latin_letters(export: Export) -> None:
    path = export.files["urdf"]
    path.write_bytes(path.read_bytes().replace(b"<link ", b"<!-- T\xfcr --><link ", 1))


@fault("urdf", r"it cannot be read: XMLSyntaxError", "")
def urdf_truncated(export: Export) -> None:
    export.cut(export.files["urdf"])


@fault("files", r"\.urdf is empty, which urdf needs", "")
def urdf_empty(export: Export) -> None:
    export.files["urdf"].write_bytes(b"")
