"""Directions that are tried to keep pieces apart, for many items at once."""

from dataclasses import dataclass, field, replace

import numpy as np

from artgen._arrays import Array, Indices
from artgen.proof.bounds import Motion, gap
from artgen.proof.items import NONE
from artgen.proof.kinematics import Layout

GRAIN = 1e9
"""Steps per metre in which gaps are compared, so that ties fall alike on every machine."""

_UNIT = 0.99  # least square of the length of a normal
_HARDLY = 0.02  # variables that move the pieces by less than this share of the largest motion stay whole


@dataclass(eq=False)
class Planes:
    """The best plane of each item so far.

    Attributes:
        first: Vertices of the nodes of link A, shape (N, V, 3) [m].
        second: Vertices of the nodes of link B, shape (N, W, 3) [m].
        path: The joints between them.
        best: The bound of the best plane, shape (N,) [m].
        normal: Its normal, shape (N, 3).
        frame: Its frame, shape (N,).
    """

    first: Array
    second: Array
    path: list[Motion]
    best: Array = field(init=False)
    normal: Array = field(init=False)
    frame: Indices = field(init=False)

    def __post_init__(self) -> None:
        count = len(self.first)
        self.best = np.full(count, -np.inf)
        self.normal = np.zeros((count, 3))
        self.frame = np.full(count, NONE, np.int64)

    def attempt(self, rows: Indices, normals: Array, frame: int) -> Array:
        """Try directions, shape (n, C, 3), for some items in a frame; return the best gap of each [m]."""
        if not len(rows):
            return np.zeros(0)
        whole = len(rows) == len(self.best)
        path = self.path if whole else [taken(motion, rows) for motion in self.path]
        first, second = (self.first, self.second) if whole else (self.first[rows], self.second[rows])
        gaps = gap(first, second, path, frame, normals)
        gaps[np.sum(normals * normals, axis=2) < _UNIT] = -np.inf  # no direction: that keeps nothing apart
        choice = np.round(gaps * GRAIN).argmax(axis=1)
        line = np.arange(len(rows))
        reached: Array = gaps[line, choice]
        better = reached > self.best[rows]
        chosen = rows[better]
        self.best[chosen] = reached[better]
        self.normal[chosen] = normals[line, choice][better]
        self.frame[chosen] = frame
        return reached


@dataclass(eq=False)
class Ahead:
    """What splitting each variable of open items would gain, along the direction that FCL proposed."""

    first: Array
    second: Array
    path: list[Motion]
    normal: Array
    frame: Indices

    def dimension(self, layout: Layout, ways: Indices, rows: Indices, motion: Array) -> Indices:
        """Return the variable to split for some items: the one that would raise the bound most."""
        motion = motion[rows]
        if motion.shape[1] == 1:
            return np.zeros(len(rows), np.int64)
        gain = np.zeros_like(motion)
        for frame in np.unique(self.frame[rows]):
            if frame < 0:
                continue
            lines = np.flatnonzero(self.frame[rows] == frame)
            chosen = rows[lines]
            path = [taken(each, chosen) for each in self.path]
            normals = self.normal[chosen][:, None, :]
            pieces = self.first[chosen], self.second[chosen]
            before = gap(*pieces, path, int(frame), normals)[:, 0]
            for variable in range(motion.shape[1]):
                held = [
                    replace(
                        each, half=np.where(layout.variable[ways[chosen], step] == variable, 0.0, each.half)
                    )
                    for step, each in enumerate(path)
                ]
                gain[lines, variable] = gap(*pieces, held, int(frame), normals)[:, 0] - before
        score = np.where(self.frame[rows, None] < 0, motion, gain + 1e-3 * motion)
        score[motion < _HARDLY * motion.max(axis=1, keepdims=True)] = -np.inf
        choice: Indices = np.round(score * GRAIN).argmax(axis=1)
        return choice


def taken(motion: Motion, rows: Indices) -> Motion:
    """Return the motion of some of its items."""
    return Motion(
        motion.kind, *(each[rows] for each in (motion.origin, motion.axis, motion.centre, motion.half))
    )
