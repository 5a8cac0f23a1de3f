"""What artgen knows of each client: simulators, validators and converters that read its exports."""

from dataclasses import dataclass
from typing import Literal

FormatName = Literal["urdf", "mjcf", "usd", "glb"]

READ = ("links", "joints", "poses")
"""What a client tells of a model that it read, see `Client.tells`."""

MOVED = ("moved", "steps", "finite")
"""What a client tells that simulates the model as well."""


@dataclass(frozen=True)
class Unavoidable:
    """A message that a client prints at every asset of a kind, whatever is written.

    Attributes:
        pattern: Regular expression that matches the whole of one line of its output.
        reason: Why no asset can avoid it.
    """

    pattern: str
    reason: str


MACHINE = (
    Unavoidable(
        r"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver\..*",
        "Warp says so on every machine without a GPU",
    ),
)
"""Messages of any client about the machine, not about what it reads."""


@dataclass(frozen=True)
class Client:
    """A program that reads exported assets, and how to ask it what it read.

    Attributes:
        name: Identifier, such as `pybullet` or `newton_usd`.
        format: The format that it reads.
        distribution: Python distribution whose version is shown; empty for a program of the system.
        environment: Name of its environment, see `artgen.validate.clients.environments`.
        driver: Name of its script in `artgen/validate/clients/drivers`, which runs in that environment.
        layouts: Layouts of exports whose main file of that format it reads.
        seconds: How long one asset may take.
        length_tolerance: By how much positions of links and limits may differ [m or rad].
        relative_tolerance: By which share masses, moments and gains may differ.
        unavoidable: Messages that are no fault.
        light: Whether it comes with `artgen[test]`; others need an environment of their own.
        tells: Keys that its answer must have, so that a reader that falls silent is noticed; such as
            `links`, or `joints.damping` for a quantity of each joint.
        withholds: What it has no words for, of what others have to tell, such as `joints.kind`.
        obtain: How to get it, where no environment of artgen's brings it.
        misplaces: Whether it places a link wrongly that moves by several joints, whatever is written.
    """

    name: str
    format: FormatName
    distribution: str
    environment: str
    driver: str
    layouts: tuple[str, ...] = ("flat",)
    seconds: float = 120.0
    length_tolerance: float = 1e-6
    relative_tolerance: float = 1e-6
    unavoidable: tuple[Unavoidable, ...] = ()
    light: bool = False
    tells: tuple[str, ...] = ()
    withholds: tuple[str, ...] = ()
    obtain: str = ""
    misplaces: bool = False
