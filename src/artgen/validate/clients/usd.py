"""Newton, PhysX and Genesis, the validators of USD and GLB, and the converters to USD."""

from artgen.validate.clients.client import MOVED, READ, Client, FormatName, Unavoidable

_USD = ("flat", "simready")

# USD and these simulators hold single precision: seven digits of metres, and of sums of a few such numbers
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
        seconds=300.0,  # the first time on a machine it compiles its kernels
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
        seconds=900.0,  # the first time on a machine it compiles its kernels for seven minutes
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
    seconds=300.0,  # dials that must be pushed before they turn are tried in many poses
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
    withholds=("joints.kind",),  # a wrong one shows in the poses
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
                "the material has maps, but none of colour, which is all that the converter knows",
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
