"""Readings of layouts that have names, axes and closed ends of their own, taken back to those of the asset.

Such a layout keeps beside its main file which of artgen's links and joints its own names stand for.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from artgen._arrays import Array
from artgen.export.layouts.partnet.names import NAMES_FILE
from artgen.validate.readback.pieces import Piece
from artgen.validate.readback.reading import Faces, Inertial, Reading, Said

Law = tuple[str, float, float]

_UP = np.array([0.0, 0.0, 1.0, 0.0])
_UPRIGHT = 1e-6  # error of an axis


@dataclass(frozen=True, eq=False)
class Names:
    """What the names of a layout stand for."""

    links: Mapping[str, str]  # link of the asset, by name of the body
    # joint of the asset, and -1 where it is turned round, else 1, by name in the file
    joints: Mapping[str, tuple[str, int]]
    # leader, ratio and offset of each joint that follows, in the names of the file
    couplings: Mapping[str, Law]
    axes: Array  # from the asset's coordinates to those of the bodies, shape (3, 3): right angles only

    @property
    def bodies(self) -> dict[str, str]:
        """Name of the body of each link."""
        return {link: body for body, link in self.links.items()}

    def joint(self, name: str) -> str:
        """Return the joint of the asset that a name stands for."""
        return self.joints.get(name, (name, 1))[0]

    def sign(self, name: str) -> int:
        """Return -1 where a joint is turned round, else 1."""
        return self.joints.get(name, (name, 1))[1]

    def law(self, follower: str, law: Law) -> Law:
        """Return a coupling of the file in the joints of the asset."""
        leader, ratio, offset = law
        sign = self.sign(follower)
        return self.joint(leader), sign * self.sign(leader) * ratio, sign * offset


def read_names(path: Path) -> Names | None:
    """Read what the names in a file stand for; None where it has those of the asset."""
    table = path.parent / NAMES_FILE
    if not table.exists():
        return None
    data = json.loads(table.read_text(encoding="utf-8"))
    return Names(
        {str(body): str(link) for body, link in data["links"].items()},
        {str(name): (str(each["name"]), int(each["sign"])) for name, each in data["joints"].items()},
        {str(name): (str(law[0]), float(law[1]), float(law[2])) for name, law in data["couplings"].items()},
        np.array(data["axes"], float),
    )


def translated(reading: Reading, names: Names, base: str) -> Reading:
    """Return a reading in the names, axes and positions of the asset."""
    back = names.axes.T
    turn = np.eye(4)
    turn[:3, :3] = names.axes

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        own = {
            name: sign * positions[joint]
            for name, (joint, sign) in names.joints.items()
            if joint in positions
        }
        found = {name: frame @ turn for name, frame in reading.frames(own).items()}
        if base in found and np.abs(found[base][:, 2] - _UP).max() <= _UPRIGHT:
            # the layout may have its front elsewhere, but not its top
            away = np.linalg.inv(found[base])
            found = {name: away @ frame for name, frame in found.items()}
        return found

    return replace(
        reading,
        frames=frames,
        inertials={
            name: Inertial(each.mass, back @ each.center, back @ each.inertia @ names.axes)
            for name, each in reading.inertials.items()
        },
        kinds={names.joint(name): kind for name, kind in reading.kinds.items()},
        ends={
            names.joint(name): (names.links.get(first, first), names.links.get(second, second))
            for name, (first, second) in reading.ends.items()
        },
        limits={names.joint(name): _turned(each, names.sign(name)) for name, each in reading.limits.items()},
        axes={names.joint(name): names.sign(name) * (back @ axis) for name, axis in reading.axes.items()},
        dynamics={
            names.joint(name): tuple(
                Said(
                    each.field,
                    names.sign(name) * each.value if each.field == "rest" else each.value,
                    each.source,
                )
                for each in said
            )
            for name, said in reading.dynamics.items()
        },
        couplings={names.joint(name): names.law(name, law) for name, law in _laws(reading, names).items()},
        colliders={
            name: tuple(_piece(piece, back) for piece in pieces) for name, pieces in reading.colliders.items()
        },
        faces={
            name: tuple(Faces(each.name, _bounds(each.bounds, back), each.count) for each in faces)
            for name, faces in reading.faces.items()
        },
        holds=None,
    )


def _laws(reading: Reading, names: Names) -> dict[str, Law]:
    """Return the couplings of a file; those between joints of one body are in the table, not in the URDF."""
    laws = dict(reading.couplings)
    for follower, law in names.couplings.items():
        ends = [reading.ends.get(name) for name in (follower, law[0])]
        if ends[0] and ends[1] and ends[0][0] == ends[1][0]:
            laws.setdefault(follower, law)
    return laws


def _turned(limits: tuple[float, float] | None, sign: int) -> tuple[float, float] | None:
    return limits if limits is None or sign > 0 else (-limits[1], -limits[0])


def _bounds(bounds: Array, turn: Array) -> Array:
    return np.sort(bounds @ turn.T, axis=0)


def _piece(piece: Piece, turn: Array) -> Piece:
    return replace(
        piece,
        bounds=_bounds(piece.bounds, turn),
        middle=turn @ piece.middle,
        vertices=piece.vertices @ turn.T,
    )
