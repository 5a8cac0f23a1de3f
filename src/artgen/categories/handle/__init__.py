"""A door handle as displayed in a shop: a lever, knob or grip set on a piece of door leaf, with its latch.

Links: `base` (a piece of door leaf on a foot, with roses and faceplate), `handle`, `latch`; `lock` if there
is one; `thumb_latch` on a grip set. Joints: `handle_turn`, against a spring; `latch_slide` and `thumb_press`,
which follow it; `lock_turn` or `lock_push`.

The lock is the privacy lock of a bathroom door: in the middle of a knob, or in the rose below a lever. A grip
set has its lever or knob, and its lock, on the inside (the back).

Sizes are those of EN 12209 and EN 1906 locks and furniture and of bored locks after ANSI/BHMA A156.2.
"""

from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.handle.grip_set import grip, thumb_piece, thumb_press
from artgen.categories.shared import HARDWARE_LABELS, locks, require_suited
from artgen.categories.shared.door_handles import knob_handle, lever_handle, spring_turn
from artgen.categories.shared.finish import FINISH_WEIGHTS, FINISHES, known, paints, recess

_HANDLES = {"lever": lever_handle, "knob": knob_handle}
_FOOT = 0.020  # thickness of the stand's foot [m]
_DEEP = 0.15  # depth of the foot, front to back [m]
_WIDTH = 0.20  # width of the piece of door leaf [m]
_WOODS = "oak oak_flat_sawn walnut walnut_flat_sawn beech maple ash mahogany pine_flat_sawn"
_LEAVES = (*known(*_WOODS.split()), *paints(700.0, "paint"))
_LEAF_WEIGHTS = tuple(
    3.0 if leaf.name == "paint_white" else 0.6 if leaf.name.startswith("paint_") else 1.2 for leaf in _LEAVES
)
_FEET = (
    ag.material("black_abs").with_(name="stand", density=1800.0),  # density with stone powder as ballast
    *known("walnut", "oak", "granite", "black_granite", "aluminium"),
)
_FOOT_WEIGHTS = (4.0, *(1.0,) * (len(_FEET) - 1))


@ag.category(labels=("stand", "door", *HARDWARE_LABELS, "grip", "thumb_latch"), joints=(2, 4))
def handle(
    *,
    kind: Literal["lever", "knob", "grip_set"] = ag.choice({"lever": 0.45, "knob": 0.3, "grip_set": 0.25}),
    inside: Literal["lever", "knob"] = ag.by(
        "kind", lever={"lever": 1}, knob={"knob": 1}, grip_set={"lever": 1, "knob": 1}
    ),
    handle: ag.Generator = ag.by("inside", _HANDLES),
    rose_style: Literal["round", "square", "plate"] = ag.choice(
        {"round": 0.5, "square": 0.25, "plate": 0.25}
    ),
    rose_across: ag.Float = ag.by(
        "rose_style",
        # EN 1906 roses are 50-55 mm wide, those of bored American locks 65-80 mm
        round=ag.uniform(0.050, 0.080, "m"),
        square=ag.uniform(0.050, 0.065, "m"),
        plate=ag.uniform(0.040, 0.050, "m"),
        within=(0.04, 0.1),
        doc="diameter or width of the rose or plate",
    ),
    plate_height: ag.Float = ag.uniform(0.19, 0.22, "m", doc="height of a long plate", within=(0.12, 0.24)),
    rose_depth: ag.Float = ag.uniform(0.007, 0.010, "m", doc="height of the rose", within=(0.007, 0.014)),
    lock: Literal["none", "turn", "push"] = ag.choice("none", "turn", "push"),
    turn: ag.Float = ag.uniform(0.6, 0.9, "rad", doc="range of the handle", within=(0.4, 1.2)),
    release: ag.Float = ag.uniform(
        0.82, 0.9, doc="share of the turn that frees the latch", within=(0.7, 1.0)
    ),
    throw: ag.Float = ag.uniform(0.010, 0.0127, "m", doc="projection of the latch", within=(0.006, 0.015)),
    backset: ag.Float = ag.uniform(0.060, 0.070, "m", doc="distance to the lock edge", within=(0.05, 0.13)),
    thickness: ag.Float = ag.uniform(0.035, 0.045, "m", doc="thickness of the leaf", within=(0.032, 0.06)),
    preload: ag.Float = ag.uniform(0.6, 0.9, "N m", doc="torque of the spring at rest", within=(0.3, 2.0)),
    torque_ratio: ag.Float = ag.uniform(
        1.5, 2.0, doc="ratio of the torques at the full turn and at rest", within=(1.05, 4)
    ),
    damping: ag.Float = ag.uniform(0.05, 0.08, "N m s/rad", doc="damping of the handle"),
    hand: Literal["left", "right"] = ag.choice("left", "right"),
    finish: ag.Material = ag.shades(*FINISHES, weights=FINISH_WEIGHTS, color=0.03, roughness=0.03),
    fixing: locks.Fixing = ag.by(
        "rose_style",
        plate={"slot": 1, "phillips": 1},
        otherwise={"hidden": 0.4, "slot": 0.3, "phillips": 0.3},
        doc="fixing of roses: hidden, or with two screws",
    ),
    leaf: ag.Material = ag.shades(*_LEAVES, weights=_LEAF_WEIGHTS),
    foot: ag.Material = ag.shades(
        *_FEET, weights=_FOOT_WEIGHTS, color=0.05, doc="finish of the display stand"
    ),
    maker: str = ag.choice(*details.BRANDS, doc="brand on the stand and on the latch"),
    model: int = ag.count(101, 989, doc="number on the stand"),
) -> ag.Body:
    """Make a lever, knob or grip set on a stand: both sides, spindle, latch, lock."""
    require_suited(handle, "inside", inside, _HANDLES)
    is_set = kind == "grip_set"
    faces: locks.Faces = "back" if is_set else "both"
    side = 1 if is_set else -1  # the face with the lock
    common = {"thickness": thickness, "rose_depth": rose_depth, "finish": finish, "faces": faces}
    pinned = lock if inside == "lever" else "none"  # a knob contains the lock
    # the pin of a lock needs a rose with a margin of 3 mm beyond it
    across = ag.max_(rose_across, 0.062) if pinned != "none" and rose_style != "plate" else rose_across

    # all parts are built about the spindle, and moved onto the stand at the end
    height = 0.35 if is_set else 0.145
    board = ag.Region((backset - _WIDTH, backset), (-thickness / 2, thickness / 2), (-height, 0.125))
    pocket, dark = locks.latch_pocket(backset=backset, throw=throw), recess(finish)
    holes = [hole.paint(dark) for hole in (locks.spindle_hole(thickness), pocket)]
    base = ag.weld(
        _stand(board, holes, leaf, foot, (maker.upper(), f"No. {model}")),
        locks.rose(
            thickness=thickness,
            depth=rose_depth,
            across=across,
            finish=finish,
            style=rose_style,
            height=plate_height,
            faces=faces,
            pin=pinned != "none",
            pin_side=side,
            fixing=fixing,
        ),
        locks.faceplate(backset=backset, finish=finish, mark=maker),
    )
    if is_set:
        base = ag.weld(
            base, grip(thickness=thickness, depth=rose_depth, finish=finish, length=0.23, projection=0.055)
        )
    lean = spring_turn(limit=turn, preload=preload, torque=preload * torque_ratio, damping=damping)
    inner = {} if inside == "lever" else {"lock": lock, "lock_side": side}
    base = base.attach(handle(**common, **inner), lean)
    if pinned != "none":
        base = locks.with_button(
            base,
            pinned,
            face=thickness / 2 + rose_depth,
            depth=rose_depth,
            finish=finish,
            side=side,
            below=locks.PIN_BELOW,
        )
    bolt = locks.latch_bolt(backset=backset, throw=throw, finish=finish)
    base = base.attach(bolt, locks.latch_slide(lean, throw=throw, release=release * turn))
    if is_set:
        piece = thumb_piece(thickness=thickness, depth=rose_depth, finish=finish)
        press = thumb_press(lean, limit=turn, thickness=thickness, depth=rose_depth)
        base = base.attach(piece, press)
    shown = base.at(_WIDTH / 2 - backset, 0.0, height + _FOOT)
    return shown.mirror(ag.X) if hand == "right" else shown


def _stand(
    board: ag.Region, holes: Sequence[ag.Solid], wood: ag.Material, foot: ag.Material, lines: tuple[str, str]
) -> ag.Body:
    """Make a bored piece of door leaf on a foot, with the name of the maker and the model engraved on it."""
    block = board.with_(y=(-_DEEP / 2, _DEEP / 2), z=(board.z.low - _FOOT, board.z.low))
    pad = ag.cylinder(0.008, 0.0016, bevel=0.0004).at(z=block.z.low + 0.0008)
    corners = [(x, y, 0.0) for x in block.x for y in block.shrink(y=0.018).y]
    leaf = board.grow(bottom=0.002).box(bevel=0.0015)
    for hole in holes:
        leaf = leaf - hole
    metal, front = ag.material("stainless"), block.grow(front=0.0004).anchor(y=-1)
    plate = ag.extrude(ag.rectangle(0.060, 0.0125, radius=0.0012), 0.0010, axis=ag.Y, bevel=0.0002)
    name = details.lettering(lines[:1], 0.0036, tracking=0.15, fineness="coarse").at(0.0, 0.0019)
    model = details.lettering(lines[1:], 0.0021, tracking=0.05, fineness="coarse").at(0.0, -0.0033)
    return ag.weld(
        ag.part(block.grow(x=0.025).box(bevel=0.003), "stand", foot, name="base"),
        ag.part(leaf, "door", wood),
        ag.detail(ag.array(pad, at=corners), "stand", ag.material("rubber")),
        ag.detail(plate.at(front).at(0.0, 0.0005), "stand", metal),
        details.engraved(name | model, front, label="stand", material=metal),
    )
