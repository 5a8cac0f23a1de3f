"""Assets and tasks in ManiSkill; importing this registers `ArtgenOpenDrawer-v1` and the others of `NAMES`.

import gymnasium
import artgen.envs.maniskill

env = gymnasium.make("ArtgenOpenDrawer-v1", assets=range(100))

Each world has its own asset: ManiSkill asks for no common topology. It reads the URDF; drives of the joints
are their springs, and followers are coupled to their leaders, so that a latch holds a door until its lever
turns. Dry friction of joints and detents are not simulated.
"""

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.link import BareLink
from artgen.envs.task import TASKS
from artgen.errors import EnvError, ParameterError

try:
    import sapien
    import torch
    from mani_skill.envs.sapien_env import BaseEnv
    from mani_skill.utils.registration import register_env
    from mani_skill.utils.structs import Articulation, Pose
except ImportError as error:
    raise EnvError(f"ManiSkill cannot be loaded ({error}): pip install mani_skill") from error

NAMES = tuple(TASKS)
"""Tasks of `artgen.envs` that are registered, as `ArtgenNAME-v1`."""

_OPEN = 0.04  # position of an open finger of the Panda [m]
_STEPS = 200  # time limit [steps]
_STIFFNESS = 1e5  # of the coupling of a follower to its leader, as in the loader of ManiSkill


def build(
    scene: Any, asset: Asset, name: str, worlds: Iterable[int] | None = None, *, textures: int = 0
) -> Any:
    """Return ManiSkill's articulation of an asset, with a fixed base, at the origin.

    Without a graphics device, it has colliders only. The drive of each joint is its spring. Followers whose
    leader moves a link of the same parent are coupled here: ManiSkill's loader inverts their ratio.

    Args:
        scene: A scene of ManiSkill.
        asset: The asset.
        name: Name of the articulation, unique in the scene.
        worlds: Numbers of the worlds that get it; None: all.
        textures: Width of material maps in pixels; 0 writes none.
    """
    if not scene.can_render():
        asset = replace(asset, links=ByName(BareLink.of(link) for link in asset.links))
    loader = scene.create_urdf_loader()
    loader.name, loader.fix_root_link = name, True
    with tempfile.TemporaryDirectory() as folder:
        asset.export(folder, formats=("urdf",), textures=textures)
        (builder,) = loader.parse(str(Path(folder) / f"{asset.name}.urdf"))["articulation_builders"]
        builder.initial_pose = sapien.Pose()
        parents = {joint.name: joint.parent for joint in asset.joints}
        records = builder.mimic_joint_records
        siblings = [each for each in records if parents[each.joint] == parents[each.mimic]]
        builder.mimic_joint_records = [each for each in records if each not in siblings]
        if worlds is not None:
            builder.set_scene_idxs(list(worlds))
        built = builder.build(name=name)
    for each in built.active_joints:
        joint = asset.joint(each.name)
        each.set_drive_properties(joint.stiffness, joint.damping)
        for world in each._objs:  # ManiSkill's own setter needs a running simulation
            world.set_drive_target(joint.rest)
            world.set_armature([joint.armature])
    joints = {each.name: each._objs for each in built.active_joints}
    for each in siblings:
        for follower, leader in zip(joints[each.joint], joints[each.mimic], strict=True):
            _couple(follower, leader, each.multiplier, each.offset)
    return built


def _couple(follower: Any, leader: Any, ratio: float, offset: float) -> None:
    """Couple two joints of one parent: with these coefficients, forces do the same work on both."""
    largest = max(1.0, abs(ratio))  # larger coefficients make PhysX stick
    coefficients = [0.0, -ratio / largest, 1.0 / largest]
    links = [leader.parent_link, leader.child_link, follower.child_link]
    follower.child_link.articulation.create_fixed_tendon(
        links, coefficients, coefficients, rest_length=offset / largest, stiffness=_STIFFNESS
    )


class ManiSkillTask(BaseEnv):  # type: ignore[misc]  # mani_skill has no types
    """A task of `artgen.envs` in ManiSkill: each world has the next asset, and a Panda that reaches its part.

    Args:
        task: Name of the task.
        assets: Seeds of the assets; worlds get them in turn.
        **options: Options of ManiSkill's `BaseEnv`.

    Raises:
        ParameterError: There are no seeds.
        EnvError: No robot reaches the part of an asset.
    """

    SUPPORTED_ROBOTS = ("panda",)

    def __init__(self, *args: Any, task: str, assets: Iterable[int] = range(16), **options: Any) -> None:
        self._task, self._seeds = TASKS[task], list(assets)
        if not self._seeds:
            raise ParameterError("assets has no seeds; give some, such as range(16)")
        self.asset_list: list[Asset] = []
        super().__init__(*args, robot_uids=options.pop("robot_uids", "panda"), **options)

    @property
    def _default_sensor_configs(self) -> Sequence[Any]:
        return []

    def _load_agent(self, options: Mapping[str, Any]) -> None:
        super()._load_agent(options, sapien.Pose(p=[-1.0, 0.0, 0.0]))

    def _load_scene(self, options: Mapping[str, Any]) -> None:
        numbers = range(self.num_envs)
        seeds = [self._seeds[number % len(self._seeds)] for number in numbers]
        self.asset_list = [self._task.generate(seed) for seed in seeds]
        pairs = zip(self.asset_list, seeds, strict=True)
        targets = [self._task.target(asset, np.random.default_rng(seed)) for asset, seed in pairs]
        built = []
        for number, asset in zip(numbers, self.asset_list, strict=True):
            built.append(build(self.scene, asset, f"{asset.name}-{number}", [number]))
            self.remove_from_state_dict_registry(built[-1])
        self.asset = Articulation.merge(built, name="asset")
        self.add_to_state_dict_registry(self.asset)
        names = [[joint.name for joint in each.active_joints] for each in built]
        closed = np.zeros((len(built), max(map(len, names))))
        for row, target, asset, each in zip(closed, targets, self.asset_list, names, strict=True):
            positions = asset.positions(target.start)
            row[: len(each)] = [positions[name] for name in each]
        self._closed = self._tensor(closed)
        most = max(len(target.stages) for target in targets)
        stages = [[*each.stages, *(most - len(each.stages)) * each.stages[-1:]] for each in targets]
        self._joint = self._tensor(
            [[each.index(stage.joint) for stage in row] for each, row in zip(names, stages, strict=True)]
        ).long()
        self._start = self._tensor([[stage.start for stage in row] for row in stages])
        self._goal = self._tensor([[stage.goal for stage in row] for row in stages])
        holds = [[stage.holds or stage is row[-1] for stage in row] for row in stages]
        self._holds = self._tensor(holds).bool()
        self._done = torch.zeros_like(self._holds)
        self._base = self._tensor(np.array([target.base for target in targets]))
        self._arm = self._tensor([[*target.arm, _OPEN, _OPEN] for target in targets])

    def _tensor(self, values: Any) -> Any:
        return torch.as_tensor(np.asarray(values), dtype=torch.float32, device=self.device)

    def _initialize_episode(self, env_idx: Any, options: Mapping[str, Any]) -> None:
        self.asset.set_qpos(self._closed[env_idx])
        self.asset.set_qvel(torch.zeros_like(self._closed[env_idx]))
        self._done[env_idx] = False
        turn = torch.atan2(self._base[env_idx, 1, 0], self._base[env_idx, 0, 0]) / 2.0
        zero = torch.zeros_like(turn)
        quaternion = torch.stack([torch.cos(turn), zero, zero, torch.sin(turn)], dim=-1)
        self.agent.robot.set_pose(Pose.create_from_pq(self._base[env_idx, :3, 3], quaternion))
        self.agent.reset(self._arm[env_idx])

    def progress(self) -> Any:
        """Return the mean progress of the stages to their goals, 0-1, shape (num_envs,)."""
        return torch.where(self._done, 1.0, self._shares()).mean(dim=1)

    def _shares(self) -> Any:
        position = self.asset.qpos.gather(1, self._joint)
        return ((position - self._start) / (self._goal - self._start)).clamp(0.0, 1.0)

    def evaluate(self) -> dict[str, Any]:
        """Return success and progress of each world; a stage can be done only after the earlier ones."""
        reached = (self._shares() >= 1.0) | (self._done & ~self._holds)
        self._done = reached.int().cumprod(dim=1).bool()
        return {"success": self._done.all(dim=1), "progress": self.progress()}

    def _get_obs_extra(self, info: Mapping[str, Any]) -> dict[str, Any]:
        return {"tip": self.agent.tcp.pose.raw_pose, "progress": info["progress"]}

    def compute_dense_reward(self, obs: Any, action: Any, info: Mapping[str, Any]) -> Any:
        """Return the progress."""
        return info["progress"]

    compute_normalized_dense_reward = compute_dense_reward


for _name in NAMES:
    register_env(f"Artgen{_name}-v1", max_episode_steps=_STEPS, task=_name)(ManiSkillTask)
