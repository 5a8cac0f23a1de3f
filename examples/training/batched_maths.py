"""Control of the arm, observation and reward of `artgen.envs` for many worlds at once, in PyTorch."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import torch

from artgen.envs.env import ACTION, ALONG, DENSE, NEAR, STEEPNESS
from artgen.envs.motion import Stage, Target, tip_of
from artgen.envs.robot import DAMPING, OPENING, POSTURE, POSTURE_DAMPING, STIFFNESS
from artgen.envs.scene import TaskScene


def rotations(vectors: torch.Tensor) -> torch.Tensor:
    """Return the matrices of rotations by rotation vectors, shape (n, 3, 3) [rad]."""
    return torch.matrix_exp(torch.linalg.cross(vectors[:, None], torch.eye(3).to(vectors)[None]).mT)


def jacobians(axes: torch.Tensor, anchors: torch.Tensor, tips: torch.Tensor) -> torch.Tensor:
    """Return the Jacobians of the tips of arms, shape (n, 6, 7)."""
    return torch.cat([torch.linalg.cross(axes, tips[:, None] - anchors), axes], dim=2).mT


def torques(
    state: dict[str, torch.Tensor], goal: torch.Tensor, goal_turn: torch.Tensor, posture: torch.Tensor
) -> torch.Tensor:
    """Return the torques of `Control`, which bring tips to their goals, shape (n, 7).

    Args:
        state: `jacobian` (n, 6, 7), `inertia` (n, 7, 7), `angles`, `speeds` and `bias` (n, 7), and the tip's
            `place` (n, 3) and `turn` (n, 3, 3).
        goal: Goals of the tips, shape (n, 3) [m].
        goal_turn: Orientations of the goals, shape (n, 3, 3).
        posture: Angles of the arms for the null space of the tips, shape (n, 7) [rad].
    """
    jacobian, inertia, speeds = state["jacobian"], state["inertia"], state["speeds"][..., None]
    turn = goal_turn @ state["turn"].mT
    between = 0.5 * torch.stack(
        [turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0], turn[:, 1, 0] - turn[:, 0, 1]], dim=1
    )
    error = torch.cat([goal - state["place"], between], dim=1)[..., None]
    wanted = STIFFNESS * error - DAMPING * (jacobian @ speeds)
    yields = jacobian @ _solve(inertia, jacobian.mT)
    keep = POSTURE * (posture - state["angles"])[..., None] - POSTURE_DAMPING * speeds
    wrench = -_solve(yields, jacobian @ keep)
    wrench[:, :3] += _solve(yields[:, :3, :3], wanted[:, :3])
    wrench[:, 3:] += _solve(yields[:, 3:, 3:], wanted[:, 3:])
    return (jacobian.mT @ wrench + inertia @ keep)[..., 0] + state["bias"]


def rewarded(
    stage: torch.Tensor,
    count: torch.Tensor,
    progress: torch.Tensor,
    distance: torch.Tensor,
    action: torch.Tensor,
    steps: int,
    *,
    done: torch.Tensor,
) -> torch.Tensor:
    """Return the rewards of steps without the bonus for success, shape (n,).

    Args:
        stage: Number of the current stage, shape (n,).
        count: Number of stages, shape (n,).
        progress: Progress of the joint of the current stage, 0-1, shape (n,).
        distance: Distance from the tip to the handle, shape (n,) [m].
        action: Actions within -1 and 1, shape (n, 7).
        steps: Number of steps of an episode.
        done: Whether all stages are done, shape (n,).
    """
    near = NEAR * (1.0 - torch.tanh(STEEPNESS * distance)) + ALONG * progress
    value = torch.where(done, torch.ones_like(near), (stage + near) / count)
    return DENSE / steps * (value - ACTION * (action**2).mean(dim=1))


def _solve(matrix: torch.Tensor, right: torch.Tensor) -> torch.Tensor:
    """Solve systems; one without a solution, in an unstable world, does not stop the others."""
    return torch.linalg.solve_ex(matrix, right)[0]


class Goals:
    """The stages of a task in each world, as tensors of shape (worlds, stages, ...).

    Worlds with fewer stages repeat their last one.

    Args:
        scenes: The scene of each asset, placed.
        targets: The stages of the task in each scene.
        of: Number of the scene of each world.
        device: PyTorch's device.
    """

    def __init__(
        self, scenes: Sequence[TaskScene], targets: Sequence[Target], of: Sequence[int], device: str
    ) -> None:
        def tensor(values: Sequence[Any], kind: torch.dtype = torch.float64) -> torch.Tensor:
            return torch.as_tensor(np.array([values[number] for number in of]), dtype=kind, device=device)

        most = max(len(target.stages) for target in targets)

        def staged(
            number: Callable[[TaskScene, Stage], Any], kind: torch.dtype = torch.float64
        ) -> torch.Tensor:
            values = [
                [number(scene, stage) for stage in target.stages]
                for scene, target in zip(scenes, targets, strict=True)
            ]
            return tensor([each + each[-1:] * (most - len(each)) for each in values], kind)

        whole = torch.int64
        self.joint = staged(lambda scene, stage: scene.model.joint(stage.joint).id, whole)
        self.at = staged(lambda scene, stage: int(scene.model.joint(stage.joint).qposadr[0]), whole)
        self.dof = staged(lambda scene, stage: int(scene.model.joint(stage.joint).dofadr[0]), whole)
        self.body = staged(lambda scene, stage: scene.model.body(stage.affordance.link).id, whole)
        self.slides = staged(
            lambda scene, stage: scene.asset.joint(stage.joint).kind == "prismatic", torch.bool
        )
        self.origin = staged(lambda scene, stage: scene.asset.origin(stage.affordance.link))
        self.frame = staged(lambda _, stage: tip_of(stage.affordance))
        self.start = staged(lambda _, stage: stage.start)
        self.goal = staged(lambda _, stage: stage.goal)
        self.grasp = staged(lambda _, stage: stage.affordance.kind == "grasp")
        self.holds = staged(lambda _, stage: stage.holds, torch.bool)
        self.base = tensor([target.base[:3, 3] for target in targets])
        self.arm = tensor([target.arm for target in targets])
        self.count = tensor([len(target.stages) for target in targets], whole)
        self.toward = torch.sign(self.goal - self.start)
        self.worlds = torch.arange(len(of), device=device)
        self.done = torch.zeros_like(self.holds)

    def begin(self, worlds: torch.Tensor) -> None:
        """Begin the first stage again in worlds of these numbers, shape (n,)."""
        self.done[worlds] = False

    def update(self, qpos: torch.Tensor) -> torch.Tensor:
        """Note the stages that are done at positions of all joints; return the progress of each, 0-1."""
        position = qpos[self.worlds[:, None], self.at]
        now = (self.toward * (position - self.goal) >= 0.0) | (self.done & ~self.holds)
        self.done = now.cumprod(dim=1).bool()  # a stage can be done only after the earlier ones
        return ((position - self.start) / (self.goal - self.start)).clamp(0.0, 1.0)

    @property
    def stage(self) -> torch.Tensor:
        """Number of the current stage, or of the last one if all are done, shape (n,)."""
        return torch.minimum(self.done.sum(dim=1), self.count - 1)

    def observe(self, seen: dict[str, torch.Tensor]) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Update the stages; return observations, progress of the stages, and distances to the handles.

        Their shapes are (n, 47), (n, stages) and (n,) [m].

        Args:
            seen: The result of `Worlds.seen`.
        """
        progress = self.update(seen["qpos"])
        now = self.worlds, self.stage
        position, speed = seen["qpos"][self.worlds, self.at[now]], seen["qvel"][self.worlds, self.dof[now]]
        turn, frame, toward = seen["xmat"][self.worlds, self.body[now]], self.frame[now], self.toward[now]
        local = frame[:, :3, 3] - self.origin[now]  # in the frame of the link
        place = seen["xpos"][self.worlds, self.body[now]] + (turn @ local[..., None])[..., 0]
        axes = turn @ frame[:, :3, :3]
        tip, tip_turn = seen["place"], seen["turn"]
        axis = seen["xaxis"][self.worlds, self.joint[now]]
        about = torch.linalg.cross(axis, place - seen["xanchor"][self.worlds, self.joint[now]])
        way = toward[:, None] * torch.where(self.slides[now][:, None], axis, about)
        distance = torch.linalg.norm(place - tip, dim=1)
        numbers = [
            seen["angles"],
            0.5 * seen["speeds"],
            tip - self.base,
            tip_turn[:, :, 0],
            tip_turn[:, :, 2],
            0.5 * (seen["jacobian"] @ seen["speeds"][..., None])[..., 0],
            seen["opening"][:, None] / (2.0 * OPENING),
            place - tip,
            axes[:, :, 0],
            axes[:, :, 2],
            way / torch.linalg.norm(way, dim=1, keepdim=True).clamp(min=1e-9),
            progress[now][:, None],
            (toward * (self.goal[now] - position))[:, None],
            (toward * speed)[:, None],
            self.grasp[now][:, None],
            (self.stage / self.count)[:, None],
        ]
        return torch.cat(numbers, dim=1).float(), progress, distance
