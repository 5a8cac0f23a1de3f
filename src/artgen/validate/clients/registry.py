"""Table of clients: simulators, validators and converters that read exported assets; and their packages."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from artgen.errors import ParameterError, nearest

REQUIREMENTS: Mapping[str, tuple[str, ...]] = {
    "bullet": ("pybullet>=3.2.7", "numpy"),
    "drake": ("drake>=1.51",),
    "genesis": ("genesis-world>=1.4.5", "torch"),
    "light": (
        "mujoco>=4.0",
        "omniverse-asset-validator>=1.18; python_version < '3.13'",
        "pin>=4.1",
        "simready-foundation-tier-core>=2026.8; python_version < '3.13'",
        "simready-validate>=2026.8; python_version < '3.13'",
        "usd-core>=26.11",
        "yourdfpy>=0.0.60",
    ),
    "mani_skill": ("mani_skill>=3.0.1",),
    "mjx": ("jax[cpu]", "mujoco-mjx[warp]>=3.17", "mujoco>=4.0"),
    "newton": ("newton[importers,sim]>=1.8", "trimesh"),
    "ovphysx": ("newton-usd-schemas", "ovphysx>=0.7", "physx-usd-schemas"),
    "robosuite": ("robosuite>=1.5",),
    "sapien": ("pillow", "sapien>=3.0.3"),
    "urchin": ("urchin>=0.0.30",),
    "usd_converters": ("mujoco-usd-converter>=0.8", "urdf-usd-converter>=0.3.4"),
}
"""Packages in each environment. `artgen[test]` installs those of `light` into artgen's own environment."""


Format = Literal["urdf", "mjcf", "usd", "glb", "sdf"]


@dataclass(frozen=True)
class Client:
    """A program that reads exported assets, and its driver."""

    name: str  # identifier, such as `pybullet` or `newton_usd`
    format: Format  # format that it reads
    distribution: str  # Python distribution whose version is shown; empty for a system program
    environment: str  # name of its environment in `REQUIREMENTS`; empty for a system program
    driver: str  # name of its script in `artgen/validate/clients/drivers`, which runs in that environment
    layouts: tuple[str, ...] = ("flat",)  # layouts of exports that it reads
    # required keys of its answer, such as `links`, or `joints.damping` for a quantity of each joint: without
    # them, a reader that stops reporting something would pass
    reports: tuple[str, ...] = ()
    omits: tuple[str, ...] = ()  # required keys that it cannot report, such as `joints.kind`
    # tolerance of link positions and limits [m or rad], and relative tolerance of masses, moments and gains
    tolerances: tuple[float, float] = (1e-6, 1e-6)
    seconds: float = 120.0  # time limit for one asset [s]
    # messages that are not faults: regular expressions that match a whole line of its output, and reasons why
    # no asset can avoid them
    unavoidable: tuple[tuple[str, str], ...] = ()
    obtain: str = ""  # how to obtain it if no environment of artgen has it
    misplaces: bool = False  # whether it always misplaces links with several joints


ALL = "all"
"""Name that selects all clients."""

_FLAT, _PARTNET, _SIMREADY = ("flat",), ("flat", "partnet-mobility"), ("flat", "simready")
_MUJOCO = ("flat", "robocasa", "molmospaces")

_READ = ("links", "joints", "poses")
_FRICTION = ("joints.damping", "joints.friction")
_GAINS = (*_FRICTION, "joints.stiffness", "joints.armature")
_READ_FRICTION = (*_READ, *_FRICTION)
_MOVED = (*_READ, "moved", "steps", "finite")
_MOVED_FRICTION = (*_MOVED, *_FRICTION)
_MOVED_DAMPING = (*_MOVED, "joints.damping")
_MOVED_SPRINGS = (*_MOVED, "joints.stiffness", "joints.damping")
_COUPLED = (*_READ, "couplings")
_MOVED_COUPLINGS = (*_COUPLED, "moved", "steps", "finite")
_MOVED_GAINS = (*_MOVED_COUPLINGS, *_GAINS)
_STEPPED = (*_COUPLED, "steps", *_GAINS)

# name, format, distribution, environment, driver, layouts, reports
_TABLE: tuple[tuple[str, Format, str, str, str, tuple[str, ...], tuple[str, ...]], ...] = (
    ("mujoco", "mjcf", "mujoco", "light", "mujoco_model", _MUJOCO, _MOVED_GAINS),
    ("mujoco_urdf", "urdf", "mujoco", "light", "mujoco_model", _FLAT, _MOVED_FRICTION),
    ("pinocchio", "urdf", "pin", "light", "pinocchio_model", _PARTNET, _READ_FRICTION),
    ("yourdfpy", "urdf", "yourdfpy", "light", "urdf_readers", _PARTNET, _READ_FRICTION),
    ("check_urdf", "urdf", "", "", "check_urdf", _PARTNET, ()),
    ("urchin", "urdf", "urchin", "urchin", "urdf_readers", _PARTNET, _READ_FRICTION),
    ("pybullet", "urdf", "pybullet", "bullet", "bullet", _PARTNET, _MOVED_FRICTION),
    ("drake_urdf", "urdf", "drake", "drake", "drake", _PARTNET, _MOVED_DAMPING),
    ("drake_mjcf", "mjcf", "drake", "drake", "drake", _FLAT, _MOVED_DAMPING),
    ("drake_sdf", "sdf", "drake", "drake", "drake", _FLAT, _MOVED_DAMPING),
    ("sapien", "urdf", "sapien", "sapien", "sapien_model", _PARTNET, _MOVED_DAMPING),
    ("mani_skill", "urdf", "mani_skill", "mani_skill", "mani_skill_model", _PARTNET, _MOVED_DAMPING),
    ("robosuite", "mjcf", "robosuite", "robosuite", "robosuite_model", ("robocasa",), (*_STEPPED, "moved")),
    ("mjx", "mjcf", "mujoco-mjx", "mjx", "mjx_model", _FLAT, _STEPPED),
    ("mujoco_warp", "mjcf", "mujoco-warp", "newton", "mujoco_warp_model", _FLAT, _STEPPED),
    ("ovphysx", "usd", "ovphysx", "ovphysx", "physx_model", _SIMREADY, _MOVED_SPRINGS),
    ("newton_usd", "usd", "newton", "newton", "newton_model", _SIMREADY, _MOVED_COUPLINGS),
    ("newton_mjcf", "mjcf", "newton", "newton", "newton_model", _FLAT, _MOVED_COUPLINGS),
    ("newton_urdf", "urdf", "newton", "newton", "newton_model", _FLAT, _MOVED_COUPLINGS),
    ("genesis_mjcf", "mjcf", "genesis-world", "genesis", "genesis_model", _FLAT, _MOVED_COUPLINGS),
    ("genesis_urdf", "urdf", "genesis-world", "genesis", "genesis_model", _FLAT, _MOVED_COUPLINGS),
    ("usd_validation", "usd", "usd-core", "light", "usd_validation", _SIMREADY, ()),
    ("omniverse_asset_validator", "usd", "omniverse-asset-validator", "light", "nvidia_usd", _SIMREADY, ()),
    ("simready_validate", "usd", "simready-validate", "light", "nvidia_usd", ("simready",), ()),
    ("gltf_validator", "glb", "", "", "gltf", _FLAT, ()),
    ("mujoco_usd_converter", "mjcf", "mujoco-usd-converter", "usd_converters", "converters", _FLAT, _COUPLED),
    ("urdf_usd_converter", "urdf", "urdf-usd-converter", "usd_converters", "converters", _FLAT, _COUPLED),
)

_SINGLE = (1e-5, 1e-5)  # single precision
_DIGITS = (3e-6, 1e-6)  # single precision: seven digits of metres and of sums of a few numbers

# tolerances and time limit for one asset [s] by driver
_LIMITS = {
    "sapien_model": (_SINGLE, 300.0),
    "mani_skill_model": (_SINGLE, 300.0),
    "mjx_model": (_SINGLE, 600.0),  # it compiles each model
    "mujoco_warp_model": (_SINGLE, 600.0),  # the first run on a machine compiles kernels
    "physx_model": (_DIGITS, 300.0),  # dials that must be pushed before they turn are driven in many poses
    "newton_model": (_DIGITS, 300.0),  # the first run on a machine compiles kernels
    "genesis_model": (_DIGITS, 900.0),  # the same, for seven minutes
}

_OBTAIN = {
    "check_urdf": "install liburdfdom-tools by apt, or pin by pip, which brings it",
    "gltf_validator": "install node, and run `npm install --global gltf-validator` or name its node_modules "
    "in ARTGEN_NODE_MODULES",
}

_DRAKE = r"WARNING:drake:.*: (warning|error): "

MACHINE = {
    r"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver\..*": (
        "Warp prints this on every machine without a GPU"
    ),
    r".*: UserWarning: Failed to find system libvulkan\. Fallback to SAPIEN builtin libvulkan\.\s+warn\(.*": (
        "SAPIEN prints this on every machine without Vulkan, which its physics does not need"
    ),
}
"""Messages of any client about the machine instead of the asset: patterns, and reasons."""

# by client, or by driver for several clients
_UNAVOIDABLE: Mapping[str, dict[str, str]] = {
    "pybullet": {"pybullet build time: .*": "it prints this at every import"},
    "drake_urdf": {
        rf"{_DRAKE}A joint has specified a non-zero value for the 'friction' attribute of a "
        r"joint/dynamics tag\. .*": "Drake has no dry friction of joints, which the asset has",
        rf"{_DRAKE}visual name '.*' has already been used, renaming to '.*' instead": (
            "in PartNet-Mobility, all visuals of a part have its name, which loaders look up"
        ),
    },
    "drake_mjcf": {
        rf"{_DRAKE}The attribute '(frictionloss|stiffness|springref|actuatorfrcrange)' found in a 'joint' "
        r"tag is currently unsupported and will be ignored\.": (
            "Drake's MJCF reader supports no friction, spring and effort limit of joints, which the asset has"
        ),
        rf"{_DRAKE}The tag 'joint' found as a child of 'equality' is currently unsupported and will be "
        r"ignored\.": "Drake's MJCF reader supports no coupling of joints, which the asset has",
        rf"{_DRAKE}The tag 'site' found as a child of 'body' is currently unsupported and will be "
        r"ignored\.": "Drake's MJCF reader supports no sites, which mark grasps and pushes",
        rf"{_DRAKE}The tag 'keyframe' found as a child of 'mujoco' is currently unsupported and will be "
        r"ignored\.": "Drake's MJCF reader supports no keyframes, which are valid states",
        rf"{_DRAKE}The tag 'tendon' found as a child of 'mujoco' is currently unsupported and will be "
        r"ignored\.": "Drake's MJCF reader supports no tendons, which are the detents of joints",
        rf"{_DRAKE}The texture element is not supported, .*": "Drake's MJCF reader supports no textures",
    },
    "drake_sdf": {
        rf"{_DRAKE}Ignoring unsupported SDFormat element in (model: self_collide|material: pbr)": (
            "Drake lets all links collide, and its looks have a color and a map of it"
        )
    },
    "robosuite": {
        r"\[robosuite WARNING\] (No private macro file found!|It is recommended to use a private macro file|"
        r"To setup, run: python .*setup_macros\.py|Could not import robosuite_models\.|Could not load the "
        r"mink-based whole-body IK\.).*": "advice on the installation of robosuite, for every model"
    },
    "mjx": {r"Failed to import (warp|mujoco_warp): .*": "MJX prints this if the optional Warp is missing"},
    "ovphysx": {
        r"\[Warning\] \[omni\.physx\] GPU broadphase requires a CUDA context manager; .*": (
            "PhysX prints this for every stage that leaves the choice of a processor to its user"
        ),
        r"\[Warning\] \[\] PhysX warning: Cooking::cookConvexMesh: GPU-compatible convex hull could not be "
        r"built because of oblong shape\..*": (
            "a convex piece is more than a hundred times as long as its insphere's radius, as a moulding "
            "along a door frame is; PhysX collides such pieces on the processor, also in GPU simulation"
        ),
        r"\[Warning\] \[\] ConvexMeshCookingTask: failed to cook GPU-compatible mesh, .*": (
            "it follows the message about an oblong shape"
        ),
    },
    "newton_model": {
        r"NewtonWarning: (Roughness|Metallic) texture inputs are not yet supported; using scalar "
        r"fallback\.": (
            "Newton draws roughness and metalness as one number each, and the asset has maps of them"
        ),
        r"NewtonWarning: \d+ joint equalities omit joint2 or target a multi-DoF joint, .*": (
            "Newton makes one joint of the turn and the rise of a screw; its solver of MuJoCo couples them"
        ),
    },
    "genesis_model": {
        r"\[W .*\] \[frontend_ir\.cpp:.*\] qd\.loop_config\(serialize=True\) does not have effect .*": (
            "Genesis prints this about its own kernels while it compiles them"
        ),
        r"\[Genesis\] \[.*\] \[WARNING\] Link '.*' has dubious inertia \[.*\] compared to the estimate from "
        r"geometry \[.*\]\.": (
            "Genesis compares principal moments, as MuJoCo sorts them, with those about the link's axes"
        ),
        r"\[Genesis\] \[.*\] \[WARNING\] Filtered out geometry pairs causing self-collision for the neutral "
        r"configuration \(qpos0\): .*\. Consider tuning Morph option .*\.": (
            "Genesis searches for overlapping parts with voxels wider than small gaps, as between the jaws "
            "of pliers or around the stem of a valve"
        ),
    },
    "usd_validation": {
        r"MissingShaderIdInRegistry: shaderId 'ND_\w+' .*": (
            "PyPI's usd-core comes without MaterialX, whose nodes OpenPBR materials use"
        )
    },
    "simready_validate": {
        r"(WARNING:root:)?(DeprecationWarning: Use find\(\) instead|File .*, in validate_stage)": (
            "simready-validate calls its own engine in a deprecated way"
        )
    },
    "converters": {
        r"\[Warning\] \[usdex\.core\.deprecation\] .* was deprecated .*": (
            "the converter calls usd-exchange in a deprecated way"
        )
    },
    "mujoco_usd_converter": {
        r"\[Warning\] \[mujoco_usd_converter\._impl\.material\.convert_material\] Unsupported texture layers "
        r"for material '.*'": (
            "the material has maps, but none of color, and the converter supports maps of color only"
        ),
        r"\[Warning\] \[mujoco_usd_converter\._impl\.convert\.warn\] keys are not supported": (
            "the converter supports no keyframes, which are valid states"
        ),
    },
}


def _client(row: tuple[str, Format, str, str, str, tuple[str, ...], tuple[str, ...]]) -> Client:
    name, driver = row[0], row[4]
    tolerances, seconds = _LIMITS.get(driver, ((1e-6, 1e-6), 120.0))
    return Client(
        *row,
        tolerances=tolerances,
        seconds=seconds,
        unavoidable=tuple((_UNAVOIDABLE.get(driver, {}) | _UNAVOIDABLE.get(name, {})).items()),
        obtain=_OBTAIN.get(name, ""),
        omits=("joints.kind",) if name == "ovphysx" else (),  # a wrong kind shows in the poses
        misplaces=name == "drake_mjcf",  # it turns such a body about the origin of its parent
    )


CLIENTS: Mapping[str, Client] = {row[0]: _client(row) for row in _TABLE}
"""Every client by its name."""


def chosen_clients(names: str) -> tuple[Sequence[Client], bool]:
    """Return the clients in a text such as `all` or `pybullet,drake_urdf`, each once, and whether by name.

    Raises:
        ParameterError: The text is empty, or a client does not exist.
    """
    words = list(dict.fromkeys(word for part in names.split(",") if (word := part.strip())))
    if not words:
        raise ParameterError(f"{names!r} names no client; give {ALL!r} or some of: {', '.join(CLIENTS)}")
    for word in words:
        if word not in (ALL, *CLIENTS):
            raise ParameterError(f"there is no client {word!r}.{nearest(word, [ALL, *CLIENTS])}")
    if ALL in words:
        return tuple(CLIENTS.values()), False
    return tuple(CLIENTS[word] for word in words), True
