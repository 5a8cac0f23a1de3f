"""The manipulation tasks: which asset each is about, what has to be done, and how much time there is."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from artgen.asset import Asset
from artgen.catalog import generate
from artgen.envs.motion import FAR_BACK, Contact, Move, Stage, Target
from artgen.envs.placing import place
from artgen.envs.targets import Chooser, open_dishwasher, push_door, simple
from artgen.errors import EnvError
from artgen.sampling import choice

__all__ = ["TASKS", "Contact", "Move", "Stage", "Target", "Task"]

_FAR = 0.16  # that OpenFridge asks for: 9 degrees and a little [rad]


@dataclass(frozen=True, eq=False)
class Task:
    """Something for a robot to do with any asset of a category.

    Attributes:
        name: `PushDoor`; the environment is registered as `artgen/PushDoor-v0`.
        category: Name of the category.
        seconds: Time limit [s].
        doc: What has to be done, in one sentence.
        choose: Yields what the task may ask of an asset.
        overrides: Values or distributions of parameters, so that the asset has the part.
        raised: Whether the asset stands on a table, beside which the robot is.
    """

    name: str
    category: str
    seconds: float
    doc: str
    choose: Chooser
    overrides: Mapping[str, Any] = field(default_factory=dict)
    raised: bool = False

    def generate(self, seed: int) -> Asset:
        """Draw an asset that has what the task is about; it is not certified."""
        return generate(self.category, seed, certify=False, **self.overrides)

    def target(self, asset: Asset, rng: np.random.Generator) -> Target:
        """Return what has to be done with an asset, and where a Panda stands that can reach all of it.

        Args:
            asset: An asset of any category that has the parts.
            rng: Draws the part where there are several, where the robot stands, and the pose of its hand.

        Raises:
            EnvError: The asset lacks the part, or no place for the robot was found from which it reaches it.
        """
        tried = 0
        for stages in self.choose(asset, rng):
            tried += 1
            found = place(asset, stages, rng, raised=self.raised or _hangs(asset))
            if found is not None:
                return found
        if not tried:
            raise EnvError(
                f"asset {asset.name!r} of category {asset.category!r} has nothing for {self.name}: "
                f"{self.doc} Take assets that the task's generate(seed) draws"
            )
        raise EnvError(
            f"{self.name}: no place was found from which a Panda reaches what it has to move on asset "
            f"{asset.name!r} ({tried} tried); leave the asset out, or make it with another seed"
        )


def _hangs(asset: Asset) -> bool:
    """Tell whether an asset hangs on a wall, where it has more room below than on a floor."""
    return asset.parameters.get("kind") == "wall"


def _tasks() -> dict[str, Task]:
    tasks = (
        Task(
            "PushDoor",
            "door",
            10.0,
            "Turn the lever until the latch is free, by 0.3 rad or more, then push the leaf open by 0.3 rad.",
            push_door,
            {"opener": "lever", "layout": "single"},
        ),
        Task(
            "PushToasterLever",
            "toaster",
            8.0,
            "Push a lever of the toaster down.",
            simple("lever", "push", "prismatic", 0.9),
        ),
        Task(
            "OpenFridge",
            "refrigerator",
            10.0,
            "Open a door of the refrigerator to 9 degrees and more.",
            simple("door", "grasp", "revolute", at_least=_FAR),
        ),
        Task(
            "OpenDrawer",
            "drawer",
            10.0,
            "Pull a drawer open by half its way.",
            simple("drawer", "grasp", "prismatic", 0.5),
        ),
        Task(
            "OpenDishwasher",
            "dishwasher",
            30.0,
            "Open the door of the dishwasher, then pull a rack out by half its way.",
            open_dishwasher,
            {"racks": choice(2, 3)},
        ),
        Task(
            "PressMicrowaveButton",
            "microwave",
            5.0,
            "Press a key or button of the microwave oven.",
            simple("", "push", "prismatic", 0.8, back=FAR_BACK),
            {"controls": choice("keypad", "mixed")},
            raised=True,
        ),
        Task(
            "TurnFaucet",
            "faucet",
            6.0,
            "Open the faucet by four fifths of what its handle turns or lifts.",
            simple("handle", "grasp", "revolute", 0.8, back=FAR_BACK),
        ),
        Task(
            "OpenTrashcan",
            "trashcan",
            8.0,
            "Press the pedal that lifts the lid.",
            simple("pedal", "push", "revolute", 0.8),
            {"style": "pedal"},
        ),
        Task(
            "OpenMicrowave",
            "microwave",
            10.0,
            "Open the door of the microwave oven by 0.4 rad.",
            simple("door", "grasp", "revolute", at_least=0.4),
            {"handle": choice("bar", "pocket")},
            raised=True,
        ),
        Task(
            "OpenCabinet",
            "cabinet",
            10.0,
            "Open a door of the cabinet by 0.4 rad.",
            simple("door", "grasp", "revolute", at_least=0.4),
        ),
    )
    return {task.name: task for task in tasks}


TASKS = _tasks()
"""Every task by its name."""
