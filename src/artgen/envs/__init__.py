"""Manipulation tasks for a Panda, as environments of Gymnasium; importing this registers them.

import gymnasium
import artgen.envs

env = gymnasium.make("artgen/PushToasterLever-v0", assets=range(100))
"""

from artgen.errors import EnvError

try:
    import gymnasium
except ImportError as error:
    raise EnvError("manipulation tasks need Gymnasium: pip install 'artgen[envs]'") from error

from artgen.envs.env import ManipulationEnv
from artgen.envs.motion import Stage, Target
from artgen.envs.stages import by_lever, by_output, one_joint
from artgen.envs.task import KITCHEN_TASKS, TASKS, Task

__all__ = [
    "KITCHEN_TASKS",
    "TASKS",
    "ManipulationEnv",
    "Stage",
    "Target",
    "Task",
    "by_lever",
    "by_output",
    "one_joint",
]

for _name in (*TASKS, *KITCHEN_TASKS):
    gymnasium.register(
        id=f"artgen/{_name}-v0", entry_point="artgen.envs.env:ManipulationEnv", kwargs={"task": _name}
    )
