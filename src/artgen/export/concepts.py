"""How each concept of an asset is written in each format: the source of docs/concept_mapping.md.

The tests hold this table against the writers: every word in backticks stands in a file that the format wrote,
and every loss that a writer reports stands in its column.
"""

from collections.abc import Mapping
from dataclasses import dataclass

FORMAT_TITLES: Mapping[str, str] = {"urdf": "URDF", "mjcf": "MJCF", "usd": "USD", "glb": "GLB"}
"""Title of the column of each format."""


@dataclass(frozen=True)
class Cell:
    """How one format says a concept.

    Attributes:
        text: The words of the format in backticks, with their unit where it differs from the asset's.
        losses: Features under which the writer reports what it cannot say; none if it says all.
    """

    text: str
    losses: tuple[str, ...] = ()


@dataclass(frozen=True)
class Concept:
    """One thing that an asset is or has.

    Attributes:
        name: What it is called.
        unit: Its unit in artgen; empty if it has none.
        field: Where it stands in asset.json; `[]` stands for each item of a list.
        cells: How each format says it, by the name of the format.
    """

    name: str
    unit: str
    field: str
    cells: Mapping[str, Cell]


def _row(name: str, unit: str, field: str, **cells: str | tuple[str, ...]) -> Concept:
    """Make a concept; a cell is its text, or its text and the losses that belong to it."""
    found = {
        key: Cell(value) if isinstance(value, str) else Cell(value[0], value[1:])
        for key, value in cells.items()
    }
    return Concept(name, unit, field, found)


_IN_JSON = "not said; asset.json has it"

CONCEPTS: tuple[Concept, ...] = (
    _row(
        "units and axes",
        "m, kg, rad, s; z up, front to -y",
        "",
        urdf="the same, fixed by the format",
        mjcf='`angle="radian"`',
        usd='`metersPerUnit = 1`, `kilogramsPerUnit = 1`, `upAxis = "Z"`; angles in degrees',
        glb='metres, y up: the root node has a `"rotation"`',
    ),
    _row(
        "name",
        "",
        "name",
        urdf="`<robot name=`",
        mjcf="`<mujoco model=`",
        usd="`defaultPrim`",
        glb="root node",
    ),
    _row(
        "category, seed, version",
        "",
        "category, seed, version",
        urdf=_IN_JSON,
        mjcf=_IN_JSON,
        usd="`customData` and `semantics:labels:category` of the default prim, with Wikidata's code in "
        "`semantics:labels:wikidata_qcode`",
        glb='`"extras"` of the root node',
    ),
    _row(
        "parameters",
        "",
        "parameters",
        urdf=_IN_JSON,
        mjcf=_IN_JSON,
        usd="`dictionary parameters` in `customData`",
        glb=_IN_JSON,
    ),
    _row(
        "base: fixed or free",
        "",
        "base",
        urdf="not said: each client is told when it loads the file",
        mjcf="no joint, or a `freejoint`",
        usd="`root_joint` from the world, or none",
        glb='`"base"` in `"extras"`',
    ),
    _row(
        "link",
        "",
        "links[].name",
        urdf="`<link name=`",
        mjcf="`<body name=`",
        usd="`Xform` with `PhysicsRigidBodyAPI`",
        glb='`"nodes"`',
    ),
    _row(
        "mass",
        "kg",
        "links[].mass",
        urdf="`<mass value=`",
        mjcf="`mass=` of `<inertial`",
        usd="`physics:mass`",
        glb=(_IN_JSON, "mass and inertia"),
    ),
    _row(
        "centre of mass",
        "m, in the link's frame",
        "links[].center",
        urdf="`<origin` of the `<inertial>`",
        mjcf="`pos=` of `<inertial`",
        usd="`physics:centerOfMass`",
        glb=(_IN_JSON, "mass and inertia"),
    ),
    _row(
        "inertia about it",
        "kg m^2",
        "links[].inertia",
        urdf="`ixx=` to `izz=`",
        mjcf="`fullinertia=`",
        usd="`physics:diagonalInertia`, `physics:principalAxes`",
        glb=(_IN_JSON, "mass and inertia"),
    ),
    _row(
        "visible surface",
        "m",
        "links[].surfaces",
        urdf="`<visual name=` with an OBJ file",
        mjcf='`class="cabinet_7_visual"` with an OBJ file',
        usd="a `Mesh` in `visuals`",
        glb='one of the `"primitives"` of the mesh of its node',
    ),
    _row(
        "collider",
        "m",
        "links[].colliders",
        urdf="`<collision name=`; a capsule is a cylinder between two balls",
        mjcf='`class="cabinet_7_collision"`',
        usd="`collisions` with `PhysicsCollisionAPI`; hulls are meshes with `convexHull`",
        glb=(_IN_JSON, "colliders"),
    ),
    _row(
        "friction of contacts",
        "1",
        "materials[].friction",
        urdf=("not said: clients take their own default", "contact friction"),
        mjcf="`friction=` of each collider",
        usd="`physics:dynamicFriction`, `physics:staticFriction`",
        glb=(_IN_JSON, "colliders"),
    ),
    _row(
        "contact by design",
        "m",
        "contacts",
        urdf=("not said: simulators push the parts apart", "contact by design"),
        mjcf=("not said: MuJoCo pushes the parts apart", "contact by design"),
        usd=("not said: simulators push the parts apart", "contact by design"),
        glb=_IN_JSON,
    ),
    _row(
        "joint that turns",
        "rad",
        "joints[].kind",
        urdf='`type="revolute"`, or `type="continuous"` without limits',
        mjcf='`type="hinge"`',
        usd="`PhysicsRevoluteJoint`, degrees",
        glb=('`"joints"` in `"extras"`, `"animations"`', "joints", "animation"),
    ),
    _row(
        "joint that slides",
        "m",
        "joints[].kind",
        urdf=('`type="prismatic"`; limits of 1000 m where there are none', "unlimited slide"),
        mjcf='`type="slide"`',
        usd="`PhysicsPrismaticJoint`",
        glb=('`"joints"` in `"extras"`, `"animations"`', "joints", "animation"),
    ),
    _row(
        "locked joint",
        "",
        "joints[].limits",
        urdf='`type="fixed"`',
        mjcf=("no joint: the body stands where it is locked", "locked joint"),
        usd="`PhysicsFixedJoint`",
        glb='`"type":"fixed"`',
    ),
    _row(
        "axis",
        "1",
        "joints[].axis",
        urdf="`<axis xyz=`",
        mjcf="`axis=`",
        usd="x of `physics:localRot0` and `physics:localRot1`",
        glb='`"axis"`',
    ),
    _row(
        "pivot",
        "m",
        "joints[].pivot",
        urdf="`<origin xyz=` of the joint",
        mjcf="the body's `pos=`, or the joint's",
        usd="`physics:localPos0`; `physics:localPos1` is 0",
        glb='`"origin"`',
    ),
    _row(
        "limits",
        "rad or m",
        "joints[].limits",
        urdf="`lower=`, `upper=`",
        mjcf="`range=`",
        usd=("`physics:lowerLimit`, `physics:upperLimit`, degrees or m", "coupling without limits"),
        glb='`"lower"`, `"upper"`',
    ),
    _row(
        "where it stands",
        "rad or m",
        "joints[].limits",
        urdf="not said: clients begin at 0, or at the limit next to it",
        mjcf="`ref=` where it is not 0",
        usd=("bodies placed so, and `state:linear:physics:position`", "joint that does not stand at 0"),
        glb='`"position"`',
    ),
    _row(
        "spring and its rest",
        "N m/rad or N/m",
        "joints[].stiffness, .rest",
        urdf=("`springStiffness`, `springReference` of Gazebo", "joint spring"),
        mjcf="`stiffness=`, `springref=`",
        usd="`drive:angular:physics:stiffness` per degree, `drive:angular:physics:targetPosition`",
        glb=(_IN_JSON, "joint dynamics"),
    ),
    _row(
        "damping",
        "N m s/rad or N s/m",
        "joints[].damping",
        urdf="`damping=`",
        mjcf="`damping=`",
        usd="`drive:angular:physics:damping` per degree",
        glb=(_IN_JSON, "joint dynamics"),
    ),
    _row(
        "dry friction",
        "N m or N",
        "joints[].friction",
        urdf="`friction=`",
        mjcf="`frictionloss=`",
        usd=(
            "`physxJointAxis:angular:staticFrictionEffort`, `newton:friction`, `mjc:frictionloss`",
            "joint friction",
        ),
        glb=(_IN_JSON, "joint dynamics"),
    ),
    _row(
        "armature",
        "kg m^2 or kg",
        "joints[].armature",
        urdf=("not said", "joint armature"),
        mjcf="`armature=`",
        usd=("`physxJointAxis:angular:armature`, `newton:armature`, `mjc:armature`", "joint armature"),
        glb=(_IN_JSON, "joint dynamics"),
    ),
    _row(
        "largest effort",
        "N m or N",
        "joints[].effort",
        urdf="`effort=`",
        mjcf="`actuatorfrcrange=`",
        usd=(
            "`drive:angular:physics:maxForce` unless it would weaken the spring; `mjc:actuatorfrcrange:max`",
            "joint effort",
        ),
        glb=_IN_JSON,
    ),
    _row(
        "largest speed",
        "rad/s or m/s",
        "joints[].velocity",
        urdf="`velocity=`",
        mjcf=("not said", "joint velocity limit"),
        usd=(
            "`physxJointAxis:angular:maxJointVelocity`, `newton:velocityLimit`, degrees/s or m/s",
            "joint velocity limit",
        ),
        glb=_IN_JSON,
    ),
    _row(
        "numbers of one simulator",
        "",
        "",
        urdf="none",
        mjcf="`solref=`, `solimp=`, `solreflimit=`, `solimpfriction=`",
        usd="`mjc:solref` and the like, as in MJCF; `physxArticulation:solverPositionIterationCount`, "
        "`physxRigidBody:angularDamping`; `newton:selfCollisionEnabled`",
        glb="none",
    ),
    _row(
        "coupling",
        "rad or m",
        "joints[].follows",
        urdf="`<mimic`",
        mjcf="`<equality>` with `polycoef=`",
        usd=(
            "`physxMimicJoint:rotX:gearing`, and `newton:mimicCoef1` or, between a rotation and a slide, "
            "`mjc:coef1`",
            "joint coupling",
        ),
        glb='`"mimic"`',
    ),
    _row(
        "dependency",
        "rad or m",
        "joints[].needs",
        urdf=("not said: contact has to hold the part", "joint dependency"),
        mjcf=("not said: contact has to hold the part", "joint dependency"),
        usd=("not said: contact has to hold the part", "joint dependency"),
        glb='`"needs"`; what it needs moves first in animations',
    ),
    _row(
        "several joints between two links",
        "",
        "joints",
        urdf=("a link of 1e-6 kg after each but the last", "several joints between two links"),
        mjcf="several joints of one body",
        usd=("a body of 1e-6 kg after each but the last", "several joints between two links"),
        glb="a node after each but the last",
    ),
    _row(
        "grasp: frame",
        "m; z approaches, x closes",
        "affordances[].frame",
        urdf=("a link `grasp_lid_edge` of 1e-9 kg, fixed there", "grasp frame"),
        mjcf="`<site name=`",
        usd='an `Xform` in `grasps` with `kind = "grasp"`, and a line `grasp_identifier_lid_edge`',
        glb=(_IN_JSON, "grasp frame"),
    ),
    _row(
        "push: frame",
        "m; z is the way of the push",
        "affordances[].frame",
        urdf=("a link `push_knob_face` of 1e-9 kg, fixed there", "push frame"),
        mjcf="`<site name=`",
        usd='an `Xform` in `grasps` with `kind = "push"`',
        glb=(_IN_JSON, "push frame"),
    ),
    _row(
        "width and joints of a grasp",
        "m",
        "affordances[].width, .joints",
        urdf=("not said", "grasp frame", "push frame"),
        mjcf="`<tuple name=` in `<custom>`",
        usd="`customData` of its prim",
        glb=(_IN_JSON, "grasp frame", "push frame"),
    ),
    _row(
        "semantic labels",
        "",
        "links[].labels",
        urdf=("not said", "semantic labels"),
        mjcf='`<text name="body_labels"`',
        usd="`semantics:labels:part`",
        glb='`"labels"` in `"extras"` of its node',
    ),
    _row(
        "base colour",
        "linear RGB",
        "materials[].base_color",
        urdf=("`<color rgba=` in sRGB; `Kd` in the MTL file", "colour beside a colour map"),
        mjcf="`rgba=` in sRGB",
        usd="`inputs:diffuseColor`, linear",
        glb='`"baseColorFactor"`, linear',
    ),
    _row(
        "roughness, metalness",
        "1",
        "materials[].specular_roughness, .base_metalness",
        urdf=("`Pr` and `Pm` in the MTL file", "surface roughness, metalness and coat"),
        mjcf="`roughness=`, `metallic=`",
        usd="`inputs:roughness`, `inputs:metallic`",
        glb='`"roughnessFactor"`, `"metallicFactor"`',
    ),
    _row(
        "coat",
        "1",
        "materials[].coat_weight",
        urdf=("`Pc` in the MTL file", "surface roughness, metalness and coat"),
        mjcf=("the highlight of the coat", "coat"),
        usd="`inputs:clearcoat`, `inputs:clearcoatRoughness`",
        glb='`"KHR_materials_clearcoat"`',
    ),
    _row(
        "opacity, transmission",
        "1",
        "materials[].opacity",
        urdf=("alpha of `rgba=`", "transmission"),
        mjcf=("alpha of `rgba=`", "transmission"),
        usd=("`inputs:opacity`", "transmission"),
        glb=('`"alphaMode":"BLEND"`', "transmission"),
    ),
    _row(
        "texture",
        "m a repeat",
        "materials[].texture",
        urdf=("`map_Kd`, `norm` in the MTL file", "texture"),
        mjcf=("`<texture`, `<layer role=`", "texture"),
        usd=("`UsdUVTexture`, `primvars:st` in repeats", "texture"),
        glb=('`"baseColorTexture"`, `"TEXCOORD_0"` in repeats', "texture"),
    ),
    _row(
        "proof that nothing collides",
        "",
        "certificate",
        urdf="not said; certificate.json has it",
        mjcf="not said; certificate.json has it",
        usd="not said; certificate.json has it",
        glb="not said; certificate.json has it",
    ),
)
"""Every concept, in the order of the page."""

_HEAD = """# What each format says

How artgen's concepts are written in URDF, MJCF, USD and GLB, with their units, and what is lost where. The
words in backticks stand in the files, here of an asset named `cabinet_7`. *Lost* names the entry under `formats`
in the export's `asset.json` that tells, for each asset, which joints or links it concerns and what was written
instead. `scripts/concept_mapping.py` writes this page from `artgen.export.concepts`, and the tests hold both
against the writers.
"""


def concept_page() -> str:
    """Return the text of docs/concept_mapping.md."""
    titles = ["concept", "unit in artgen", "in asset.json", *FORMAT_TITLES.values()]
    lines = [f"| {' | '.join(titles)} |", f"|{' --- |' * len(titles)}"]
    for concept in CONCEPTS:
        field = f"`{concept.field}`" if concept.field else ""
        cells = [concept.name, concept.unit, field, *(_said(concept.cells[name]) for name in FORMAT_TITLES)]
        lines.append(f"| {' | '.join(cells)} |")
    return _HEAD + "\n" + "\n".join(lines) + "\n"


def _said(cell: Cell) -> str:
    if not cell.losses:
        return cell.text
    return f"{cell.text}. *Lost: {', '.join(cell.losses)}*"
