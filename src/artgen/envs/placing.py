"""Places of the robot and orientations of its hand from which a whole task is within reach."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice, product

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices
from artgen.asset import Asset
from artgen.asset.affordance import GRIPPER
from artgen.colliders import Convex
from artgen.envs.motion import Contact, Move, Stage, Target, between, lifted, turned
from artgen.envs.robot import BALL_JOINTS, BALL_PLACES, BALL_RADII, HOME, LIMITS, frames, reach

Flags = NDArray[np.bool_]

_STEPS = 6  # poses along the motion of a joint
_BASES = 16  # places of the base that are tried at once
_ROUNDS = 4
_BATCH = 4  # paths of the hand that are compared
_GOOD = 0.4  # score at which the search ends
_POSTURES = 2  # initial postures of the arm at each base
_DISTANCES = (0.40, 0.50, 0.60, 0.70)  # distance from the contact to the base [m]
# directions of the base [rad]
_ANGLES = np.radians([0.0, 20.0, -20.0, 40.0, -40.0, 60.0, -60.0, 85.0, -85.0])
_ABOVE = (0.15, 0.30, 0.45, 0.60)  # height of the hand over the base [m]
_STEP = 0.05  # least height of a table above the base next to it [m]
_FOOT = 0.16  # half the width of the pedestal [m]
MISS = 2e-3  # largest error of the tip [m]
_MOST_COMBINED, _COMBINED = 5000, 24  # combinations that are sorted, and that are tried
_APART = (0.15, 0.4)  # largest step between poses of the tip [m], [rad]
JUMP = 1.0  # largest change of an angle between poses [rad]
_TILTS = np.radians([0.0, 25.0, -25.0, 45.0, -45.0, 60.0, -60.0])
_JITTER = 0.02  # distances of the hand at reset [m]
_ROOM = 0.004  # clearance of the hand [m]
_FARTHER = (0.03, 0.08)  # distance of the reset pose beyond the start of the approach [m]
_TABLE = 1.0  # height of a table, more than a robot reaches down [m]
_GRAZE = 0.001  # gap between the table and the asset [m]
_UNIT = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)

# corners of the box behind the fingers, in the frame of the tip, shape (2, 3) [m]
HAND_BOX = np.array([[-0.5, -0.5, -1.0], [0.5, 0.5, 0.0]]) * GRIPPER.hand
HAND_BOX[:, 2] += GRIPPER.tip - GRIPPER.long


class Obstacles:
    """An asset as obstacles: each collider as an oriented box that moves with its link."""

    def __init__(self, asset: Asset, *, raised: bool = False) -> None:
        self.asset, self.raised = asset, raised  # raised: it stands on a table of its own size
        low, high = asset.bounds()
        self.floor = float(low[2]) - (_TABLE if raised else 0.0)  # height of the floor [m]
        solid = [(number, each) for number, link in enumerate(asset.links) for each in link.colliders]
        self.ground = np.array([[-np.inf] * 3, [np.inf] * 3])  # box in which a robot stands, shape (2, 3) [m]
        if asset.is_room:  # it stands on the floor, which is no obstacle
            floors = [each.convex.bounds() for each in asset.links[0].colliders if each.label == "floor"]
            self.ground[:, :2] = np.min(floors, axis=0)[0, :2], np.max(floors, axis=0)[1, :2]
            self.floor = float(np.max(floors, axis=0)[1, 2])
            solid = [(number, each) for number, each in solid if number or each.label != "floor"]
        pieces = [(number, each.convex) for number, each in solid]
        if raised:
            table = np.eye(4)
            table[:3, 3] = [*(low + high)[:2] / 2.0, self.floor + _TABLE / 2.0 - _GRAZE]
            pieces.append((0, Convex.box(np.array([*(high - low)[:2], _TABLE]), table)))
        boxes = [_box(convex) for _, convex in pieces]
        corners = [
            convex.points if convex.kind == "hull" else (_UNIT * half) @ frame[:3, :3].T + frame[:3, 3]
            for (_, convex), (frame, half) in zip(pieces, boxes, strict=True)
        ]
        self._links = np.array([number for number, _ in pieces])
        self._frames, self._halves = (np.array(each) for each in zip(*boxes, strict=True))
        self._corners = np.concatenate(corners)
        self._piece = np.repeat(np.arange(len(corners)), [len(each) for each in corners])
        self._first = np.searchsorted(self._piece, np.arange(len(corners)))

    def depth(self, points: Array, pose: Mapping[str, Array]) -> Array:
        """Return the depth of points, shape (n, 3), in the asset, negative outside, shape (n,) [m]."""
        boxes = self._placed(pose)
        local = (points[None] - boxes[:, None, :3, 3]) @ boxes[:, :3, :3]
        return np.asarray((self._halves[:, None] - np.abs(local)).min(axis=2).max(axis=0))

    def touch(self, corners: Array, frame: Array, pose: Mapping[str, Array]) -> bool:
        """Tell whether a box with opposite corners in a frame, shape (2, 3) [m], overlaps the asset."""
        own, half = frame[:3, :3], (corners[1] - corners[0]) / 2.0
        middle = own @ corners.mean(axis=0) + frame[:3, 3]
        # extents of the pieces along the axes of the frame
        moved, at = self._moved(pose)[self._piece], middle @ own
        points = (np.einsum("nij,nj->ni", moved[:, :3, :3], self._corners) + moved[:, :3, 3]) @ own
        low = np.minimum.reduceat(points, self._first)
        high = np.maximum.reduceat(points, self._first)
        near = ((low <= at + half) & (high >= at - half)).all(axis=1)
        chosen = np.flatnonzero(near)
        if not len(chosen):
            return False
        boxes, halves = self._placed(pose)[chosen], self._halves[chosen]
        turn = own.T @ boxes[:, :3, :3]  # axes of the boxes in the frame, (n, 3, 3)
        apart = (boxes[:, :3, 3] - middle) @ own
        sides = turn.swapaxes(1, 2)
        edges = np.cross(np.eye(3)[:, None], sides[:, None]).reshape(-1, 9, 3)
        axes = np.concatenate([np.broadcast_to(np.eye(3), sides.shape), sides, edges], axis=1)
        reach = np.abs(axes) @ half + np.einsum("nij,nj->ni", np.abs(axes @ turn), halves)
        between = np.abs(np.einsum("nij,nj->ni", axes, apart))
        return bool((between <= reach + 1e-9).all(axis=1).any())

    def spans(self, pose: Mapping[str, Array]) -> Array:
        """Return the bounding boxes of all pieces in asset coordinates, shape (n, 2, 3) [m]."""
        boxes = self._placed(pose)
        reach = np.einsum("nij,nj->ni", np.abs(boxes[:, :3, :3]), self._halves)
        return np.stack([boxes[:, :3, 3] - reach, boxes[:, :3, 3] + reach], axis=1)

    def _placed(self, pose: Mapping[str, Array]) -> Array:
        """Return the poses of the boxes, shape (n, 4, 4)."""
        return np.asarray(self._moved(pose) @ self._frames)

    def _moved(self, pose: Mapping[str, Array]) -> Array:
        """Return the displacement of each box from rest, shape (n, 4, 4)."""
        return np.asarray(np.array([pose[link.name] for link in self.asset.links])[self._links])


@dataclass(frozen=True, eq=False)
class _Path:
    """A path of the hand."""

    moves: tuple[Move, ...]
    tips: Array  # poses of the tip, shape (n, 4, 4)
    poses: list[dict[str, Array]]  # displacement of each link at each pose of the tip


def place(
    asset: Asset, stages: Sequence[Stage], rng: np.random.Generator, *, raised: bool = False
) -> Target | None:
    """Return a target with a place for the robot; None if there is no place.

    The hand is rotated about its approach, and tilted if it would collide; bases are tried around the contact
    at several distances and heights. The result is the base farthest from singular postures, among those from
    which the arm follows the whole path within its limits and without collision. A raised asset stands on a
    table, and the robot stands next to it. Joints begin closed.
    """
    obstacles = Obstacles(asset, raised=raised)
    options = [
        list(_variants(obstacles, move, stages)) if move.contact else [move]
        for stage in stages
        for move in stage.moves
    ]
    numbers = product(*(range(len(each)) for each in options))
    preferred = sorted(islice(numbers, _MOST_COMBINED), key=sum)[:_COMBINED]
    combined = [tuple(each[index] for each, index in zip(options, some, strict=True)) for some in preferred]
    paths = [_path(obstacles, moves, rng) for moves in combined]
    best, most = None, 0.0
    for path, bases in _trials(obstacles, paths, rng):
        for score, base, arm in _followed(obstacles, path, bases, rng):
            if score > most:
                moves, most = iter(path.moves), score
                moved = (replace(stage, moves=tuple(next(moves) for _ in stage.moves)) for stage in stages)
                best = Target(tuple(moved), {}, base, arm, base @ frames(arm[None])[0, 7])
        if most > _GOOD:
            break
    return best


def _trials(
    obstacles: Obstacles, paths: Sequence[_Path], rng: np.random.Generator
) -> Iterator[tuple[_Path, Array]]:
    """Yield paths of the hand with bases to try them from, few at a time."""
    for first in range(0, len(paths), _BATCH):
        some = [(path, _bases(obstacles, path, rng)) for path in paths[first : first + _BATCH]]
        for begin in range(0, _ROUNDS * _BASES, _BASES):
            yield from ((path, bases[begin : begin + _BASES]) for path, bases in some if len(bases) > begin)


def orientations(contact: Contact) -> Iterator[Array]:
    """Yield frames of a contact, rotated about its approach and tilted, the least tilted first."""
    grasp = contact.kind == "grasp"
    rolls = (0.0, np.pi) if grasp else (0.0, np.pi / 2, np.pi, -np.pi / 2)
    for tilt in _TILTS:
        for axis in (0,) if grasp or not tilt else (0, 1):
            for roll in rolls:
                yield turned(turned(contact.frame, 2, roll), axis, tilt)


def _variants(obstacles: Obstacles, move: Move, stages: Sequence[Stage]) -> Iterator[Move]:
    """Yield variants of a move with the hand turned and without collision, the least tilted first."""
    assert move.contact is not None
    moves = [each for stage in stages for each in stage.moves]
    before = {each.joint: each.until for each in moves[: moves.index(move)]}
    for frame in orientations(move.contact):
        turn = replace(move.contact, frame=frame)
        if _free(obstacles, turn, before, move):
            yield replace(move, contact=turn)


def _free(obstacles: Obstacles, contact: Contact, q: dict[str, float], move: Move) -> bool:
    """Tell whether the hand collides neither in its approach nor in the motion of the joint."""
    asset, hand = obstacles.asset, HAND_BOX + np.array([[-_ROOM], [_ROOM]])
    start = q.get(move.joint, asset.joint(move.joint).closed)
    for share, back in ((0.0, contact.back), (0.0, 0.0), (0.5, 0.0), (1.0, 0.0)):
        pose = asset.pose({**q, move.joint: start + share * (move.until - start)})
        tip = lifted(pose[contact.link] @ contact.frame, -back)
        lowest = tip[2, 3] + np.minimum(hand[0] * tip[2, :3], hand[1] * tip[2, :3]).sum()
        if lowest < obstacles.floor or obstacles.touch(hand, tip, pose):
            return False
    return True


def _path(obstacles: Obstacles, moves: tuple[Move, ...], rng: np.random.Generator) -> _Path:
    """Return the path of the hand through all moves."""
    asset = obstacles.asset
    tips: list[Array] = []
    poses: list[dict[str, Array]] = []

    def add(tip: Array, pose: dict[str, Array]) -> None:
        path = [*between(tips[-1], tip, *_APART), tip] if tips else [tip]
        tips.extend(path)
        poses.extend([pose] * len(path))

    q: dict[str, float] = {}
    contact: Contact | None = None
    for move in moves:
        pose = asset.pose(q)
        if move.contact is not None:
            if contact is not None:
                add(lifted(pose[contact.link] @ contact.frame, -contact.back), pose)
            contact = move.contact
            for through in contact.through:
                add(through, pose)
            before = lifted(pose[contact.link] @ contact.frame, -contact.back)
            if not tips:
                away = lifted(before, -rng.uniform(*_FARTHER))
                away[:3, 3] += rng.uniform(-_JITTER, _JITTER, 3)
                add(away, pose)
            add(before, pose)
        assert contact is not None, "the first move has a contact"
        begin = q.get(move.joint, asset.joint(move.joint).closed)
        for share in np.linspace(0.0, 1.0, _STEPS):
            q[move.joint] = begin + share * (move.until - begin)
            pose = asset.pose(q)
            add(pose[contact.link] @ contact.frame, pose)
    return _Path(moves, np.array(tips), poses)


def _bases(obstacles: Obstacles, path: _Path, rng: np.random.Generator) -> Array:
    """Return free bases around a path in random order, shape (n, 4, 4)."""
    middle = (path.tips[:, :3, 3].min(axis=0) + path.tips[:, :3, 3].max(axis=0)) / 2.0
    approach = path.tips[:, :2, 2].mean(axis=0)
    away = -approach if np.linalg.norm(approach) > 0.3 else np.array([0.0, -1.0])
    heading = np.arctan2(away[1], away[0])
    spans = np.concatenate([obstacles.spans(pose) for pose in path.poses])
    most = float(obstacles.asset.bounds()[0, 2]) - _STEP if obstacles.raised else np.inf
    lowest = obstacles.floor
    heights = sorted({round(min(max(lowest, middle[2] - above), most), 3) + 0.0 for above in _ABOVE})
    result = []
    for angle, distance, height in product(heading + _ANGLES, _DISTANCES, heights):
        away = distance * np.array([np.cos(angle), np.sin(angle)])
        place = np.array([*(middle[:2] + away), height])
        low, high = place - (_FOOT, _FOOT, 10.0), place + (_FOOT, _FOOT, 0.35)
        foot = np.array([low, high])[:, :2]
        inside = (foot[0] >= obstacles.ground[0, :2]).all() and (foot[1] <= obstacles.ground[1, :2]).all()
        if inside and not ((spans[:, 0] < high) & (spans[:, 1] > low)).all(axis=1).any():
            base = np.eye(4)
            sine, cosine = np.sin(angle + np.pi), np.cos(angle + np.pi)
            base[:2, :2] = [[cosine, -sine], [sine, cosine]]
            base[:3, 3] = place
            result.append(base)
    return np.array(result)[rng.permutation(len(result))] if result else np.zeros((0, 4, 4))


def _followed(
    obstacles: Obstacles, path: _Path, bases: Array, rng: np.random.Generator
) -> list[tuple[float, Array, Array]]:
    """Return score, base and initial angles for each base from which the arm follows a path."""
    inverse = np.linalg.inv(bases)
    angles, which = starts(inverse @ path.tips[0], rng, (12, 0.1))
    score = ease(angles)
    order = np.argsort(-score, kind="stable")  # the `_POSTURES` best postures of each base
    chosen = [index for base in np.unique(which) for index in order[which[order] == base][:_POSTURES]]
    begin = angles = angles[chosen]
    which, score = which[chosen], score[chosen]
    for index, tip in enumerate(path.tips):
        if not len(which):
            return []
        moved, miss = reach(angles, inverse[which] @ tip, 8 if index else 2)
        good = (miss < MISS) & (np.abs(moved - angles).max(axis=1) < JUMP)
        good[good] &= _clear(obstacles, path, index, bases[which[good]], moved[good])
        score = np.minimum(score, ease(moved))
        angles, begin, which, score = moved[good], begin[good], which[good], score[good]
    return [(float(score[index]), bases[which[index]], begin[index]) for index in range(len(which))]


def starts(tips: Array, rng: np.random.Generator, coarse: tuple[int, float]) -> tuple[Array, Indices]:
    """Return angles of the arm that reach poses of the tip, and the number of the pose of each.

    Args:
        tips: A pose of the tip in the frame of each base, shape (n, 4, 4) [m].
        rng: Draws initial postures.
        coarse: Steps after which postures that miss by more than a distance are given up [m].
    """
    initial = _postures(rng)
    which = np.repeat(np.arange(len(tips)), len(initial))
    angles = np.tile(initial, (len(tips), 1))
    angles[:, 0] += np.arctan2(tips[:, 1, 3], tips[:, 0, 3])[which]
    for steps, allowed in (coarse, (20, MISS)):
        angles, miss = reach(angles, tips[which], steps)
        angles, which = angles[miss < allowed], which[miss < allowed]
    return angles, which


def _postures(rng: np.random.Generator) -> Array:
    """Return initial postures of inverse kinematics, shape (n, 7) [rad]."""
    down = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 1.9, np.pi / 4])
    ahead = np.array([0.0, -0.3, 0.0, -2.0, 0.0, 3.2, np.pi / 4])
    left = np.array([-0.5, 0.3, 0.8, -2.0, -0.9, 2.6, 0.5])
    right = left * np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 1.0])
    drawn = rng.uniform(0.6 * LIMITS[:, 0], 0.6 * LIMITS[:, 1], (2, 7))
    drawn[:, 3] -= 1.0
    drawn[:, 0] *= 0.3
    rolled = down + np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -np.pi / 2])
    return np.array([HOME, down, ahead, left, right, rolled, *drawn])


def ease(angles: Array) -> Array:
    """Return the distance of postures from singular ones and from the limits of the joints, shape (n,)."""
    poses = frames(angles)
    axes, places = poses[:, :7, :3, 2], poses[:, :7, :3, 3]
    jacobian = np.concatenate([np.cross(axes, poses[:, None, 7, :3, 3] - places), 0.3 * axes], axis=2)
    least = np.linalg.svd(jacobian, compute_uv=False)[:, -1]
    margin = np.minimum(angles - LIMITS[:, 0], LIMITS[:, 1] - angles).min(axis=1)
    return np.asarray(np.minimum(least / 0.1, margin / 0.3))


def _clear(obstacles: Obstacles, path: _Path, index: int, bases: Array, angles: Array) -> Flags:
    """Tell for each posture whether the arm behind the hand collides with nothing."""
    poses = (bases[:, None] @ frames(angles))[:, BALL_JOINTS]
    points = np.einsum("nkij,kj->nki", poses[..., :3, :3], BALL_PLACES) + poses[..., :3, 3]
    depth = obstacles.depth(points.reshape(-1, 3), path.poses[index]).reshape(points.shape[:2])
    floor = np.minimum(bases[:, 2, 3], 0.0) if obstacles.raised else np.full(len(bases), obstacles.floor)
    low = points[:, :, 2] - floor[:, None]
    return np.asarray(((depth < -BALL_RADII) & (low > BALL_RADII)).all(axis=1))


def _box(convex: Convex) -> tuple[Array, Array]:
    """Return the pose of a box around a piece, shape (4, 4), and half its size, shape (3,) [m]."""
    if convex.kind == "hull":
        low, high = convex.bounds()
        frame = np.eye(4)
        frame[:3, 3] = (low + high) / 2.0
        return frame, (high - low) / 2.0
    if convex.kind == "box":
        return convex.pose, np.array(convex.size) / 2.0
    radius = convex.size[0]
    long = 0.0 if convex.kind == "sphere" else convex.size[1] / 2.0
    beyond = 0.0 if convex.kind == "cylinder" else radius
    return convex.pose, np.array([radius, radius, long + beyond])
