"""The clients that read URDF, and those that read MJCF beside it."""

from artgen.validate.clients.client import MOVED, READ, Client, Unavoidable

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
        misplaces=True,  # it turns such a body about its parent's origin
    ),
)
"""In the order of the table."""
