"""Stands of a mobile Panda in a room: for each joint, places from which its hand follows the whole way.

The base of the arm is level and has any height above the floor of the room; its footprint is free of all
assets and walls, also along the way. A joint that stays where the hand leaves it may be followed from several
stands, one after another. The other joints are closed, or open where the joint or the hand needs them.
"""

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from artgen._arrays import Array, FrozenArrays, Indices, Mask
from artgen.asset import Asset, AssetCondition, AssetCoupling, AssetJoint
from artgen.asset.affordance import GRIPPER, Affordance, held
from artgen.asset.record import json_text
from artgen.colliders.polytope import Polytope
from artgen.envs.motion import BACK, contact_of, lifted, rotation_vector, turned
from artgen.envs.placing import HAND_BOX, JUMP, MISS, ease, orientations, starts
from artgen.envs.robot import BALL_JOINTS, BALL_PLACES, BALL_RADII, frames, reach
from artgen.export.files import replaced
from artgen.export.frames import coupling, quaternion
from artgen.validate.hands.motion import openable, positions_to_move

FORMAT = "artgen-reach-2"
"""Format of the file of stands."""

_DIGITS = 6  # decimals of stored numbers: inverse kinematics differs between machines
_STANDS = 4  # most stands for one joint
_GAIN = 0.1  # least share of the way that a further stand adds
_HALF = 0.5  # share of the rest of the way after which other hands are not tried
_STEP = (0.06, 0.25)  # largest step of a hand along the way [m], [rad]
_MOST_STEPS = 24
_PATHS = 16  # orientations of hands that are tried
_PUSHES, _BETWEEN = 6, 0.06  # points at which a finger pushes a part, and the distance between two [m]
_POINTS = 24  # points that are looked at
_FACE = 0.003  # least half width of a face that a finger pushes [m]
_EDGE = 0.75  # share of the way from its middle to its corners
_CANDIDATES = 120  # places of grasps that are looked at
_ROLLS = np.radians([30.0, 60.0, 90.0, 120.0, 150.0])  # of a hand about its approach, for round parts [rad]
_GRASPS, _BESIDE = 8, 0.03  # grasps across two faces that are tried, and the distance between two [m]
_ALIKE = 0.5  # least cosine between the fingers of two grasps that are alike
_INSIDE = 0.010  # from an edge of a face to the middle of the pads [m]
_CELL, _COARSE = 0.02, 0.6  # grasps nearer than this count as one: [m], and of unit vectors
_OPPOSITE = 0.9  # least cosine between a face and the reverse of the one across
_THIN = 0.0015  # least thickness between the fingers [m]
_LEANS = np.radians([20.0, 40.0, 60.0])  # of a pushing finger [rad]
_TURNS = np.radians(np.arange(0.0, 360.0, 30.0))  # of its lean and of the hand about it [rad]
_FACING = 0.8  # least cosine between a push on a face and its motion
_OUT = 0.003  # distance before a face at which the part ends [m]
_EASE = 0.05  # least distance from singular postures and from limits
_ALONG = 0.5  # least cosine between a push and the motion of its point
_BATCH, _ROUNDS = 20, 4  # bases that are tried at once, and how often for one orientation of the hand
_ROOM = 0.004  # clearance of the hand behind the fingers [m]
_SLACK = 0.001  # by which a finger may overlap another part [m]
_OPENED, _POSTURES = 3, 5  # other joints that are opened, and postures that tell what an arm strikes
_BACKS = (1.0, 0.5)  # shares of the approach at which the hand has to be free
_SHORT = 0.03  # of an approach where there is no room for a long one [m]
_SHARES = (0.5, 1.0)  # of the turn of a part by which a hand turns on it
_PARALLEL, _CENTERED = 0.95, 0.005  # least cosine to an axis, and most distance from it [m]
_STILL = 1e-9  # largest change of a pose that does not turn
_MOST_LEAN = math.radians(75.0)  # of a finger that turns on a part [rad]
_LEAST = math.cos(_MOST_LEAN) - 0.01  # least cosine between a finger that turns and its push
_TILTED = 0.05  # sine of the angle from which a finger pushes with an edge of its end
_PAST = 0.006  # from an edge to the end of a finger on a face [m]
_QUARTERS = np.radians([0.0, 90.0, 180.0, 270.0])  # of a finger beside a face [rad]

_DIRECTIONS = np.radians(np.arange(0.0, 360.0, 20.0))  # of the base from the hand [rad]
_DISTANCES = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)  # from the hand to the axis of the base [m]
_ABOVE = (-0.25, -0.1, 0.05, 0.2, 0.35, 0.5, 0.65)  # height of the hand above the base [m]
_FEW = 60  # free places of the base, below which more are tried
_FINE_DIRECTIONS, _FINE_DISTANCES = np.radians(np.arange(0.0, 360.0, 6.0)), np.arange(0.3, 1.01, 0.05)
_FOOT = np.array([[-0.16, -0.12], [0.08, 0.12]])  # of pedestal and first link, in the frame of the base [m]
_SHOULDER = 0.35  # height of what stands on the foot [m]
_WRIST = (0.25, 0.80)  # from the shoulder to the axis of the hand at the wrist [m]
_TIP = 0.2035  # from the wrist to the tip [m]
_AROUND = 1.0  # distance from the hand within which an arm strikes something [m]
_NEAR = 0.35  # the same of a hand [m]
_COLUMN = 0.09  # radius of the pedestal and of the first links, which the hand must not strike [m]
_GRAVITY = 9.81  # [m/s^2]
_FRICTION = 0.01  # of a joint that stays, at least [N m or N]

# balls of the arm in the frames of its joints: those from the elbow on, and two in the upper arm
_JOINTS = np.array([*BALL_JOINTS, 2, 2])
_PLACES = np.array([*BALL_PLACES, (0.0, 0.0, -0.13), (0.0, 0.0, -0.20)])
_RADII = np.array([*BALL_RADII, 0.06, 0.06])
# balls that must not strike the foot: those of the forearm and of the hand, the last frame is that of the tip
_FOREARM = BALL_JOINTS >= 4
_OWN_JOINTS = np.array([*BALL_JOINTS[_FOREARM], 7, 7, 7])
_OWN_PLACES = np.array([*BALL_PLACES[_FOREARM], *((x, 0.0, -0.09) for x in (-0.07, 0.0, 0.07))])
_OWN_RADII = np.array([*BALL_RADII[_FOREARM], 0.035, 0.035, 0.035])


@dataclass(frozen=True, eq=False)
class Stand(FrozenArrays):
    """A place of a Panda for one joint, or the reason why there is none.

    Attributes:
        joint: Name of the joint.
        hold: Name of the grasp or push by which the hand moves it, or of its link with `_push` where a finger
            pushes a face of the part at `tip`, or with `_hold` where the hand grasps it across two faces at
            `tip`; empty if there is no place.
        link: Name of the link that the hand touches.
        way: Share of the way of the joint that the hand has followed at the end of this stand and of those in
            `then`, 0-1.
        base: Pose of the base of the arm in the room, shape (4, 4) [m].
        arm: Angles of the arm at the start of its approach, shape (7,) [rad].
        start: Positions of other joints that the joint or the hand needs [rad or m].
        reason: Why there is no place; empty if there is one.
        at: Positions of the joint along the way, the first of them three times: two places of the approach
            and the contact, shape (n,) [rad or m].
        path: Angles of the arm at these positions, shape (n, 7) [rad].
        tip: Pose of the tip of the hand at the contact, for the link at rest, shape (4, 4) [m].
        turns: Whether the hand turns on the part along the way: about a round bar, on its pads, or on a tip.
        then: Further stands, from which the hand goes on.
    """

    joint: str
    hold: str = ""
    link: str = ""
    way: float = 0.0
    base: Array | None = None
    arm: Array | None = None
    start: Mapping[str, float] | None = None
    reason: str = ""
    at: Array | None = None
    path: Array | None = None
    tip: Array | None = None
    turns: bool = False
    then: tuple["Stand", ...] = ()

    def to_data(self) -> dict[str, Any]:
        """Return the stand as JSON data."""
        if self.base is None or self.arm is None or self.at is None or self.path is None:
            return {"joint": self.joint, "reason": self.reason}
        data = {
            "joint": self.joint,
            "hold": self.hold,
            "link": self.link,
            "way": round(self.way, _DIGITS),
            "position": np.round(self.base[:3, 3], _DIGITS).tolist(),
            "quaternion": np.round(quaternion(self.base), _DIGITS).tolist(),  # w, x, y, z
            "arm": np.round(self.arm, _DIGITS).tolist(),
            "start": dict(self.start or {}),
            "at": np.round(self.at, _DIGITS).tolist(),
            "path": np.round(self.path, _DIGITS).tolist(),
            "tip": None if self.tip is None else np.round(self.tip, _DIGITS).tolist(),
        }
        data |= {"turns": True} if self.turns else {}
        return data | ({"then": [each.to_data() for each in self.then]} if self.then else {})


def hand_joints(asset: Asset) -> list[AssetJoint]:
    """Return the joints that a hand moves: free, without a motor, and with a grasp or a push."""
    held = {name for each in asset.affordances for name in each.joints}
    return [joint for joint in asset.free_joints if joint.name in held and not joint.driven]


def stands(asset: Asset, seed: int = 0) -> Iterator[Stand]:
    """Yield a stand for each joint that a hand moves.

    Args:
        asset: A room, or another asset on the floor.
        seed: Seed of the search; the result depends on it and on the asset.
    """
    space = Surroundings(asset)
    for number, joint in enumerate(hand_joints(asset)):
        yield _Search(space, joint, np.random.default_rng((seed, number))).stand()


def write_stands(asset: Asset, found: Sequence[Stand], path: Path) -> Path:
    """Write the stands of an asset to a JSON file, and return its path."""
    data = {
        "format": FORMAT,
        "asset": asset.name,
        "robot": "Franka Panda with its hand; the base of the arm is at `position`, z up, x ahead",
        "stands": [each.to_data() for each in found],
    }
    with replaced(path) as partial:
        partial.write_text(json_text(data), encoding="utf-8")
    return path


class Surroundings:
    """The colliders of an asset as obstacles of an arm."""

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self.floor = float(asset.bounds()[0, 2])  # height of the floor [m]
        self.ground = np.array(
            [[-np.inf] * 2, [np.inf] * 2]
        )  # area in which a robot stands, shape (2, 2) [m]
        solid = [(number, each) for number, link in enumerate(asset.links) for each in link.colliders]
        if asset.is_room:  # a robot stands on its floor, which is no obstacle of the arm
            floors = [each.convex.bounds() for each in asset.links[0].colliders if each.label == "floor"]
            self.ground = np.array([np.min(floors, axis=0)[0, :2], np.max(floors, axis=0)[1, :2]])
            self.floor = float(np.max(floors, axis=0)[1, 2])
            solid = [(number, each) for number, each in solid if number or each.label != "floor"]
        self._faces: dict[str, _Faces] = {}
        faces = [each.convex.faces for _, each in solid]
        self.links = np.array([number for number, _ in solid])  # link of each piece
        self.corners = np.concatenate([each.points for each in faces])
        self.planes = np.concatenate([each.planes for each in faces])
        self.corner_counts = np.array([len(each.points) for each in faces])
        self.plane_counts = np.array([len(each.planes) for each in faces])

    def faces(self, link: str) -> "_Faces":
        """Return points on the faces of a link."""
        if link not in self._faces:
            self._faces[link] = _Faces([each.convex.faces for each in self.asset.link(link).colliders])
        return self._faces[link]

    def at(self, q: Mapping[str, float]) -> "_State":
        """Return the obstacles at positions of the joints."""
        return _State(self, self.asset.pose(q))


class _Faces:
    """Points on the faces of a link at rest: their middles, points off them, and points beside edges."""

    def __init__(self, pieces: Sequence[Polytope]) -> None:
        found: list[tuple[Array, Array, Array]] = []
        for piece in pieces:
            for normal, inside in zip(piece.planes[:, :3], piece.contact.T, strict=True):
                corners = piece.points[inside]
                middle = corners.mean(axis=0)
                if len(corners) < 3:
                    continue
                spread = np.linalg.svd(corners - middle, compute_uv=False)
                if spread[1] >= _FACE * math.sqrt(len(corners)):
                    found += [
                        (middle + _EDGE * way, normal, np.zeros(3)) for way in (0.0, *(corners - middle))
                    ]
                    found += [(point, normal, out) for point, out in _beside_edges(corners, normal)]
        # points, normals, and vectors to edges that are zero for points off edges, shape (n, 3) each
        self.points, self.normals, self.outs = np.array(found).reshape(-1, 3, 3).transpose(1, 0, 2)
        self._planes = np.concatenate([np.zeros((0, 4)), *(each.planes for each in pieces)])
        self._first = np.cumsum([0, *(len(each.planes) for each in pieces[:-1])])[: len(pieces)]

    def exposed(self, points: Array) -> Mask:
        """Tell which points are in no piece."""
        apart = np.einsum("ni,mi->nm", points, self._planes[:, :3]) - self._planes[:, 3]
        return np.asarray((np.maximum.reduceat(apart, self._first, axis=1) >= 0.0).all(axis=1))


class _Pieces:
    """Convex pieces at one state of all joints, in asset coordinates."""

    def __init__(
        self,
        links: Indices,
        corners: Array,
        planes: Array,
        firsts: tuple[Indices, Indices],
        counts: tuple[Indices, Indices],
        bounds: Array,
    ) -> None:
        self.links, self.bounds = links, bounds  # of each piece; bounding boxes, shape (pieces, 2, 3) [m]
        self._corners, self._planes = corners, planes  # of these pieces, and of others
        self._firsts, self._counts = firsts, counts  # of corners and planes of each piece

    def within(self, low: Array, high: Array) -> "_Pieces":
        """Return the pieces whose bounding boxes overlap a box."""
        overlap: Mask = np.all((self.bounds[:, 0] <= high) & (self.bounds[:, 1] >= low), axis=1)
        return self.chosen(overlap)

    def chosen(self, kept: Mask) -> "_Pieces":
        """Return some of the pieces."""
        firsts = (self._firsts[0][kept], self._firsts[1][kept])
        counts = (self._counts[0][kept], self._counts[1][kept])
        return _Pieces(self.links[kept], self._corners, self._planes, firsts, counts, self.bounds[kept])

    def struck(self, box: Array, poses: Array) -> Mask:
        """Tell which pieces overlap a box with opposite corners, shape (2, 3), at poses, shape (n, 4, 4).

        The answer, shape (n, pieces), is exact but for edges that cross each other: these count as striking.
        """
        half, turns = (box[1] - box[0]) / 2.0, poses[:, :3, :3]
        middle = turns @ box.mean(axis=0) + poses[:, :3, 3]
        around = np.abs(turns) @ half
        near = np.ones((len(poses), len(self.links)), bool)
        for axis in range(3):
            near &= self.bounds[:, 0, axis] < (middle + around)[:, axis, None]
            near &= self.bounds[:, 1, axis] > (middle - around)[:, axis, None]
        pose, piece = np.nonzero(near)
        if len(pose):
            which, number, first = _spread(self._firsts[0][piece], self._counts[0][piece])
            local = _turned_back(self._corners[number] - middle[pose][which], turns[pose][which])
            low, high = np.minimum.reduceat(local, first), np.maximum.reduceat(local, first)
            overlaps = ((low < half) & (high > -half)).all(axis=1)
            pose, piece = pose[overlaps], piece[overlaps]
            near[:] = False
        if len(pose):
            which, number, first = _spread(self._firsts[1][piece], self._counts[1][piece])
            normals = self._planes[number, :3]
            apart = (normals * middle[pose][which]).sum(axis=1) - self._planes[number, 3]
            apart -= np.abs(_turned_back(normals, turns[pose][which])) @ half
            near[pose, piece] = np.maximum.reduceat(apart, first) < 0.0
        return near

    def clear(self, points: Array, radii: Array) -> Mask:
        """Tell which balls with centers of shape (n, 3) and radii of shape (n,) strike nothing."""
        free = np.ones(len(points), bool)
        near = np.ones((len(self.links), len(points)), bool)
        for axis in range(3):
            near &= points[:, axis] + radii > self.bounds[:, 0, axis, None]
            near &= points[:, axis] - radii < self.bounds[:, 1, axis, None]
        for piece in np.flatnonzero(near.any(axis=1)):
            some = np.flatnonzero(near[piece])
            first = self._firsts[1][piece]
            planes = self._planes[first : first + self._counts[1][piece]]
            away = (points[some] @ planes[:, :3].T - planes[:, 3]).max(axis=1)
            free[some] &= away > radii[some]
        return free

    def met(self, points: Array, radii: Array) -> set[int]:
        """Return the links that some balls meet."""
        links = set(self.links.tolist())
        return {each for each in links if not self.chosen(self.links == each).clear(points, radii).all()}


class _State(_Pieces):
    """All obstacles at one state of the joints, with the displacements of the links."""

    def __init__(self, space: Surroundings, pose: Mapping[str, Array]) -> None:
        self.pose = pose
        matrices = np.array([pose[link.name] for link in space.asset.links])[space.links]
        at_corners, at_planes = (
            np.repeat(matrices, counts, axis=0) for counts in (space.corner_counts, space.plane_counts)
        )
        corners = np.einsum("nij,nj->ni", at_corners[:, :3, :3], space.corners) + at_corners[:, :3, 3]
        planes = space.planes.copy()
        planes[:, :3] = np.einsum("nij,nj->ni", at_planes[:, :3, :3], space.planes[:, :3])
        planes[:, 3] += (planes[:, :3] * at_planes[:, :3, 3]).sum(axis=1)
        counts = (space.corner_counts, space.plane_counts)
        firsts = (np.cumsum(counts[0]) - counts[0], np.cumsum(counts[1]) - counts[1])
        ends = [np.minimum.reduceat(corners, firsts[0]), np.maximum.reduceat(corners, firsts[0])]
        super().__init__(space.links, corners, planes, firsts, counts, np.stack(ends, axis=1))


@dataclass(frozen=True, eq=False)
class _Hold:
    """A grasp or push of the joint, in states of the joint along its way."""

    affordance: Affordance
    start: dict[str, float]  # positions of other joints [rad or m]
    states: list[_State]
    # poses of the tip for the link at rest, turned and tilted, shape (variants, states, 4, 4) [m]
    tips: Array
    free: Mask  # whether the hand strikes nothing while it holds, shape (variants, states)
    back: float  # distance at which the approach begins [m]

    def tip(self, variant: int, index: int) -> Array:
        """Return the pose of the tip in a state, shape (4, 4) [m]."""
        return np.asarray(self.states[index].pose[self.affordance.link] @ self.tips[variant, index])


@dataclass(frozen=True, eq=False)
class _Path:
    """A part of the way with one orientation of the hand."""

    hold: _Hold
    variant: int
    first: int  # states at its ends
    last: int
    bases: Array  # to try, shape (n, 4, 4) [m]

    def tips(self) -> list[tuple[int, Array]]:
        """Return the poses of the tip with their states: the approach, the contact and the way."""
        contact = self.hold.tip(self.variant, self.first)
        before = [(self.first, lifted(contact, -share * self.hold.back)) for share in _BACKS]
        return [*before, *((at, self.hold.tip(self.variant, at)) for at in range(self.first, self.last + 1))]


class _Search:
    """The search of the stands for one joint."""

    def __init__(self, space: Surroundings, joint: AssetJoint, rng: np.random.Generator) -> None:
        self.space, self.asset, self.joint, self.rng = space, space.asset, joint, rng
        low, high = joint.limits or (-math.pi, math.pi)
        self.far = high if high - joint.closed >= joint.closed - low else low
        named = [each for each in self.asset.affordances if joint.name in each.joints]
        self.hands = sorted(named, key=lambda each: each.joints.index(joint.name))
        self.at = np.linspace(joint.closed, self.far, self._steps() + 1)  # positions along the way [rad or m]
        self.states: dict[tuple[tuple[str, float], ...], list[_State]] = {}
        self.given: dict[int, list[_Hold]] = {}  # holds of the asset's own hands, by the first state
        self.struck = ""  # link that a hand strikes
        self.blocking: Counter[str] = Counter()  # numbers of postures in which an arm strikes a link
        self.held = False  # whether a hand can hold it
        self.footing = False  # whether a robot can stand near it

    def stand(self) -> Stand:
        """Return the first stand with those that follow it, or the reason why there is none."""
        found: list[Stand] = []
        done, last = 0, len(self.at) - 1
        while done < last and len(found) < _STANDS:
            best: tuple[int, Stand] | None = None
            for hands in (
                self._given, self._opened, self._turning, self._pushes, self._hooks, self._rolling,
                self._grasps,
            ):  # fmt: skip
                # a further stand goes on where the part stays
                least = _GAIN * last if hands == self._grasps else _HALF * (last - done)
                if best is not None and (
                    best[0] == last or (best[0] - done >= least and self._stays(best[1].start or {}, best[0]))
                ):
                    break
                holds = hands(done)
                best = max(best, self._farthest(holds, done), key=lambda each: each[0] if each else 0)
            if best is None or (best[0] < last and best[0] - done < _GAIN * last):
                break
            done = best[0]
            found.append(replace(best[1], way=done / last))
            if not self._stays(best[1].start or {}, done):
                break
        if found:
            return replace(found[0], way=found[-1].way, then=tuple(found[1:]))
        if self.footing:
            why = "from no place that was tried, the arm follows its way"
        elif self.held:
            why = "a robot cannot stand near enough to it"
        elif self.struck:
            why = f"the hand would touch {self.struck}"
        else:
            why = "no hand acts along its way where other joints let it move"
        return Stand(self.joint.name, reason=why)

    def _steps(self) -> int:
        """Return the number of steps in which hands follow the joint."""
        most = 2.0
        for hand in self.hands:
            tips = [
                self.asset.pose({self.joint.name: at})[hand.link] @ hand.frame
                for at in np.linspace(self.joint.closed, self.far, 5)
            ]
            shift = sum(float(np.linalg.norm(b[:3, 3] - a[:3, 3])) for a, b in pairwise(tips))
            turn = sum(
                float(np.linalg.norm(rotation_vector(b[:3, :3] @ a[:3, :3].T))) for a, b in pairwise(tips)
            )
            most = max(most, shift / _STEP[0], turn / _STEP[1])
        return min(math.ceil(most), _MOST_STEPS)

    def _moves(self, hand: Affordance, first: int) -> bool:
        """Tell whether a hand moves the joint along its way; a push does so in one direction."""
        if hand.kind == "grasp":
            return True
        ends = self.at[first] + np.array([0.0, 1e-3]) * (self.far - self.joint.closed)
        before, behind = (
            (self.asset.pose({self.joint.name: float(at)})[hand.link] @ hand.frame) for at in ends
        )
        moved = (behind - before)[:3, 3]
        length = float(np.linalg.norm(moved))
        return length > 0.0 and float(moved @ before[:3, 2]) > _ALONG * length

    def _stays(self, start: Mapping[str, float], index: int) -> bool:
        """Tell whether friction holds the joint in a state against springs and weight."""
        ends = self.at[[max(index - 1, 0), min(index + 1, len(self.at) - 1)]].tolist()
        poses = [self.asset.pose({**start, self.joint.name: at}) for at in ends]
        rise = 0.0
        for link in self.asset.links:
            height = (poses[1][link.name] - poses[0][link.name])[2] @ [*link.mass_properties.center, 1.0]
            rise += _GRAVITY * link.mass_properties.mass * float(height) if abs(height) > 1e-9 else 0.0
        load, friction = -rise / (ends[1] - ends[0]), _FRICTION
        for each in self.asset.joints:
            law = coupling(self.asset, each) or AssetCoupling(each.name, 1.0)
            if law.leader == self.joint.name:
                slope, at = law.slope(float(self.at[index])), law.at(float(self.at[index]))
                load += slope * each.stiffness * (each.rest - at)
                friction += abs(slope) * each.friction
        return bool(abs(load) <= friction)

    def _given(self, first: int) -> list[_Hold]:
        """Return the grasps and pushes that the asset has for the joint, in all orientations of the hand."""
        if first not in self.given:
            found = (self._hold(hand, first) for hand in self.hands if self._moves(hand, first))
            self.given[first] = [each for each in found if each is not None]
        return self.given[first]

    def _opened(self, first: int) -> list[_Hold]:
        """Return the given hands with one more joint open, which moves their link or an obstacle."""
        result = []
        for hand in (each for each in self.hands if self._moves(each, first)):
            links = [hand.link, *(name for name, _ in self.blocking.most_common())]
            opened = {name: where for link in links for name, where in openable(self.asset, hand, link)}
            also = {} if hand.when is None else {"": hand.when}
            for name, where in islice(opened.items(), _OPENED):
                start = positions_to_move(self.asset, self.joint.name, also | {name: where})
                if start is not None:
                    hold, struck = self._oriented(hand, start, first)
                    result += [] if struck else [hold]
        return result

    def _turning(self, first: int) -> list[_Hold]:
        """Return the same with hands that turn on the part: about a round bar, on their pads, or on a tip."""
        given = {hold.affordance.name: hold for hold in self._given(first)}
        return [each for hold in given.values() for each in self._turned(hold.affordance, hold.start, first)]

    def _turned(self, hand: Affordance, start: dict[str, float], first: int) -> list[_Hold]:
        """Return a hand in all orientations as it turns on a part that turns."""
        axis = self._turns(hand, start, first)[-1]
        angle = float(np.linalg.norm(axis))
        if angle < _STEP[1]:
            return []
        frame = contact_of(hand).frame
        x, y = frame[:3, 0] @ axis / angle, frame[:3, 1] @ axis / angle
        if hand.kind == "push":
            side = math.atan2(y, x)
            tips = _leaning(frame, (side, side + math.pi), (*_LEANS, _MOST_LEAN))
        elif abs(x) > _PARALLEL or (abs(y) > _PARALLEL and self._round(hand)):
            tips = np.array(list(orientations(contact_of(hand))))
        else:
            return []
        hold, struck = self._tried(hand, start, tips, first, turns=_SHARES)
        return [] if struck else [hold]

    def _turns(self, hand: Affordance, start: dict[str, float], first: int) -> Array:
        """Return the turns that keep a hand parallel to itself after a state, shape (states, 3) [rad]."""
        turns = [state.pose[hand.link][:3, :3] for state in self._states(start)]
        steps = [rotation_vector(behind.T @ before) for before, behind in pairwise(turns)]
        summed = np.cumsum([np.zeros(3), *steps], axis=0)
        return np.asarray(summed - summed[first])

    def _round(self, hand: Affordance) -> bool:
        """Tell whether a grasp is around a bar that is round about the y axis of its frame."""
        place, along = hand.frame[:3, 3], hand.frame[:3, 1]
        for each in self.asset.link(hand.link).colliders:
            pose, apart = each.convex.pose, place - each.convex.pose[:3, 3]
            if each.convex.kind in ("cylinder", "capsule") and abs(pose[:3, 2] @ along) > _PARALLEL:
                away = apart - apart @ pose[:3, 2] * pose[:3, 2]
                long = abs(apart @ pose[:3, 2]) < 0.5 * each.convex.size[1]
                if long and np.linalg.norm(away) < _CENTERED:
                    return True
        return False

    def _pushes(self, first: int) -> list[_Hold]:
        """Return pushes with a finger on faces of the part that move along the push in a state."""
        start, found = self._pushed(first)
        chosen = _distinct(found, _POINTS, lambda one, other: _apart(one, other) <= _BETWEEN)
        holds = (self._oriented(push, start, first) for push in chosen)
        return list(islice((hold for hold, struck in holds if not struck), _PUSHES))

    def _rolling(self, first: int) -> list[_Hold]:
        """Return pushes with a finger that leans less or more as the part turns."""
        if self.joint.kind != "revolute":
            return []
        start, inner = self._pushed(first)
        found = inner + self._pushed(first, edges=True)[1]
        chosen = _distinct(found, _POINTS, lambda one, other: _apart(one, other) <= _BETWEEN)
        holds = (each for push in chosen for each in self._turned(push, start, first))
        return list(islice(holds, _PUSHES))

    def _hooks(self, first: int) -> list[_Hold]:
        """Return pushes with the side of a finger that lies on a face of the part at its edge."""
        start, found = self._pushed(first, edges=True, beside=True)
        chosen = _distinct(found, _POINTS, _same_side)
        holds = (self._tried(hand, start, _beside(hand.frame), first, own=True) for hand in chosen)
        return list(islice((hold for hold, struck in holds if not struck), _PUSHES))

    def _pushed(
        self, first: int, *, edges: bool = False, beside: bool = False
    ) -> tuple[dict[str, float], list[tuple[float, Affordance]]]:
        """Return positions of other joints, and pushes on faces, each with the motion of its point [m].

        `edges` tells whether the points are beside edges, and `beside` whether the finger lies on the face.
        """
        start = positions_to_move(self.asset, self.joint.name, {})
        found: list[tuple[float, Affordance]] = []
        if start is None:
            return {}, found
        states = self._states(start)
        for name in dict.fromkeys(each.link for each in self.hands):
            faces, before, behind = self.space.faces(name), *(each.pose[name] for each in states[first:][:2])
            some = faces.outs.any(axis=1) == edges
            if beside:
                some &= np.sqrt((faces.outs**2).sum(axis=1)) > _PAST
            points, normals, outs = faces.points[some], faces.normals[some], faces.outs[some]
            shift = np.linalg.inv(before) @ behind - np.eye(4)
            moved = np.einsum("ij,nj->ni", shift[:3, :3], points) + shift[:3, 3]
            along = -(moved * normals).sum(axis=1)
            some = (along > _FACING * np.sqrt((moved**2).sum(axis=1))) & (along > 0.0)
            points, normals, outs, along = points[some], normals[some], outs[some], along[some]
            some = faces.exposed(points + _OUT * normals)
            for point, normal, out, share in zip(
                points[some], normals[some], outs[some], along[some].tolist(), strict=True
            ):
                frame = _facing(point + 0.5 * out, -normal)
                if beside:
                    ahead = -out / max(float(np.linalg.norm(out)), 1e-9)
                    frame[:3, :3] = np.column_stack([normal, np.cross(ahead, normal), ahead])
                    frame[:3, 3] = point + out
                push = Affordance(f"{name}_push", "push", name, frame, 0.0, (self.joint.name,))
                found.append((share, push))
        return start, found

    def _grasps(self, first: int) -> list[_Hold]:
        """Return grasps across two opposite faces of the part that the hand can reach in a state."""
        start = positions_to_move(self.asset, self.joint.name, {})
        if start is None:
            return []
        state, names = self._states(start)[first], [each.name for each in self.asset.links]
        found: list[tuple[int, Affordance]] = []
        for name in dict.fromkeys(each.link for each in self.hands):
            number = names.index(name)
            pieces = [each.convex.faces for each in self.asset.links[number].colliders]
            frames_of, widths = _across(pieces)
            some = np.sort(self.rng.permutation(len(frames_of))[:_CANDIDATES])
            frames_of, widths = frames_of[some], widths[some]
            given = [each for each in self.hands if each.kind == "grasp" and each.link == name]
            rolled = [turned(each.frame, 2, angle) for each in given for angle in _ROLLS]
            frames_of = np.array([*rolled, *frames_of]).reshape(-1, 4, 4)
            widths = np.array([*(each.width for each in given for _ in _ROLLS), *widths])
            if not len(frames_of):
                continue
            solids = [each.convex.manifold() for each in self.asset.links[number].colliders]
            poses = state.pose[name] @ frames_of
            near = state.within(poses[:, :3, 3].min(axis=0) - _NEAR, poses[:, :3, 3].max(axis=0) + _NEAR)
            for frame, width, pose in zip(frames_of, widths, poses, strict=True):
                around = near.within(pose[:3, 3] - _NEAR, pose[:3, 3] + _NEAR)
                between = held(solids, frame)
                if between is None or between[1] - between[0] < _THIN:
                    continue
                hand = Affordance(f"{name}_hold", "grasp", name, frame, float(width), (self.joint.name,))
                tips = state.pose[name] @ np.array(list(orientations(contact_of(hand))))
                fits = self._unhindered(around, tips, float(width), -1)[0]
                if fits.any():
                    found.append((int(fits.sum()), hand))
        chosen = _distinct(found, _GRASPS, _same_grasp)
        holds = (self._oriented(hand, start, first, own=True) for hand in chosen)
        return [hold for hold, struck in holds if not struck]

    def _hold(self, hand: Affordance, begin: int) -> _Hold | None:
        """Return a hold with other joints open where it needs them; None if its hand strikes something."""
        opened: dict[str, AssetCondition] = {} if hand.when is None else {"": hand.when}
        while (start := positions_to_move(self.asset, self.joint.name, opened)) is not None:
            hold, struck = self._oriented(hand, start, begin)
            if not struck:
                return hold
            self.struck = self.struck or struck
            new = (each for each in openable(self.asset, hand, struck) if each[0] not in opened)
            name, where = next(new, ("", None))
            if where is None:
                return None
            opened[name] = where
        return None

    def _oriented(
        self, hand: Affordance, start: dict[str, float], begin: int, *, own: bool = False
    ) -> tuple[_Hold, str]:
        """Return a hold in all orientations of its hand, and a link that is always in its way, if any.

        `own` tells whether the open fingers must not touch their own link.
        """
        contact = contact_of(hand)
        hold, struck = self._tried(hand, start, np.array(list(orientations(contact))), begin, own=own)
        if struck and hand.kind == "push":
            leaning, still = self._tried(hand, start, _leaning(contact.frame), begin)
            if not still:
                return leaning, ""
        return hold, struck

    def _tried(
        self,
        hand: Affordance,
        start: dict[str, float],
        tips: Array,
        begin: int,
        *,
        own: bool = False,
        turns: Sequence[float] = (0.0,),
    ) -> tuple[_Hold, str]:
        """Return a hold with poses of the tip, and a link that is always in its way, if any.

        The poses are those with which a hand can begin, after a short approach where none can after a long
        one. `turns` are shares of the turn that would keep the hand parallel to itself.
        """
        states, vectors = self._states(start), self._turns(hand, start, begin)
        link = [each.name for each in self.asset.links].index(hand.link)
        state, closed = states[begin], max(hand.width - 2.0 * GRIPPER.clearance, 0.0)
        push = None if hand.kind == "grasp" or own else hand.frame[:3, 2]
        poses = state.pose[hand.link] @ _before(tips, push)
        near = state.within(poses[:, :3, 3].min(axis=0) - _NEAR, poses[:, :3, 3].max(axis=0) + _NEAR)
        fits, struck = self._unhindered(near, poses, closed, link)
        if own:
            fits &= self._unhindered(near, poses, hand.width, -1)[0]
        first, back = struck, 0.0
        for back in (BACK, _SHORT):
            ready = fits.copy()
            for share in _BACKS:
                before = poses.copy()
                before[:, :3, 3] -= share * back * poses[:, :3, 2]
                good, struck = self._unhindered(near, before, hand.width, -1 if own else link)
                ready &= good
                first = first or struck
            if ready.any():
                break
        spun = np.concatenate([_spun(tips[ready], hand.frame[:3, 3], share * vectors) for share in turns])
        spun, free = _before(spun, push), np.ones(spun.shape[:2], bool)
        if any(turns) and push is not None:
            free &= spun[..., :3, 2] @ push > _LEAST
        if len(spun):
            for index in range(begin + 1, len(states)):
                state = states[index]
                poses = state.pose[hand.link] @ spun[:, index]
                near = state.within(poses[:, :3, 3].min(axis=0) - _NEAR, poses[:, :3, 3].max(axis=0) + _NEAR)
                free[:, index] &= self._unhindered(near, poses, closed, link)[0]
        return _Hold(hand, start, states, spun, free, back), "" if len(spun) else first or hand.link

    def _unhindered(self, near: _Pieces, poses: Array, width: float, link: int) -> tuple[Mask, str]:
        """Tell for each pose whether the hand strikes nothing, and return a link that it strikes first.

        The fingers, at a distance of `width`, may touch their own link.
        """
        bounds = HAND_BOX + np.array([[-_ROOM], [_ROOM]])
        hits = near.struck(bounds, poses)
        corners = np.stack(np.meshgrid(*bounds.T, indexing="ij"), axis=-1).reshape(-1, 3)
        lowest = (poses[:, None, 2, :3] * corners).sum(axis=2).min(axis=1) + poses[:, 2, 3]
        for name, box in GRIPPER.blocks(-width / 2.0, width / 2.0).items():
            if name != "hand":
                shrunk = box + np.array([[_SLACK], [-_SLACK]])
                hits |= near.struck(shrunk, poses) & (near.links != link)
        free = ~hits.any(axis=1) & (lowest > self.space.floor)
        names = [self.asset.links[int(near.links[piece])].name for piece in np.flatnonzero(hits[0])]
        return free, names[0] if names else ("" if lowest[0] > self.space.floor else "the floor")

    def _states(self, start: Mapping[str, float]) -> list[_State]:
        """Return the states along the way with other joints at positions."""
        key = tuple(sorted(start.items()))
        if key not in self.states:
            self.states[key] = [self.space.at({**start, self.joint.name: float(at)}) for at in self.at]
        return self.states[key]

    def _farthest(self, holds: Sequence[_Hold], first: int) -> tuple[int, Stand] | None:
        """Return the last state to which an arm follows from a state, and its stand."""
        paths = []
        self.held = self.held or bool(holds)
        for hold in holds:
            bases = self._bases(hold, first)
            for variant in range(len(hold.tips)):
                ends = np.flatnonzero(~hold.free[variant, first:])
                last = first + int(ends[0]) - 1 if len(ends) else len(self.at) - 1
                if last == len(self.at) - 1 or last - first >= _GAIN * (len(self.at) - 1):
                    path = _Path(hold, variant, first, last, bases)
                    near, whole = _within_reach(path)
                    if len(near):
                        paths.append((replace(path, bases=near), min(whole, _BATCH)))
        self.footing = self.footing or bool(paths)
        # those that go farthest come first, of these those for which most bases are near
        order = self.rng.permutation(len(paths))
        ranked = sorted((paths[index] for index in order), key=lambda each: (-each[0].last, -each[1]))
        chosen = [path for path, _ in ranked[:_PATHS]]
        best: tuple[int, Stand] | None = None
        for turn in range(_ROUNDS):
            for path in chosen:
                bases = path.bases[turn * _BATCH : (turn + 1) * _BATCH]
                if len(bases) and (best is None or path.last > best[0]):
                    found = self._followed(path, bases)
                    if found is not None and (best is None or found[0] > best[0]):
                        best = found
        return best

    def _bases(self, hold: _Hold, first: int) -> Array:
        """Return free places of the base around the way of a hold in random order, shape (n, 4, 4)."""
        places = np.array([hold.tip(0, index)[:3, 3] for index in range(first, len(self.at))])
        middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
        heights = sorted({max(self.space.floor, float(middle[2]) - above) for above in _ABOVE})
        bases = np.zeros((0, 4, 4))
        for directions, distances in ((_DIRECTIONS, _DISTANCES), (_FINE_DIRECTIONS, _FINE_DISTANCES)):
            if len(bases) < _FEW:
                plan = np.array(np.meshgrid(directions, distances, heights, indexing="ij"))
                bases = self._standing(middle, plan.reshape(3, -1).T, hold.states[first:])
        return bases

    def _standing(self, middle: Array, plan: Array, states: Sequence[_State]) -> Array:
        """Return free places of the base around a point, at directions, distances and heights in a plan."""
        plan = plan[self.rng.permutation(len(plan))]
        bases: Array = np.tile(np.eye(4), (len(plan), 1, 1))
        cosines, sines = np.cos(plan[:, 0]), np.sin(plan[:, 0])
        bases[:, 0, 0] = bases[:, 1, 1] = -cosines
        bases[:, 0, 1], bases[:, 1, 0] = sines, -sines
        bases[:, 0, 3], bases[:, 1, 3] = middle[0] + plan[:, 1] * cosines, middle[1] + plan[:, 1] * sines
        bases[:, 2, 3] = plan[:, 2]
        feet = np.concatenate([_FOOT, [[-10.0], [_SHOULDER]]], axis=1)
        corners = np.array([[x, y, 0.0, 1.0] for x in _FOOT[:, 0] for y in _FOOT[:, 1]])
        edges = np.einsum("nij,kj->nki", bases, corners)[:, :, :2]
        inside = (edges >= self.space.ground[0]) & (edges <= self.space.ground[1])
        bases = bases[inside.all(axis=(1, 2))]
        names = [each.name for each in self.asset.links]
        moved = [not np.array_equal(states[0].pose[name], states[-1].pose[name]) for name in names]
        for number, state in enumerate(states):
            pieces = state.chosen(np.array(moved)[state.links]) if number else state
            bases = bases[~pieces.struck(feet, bases).any(axis=1)]
        return bases

    def _followed(self, path: _Path, bases: Array) -> tuple[int, Stand] | None:
        """Return the last state to which an arm follows a path from one of several bases, and its stand."""
        inverse, tips = np.linalg.inv(bases), path.tips()
        angles, which = starts(inverse @ tips[0][1], self.rng, (10, 0.15))
        followed = angles[:, None]
        score = ease(angles)
        best, state = None, None
        for number, (index, tip) in enumerate(tips):
            if path.hold.states[index] is not state:
                state = path.hold.states[index]
                near = state.within(tip[:3, 3] - _AROUND, tip[:3, 3] + _AROUND)
            moved, miss = reach(angles, inverse[which] @ tip, 5 if number else 2)
            good = (miss < MISS) & (np.abs(moved - angles).max(axis=1) < JUMP)
            good[good] &= self._clear(near, bases[which[good]], moved[good])
            score = np.minimum(score, ease(moved))
            good &= score > _EASE
            if not good.any():
                self._note_blocking(near, bases[which], moved)
                break
            angles, which, score = moved[good], which[good], score[good]
            followed = np.concatenate([followed[good], angles[:, None]], axis=1)
            if number >= len(_BACKS) + 1:
                most = int(score.argmax())
                best = index, bases[which[most]], followed[most, 1:]
        if best is None:
            return None
        at = [self.at[index] for index, _ in tips[: len(best[2])]]
        hand, start, tips_of = path.hold.affordance, path.hold.start, path.hold.tips[path.variant]
        stand = Stand(
            self.joint.name, hand.name, hand.link, 0.0, best[1], best[2][0], start, at=np.array(at),
            path=best[2], tip=tips_of[path.first], turns=bool(np.ptp(tips_of, axis=0).max() > _STILL),
        )  # fmt: skip
        return best[0], stand

    def _clear(self, near: _Pieces, bases: Array, angles: Array) -> Mask:
        """Tell for each posture whether the arm strikes no obstacle, nor the floor, nor its own foot."""
        poses = frames(angles)
        points, own = _balls(poses, _JOINTS, _PLACES), _balls(poses, _OWN_JOINTS, _OWN_PLACES)
        beside = np.sqrt((own[..., :2] ** 2).sum(axis=2)) > _COLUMN + _OWN_RADII
        good = (beside | (own[..., 2] > _SHOULDER + _OWN_RADII)).all(axis=1)
        points = np.einsum("nij,nkj->nki", bases[:, :3, :3], points) + bases[:, None, :3, 3]
        good &= (points[..., 2] > self.space.floor + _RADII).all(axis=1)
        some = np.flatnonzero(good)
        balls = points[some].reshape(-1, 3)
        if len(balls):
            near = near.within(balls.min(axis=0) - _RADII.max(), balls.max(axis=0) + _RADII.max())
        free = near.clear(balls, np.tile(_RADII, len(some)))
        good[some] = free.reshape(len(some), len(_RADII)).all(axis=1)
        return np.asarray(good)

    def _note_blocking(self, near: _Pieces, bases: Array, angles: Array) -> None:
        """Count the links that an arm strikes in some postures."""
        points = _balls(frames(angles[:_POSTURES]), _JOINTS, _PLACES)
        for balls, base in zip(points, bases, strict=False):
            met = near.met(balls @ base[:3, :3].T + base[:3, 3], _RADII)
            self.blocking.update(self.asset.links[number].name for number in sorted(met))


def _spread(firsts: Indices, counts: Indices) -> tuple[Indices, Indices, Indices]:
    """Return for all members of ranges the range and the member, and the first entry of each range."""
    ends = np.cumsum(counts)
    which = np.repeat(np.arange(len(counts)), counts)
    return which, np.arange(ends[-1]) + (firsts - ends + counts)[which], ends - counts


def _turned_back(vectors: Array, turns: Array) -> Array:
    """Return vectors, shape (n, 3), in the axes of poses with rotations of shape (n, 3, 3)."""
    return np.asarray(np.einsum("nj,njk->nk", vectors, turns))


def _distinct(
    found: Iterable[tuple[float, Affordance]], most: int, alike: Callable[[Affordance, Affordance], bool]
) -> list[Affordance]:
    """Return those of the highest scores that are not alike, at most a number."""
    chosen: list[Affordance] = []
    for _, hand in sorted(found, key=lambda each: -each[0]):
        if len(chosen) < most and not any(alike(hand, other) for other in chosen):
            chosen.append(hand)
    return chosen


def _apart(one: Affordance, other: Affordance) -> float:
    """Return the distance of two hands on the same link [m]."""
    return float(np.linalg.norm(one.frame[:3, 3] - other.frame[:3, 3]))


def _same_grasp(one: Affordance, other: Affordance) -> bool:
    """Tell whether two grasps of a link are near each other, with fingers and approach alike."""
    closing, approach = one.frame[:3, 0] @ other.frame[:3, 0], one.frame[:3, 2] @ other.frame[:3, 2]
    return bool(_apart(one, other) <= _BESIDE and abs(closing) >= _ALIKE and approach >= 0.0)


def _same_side(one: Affordance, other: Affordance) -> bool:
    """Tell whether two fingers lie on a link near each other, and point the same way."""
    return _apart(one, other) <= _BETWEEN and float(one.frame[:3, 2] @ other.frame[:3, 2]) >= _ALIKE


def _across(pieces: Sequence[Polytope]) -> tuple[Array, Array]:
    """Return frames of grasps across two faces of pieces, shape (n, 4, 4), and openings, shape (n,) [m]."""
    result: list[Array] = []
    openings: list[float] = []
    for piece in pieces:
        normals = piece.planes[:, :3]
        pairs = np.argwhere(np.triu(normals @ normals.T < -_OPPOSITE))
        for one, other in pairs:
            normal = normals[one] - normals[other]
            normal /= np.linalg.norm(normal)
            along = piece.points @ normal
            thick = float(along.max() - along.min())
            width = GRIPPER.opening(thick)
            corners = piece.points[piece.contact[:, one]]
            if thick <= _THIN or width > GRIPPER.stroke or len(corners) < 3:
                continue
            corners = corners + (along.max() - corners @ normal)[:, None] * normal
            for point, out in _beside_edges(corners, normal):
                ahead, frame = -out / np.linalg.norm(out), np.eye(4)
                frame[:3, 0], frame[:3, 1], frame[:3, 2] = normal, np.cross(ahead, normal), ahead
                frame[:3, 3] = point - 0.5 * thick * normal
                result.append(frame)
                openings.append(width)
    if not result:
        return np.zeros((0, 4, 4)), np.zeros(0)
    frames_of = np.array(result)
    rough = np.concatenate(
        [frames_of[:, :3, 3] / _CELL, frames_of[:, :3, 2] / _COARSE, frames_of[:, :3, 0] / _COARSE], axis=1
    )
    rough[:, 6:] = np.abs(rough[:, 6:])
    some = np.sort(np.unique(rough.round(), axis=0, return_index=True)[1])
    return frames_of[some], np.array(openings)[some]


def _beside_edges(corners: Array, normal: Array) -> Iterator[tuple[Array, Array]]:
    """Yield points of a convex face beside its edges, and vectors to the edges, shape (3,) each [m]."""
    middle = corners.mean(axis=0)
    flat = corners - middle
    side = flat[np.linalg.norm(flat, axis=1).argmax()]
    side = side / max(float(np.linalg.norm(side)), 1e-9)
    turn = np.arctan2(flat @ np.cross(normal, side), flat @ side)
    corners = corners[np.argsort(turn, kind="stable")]
    for begin, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        out = np.cross(end - begin, normal)
        length = float(np.linalg.norm(out))
        if length < _THIN:
            continue
        out /= length
        deep = min(_INSIDE, float((begin - middle) @ out))
        end_share = 2.0 * _INSIDE / length
        for share in (0.5, end_share, 1.0 - end_share)[: 3 if end_share < 0.5 else 1]:
            yield begin + share * (end - begin) - deep * out, deep * out


def _beside(frame: Array) -> Array:
    """Return poses of a tip whose finger is beside the plane x = 0, past the edge z = 0, shape (n, 4, 4) [m].

    The finger lies on the plane, or only on the edge.
    """
    result = []
    for lean in (0.0, *_LEANS[:2]):
        for roll in _QUARTERS:
            out = turned(frame, 1, lean)
            aside = GRIPPER.wide / 2.0 if roll % math.pi else GRIPPER.thick
            out[:3, 3] += aside * out[:3, 0] + _PAST * out[:3, 2]
            result.append(lifted(turned(out, 2, roll), -GRIPPER.tip))
    return np.array(result)


def _before(tips: Array, push: Array | None) -> Array:
    """Return poses of a tip, shape (..., 4, 4) [m], moved until the foremost edge or corner is at the end."""
    if push is None:
        return tips
    result = tips.copy()
    corner = np.array([GRIPPER.thick, GRIPPER.wide / 2.0])
    past = (tips[..., :3, :2] * push[:, None]).sum(axis=-2)
    ends = corner * np.where(np.abs(past) > _TILTED, np.sign(past), 0.0)
    result[..., :3, 3] -= (tips[..., :3, :2] * ends[..., None, :]).sum(axis=-1)
    result[..., :3, 3] -= ((np.abs(past) * corner - past * ends).sum(axis=-1))[..., None] * push
    return result


def _spun(tips: Array, about: Array, vectors: Array) -> Array:
    """Return poses, shape (n, 4, 4), turned about a point by m vectors, shape (n, m, 4, 4) [m]."""
    turns = Rotation.from_rotvec(vectors).as_matrix()
    result = np.tile(tips[:, None], (1, len(vectors), 1, 1))
    result[..., :3, :3] = turns @ tips[:, None, :3, :3]
    result[..., :3, 3] = np.einsum("mij,nj->nmi", turns, tips[:, :3, 3] - about) + about
    return result


def _leaning(
    tip: Array, sides: Sequence[float] = tuple(_TURNS), leans: Sequence[float] = tuple(_LEANS)
) -> Array:
    """Return poses of the tip of a finger that leans to sides about its end, shape (n, 4, 4) [m]."""
    end = np.eye(4)
    end[2, 3] = GRIPPER.tip
    result: list[Array] = []
    for lean in (0.0, *leans):
        for side in sides if lean else sides[:1]:
            axis = turned(np.eye(4), 2, side) @ turned(np.eye(4), 0, lean) @ turned(np.eye(4), 2, -side)
            rolls = (turned(np.eye(4), 2, roll) for roll in _TURNS[: len(_TURNS) // 2])
            result += [tip @ end @ axis @ roll @ np.linalg.inv(end) for roll in rolls]
    return np.array(result)


def _facing(point: Array, along: Array) -> Array:
    """Return a frame at a point with its z axis along a unit vector, shape (4, 4)."""
    side = np.cross((0.0, 0.0, 1.0), along)
    if np.linalg.norm(side) < 0.1:
        side = np.cross((0.0, 1.0, 0.0), along)
    side = side / np.linalg.norm(side)
    frame = np.eye(4)
    frame[:3, 0], frame[:3, 1], frame[:3, 2], frame[:3, 3] = side, np.cross(along, side), along, point
    return frame


def _balls(poses: Array, joints: Array, places: Array) -> Array:
    """Return the centers of balls at poses of joints, shape (n, balls, 3) [m]."""
    chosen = poses[:, joints]
    return np.asarray(np.einsum("nkij,kj->nki", chosen[..., :3, :3], places) + chosen[..., :3, 3])


def _within_reach(path: _Path) -> tuple[Array, int]:
    """Return the bases of a path whose wrist is near at first, and the number of those near all the way.

    Bases from which most of the way is near come first.
    """
    tips = np.array([tip for _, tip in path.tips()])
    wrists = tips[:, :3, 3] - _TIP * tips[:, :3, 2]
    shoulders = path.bases[:, :3, 3] + (0.0, 0.0, _SHOULDER)
    away = np.linalg.norm(shoulders[:, None] - wrists, axis=2)
    ends = away[:, : len(_BACKS) + 1 + max(1, (path.last - path.first) // 4)]  # a part of the way counts too
    near = ((ends > _WRIST[0]) & (ends < _WRIST[1])).all(axis=1)
    share = ((away[near] > _WRIST[0]) & (away[near] < _WRIST[1])).mean(axis=1)
    return path.bases[near][np.argsort(-share, kind="stable")], int((share == 1.0).sum())
