"""MuJoCo's relatives: robosuite, which puts objects into tasks, and MJX and MuJoCo Warp, for many worlds."""

from artgen.validate.clients.client import READ, Client, Unavoidable

_SINGLE = 1e-5  # what is left of numbers in single precision
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
        seconds=600.0,  # it compiles each model anew
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
        seconds=600.0,  # the first time on a machine it compiles its kernels
        tells=_TELLS,
        length_tolerance=_SINGLE,
        relative_tolerance=_SINGLE,
    ),
)
"""Clients that read MJCF beside MuJoCo itself."""
