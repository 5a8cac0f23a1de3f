"""All clients: simulators, validators and converters, with their tolerances and known messages."""

from collections.abc import Mapping, Sequence

from artgen.errors import ParameterError, nearest
from artgen.validate.clients.client import MOVED, READ, Client, FormatName, Unavoidable

_LAYOUTS = ("flat", "partnet-mobility")
_SAPIEN_TELLS = (*READ, *MOVED, "joints.damping")

SAPIEN: tuple[Client, ...] = (
    Client(
        name="sapien",
        format="urdf",
        distribution="sapien",
        environment="sapien",
        driver="sapien_model",
        layouts=_LAYOUTS,
        seconds=300.0,
        length_tolerance=1e-5,
        relative_tolerance=1e-5,  # single precision
        tells=_SAPIEN_TELLS,
    ),
    Client(
        name="mani_skill",
        format="urdf",
        distribution="mani_skill",
        environment="mani_skill",
        driver="mani_skill_model",
        layouts=_LAYOUTS,
        seconds=300.0,
        length_tolerance=1e-5,
        relative_tolerance=1e-5,
        tells=_SAPIEN_TELLS,
    ),
)
"""Clients that read URDF into SAPIEN's physics."""


_USD = ("flat", "simready")

# USD and these simulators use single precision: seven digits of metres and of sums of a few numbers
_LENGTH, _RELATIVE = 3e-6, 1e-6

_MAPS = Unavoidable(
    r"NewtonWarning: (Roughness|Metallic) texture inputs are not yet supported; using scalar fallback\.",
    "Newton draws roughness and metalness as one number each, and the asset has maps of them",
)


_TURNED = Unavoidable(
    r"\[Genesis\] \[.*\] \[WARNING\] Link '.*' has dubious inertia \[.*\] compared to the estimate from "
    r"geometry \[.*\]\.",
    "Genesis compares principal moments, as MuJoCo sorts them, with those about the link's axes",
)

_MEETING = Unavoidable(
    r"\[Genesis\] \[.*\] \[WARNING\] Filtered out geometry pairs causing self-collision for the neutral "
    r"configuration \(qpos0\): .*\. Consider tuning Morph option .*\.",
    "Genesis looks for parts in each other with voxels wider than the gap between the jaws of pliers",
)


def _newton(form: FormatName, *layouts: str) -> Client:
    return Client(
        f"newton_{form}",
        form,
        "newton",
        "newton",
        "newton_model",
        layouts=layouts,
        seconds=300.0,  # its first run on a machine compiles kernels
        length_tolerance=_LENGTH,
        relative_tolerance=_RELATIVE,
        unavoidable=(_MAPS,),
        tells=(*READ, "couplings", *MOVED),
    )


def _genesis(form: FormatName) -> Client:
    return Client(
        f"genesis_{form}",
        form,
        "genesis-world",
        "genesis",
        "genesis_model",
        seconds=900.0,  # its first run on a machine compiles kernels for seven minutes
        length_tolerance=_LENGTH,
        relative_tolerance=_RELATIVE,
        unavoidable=(
            Unavoidable(
                r"\[W .*\] \[frontend_ir\.cpp:.*\] qd\.loop_config\(serialize=True\) does not have effect .*",
                "Genesis says so of its own kernels while it compiles them",
            ),
            _TURNED,
            *((_MEETING,) if form == "urdf" else ()),
        ),
        tells=(*READ, "couplings", *MOVED),
    )


_OVPHYSX = Client(
    "ovphysx",
    "usd",
    "ovphysx",
    "ovphysx",
    "physx_model",
    layouts=_USD,
    seconds=300.0,  # dials that have to be pushed before they turn are tested in many poses
    length_tolerance=_LENGTH,
    relative_tolerance=_RELATIVE,
    unavoidable=(
        Unavoidable(
            r"\[Warning\] \[omni\.physx\] GPU broadphase requires a CUDA context manager; .*",
            "PhysX says so of every stage that leaves the choice of a processor to its user",
        ),
        Unavoidable(
            r"\[Warning\] \[\] PhysX warning: Cooking::cookConvexMesh: GPU-compatible convex hull could not "
            r"be built because of oblong shape\..*",
            "a convex piece is more than a hundred times as long as its insphere's radius, as a moulding "
            "along a door frame is; PhysX collides such pieces on the processor, also in GPU simulation",
        ),
        Unavoidable(
            r"\[Warning\] \[\] ConvexMeshCookingTask: failed to cook GPU-compatible mesh, .*",
            "it follows the message about an oblong shape",
        ),
    ),
    tells=(*READ, *MOVED, "joints.stiffness", "joints.damping"),
    withholds=("joints.kind",),  # wrong values show in the poses
)

_VALIDATORS = (
    Client(
        "usd_validation",
        "usd",
        "usd-core",
        "light",
        "usd_validation",
        layouts=_USD,
        unavoidable=(
            Unavoidable(
                r"MissingShaderIdInRegistry: shaderId 'ND_\w+' .*",
                "PyPI's usd-core comes without MaterialX, in whose nodes OpenPBR materials are written",
            ),
        ),
        light=True,
    ),
    Client(
        "omniverse_asset_validator",
        "usd",
        "omniverse-asset-validator",
        "light",
        "omniverse",
        layouts=_USD,
        light=True,
    ),
    Client(
        "simready_validate",
        "usd",
        "simready-validate",
        "light",
        "simready_profile",
        layouts=("simready",),
        unavoidable=(
            Unavoidable(
                r"(WARNING:root:)?(DeprecationWarning: Use find\(\) instead|File .*, in validate_stage)",
                "simready-validate calls its own engine in a way that is deprecated",
            ),
        ),
        light=True,
    ),
    Client(
        "gltf_validator",
        "glb",
        "",
        "",
        "gltf",
        light=True,
        obtain="install node, and run `npm install --global gltf-validator` or name its node_modules in "
        "ARTGEN_NODE_MODULES",
    ),
)

_DEPRECATED = Unavoidable(
    r"\[Warning\] \[usdex\.core\.deprecation\] .* was deprecated .*",
    "the converter calls usd-exchange in a way that is deprecated",
)
_CONVERTERS = (
    Client(
        "mujoco_usd_converter",
        "mjcf",
        "mujoco-usd-converter",
        "usd_converters",
        "usd_converters",
        layouts=("flat",),
        unavoidable=(
            _DEPRECATED,
            Unavoidable(
                r"\[Warning\] \[mujoco_usd_converter\._impl\.material\.convert_material\] "
                r"Unsupported texture layers for material '.*'",
                "the material has maps, but none of color, which is all that the converter knows",
            ),
        ),
        tells=(*READ, "couplings"),
    ),
    Client(
        "urdf_usd_converter",
        "urdf",
        "urdf-usd-converter",
        "usd_converters",
        "usd_converters",
        layouts=("flat",),
        unavoidable=(_DEPRECATED,),
        tells=(*READ, "couplings"),
    ),
)

USD: tuple[Client, ...] = (
    _OVPHYSX,
    _newton("usd", *_USD),
    _newton("mjcf", "flat"),
    _newton("urdf", "flat"),
    _genesis("mjcf"),
    _genesis("urdf"),
    *_VALIDATORS,
    *_CONVERTERS,
)
"""In the order of the table."""


_DAMPED = "joints.damping"
_RUBBED = (_DAMPED, "joints.friction")


def _drake(message: str, reason: str) -> Unavoidable:
    return Unavoidable(rf"WARNING:drake:.*: (warning|error): {message}", reason)


_DRAKE_URDF = (
    _drake(
        r"A joint has specified a non-zero value for the 'friction' attribute of a joint/dynamics tag\. .*",
        "Drake has no dry friction of joints, which the asset has",
    ),
    _drake(
        r"visual name '.*' has already been used, renaming to '.*' instead",
        "in PartNet-Mobility all visuals of a part bear its name, which loaders look for",
    ),
)
_DRAKE_MJCF = (
    _drake(
        r"The attribute '(frictionloss|stiffness|springref|actuatorfrcrange)' found in a 'joint' tag is "
        r"currently unsupported and will be ignored\.",
        "Drake's reader of MJCF knows no friction, spring and largest effort of a joint, which the asset has",
    ),
    _drake(
        r"The tag 'joint' found as a child of 'equality' is currently unsupported and will be ignored\.",
        "Drake's reader of MJCF knows no coupling of joints, which the asset has",
    ),
    _drake(
        r"The tag 'site' found as a child of 'body' is currently unsupported and will be ignored\.",
        "Drake's reader of MJCF knows no sites, which mark grasps and pushes",
    ),
    _drake(
        r"The texture element is not supported, .*",
        "Drake's reader of MJCF knows no textures",
    ),
)

URDF: tuple[Client, ...] = (
    Client(
        "mujoco",
        "mjcf",
        "mujoco",
        "light",
        "mujoco_model",
        layouts=("flat", "robocasa"),
        light=True,
        tells=(*READ, "couplings", *MOVED, *_RUBBED, "joints.stiffness", "joints.armature"),
    ),
    Client(
        "mujoco_urdf",
        "urdf",
        "mujoco",
        "light",
        "mujoco_model",
        light=True,
        tells=(*READ, *MOVED, *_RUBBED),
    ),
    Client(
        "pinocchio",
        "urdf",
        "pin",
        "light",
        "pinocchio_model",
        layouts=("flat", "partnet-mobility"),
        light=True,
        tells=(*READ, *_RUBBED),
    ),
    Client(
        "yourdfpy",
        "urdf",
        "yourdfpy",
        "light",
        "yourdfpy_model",
        layouts=("flat", "partnet-mobility"),
        light=True,
        tells=(*READ, *_RUBBED),
    ),
    Client(
        "check_urdf",
        "urdf",
        "",
        "",
        "check_urdf",
        layouts=("flat", "partnet-mobility"),
        light=True,
        obtain="install liburdfdom-tools by apt, or pin by pip, which brings it",
    ),
    Client(
        "urchin",
        "urdf",
        "urchin",
        "urchin",
        "urchin_model",
        layouts=("flat", "partnet-mobility"),
        tells=(*READ, *_RUBBED),
    ),
    Client(
        "pybullet",
        "urdf",
        "pybullet",
        "bullet",
        "bullet",
        layouts=("flat", "partnet-mobility"),
        tells=(*READ, *MOVED, *_RUBBED),
        unavoidable=(Unavoidable("pybullet build time: .*", "it says so whenever it is imported"),),
    ),
    Client(
        "drake_urdf",
        "urdf",
        "drake",
        "drake",
        "drake",
        layouts=("flat", "partnet-mobility"),
        tells=(*READ, *MOVED, _DAMPED),
        unavoidable=_DRAKE_URDF,
    ),
    Client(
        "drake_mjcf",
        "mjcf",
        "drake",
        "drake",
        "drake",
        tells=(*READ, *MOVED, _DAMPED),
        unavoidable=_DRAKE_MJCF,
        misplaces=True,  # it turns such a body about the origin of its parent
    ),
)
"""In the order of the table."""


_SINGLE = 1e-5  # precision of single-precision numbers
_GAINS = ("joints.damping", "joints.friction", "joints.stiffness", "joints.armature")
_TELLS = (*READ, "couplings", "steps", *_GAINS)
_ADVICE = "advice on the installation of robosuite, whatever is loaded"

ROBOSUITE: tuple[Client, ...] = (
    Client(
        name="robosuite",
        format="mjcf",
        distribution="robosuite",
        environment="robosuite",
        driver="robosuite_model",
        layouts=("robocasa",),
        tells=(*_TELLS, "moved"),
        unavoidable=(
            Unavoidable(r"\[robosuite WARNING\] No private macro file found!.*", _ADVICE),
            Unavoidable(r"\[robosuite WARNING\] It is recommended to use a private macro file.*", _ADVICE),
            Unavoidable(r"\[robosuite WARNING\] To setup, run: python .*setup_macros\.py.*", _ADVICE),
            Unavoidable(r"\[robosuite WARNING\] Could not import robosuite_models\..*", _ADVICE),
            Unavoidable(r"\[robosuite WARNING\] Could not load the mink-based whole-body IK\..*", _ADVICE),
        ),
    ),
    Client(
        name="mjx",
        format="mjcf",
        distribution="mujoco-mjx",
        environment="mjx",
        driver="mjx_model",
        seconds=600.0,  # it compiles each model again
        tells=_TELLS,
        unavoidable=(
            Unavoidable(
                r"Failed to import (warp|mujoco_warp): .*",
                "MJX says so wherever the optional Warp is missing",
            ),
        ),
        length_tolerance=_SINGLE,
        relative_tolerance=_SINGLE,
    ),
    Client(
        name="mujoco_warp",
        format="mjcf",
        distribution="mujoco-warp",
        environment="newton",
        driver="mujoco_warp_model",
        seconds=600.0,  # its first run on a machine compiles kernels
        tells=_TELLS,
        length_tolerance=_SINGLE,
        relative_tolerance=_SINGLE,
    ),
)
"""Clients that read MJCF, except for MuJoCo itself."""


CLIENTS: Mapping[str, Client] = {client.name: client for client in (*URDF, *SAPIEN, *ROBOSUITE, *USD)}
"""Every client by its name."""

ALL = "all"
"""Name that selects all clients."""


def chosen_clients(names: str) -> tuple[Sequence[Client], bool]:
    """Return the clients in a text such as `all` or `pybullet,drake_urdf`, each once."""
    words = list(dict.fromkeys(word for part in names.split(",") if (word := part.strip())))
    if not words:
        raise ParameterError(f"{names!r} names no client; give {ALL!r} or some of: {', '.join(CLIENTS)}")
    for word in words:
        if word not in (ALL, *CLIENTS):
            raise ParameterError(f"there is no client {word!r}.{nearest(word, [ALL, *CLIENTS])}")
    if ALL in words:
        return tuple(CLIENTS.values()), False
    return tuple(CLIENTS[word] for word in words), True
