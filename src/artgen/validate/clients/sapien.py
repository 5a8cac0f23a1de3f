"""SAPIEN and ManiSkill, which is built on it."""

from artgen.validate.clients.client import MOVED, READ, Client

_LAYOUTS = ("flat", "partnet-mobility")
_TELLS = (*READ, *MOVED, "joints.damping")

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
        relative_tolerance=1e-5,  # it computes in single precision
        tells=_TELLS,
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
        tells=_TELLS,
    ),
)
"""Clients that read URDF into SAPIEN's physics."""
