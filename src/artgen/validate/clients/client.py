"""Description of a client, and the environments of clients."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

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


FormatName = Literal["urdf", "mjcf", "usd", "glb"]

READ = ("links", "joints", "poses")
"""Parts that a reading client tells, see `Client.tells`."""

MOVED = ("moved", "steps", "finite")
"""Parts that a simulating client tells in addition."""


@dataclass(frozen=True)
class Unavoidable:
    """A message that a client prints for every asset of a kind."""

    pattern: str  # regular expression that matches the whole of one line of its output
    reason: str  # reason why no asset can avoid it


MACHINE = (
    Unavoidable(
        r"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver\..*",
        "Warp says so on every machine without a GPU",
    ),
)
"""Messages of any client about the machine instead of the asset."""


@dataclass(frozen=True)
class Client:
    """A program that reads exported assets, and its driver."""

    name: str  # identifier, such as `pybullet` or `newton_usd`
    format: FormatName  # format that it reads
    distribution: str  # Python distribution whose version is shown; empty for a system program
    environment: str  # name of its environment in `REQUIREMENTS`
    driver: str  # name of its script in `artgen/validate/clients/drivers`, which runs in that environment
    layouts: tuple[str, ...] = ("flat",)  # layouts of exports that it reads
    seconds: float = 120.0  # time limit for one asset [s]
    length_tolerance: float = 1e-6  # tolerance of link positions and limits [m or rad]
    relative_tolerance: float = 1e-6  # relative tolerance of masses, moments and gains
    unavoidable: tuple[Unavoidable, ...] = ()  # messages that are not faults
    light: bool = False  # whether `artgen[test]` installs it; other clients need their own environment
    # keys that its answer must have, such as `links`, or `joints.damping` for a quantity of each joint: a
    # reader that becomes silent is noticed
    tells: tuple[str, ...] = ()
    # required keys that it cannot tell, such as `joints.kind`
    withholds: tuple[str, ...] = ()
    obtain: str = ""  # how to obtain it if no environment of artgen has it
    # whether it always misplaces links with several joints
    misplaces: bool = False
