"""Poses of an asset to look for overlaps in."""

import math
from itertools import product

import numpy as np

from artgen.asset import Asset

_FEW = 5  # joints, of which every corner of joint space is looked at


def free_poses(asset: Asset, count: int = 12) -> list[dict[str, float]]:
    """Return the corners of joint space and some poses between that no dependency forbids."""
    draw = np.random.default_rng(7)
    joints = asset.free_joints
    limits = np.array([joint.limits or (-math.pi, math.pi) for joint in joints])
    if len(joints) <= _FEW:
        shares = [np.array(corner) for corner in product((0.0, 1.0), repeat=len(joints))]
    else:  # too many corners: some of them, those among them in which everything is closed or open
        shares = [np.zeros(len(joints)), np.ones(len(joints))]
        shares += [draw.integers(0, 2, len(joints)).astype(float) for _ in range(2**_FEW)]
    shares += [draw.random(len(joints)) ** draw.choice([0.3, 1.0, 3.0]) for _ in range(count)]
    names = [joint.name for joint in joints]
    poses = [dict(zip(names, limits[:, 0] + share * np.ptp(limits, axis=1), strict=True)) for share in shares]
    return [pose for pose in poses if not asset.blocked(pose)]
