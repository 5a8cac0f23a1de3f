"""The description of a client, and the environments that clients run in."""

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
"""What is installed in each environment. `light` is what `artgen[test]` brings into artgen's own."""


FormatName = Literal["urdf", "mjcf", "usd", "glb"]

READ = ("links", "joints", "poses")
"""What a client tells of a model that it read, see `Client.tells`."""

MOVED = ("moved", "steps", "finite")
"""What a client tells that simulates the model as well."""


@dataclass(frozen=True)
class Unavoidable:
    """A message that a client prints at every asset of a kind, whatever is written."""

    pattern: str  # regular expression that matches the whole of one line of its output
    reason: str  # why no asset can avoid it


MACHINE = (
    Unavoidable(
        r"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver\..*",
        "Warp says so on every machine without a GPU",
    ),
)
"""Messages of any client about the machine, not about what it reads."""


@dataclass(frozen=True)
class Client:
    """A program that reads exported assets, and its driver."""

    name: str  # identifier, such as `pybullet` or `newton_usd`
    format: FormatName  # the format that it reads
    distribution: str  # python distribution whose version is shown; empty for a program of the system
    environment: str  # name of its environment, see `artgen.validate.clients.client`
    driver: str  # name of its script in `artgen/validate/clients/drivers`, which runs in that environment
    layouts: tuple[str, ...] = ("flat",)  # layouts of exports whose main file of that format it reads
    seconds: float = 120.0  # how long one asset may take
    length_tolerance: float = 1e-6  # by how much positions of links and limits may differ [m or rad]
    relative_tolerance: float = 1e-6  # by which share masses, moments and gains may differ
    unavoidable: tuple[Unavoidable, ...] = ()  # messages that are no fault
    light: bool = False  # whether it comes with `artgen[test]`; others need an environment of their own
    # keys that its answer must have, so that a reader that falls silent is noticed; such as `links`, or
    # `joints.damping` for a quantity of each joint
    tells: tuple[str, ...] = ()
    # what it has no words for, of what others have to tell, such as `joints.kind`
    withholds: tuple[str, ...] = ()
    obtain: str = ""  # how to get it, where no environment of artgen's brings it
    # whether it places a link wrongly that moves by several joints, whatever is written
    misplaces: bool = False
