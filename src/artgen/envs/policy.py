"""A scripted policy: it approaches each contact, and follows the true arc or line of the moved link."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.envs.motion import OPEN, Contact, Move, lifted, rotation_vector
from artgen.envs.robot import POSITION, ROTATION

if TYPE_CHECKING:
    import gymnasium

_NEAR, _AT = 0.015, 0.004  # accuracy of intermediate poses and of contacts [m]
_TURN_MATTERS = 0.05  # distance equivalent to a rotation of 1 rad [m]
_SLOW = 0.4  # speed of an approach, over the full speed
_CLOSING = 10  # actions for closing the fingers
_OPENING = 6  # actions for opening them
_LEAD = (0.02, 0.10)  # least and largest distance of the aim ahead of the hand [m]
_MORE = 0.004  # growth of that distance with each action without progress [m]
_STUCK = 60  # actions without progress before the hand grasps again
_IDLE, _NEARER = 8, 0.001  # actions in which the hand has to approach by this distance [m]
_TAKEN = 3  # attempts at one contact

Aim = tuple[Array, float]  # a pose of the tip, and an opening of the fingers, negative to squeeze [m]


class ScriptedPolicy:
    """Performs the task of an environment with the true positions of joints and the true frames of grasps.

    It starts again after each reset of the environment.

    Args:
        env: A `ManipulationEnv`, wrapped or not.
    """

    def __init__(self, env: "gymnasium.Env[Any, Any]") -> None:
        self._env: Any = env.unwrapped
        self._time = np.inf
        self._script: Iterator[Aim] = iter(())
        self._last: Aim | None = None
        self._opening = OPEN
        self._held: dict[str, float] = {}  # positions of joints that the hand still holds
        self._ahead: dict[str, float] = {}  # offsets of the aim for these joints
        self.done = False  # whether it has finished and released the asset

    def action(self, observation: object = None) -> NDArray[np.float32]:
        """Return the next action, shape (7,); the observation is not used."""
        del observation
        now = self._env.data.time
        if now < self._time:  # there was a reset
            self._script, self._last, self.done = self._run(), None, False
        self._time = now
        try:
            self._last = next(self._script)
        except StopIteration:
            self.done = True
        pose, opening = self._last or (self._env.tip(), OPEN)
        return action_towards(self._env.tip(), pose, opening)

    def _run(self) -> Iterator[Aim]:
        """Yield aims until all moves are done, each from the current state of the environment."""
        contact: Contact | None = None
        for move in self._env.target.moves:
            for _ in range(_TAKEN if move.contact is not None else 1):
                if move.contact is not None:
                    if contact is not None:
                        yield from self._leave(contact)
                    contact = move.contact
                    yield from self._take(contact)
                assert contact is not None, "the first move has a contact"
                yield from self._follow(move, contact)
                stage = next(each for each in self._env.target.stages if move in each.moves)
                end = move.until if move is not stage.moves[-1] else stage.goal
                if (self._env.q(move.joint) - end) * np.sign(stage.goal - stage.start) >= -1e-3:
                    break
            self._held[move.joint] = move.until
        if contact is not None:
            yield from self._leave(contact)

    def _take(self, contact: Contact) -> Iterator[Aim]:
        """Approach a contact, and close the fingers if it is a grasp."""
        self._held.clear()
        self._ahead.clear()
        self._opening = contact.width
        for pose in contact.through:
            yield from self._go(pose, _NEAR)
        place = self._env.scene.pose(contact.link) @ contact.frame
        yield from self._go(lifted(place, -contact.back), _AT)
        yield from self._go(place, _AT, _SLOW)
        if contact.kind == "grasp":
            self._opening = -OPEN
            for _ in range(_CLOSING):
                yield place, self._opening

    def _leave(self, contact: Contact) -> Iterator[Aim]:
        """Open the fingers and retreat along the approach."""
        here = self._env.tip()
        self._opening = contact.width
        if contact.kind == "grasp":
            for _ in range(_OPENING):
                yield here, self._opening
        yield from self._go(lifted(here, -contact.back), _NEAR)

    def _go(self, pose: Array, near: float, speed: float = 1.0) -> Iterator[Aim]:
        """Move straight to a pose, until the hand is near it or stops approaching."""
        best, idle = np.inf, 0
        while idle < _IDLE:
            tip = self._env.tip()
            shift = pose[:3, 3] - tip[:3, 3]
            apart = float(np.linalg.norm(shift))
            turn = rotation_vector(pose[:3, :3] @ tip[:3, :3].T)
            missing = apart + _TURN_MATTERS * float(np.linalg.norm(turn))
            if missing < near:
                return
            best, idle = (missing, 0) if missing < best - _NEARER else (best, idle + 1)
            aim = pose.copy()
            aim[:3, 3] = tip[:3, 3] + shift * min(1.0, speed * POSITION / max(apart, 1e-9))
            yield aim, self._opening

    def _follow(self, move: Move, contact: Contact) -> Iterator[Aim]:
        """Bring a joint to its release position; the hand follows the path of its link."""
        scene, joint = self._env.scene, self._env.asset.joint(move.joint)
        held = contact.frame
        if contact.kind == "grasp":
            held = np.linalg.inv(scene.pose(contact.link)) @ scene.tip()
        direction = np.sign(move.until - scene.q(move.joint)) or 1.0
        lead, best, idle = _LEAD[0], scene.q(move.joint), 0
        while direction * (move.until - scene.q(move.joint)) > 0.0 and idle < _STUCK:
            q, arm = scene.q(move.joint), 1.0
            if joint.kind == "revolute":  # the distance that the hand moves per unit of the joint [m/rad]
                apart = (scene.pose(contact.link) @ held)[:3, 3] - joint.pivot
                arm = max(0.03, float(np.linalg.norm(apart - joint.axis * (apart @ joint.axis))))
            if direction * (q - best) > 1e-3 / arm:
                best, idle = q, 0
            else:
                idle += 1
                lead = min(lead + _MORE, _LEAD[1])
            yield self._pose_ahead(contact.link, joint.name, q + direction * lead / arm) @ held, self._opening

    def _pose_ahead(self, link: str, moved: str, position: float) -> Array:
        """Return the displacement of a link with one joint moved and held joints kept, shape (4, 4)."""
        result = np.eye(4)
        above = {child: (parent, joints) for parent, child, joints in self._env.asset.pairs()}
        while link in above:
            link, joints = above[link]
            motion = np.eye(4)
            for joint in joints:
                q = position if joint.name == moved else self._held_aim(joint.name)
                motion = motion @ joint.motion(q)
            result = motion @ result
        return result

    def _held_aim(self, joint: str) -> float:
        """Return the position of a joint, or the aim that keeps a held joint at its position."""
        q = float(self._env.q(joint))
        if joint not in self._held:
            return q
        ahead = self._ahead.get(joint, 0.0) + 0.1 * (self._held[joint] - q)
        self._ahead[joint] = float(np.clip(ahead, -0.6, 0.6))
        return self._held[joint] + self._ahead[joint]


def action_towards(tip: Array, pose: Array, opening: float) -> NDArray[np.float32]:
    """Return the action that moves the tip towards a pose, with an opening of the fingers [m], shape (7,)."""
    result = np.empty(7)
    shift = (pose[:3, 3] - tip[:3, 3]) / POSITION
    turn = rotation_vector(pose[:3, :3] @ tip[:3, :3].T) / ROTATION
    result[:3] = shift * min(1.0, 1.0 / max(float(np.linalg.norm(shift)), 1e-9))
    result[3:6] = turn * min(1.0, 1.0 / max(float(np.linalg.norm(turn)), 1e-9))
    result[6] = 1.0 - 2.0 * opening / OPEN
    return np.clip(result, -1.0, 1.0).astype(np.float32)
