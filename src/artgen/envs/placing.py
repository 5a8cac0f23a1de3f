"""Where the robot stands and how its hand is turned, so that the whole of a task is within its reach."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, product

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.envs.kinematics import BALL_JOINTS, BALL_PLACES, BALL_RADII, frames, reach
from artgen.envs.motion import Contact, Move, Stage, Target, between, lifted, turned
from artgen.envs.obstacles import HAND, Obstacles
from artgen.envs.robot import HOME, LIMITS

Flags = NDArray[np.bool_]

_STEPS = 6  # poses looked at along the way of a joint
_BASES = 16  # places that are tried at once
_ROUNDS = 4
_TOGETHER = 4  # ways of turning the hand that are compared
_GOOD = 0.4  # score that needs no better one
_POSTURES = 2  # of the arm from which it sets out, at each base
_DISTANCES = (0.40, 0.50, 0.60, 0.70)  # from what is touched to the base [m]
_ANGLES = np.radians([0.0, 20.0, -20.0, 40.0, -40.0, 60.0, -60.0, 85.0, -85.0])  # off the approach
_ABOVE = (0.15, 0.30, 0.45, 0.60)  # the hand over the base [m]
_STEP = 0.05  # a robot beside a table stands lower by this much at least [m]
_FOOT = 0.16  # half the width of what the base stands on [m]
_MISS = 2e-3  # by which the tip may miss [m]
_MOST_COMBINED, _COMBINED = 5000, 24  # combinations that are looked at, and those that are tried
_APART = (0.15, 0.4)  # from one pose of the tip to the next [m], [rad]
_JUMP = 1.0  # of an angle from one pose to the next [rad]
_TILTS = np.radians([0.0, 25.0, -25.0, 45.0, -45.0, 60.0, -60.0])
_JITTER = 0.02  # of the hand at reset [m]
_ROOM = 0.004  # around the hand [m]
_FARTHER = (0.03, 0.08)  # beyond the start of the approach [m]


@dataclass(frozen=True, eq=False)
class _Way:
    """A way of the hand: poses of the tip, and of the links of the asset at each."""

    moves: tuple[Move, ...]
    tips: Array
    poses: list[dict[str, Array]]


def place(
    asset: Asset, stages: Sequence[Stage], rng: np.random.Generator, *, raised: bool = False
) -> Target | None:
    """Return a target with a place for the robot; None if none was found.

    Hands are turned about their approach, and tilted where they would strike something; bases are tried
    around what is touched, at several distances and heights. Of those from which the arm follows every pose
    of the way within its limits and beside the asset, the one that is farthest from singular is taken.

    Args:
        asset: The asset.
        stages: What has to be done.
        rng: Draws the places that are tried and the pose of the hand at reset.
        raised: Whether the asset stands on a table; the robot then stands lower than it.
    """
    obstacles = Obstacles(asset, raised=raised)
    options = [
        list(_variants(obstacles, move, stages)) if move.contact else [move]
        for stage in stages
        for move in stage.moves
    ]
    ways = [_way(obstacles, moves, rng) for moves in _combined(options)]
    best, most = None, 0.0
    for way, bases in _trials(obstacles, ways, rng):
        for score, base, arm in _followed(obstacles, way, bases, rng):
            if score > most:
                best, most = (way, base, arm), score
        if most > _GOOD:
            break
    if best is None:
        return None
    way, base, arm = best
    hand = base @ frames(arm[None])[0, 7]
    return Target(_with_moves(stages, way.moves), {}, base, arm, hand)


def _trials(
    obstacles: Obstacles, ways: Sequence[_Way], rng: np.random.Generator
) -> Iterator[tuple[_Way, Array]]:
    """Yield ways of the hand, few at a time, with places to try them from, few at a time."""
    for first in range(0, len(ways), _TOGETHER):
        some = [(way, _bases(obstacles, way, rng)) for way in ways[first : first + _TOGETHER]]
        for begin in range(0, _ROUNDS * _BASES, _BASES):
            yield from ((way, bases[begin : begin + _BASES]) for way, bases in some if len(bases) > begin)


def _with_moves(stages: Sequence[Stage], moves: Sequence[Move]) -> tuple[Stage, ...]:
    left = iter(moves)
    return tuple(replace(stage, moves=tuple(next(left) for _ in stage.moves)) for stage in stages)


def _combined(options: Sequence[Sequence[Move]]) -> list[tuple[Move, ...]]:
    """Return combinations of the hands of all moves, those that come first for each move first."""
    numbers = product(*(range(len(each)) for each in options))
    chosen = sorted(islice(numbers, _MOST_COMBINED), key=sum)[:_COMBINED]
    return [tuple(each[index] for each, index in zip(options, some, strict=True)) for some in chosen]


def _variants(obstacles: Obstacles, move: Move, stages: Sequence[Stage]) -> Iterator[Move]:
    """Yield a move with its hand turned in ways in which the hand strikes nothing, the least tilted first."""
    contact = move.contact
    assert contact is not None
    rolls = [0.0, np.pi] if contact.kind == "grasp" else [0.0, np.pi / 2, np.pi, -np.pi / 2]
    axes = (0,) if contact.kind == "grasp" else (0, 1)
    before = _start(stages, move)
    for tilt in _TILTS:
        for axis in axes if tilt else (0,):
            for roll in rolls:
                frame = turned(turned(contact.frame, 2, roll), axis, tilt)
                turn = replace(contact, frame=frame)
                if _free(obstacles, turn, before, move):
                    yield replace(move, contact=turn)


def _start(stages: Sequence[Stage], until: Move) -> dict[str, float]:
    """Return where joints stand as a move begins."""
    q: dict[str, float] = {}
    for stage in stages:
        for move in stage.moves:
            if move is until:
                return q
            q[move.joint] = move.until
    return q


def _free(obstacles: Obstacles, contact: Contact, q: dict[str, float], move: Move) -> bool:
    """Tell whether the hand strikes nothing as it comes, and as it moves the joint."""
    asset, hand = obstacles.asset, HAND + np.array([[-_ROOM], [_ROOM]])
    start = q.get(move.joint, asset.joint(move.joint).closed)
    for share, back in ((0.0, contact.back), (0.0, 0.0), (0.5, 0.0), (1.0, 0.0)):
        pose = asset.pose({**q, move.joint: start + share * (move.until - start)})
        tip = lifted(pose[contact.link] @ contact.frame, -back)
        lowest = tip[2, 3] + np.minimum(hand[0] * tip[2, :3], hand[1] * tip[2, :3]).sum()
        if lowest < obstacles.floor or obstacles.touch(hand, tip, pose):
            return False
    return True


def _way(obstacles: Obstacles, moves: tuple[Move, ...], rng: np.random.Generator) -> _Way:
    """Return the way of the hand through all moves."""
    asset = obstacles.asset
    tips: list[Array] = []
    poses: list[dict[str, Array]] = []

    def add(tip: Array, pose: dict[str, Array]) -> None:
        way = [*between(tips[-1], tip, *_APART), tip] if tips else [tip]
        tips.extend(way)
        poses.extend([pose] * len(way))

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
            start = lifted(pose[contact.link] @ contact.frame, -contact.back)
            if not tips:
                away = lifted(start, -rng.uniform(*_FARTHER))
                away[:3, 3] += rng.uniform(-_JITTER, _JITTER, 3)
                add(away, pose)
            add(start, pose)
        assert contact is not None, "the first move has a contact"
        begin = q.get(move.joint, asset.joint(move.joint).closed)
        for share in np.linspace(0.0, 1.0, _STEPS):
            q[move.joint] = begin + share * (move.until - begin)
            pose = asset.pose(q)
            add(pose[contact.link] @ contact.frame, pose)
    return _Way(moves, np.array(tips), poses)


def _bases(obstacles: Obstacles, way: _Way, rng: np.random.Generator) -> Array:
    """Return places around a way that the asset leaves free, in random order, shape (n, 4, 4)."""
    middle = (way.tips[:, :3, 3].min(axis=0) + way.tips[:, :3, 3].max(axis=0)) / 2.0
    approach = way.tips[:, :2, 2].mean(axis=0)
    away = -approach if np.linalg.norm(approach) > 0.3 else np.array([0.0, -1.0])
    heading = np.arctan2(away[1], away[0])
    spans = np.concatenate([obstacles.spans(pose) for pose in way.poses])
    most = float(obstacles.asset.bounds()[0, 2]) - _STEP if obstacles.raised else np.inf
    lowest = obstacles.floor
    heights = sorted({round(min(max(lowest, middle[2] - above), most), 3) + 0.0 for above in _ABOVE})
    result = []
    for angle in heading + _ANGLES:
        for distance in _DISTANCES:
            for height in heights:
                place = np.array(
                    [*(middle[:2] + distance * np.array([np.cos(angle), np.sin(angle)])), height]
                )
                low, high = place - (_FOOT, _FOOT, 10.0), place + (_FOOT, _FOOT, 0.35)
                if ((spans[:, 0] < high) & (spans[:, 1] > low)).all(axis=1).any():
                    continue
                base = np.eye(4)
                sine, cosine = np.sin(angle + np.pi), np.cos(angle + np.pi)
                base[:2, :2] = [[cosine, -sine], [sine, cosine]]
                base[:3, 3] = place
                result.append(base)
    return np.array(result)[rng.permutation(len(result))] if result else np.zeros((0, 4, 4))


def _followed(
    obstacles: Obstacles, way: _Way, bases: Array, rng: np.random.Generator
) -> list[tuple[float, Array, Array]]:
    """Return scores, bases and angles at the start, for the bases from which the arm follows a way."""
    inverse = np.linalg.inv(bases)
    starts = _postures(rng)
    local = inverse @ way.tips[0]
    which = np.repeat(np.arange(len(bases)), len(starts))
    angles = np.tile(starts, (len(bases), 1))
    angles[:, 0] += np.arctan2(local[:, 1, 3], local[:, 0, 3])[which]
    for steps, allowed in ((12, 0.1), (20, _MISS)):
        angles, miss = reach(angles, local[which], steps)
        angles, which = angles[miss < allowed], which[miss < allowed]
    score = _ease(angles)
    kept = _first_of_each(which, score)
    angles, which, score = angles[kept], which[kept], score[kept]
    begin = angles
    for index, tip in enumerate(way.tips):
        if not len(which):
            return []
        moved, miss = reach(angles, inverse[which] @ tip, 8 if index else 2)
        good = (miss < _MISS) & (np.abs(moved - angles).max(axis=1) < _JUMP)
        good[good] &= _clear(obstacles, way, index, bases[which[good]], moved[good])
        score = np.minimum(score, _ease(moved))
        angles, begin, which, score = (each[good] for each in (moved, begin, which, score))
    return [(float(score[index]), bases[which[index]], begin[index]) for index in range(len(which))]


def _first_of_each(which: NDArray[np.int64], score: Array) -> NDArray[np.int64]:
    """Return the indices of the `_POSTURES` best of each base."""
    order = np.argsort(-score, kind="stable")
    kept = [index for base in np.unique(which) for index in order[which[order] == base][:_POSTURES]]
    return np.array(kept, int)


def _postures(rng: np.random.Generator) -> Array:
    """Return postures from which inverse kinematics starts, shape (n, 7) [rad]."""
    down = np.array([0.0, -0.3, 0.0, -2.2, 0.0, 1.9, np.pi / 4])
    ahead = np.array([0.0, -0.3, 0.0, -2.0, 0.0, 3.2, np.pi / 4])
    left = np.array([-0.5, 0.3, 0.8, -2.0, -0.9, 2.6, 0.5])
    right = left * np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 1.0])
    drawn = rng.uniform(0.6 * LIMITS[:, 0], 0.6 * LIMITS[:, 1], (2, 7))
    drawn[:, 3] -= 1.0
    drawn[:, 0] *= 0.3
    rolled = down + np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -np.pi / 2])
    return np.array([HOME, down, ahead, left, right, rolled, *drawn])


def _ease(angles: Array) -> Array:
    """Return how far postures are from singular ones and from the limits of the joints, shape (n,)."""
    poses = frames(angles)
    axes, places = poses[:, :7, :3, 2], poses[:, :7, :3, 3]
    jacobian = np.concatenate([np.cross(axes, poses[:, None, 7, :3, 3] - places), 0.3 * axes], axis=2)
    least = np.linalg.svd(jacobian, compute_uv=False)[:, -1]
    margin = np.minimum(angles - LIMITS[:, 0], LIMITS[:, 1] - angles).min(axis=1)
    return np.asarray(np.minimum(least / 0.1, margin / 0.3))


def _clear(obstacles: Obstacles, way: _Way, index: int, bases: Array, angles: Array) -> Flags:
    """Tell of postures whether the arm behind the hand strikes neither the asset nor the floor."""
    poses = (bases[:, None] @ frames(angles))[:, BALL_JOINTS]
    points = np.einsum("nkij,kj->nki", poses[..., :3, :3], BALL_PLACES) + poses[..., :3, 3]
    depth = obstacles.depth(points.reshape(-1, 3), way.poses[index]).reshape(points.shape[:2])
    floor = np.minimum(bases[:, 2, 3], 0.0) if obstacles.raised else np.full(len(bases), obstacles.floor)
    low = points[:, :, 2] - floor[:, None]
    return np.asarray(((depth < -BALL_RADII) & (low > BALL_RADII)).all(axis=1))
