"""Many worlds of assets in one model of MuJoCo Warp.

Assets whose models share their structure (tree, joints, kinds of shapes and contact pairs) share one model.
Places, sizes, masses and meshes differ from world to world.
"""

from collections.abc import Hashable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from batched_maths import Goals, jacobians, rotations, torques

from artgen.batch import joined, structure
from artgen.envs.motion import Target
from artgen.envs.robot import LIMITS, OPENING, POSITION, PREFIX, ROTATION
from artgen.envs.scene import CAMERAS, SHUT, STEPS, STEPS_OF_TORQUES, TaskScene
from artgen.export.meshes import display_color

_CONTACTS, _CONSTRAINTS = 96, 384  # room in each world; MuJoCo Warp warns if there are more
# arrays of the state: those that are set, and those that are only read
_STATE = ("qpos", "qvel", "ctrl", "qacc_warmstart")
_FOUND = ("xpos", "xmat", "xaxis", "xanchor", "site_xpos", "site_xmat", "qfrc_bias", "M")
_SEEN_GROUPS, _ROBOT_COLOR = [2, 3], (0.85, 0.85, 0.86)  # surroundings and colliders
# places of bodies, shapes, sites, cameras and lights
_PLACES = (
    *("xpos", "xquat", "xmat", "xipos", "ximat", "geom_xpos", "geom_xmat", "site_xpos", "site_xmat"),
    *("cam_xpos", "cam_xmat", "light_xpos", "light_xdir"),
)


class Worlds:
    """Worlds that are stepped together; their assets share structure.

    Args:
        scenes: A scene of each asset, placed at the beginning of the task.
        models: The models that `structured` returned for them.
        targets: The stages of the task in each scene.
        of: Number of the scene of each world.

    Attributes:
        goals: The stages of the task in each world.
    """

    def __init__(
        self, scenes: Sequence[TaskScene], models: Sequence[Any], targets: Sequence[Target], of: Sequence[int]
    ) -> None:
        import mujoco_warp
        import warp

        self._engine, self._warp, first = mujoco_warp, warp, scenes[0]
        self._model = joined(first.model, models, of)
        self._data = mujoco_warp.make_data(first.model, nworld=len(of), nconmax=_CONTACTS, njmax=_CONSTRAINTS)
        self._graph: Any = None  # of CUDA, recorded at the first action
        self._scenes, self._drawn = scenes, _Drawn()
        device = "cuda" if self._data.qpos.device.is_cuda else "cpu"
        self.goals = Goals(scenes, targets, of, device)
        hand = first.control
        self._arm, self._dofs, self._motors, self._tip = hand.at, hand.dofs, hand.actuators, hand.tip
        self._joints = [
            first.model.jnt_qposadr.tolist().index(at) for at in range(hand.at.start, hand.at.stop)
        ]
        self._finger_at, self._fingers = first.finger_at.tolist(), first.fingers.tolist()
        self._of_arm = _block(first.model, hand.dofs)
        self._views = {name: warp.to_torch(getattr(self._data, name)) for name in (*_STATE, *_FOUND)}
        # MuJoCo Warp does not place the parts that do not move, and takes active constraints from one model
        for name in (*_PLACES, "eq_active"):
            array = getattr(self._data, name)
            values = np.stack([getattr(scenes[number].data, name) for number in of])
            array.assign(values.reshape(array.numpy().shape).astype(array.numpy().dtype))
        self._begin = {
            name: torch.as_tensor(
                np.stack([getattr(scenes[number].data, name) for number in of]), device=device
            ).float()
            for name in ("qpos", "qvel", "ctrl")
        }
        self._limits = torch.as_tensor(LIMITS, device=device)
        self._posture = self.goals.arm.clone()
        self._goal = torch.zeros_like(self.goals.base)
        self._goal_turn = torch.eye(3).to(self._goal).repeat(len(of), 1, 1)

    def begin(self, worlds: torch.Tensor, arms: torch.Tensor) -> None:
        """Set some worlds to the beginning of the task, at rest.

        Args:
            worlds: Their numbers, shape (n,).
            arms: Angles of the joints of each arm, shape (n, 7) [rad].
        """
        for name, values in self._begin.items():
            self._views[name][worlds] = values[worlds]
        self._views["qacc_warmstart"][worlds] = 0.0
        arms = arms.clamp(self._limits[:, 0], self._limits[:, 1])
        self._views["qpos"][worlds, self._arm] = arms.float()
        self.goals.begin(worlds)
        self._settle()
        self._engine.step1(self._model, self._data)
        self._posture[worlds] = arms
        seen = self.seen()
        self._goal[worlds], self._goal_turn[worlds] = seen["place"][worlds], seen["turn"][worlds]

    def act(self, actions: torch.Tensor) -> None:
        """Simulate one action of each robot, as `TaskScene.act` does, shape (n, 7)."""
        seen = self.seen()
        self._goal = seen["place"] + POSITION * actions[:, :3]
        self._goal_turn = rotations(ROTATION * actions[:, 3:6]) @ seen["turn"]
        opening = 0.5 * OPENING * (1.0 - actions[:, 6])
        wanted = torch.where(opening > SHUT, opening, -OPENING)
        self._views["ctrl"][:, self._fingers] = torch.stack([wanted, -wanted], dim=1).float()
        for number in range(STEPS // STEPS_OF_TORQUES):
            seen = self.seen() if number else seen
            found = torques(seen, self._goal, self._goal_turn, self._posture)
            self._views["ctrl"][:, self._motors] = found.float()
            self._settle()
            self._step()

    def _step(self) -> None:
        """Make the steps between two changes of the torques; one launch of a graph on a graphics card."""
        if self._graph is not None:
            self._warp.capture_launch(self._graph)
            return
        engine, model, data = self._engine, self._model, self._data
        recording = self._warp.ScopedCapture() if self._limits.is_cuda else nullcontext()
        with recording:
            engine.step2(model, data)
            for _ in range(STEPS_OF_TORQUES - 1):
                engine.step(model, data)
            engine.step1(model, data)
        if self._limits.is_cuda:  # recorded, not made
            self._graph = recording.graph
            self._warp.capture_launch(self._graph)

    def _settle(self) -> None:
        """Wait until PyTorch has written its values."""
        if self._limits.is_cuda:
            torch.cuda.synchronize()

    def seen(self) -> dict[str, torch.Tensor]:
        """Return the input of control and observation, in double precision."""
        self._warp.synchronize()  # PyTorch and Warp have queues of their own on a graphics card
        views = {name: view.double() for name, view in self._views.items()}
        tip, turn = views["site_xpos"][:, self._tip], views["site_xmat"][:, self._tip]
        axes, anchors = views["xaxis"][:, self._joints], views["xanchor"][:, self._joints]
        first, second = (views["qpos"][:, at] for at in self._finger_at)
        return views | {
            "place": tip,
            "turn": turn,
            "jacobian": jacobians(axes, anchors, tip),
            "inertia": views["M"][:, self._of_arm],
            "angles": views["qpos"][:, self._arm],
            "speeds": views["qvel"][:, self._dofs],
            "bias": views["qfrc_bias"][:, self._dofs],
            "opening": first - second,
        }

    def pictures(self, size: int) -> dict[str, torch.Tensor]:
        """Return a picture of each world from each of the `CAMERAS`, shape (n, size, size, 3), 0-1.

        They show colliders in the colors of their materials.
        """
        engine, model, data = self._engine, self._model, self._data
        if self._drawn.size != size:
            self._drawn = _Drawn.of(self._scenes, data.nworld, size)
        self._settle()
        engine.refit_bvh(model, data, self._drawn.context)
        engine.render(model, data, self._drawn.context)
        result = {}
        for number, name in enumerate(CAMERAS):
            colors = self._warp.zeros((data.nworld, size, size), dtype=self._warp.vec3)
            engine.get_rgb(self._drawn.context, number, colors)
            self._warp.synchronize()
            result[name] = self._warp.to_torch(colors)
        return result


@dataclass
class _Drawn:
    """The renderer of worlds, and the renderers whose surfaces it uses."""

    size: int = 0
    context: Any = None
    others: Sequence[Any] = ()

    @classmethod
    def of(cls, scenes: Sequence[TaskScene], worlds: int, size: int) -> "_Drawn":
        """Return the renderer of worlds whose meshes are those of all scenes, as in the joined model."""
        import mujoco_warp
        import warp

        contexts = [
            mujoco_warp.create_render_context(
                scene.model,
                nworld=worlds if scene is scenes[0] else 1,
                cam_res=(size, size),
                cam_active=list(CAMERAS.values()),
                render_rgb=True,
                render_depth=False,
                use_textures=False,
                enabled_geom_groups=_SEEN_GROUPS,
                enable_vertex_normals=False,
                enable_specular=False,
                background_color=(0.6, 0.6, 0.6, 1.0),
            )
            for scene in scenes
        ]
        first = contexts[0]
        for name in ("mesh_bvh_id", "mesh_bounds_size"):
            values = np.concatenate([getattr(each, name).numpy() for each in contexts])
            old = getattr(first, name)
            setattr(first, name, warp.array(values, dtype=old.dtype, device=old.device))
        return cls(size, first, contexts[1:])


def color(scene: TaskScene) -> None:
    """Give the colliders of a scene the colors of their materials."""
    model = scene.model
    for body in range(model.nbody):
        numbers = np.flatnonzero((model.geom_bodyid == body) & (model.geom_group == _SEEN_GROUPS[1]))
        name = model.body(body).name
        if name.startswith(PREFIX):
            model.geom_rgba[numbers, :3] = _ROBOT_COLOR
        elif len(numbers):
            for number, each in zip(numbers, scene.asset.link(name).colliders, strict=True):
                model.geom_rgba[number, :3] = display_color(each.material.base_color)


def structured(scene: TaskScene) -> tuple[Hashable, Any]:
    """Return the structure of a scene, which worlds that are stepped together share, and its model."""
    import mujoco_warp

    model = mujoco_warp.put_model(scene.model)
    # addresses of the robot, equal in all worlds
    hand = scene.control
    places = (
        hand.at.start,
        hand.dofs.start,
        hand.actuators.start,
        hand.tip,
        *scene.finger_at,
        *scene.fingers,
    )
    return (structure(model), *(int(place) for place in places)), model


def _block(model: Any, dofs: slice) -> list[list[int]]:
    """Return the addresses of the inertia of the arm in the sparse matrix, shape (7, 7)."""
    numbers = range(dofs.start, dofs.stop)
    where = {}
    for row in numbers:
        first = int(model.M_rowadr[row])
        for address in range(first, first + int(model.M_rownnz[row])):
            where[row, int(model.M_colind[address])] = address
    return [[where[max(row, column), min(row, column)] for column in numbers] for row in numbers]
