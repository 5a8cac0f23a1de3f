"""Faults of a USD; see `support.injections`."""

from math import radians
from typing import Any

from pxr import Gf, Sdf

from support.injections import Absent, Export, fault


def author(prim: Any, name: str, kind: Any, value: Any) -> None:
    """Give an attribute a value, whether it is there or not."""
    attribute = prim.attributes.get(name) or Sdf.AttributeSpec(prim, name, kind)
    attribute.default = value


def apply(prim: Any, schema: str) -> None:
    known = prim.GetInfo("apiSchemas").prependedItems
    prim.SetInfo("apiSchemas", Sdf.TokenListOp.Create(prependedItems=[*known, schema]))


def unapply(prim: Any, schema: str) -> None:
    known = prim.GetInfo("apiSchemas").prependedItems
    prim.SetInfo(
        "apiSchemas", Sdf.TokenListOp.Create(prependedItems=[each for each in known if each != schema])
    )


def drop(prim: Any, name: str) -> None:
    if name not in prim.properties:
        raise Absent
    prim.RemoveProperty(prim.properties[name])


def turned(prim: Any, name: str, angle: float) -> None:
    """Turn a quaternion about z."""
    turn = Gf.Rotation(Gf.Vec3d(0, 0, 1), angle).GetQuat()
    prim.attributes[name].default = Gf.Quatf(Gf.Quatd(prim.attributes[name].default) * turn)


def collider(export: Export, layer: Any) -> Any:
    """Return the first collider of the link in the text layer, or of any other."""
    for link in (export.link, *(link.name for link in export.asset.links)):
        scope = export.prim(layer, link).nameChildren.get("collisions")
        if scope is not None and len(scope.nameChildren):
            return scope.nameChildren[0]
    raise Absent


def hull(export: Export, layer: Any) -> Any:
    """Return the first hull in the layer of the meshes."""
    found: list[Any] = []

    def look(path: Any) -> None:
        spec = layer.GetPrimAtPath(path) if path.IsPrimPath() else None
        if spec is not None and "physics:approximation" in spec.properties:
            found.append(spec)

    layer.Traverse("/", look)
    if not found:
        raise Absent
    return min(found, key=lambda spec: str(spec.path))


@fault("usd", r"its mass is 123\.5 kg in", "link")
def usd_other_mass(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.link).attributes["physics:mass"].default = 123.5


@fault("usd", r"its center of mass is 10 mm away", "link")
def usd_other_center(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.link).attributes["physics:centerOfMass"].default += Gf.Vec3f(0.01, 0, 0)


@fault("usd", r"its inertia differs by .* not all positive", "link")
def usd_zero_inertia(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.link).attributes["physics:diagonalInertia"].default = Gf.Vec3f(0.0)


@fault("usd", r"its inertia differs by .* violate the triangle inequality", "link")
def usd_inertia_of_no_body(export: Export) -> None:
    with export.layer() as layer:
        attribute = export.prim(layer, export.link).attributes["physics:diagonalInertia"]
        x, y, z = attribute.default
        attribute.default = Gf.Vec3f(x, y, 3.0 * (x + y + z))


@fault("usd", r"its limits are inverted: from [\d.]+ to", "joint")
def usd_inverted_limits(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, export.joint.name)
        low, high = (joint.attributes[f"physics:{end}Limit"] for end in ("lower", "upper"))
        low.default, high.default = high.default, low.default


@fault("usd", r"its limits are -?[\d.e-]+ to 0\.0[\d.]+ rad in .*, not", "joint")
def usd_radians(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, export.joint.name)
        for end in ("lower", "upper"):
            joint.attributes[f"physics:{end}Limit"].default = radians(
                joint.attributes[f"physics:{end}Limit"].default
            )


@fault("usd", r"its axis differs by", "joint")
def usd_wrong_axis(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.joint.name).attributes["physics:axis"].default = "Y"


@fault("usd", r"its axis differs by (1\.\d+|2) ", "joint")
def usd_flipped_axis(export: Export) -> None:
    with export.layer() as layer:
        for number in (0, 1):
            turned(export.prim(layer, export.joint.name), f"physics:localRot{number}", 180.0)


@fault("usd", r"its frame is off by 0\.0[\d]+ ", "link")
def usd_shifted_pivot(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.joint.name).attributes["physics:localPos0"].default += Gf.Vec3f(0.01, 0, 0)


@fault("usd", r"its frame is off by", "link")
def usd_frames_that_disagree_in_place(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.joint.name).attributes["physics:localPos1"].default = Gf.Vec3f(0, 0.02, 0)


@fault("usd", r"its frame is off by", "link")
def usd_frames_that_disagree_in_turn(export: Export) -> None:
    with export.layer() as layer:
        turned(export.prim(layer, export.joint.name), "physics:localRot1", 5.0)


@fault("usd", r"its body stands 0\.05 .* wherever its joints lead", "link")
def usd_body_elsewhere(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.link).attributes["xformOp:translate"].default += Gf.Vec3d(0.05, 0, 0)


@fault("usd", r"it has 0 articulation roots", "base")
def usd_no_articulation_root(export: Export) -> None:
    with export.layer() as layer:
        for prim in (export.prim(layer, export.asset.name), export.prim(layer, export.base)):
            unapply(prim, "PhysicsArticulationRootAPI")


@fault("usd", r"it has 2 articulation roots", "base")
def usd_two_articulation_roots(export: Export) -> None:
    with export.layer() as layer:
        apply(export.prim(layer, export.link), "PhysicsArticulationRootAPI")


@fault("usd", r"it is a rigid body within the rigid body", "")
def usd_nested_bodies(export: Export) -> None:
    with export.layer() as layer:
        visuals = export.prim(layer, export.link).nameChildren["visuals"]
        visuals.typeName = "Xform"
        apply(visuals, "PhysicsRigidBodyAPI")


@fault("usd", r"its rigid body is scaled by 1\.1, 1\.1, 1\.1", "link")
def usd_scaled_body(export: Export) -> None:
    with export.layer() as layer:
        prim = export.prim(layer, export.link)
        author(prim, "xformOp:scale", Sdf.ValueTypeNames.Double3, Gf.Vec3d(1.1))
        prim.attributes["xformOpOrder"].default = ["xformOp:translate", "xformOp:orient", "xformOp:scale"]


@fault("usd", r"metersPerUnit is 0\.01, not 1", "")
def usd_in_centimetres(export: Export) -> None:
    export.rewrite(export.files["usd"], "metersPerUnit = 1\n", "metersPerUnit = 0.01\n")


@fault("usd", r"metersPerUnit is missing, not 1", "")
def usd_without_metres(export: Export) -> None:
    export.rewrite(export.files["usd"], "    metersPerUnit = 1\n", "")


@fault("usd", r"kilogramsPerUnit is missing, not 1", "")
def usd_without_kilograms(export: Export) -> None:
    export.rewrite(export.files["usd"], "    kilogramsPerUnit = 1\n", "")


@fault("usd", r"upAxis is missing, not Z", "")
def usd_without_up(export: Export) -> None:
    export.rewrite(export.files["usd"], '    upAxis = "Z"\n', "")


@fault("usd", r"it joins '\w+' to '\w+' in .*, not '\w+' to", "joint")
def usd_bodies_swapped(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, export.joint.name)
        paths = [joint.relationships[f"physics:body{end}"].targetPathList for end in (0, 1)]
        first, second = (list(each.explicitItems) for each in paths)
        paths[0].explicitItems, paths[1].explicitItems = second, first


@fault("usd", r"does not state its damping, which is [\d.]+ N", "joint")
def usd_no_drive(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, damped(export))
        for name in [each.name for each in joint.properties if each.name.startswith("drive:")]:
            drop(joint, name)
        unapply(joint, "PhysicsDriveAPI:angular")


def damped(export: Export) -> str:
    if not export.joint.damping:
        raise Absent
    return export.joint.name


@fault("usd", r"its damping is [\d.]+ N m s/rad in .* \(drive:angular:physics:damping\), not", "joint")
def usd_drive_per_radian(export: Export) -> None:
    with export.layer() as layer:
        prim = export.prim(layer, damped(export))
        for name in ("stiffness", "damping"):
            attribute = prim.attributes[f"drive:angular:physics:{name}"]
            attribute.default = attribute.default / radians(1.0)


@fault("usd", r"its friction is 0 N.*\(newton:friction\), not", "rubbing")
def usd_no_friction_for_newton(export: Export) -> None:
    with export.layer() as layer:
        drop(export.prim(layer, export.rubbing.name), "newton:friction")


@fault("usd", r"its friction is 9 N.*physxJointAxis:\w+:staticFrictionEffort\), not", "rubbing")
def usd_other_friction_for_physx(export: Export) -> None:
    kind = "angular" if export.rubbing.kind == "revolute" else "linear"
    with export.layer() as layer:
        prim = export.prim(layer, export.rubbing.name)
        prim.attributes[f"physxJointAxis:{kind}:staticFrictionEffort"].default = 9.0


@fault("usd", r"it follows another joint, but not in", "follower")
def usd_coupling_dropped(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, export.follower.name)
        name = "newton:mimicJoint" if "newton:mimicJoint" in joint.properties else "mjc:target"
        drop(joint, name)


@fault("usd", r"it is -?[\d.]+ \* \w+ \+ .*, not -?[\d.]+ \* ", "follower")
def usd_coupling_of_wrong_sign(export: Export) -> None:
    with export.layer() as layer:
        joint = export.prim(layer, export.follower.name)
        name = "newton:mimicCoef1" if "newton:mimicCoef1" in joint.properties else "mjc:coef1"
        joint.attributes[name].default = -joint.attributes[name].default


@fault("usd", r"it is -?[\d.]+ \* \w+ \+ .*\(for PhysX\), not -?[\d.]+ \* ", "follower")
def usd_coupling_of_wrong_sign_for_physx(export: Export) -> None:
    with export.layer() as layer:
        attribute = export.prim(layer, export.follower.name).attributes["physxMimicJoint:rotX:gearing"]
        attribute.default = -attribute.default


@fault("usd", r"its collider \w+ has the approximation 'none', not 'convexHull'", "")
def usd_no_approximation(export: Export) -> None:
    with export.layer(".usdc") as layer:
        drop(hull(export, layer), "physics:approximation")


@fault("usd", r"its collider \w+ has the approximation 'meshSimplification', not 'convexHull'", "")
def usd_simplified_colliders(export: Export) -> None:
    with export.layer(".usdc") as layer:
        hull(export, layer).attributes["physics:approximation"].default = "meshSimplification"


@fault("usd", r"is bound to the material \S+nowhere, which does not exist", "")
def usd_material_nowhere(export: Export) -> None:
    with export.layer(".usdc") as layer:
        relation = hull(export, layer).relationships["material:binding:physics"]
        relation.targetPathList.explicitItems = [Sdf.Path(f"/{export.asset.name}/looks/nowhere")]


@fault("usd", r"its collider \w+ is disabled", "")
def usd_collider_disabled(export: Export) -> None:
    with export.layer() as layer:
        author(collider(export, layer), "physics:collisionEnabled", Sdf.ValueTypeNames.Bool, value=False)


@fault("usd", r"it has \d+ colliders in .*, not \d+, without", "")
def usd_collider_dropped(export: Export) -> None:
    with export.layer() as layer:
        collider(export, layer).active = False


@fault("usd", r"the base is (free|fixed) in .*, not (free|fixed)", "base")
def usd_other_base(export: Export) -> None:
    with export.layer() as layer:
        if export.asset.base == "fixed":
            prim = export.prim(layer, "root_joint")
            del prim.nameParent.nameChildren["root_joint"]
            return
        scope = export.prim(layer, export.joint.name).nameParent
        joint = Sdf.PrimSpec(scope, "root_joint", Sdf.SpecifierDef, "PhysicsFixedJoint")
        base = Sdf.RelationshipSpec(joint, "physics:body1", custom=False)
        base.targetPathList.explicitItems = [export.prim(layer, export.base).path]


@fault("usd", r"has no such link with a mass", "link")
def usd_link_removed(export: Export) -> None:
    with export.layer() as layer:
        export.prim(layer, export.link).active = False


@fault("usd", r"has no such joint that can move", "joint")
def usd_joint_removed(export: Export) -> None:
    with export.layer() as layer:
        prim = export.prim(layer, export.joint.name)
        del prim.nameParent.nameChildren[prim.name]


@fault("usd", r"its visible faces \w+ are off by [\d.e+]+ mm", "link")
def usd_visuals_in_millimetres(export: Export) -> None:
    with export.layer() as layer:
        visuals = export.prim(layer, export.link).nameChildren["visuals"]
        visuals.typeName = "Xform"
        author(visuals, "xformOp:scale", Sdf.ValueTypeNames.Double3, Gf.Vec3d(0.001))
        author(visuals, "xformOpOrder", Sdf.ValueTypeNames.TokenArray, ["xformOp:scale"])


@fault("usd", r"filters contacts, which hides parts", "link")
def usd_filtered_pair(export: Export) -> None:
    with export.layer() as layer:
        prim = export.prim(layer, export.link)
        apply(prim, "PhysicsFilteredPairsAPI")
        pairs = Sdf.RelationshipSpec(prim, "physics:filteredPairs", custom=False)
        pairs.targetPathList.explicitItems = [export.prim(layer, export.joint.parent).path]


@fault("usd", r"its collider \w+ has friction 1\.75 in .*, not [\d.]+", "")
def usd_slippery_material(export: Export) -> None:
    with export.layer() as layer:
        looks = export.prim(layer, export.asset.name).nameChildren["looks"]
        name = export.asset.link(export.link).colliders[0].material.name
        looks.nameChildren[name].attributes["physics:dynamicFriction"].default = 1.75


@fault("usd", r"its grasp '\w+' is off by 0\.02 ", "held")
def usd_grasp_elsewhere(export: Export) -> None:
    with export.layer() as layer:
        for grasp in export.asset.affordances:
            if grasp.kind == "grasp":
                export.prim(layer, grasp.name).attributes["xformOp:translate"].default += Gf.Vec3d(0.02, 0, 0)
                return
    raise Absent


@fault("usd", r"it cannot be read: ", "")
def usd_truncated(export: Export) -> None:
    export.cut(export.files["usd"])


@fault("usd", r"(it cannot be read|its reader complains): ", "")
def usd_meshes_truncated(export: Export) -> None:
    export.cut(next(export.directory.glob("*.usdc")))


@fault("files", r"\.usda is not UTF-8 text: byte \d+ is 0xfc", "")
def usd_in_latin_letters(export: Export) -> None:
    path = export.files["usd"]
    path.write_bytes(path.read_bytes().replace(b"\n)\n", b"\n) # T\xfcr\n", 1))
