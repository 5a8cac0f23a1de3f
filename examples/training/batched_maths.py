"""The arm's control, the observation and the reward of `artgen.envs` for many worlds at once, in PyTorch."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import torch

from artgen.envs.env import ACTION, ALONG, DENSE, NEAR, STEEPNESS
from artgen.envs.motion import Target, tip_of
from artgen.envs.robot import DAMPING, OPENING, POSTURE, POSTURE_DAMPING, STIFFNESS
from artgen.envs.scene import TaskScene


def rotations(vectors: torch.Tensor) -> torch.Tensor:
    """Return the matrices of turns about vectors by their lengths, shape (n, 3, 3) [rad]."""
    return torch.matrix_exp(torch.linalg.cross(vectors[:, None], torch.eye(3).to(vectors)[None]).mT)


def jacobians(axes: torch.Tensor, anchors: torch.Tensor, tips: torch.Tensor) -> torch.Tensor:
    """Return how tips move and turn with the joints of their arms, shape (n, 6, 7)."""
    return torch.cat([torch.linalg.cross(axes, tips[:, None] - anchors), axes], dim=2).mT


def torques(
    state: dict[str, torch.Tensor], goal: torch.Tensor, goal_turn: torch.Tensor, posture: torch.Tensor
) -> torch.Tensor:
    """Return the torques of arms that bring their tips to their goals, as `Control` does, shape (n, 7).

    Args:
        state: `jacobian` (n, 6, 7), `inertia` (n, 7, 7), `angles`, `speeds` and `bias` (n, 7), and the tip's
            `place` (n, 3) and `turn` (n, 3, 3).
        goal: Where the tips should be, shape (n, 3) [m].
        goal_turn: How they should be turned, shape (n, 3, 3).
        posture: Angles that the arms keep as far as the tips leave them free, shape (n, 7) [rad].
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
    progress: torch.Tensor, distance: torch.Tensor, action: torch.Tensor, steps: int, *, done: torch.Tensor
) -> torch.Tensor:
    """Return the rewards of steps of a task with one stage, without the bonus for success, shape (n,).

    Args:
        progress: Share of the way to the goal, 0-1, shape (n,).
        distance: From tip to handle, shape (n,) [m].
        action: What was done, within -1 and 1, shape (n, 7).
        steps: How many steps an episode has.
        done: Whether the goal is reached, shape (n,).
    """
    near = NEAR * (1.0 - torch.tanh(STEEPNESS * distance)) + ALONG * progress
    worth = torch.where(done, torch.ones_like(near), near)
    return DENSE / steps * (worth - ACTION * (action**2).mean(dim=1))


def _solve(matrix: torch.Tensor, right: torch.Tensor) -> torch.Tensor:
    """Solve systems; one without a solution, in a world that left the rails, stops no other."""
    return torch.linalg.solve_ex(matrix, right)[0]


class Goals:
    """What tasks of one stage mean in each world, as tensors whose first dimension is the world.

    Args:
        scenes: The scene of each asset, placed.
        targets: What has to be done in it.
        of: Which of them each world has.
        device: PyTorch's device.
    """

    def __init__(
        self, scenes: Sequence[TaskScene], targets: Sequence[Target], of: Sequence[int], device: str
    ) -> None:
        def tensor(values: Sequence[Any], kind: torch.dtype = torch.float64) -> torch.Tensor:
            return torch.as_tensor(np.array([values[number] for number in of]), dtype=kind, device=device)

        stages = [target.stages[0] for target in targets]
        joints = [scene.model.joint(stage.joint) for scene, stage in zip(scenes, stages, strict=True)]
        links = [stage.affordance.link for stage in stages]
        both = list(zip(scenes, links, strict=True))
        whole = torch.int64
        self.joint = tensor([int(joint.id) for joint in joints], whole)
        self.at = tensor([int(joint.qposadr[0]) for joint in joints], whole)
        self.dof = tensor([int(joint.dofadr[0]) for joint in joints], whole)
        self.body = tensor([int(scene.model.body(link).id) for scene, link in both], whole)
        self.slides = tensor(
            [
                scene.asset.joint(stage.joint).kind == "prismatic"
                for scene, stage in zip(scenes, stages, strict=True)
            ],
            torch.bool,
        )
        self.rest = tensor([scene.asset.origin(link) for scene, link in both])
        self.frame = tensor([tip_of(stage.affordance) for stage in stages])
        self.start = tensor([stage.start for stage in stages])
        self.goal = tensor([stage.goal for stage in stages])
        self.grasp = tensor([stage.affordance.kind == "grasp" for stage in stages])
        self.holds = tensor([stage.holds for stage in stages], torch.bool)
        self.base = tensor([target.base[:3, 3] for target in targets])
        self.arm = tensor([target.arm for target in targets])
        self.toward = torch.sign(self.goal - self.start)
        self.worlds = torch.arange(len(of), device=device)

    def progress(self, position: torch.Tensor) -> torch.Tensor:
        """Return the share of the way to the goal, 0-1, shape (n,)."""
        return ((position - self.start) / (self.goal - self.start)).clamp(0.0, 1.0)

    def reached(self, position: torch.Tensor) -> torch.Tensor:
        """Tell whether positions are the goal or beyond it, shape (n,)."""
        return self.toward * (position - self.goal) >= 0.0

    def observe(self, seen: dict[str, torch.Tensor]) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Return the observation (n, 47), the joint's position (n,) and the way from tip to handle (n,) [m].

        Args:
            seen: What `Worlds.seen` returns.
        """
        worlds = self.worlds
        position, speed = seen["qpos"][worlds, self.at], seen["qvel"][worlds, self.dof]
        turn = seen["xmat"][worlds, self.body]
        local = self.frame[:, :3, 3] - self.rest  # a link is displaced from rest about its frame's origin
        place = seen["xpos"][worlds, self.body] + (turn @ local[..., None])[..., 0]
        axes = turn @ self.frame[:, :3, :3]
        tip, tip_turn = seen["place"], seen["turn"]
        axis = seen["xaxis"][worlds, self.joint]
        about = torch.linalg.cross(axis, place - seen["xanchor"][worlds, self.joint])
        way = self.toward[:, None] * torch.where(self.slides[:, None], axis, about)
        apart = torch.linalg.norm(place - tip, dim=1)
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
            self.progress(position)[:, None],
            (self.toward * (self.goal - position))[:, None],
            (self.toward * speed)[:, None],
            self.grasp[:, None],
            torch.zeros_like(position)[:, None],
        ]
        return torch.cat(numbers, dim=1).float(), position, apart
