"""A door handle as a shop shows it: a lever, a knob or a grip set on a piece of door leaf, with its latch."""

from typing import Literal

from artgen import (
    Body,
    Float,
    Generator,
    Material,
    X,
    box,
    by,
    category,
    choice,
    detail,
    material,
    max_,
    part,
    uniform,
    weld,
)
from artgen.categories.parts import HARDWARE_LABELS
from artgen.categories.parts.finish import FINISHES
from artgen.categories.parts.grip_set import grip, thumb_piece, thumb_press
from artgen.categories.parts.knobs import knob_handle
from artgen.categories.parts.latch import faceplate, latch_bolt, latch_pocket, latch_slide
from artgen.categories.parts.levers import lever_handle, spring_turn
from artgen.categories.parts.locks import with_button
from artgen.categories.parts.roses import PIN_BELOW, Faces, rose, spindle_hole

_FOOT = 0.020  # thickness of the stand's foot [m]
_WIDTH = 0.20  # of the piece of door leaf [m]
_WOODS = tuple(material(name) for name in ("oak", "walnut", "beech", "mahogany", "painted_wood"))


@category(labels=("stand", "door", *HARDWARE_LABELS, "grip", "thumb_latch"))
def handle(
    *,
    kind: Literal["lever", "knob", "grip_set"] = choice(
        "lever", "knob", "grip_set", weights=(0.45, 0.3, 0.25)
    ),
    inside: Literal["lever", "knob"] = by(
        "kind", lever=choice("lever"), knob=choice("knob"), grip_set=choice("lever", "knob")
    ),
    handle: Generator = by("inside", lever=lever_handle, knob=knob_handle),
    rose_style: Literal["round", "square", "plate"] = choice(
        "round", "square", "plate", weights=(0.5, 0.25, 0.25)
    ),
    rose_across: Float = by(
        "rose_style",
        # EN 1906 roses are 50-55 mm, those of bored American locks 65-80 mm
        round=uniform(0.050, 0.080, "m"),
        square=uniform(0.050, 0.065, "m"),
        plate=uniform(0.040, 0.050, "m"),
        within=(0.04, 0.1),
        doc="diameter or width of the rose or plate",
    ),
    plate_height: Float = uniform(0.19, 0.22, "m", doc="of a long plate", within=(0.12, 0.24)),
    rose_depth: Float = uniform(0.007, 0.010, "m", doc="how far the rose stands out", within=(0.007, 0.014)),
    lock: Literal["none", "turn", "push"] = choice("none", "turn", "push"),
    turn: Float = uniform(0.6, 0.9, "rad", doc="how far the handle turns", within=(0.4, 1.2)),
    release: Float = uniform(0.82, 0.9, doc="share of the turn that frees the latch", within=(0.7, 1.0)),
    throw: Float = uniform(0.010, 0.0127, "m", doc="how far the latch stands out", within=(0.006, 0.015)),
    backset: Float = uniform(0.060, 0.070, "m", doc="lock edge to spindle", within=(0.05, 0.13)),
    thickness: Float = uniform(0.035, 0.045, "m", doc="thickness of the leaf", within=(0.032, 0.06)),
    preload: Float = uniform(0.6, 0.9, "N m", doc="torque of the spring at rest", within=(0.3, 2.0)),
    torque_ratio: Float = uniform(
        1.5, 2.0, doc="torque at the full turn over that at rest", within=(1.05, 4)
    ),
    damping: Float = uniform(0.05, 0.08, "N m s/rad", doc="of the handle"),
    hand: Literal["left", "right"] = choice("left", "right"),
    finish: Material = choice(*FINISHES),
    leaf: Material = choice(*_WOODS),
) -> Body:
    """Build a handle with both its sides, spindle and latch on a display stand.

    Links: base (a piece of door leaf on a foot, with roses and faceplate), handle, latch; lock where there
    is one; thumb_latch on a grip set. Joints: handle_turn (sprung), latch_slide and thumb_press (both follow
    it), lock_turn or lock_push. The lock is the privacy lock of a bathroom door: in the middle of a knob, or
    in the rose below a lever. A grip set has its lever or knob, and its lock, inside, which is the back.

    Sizes are those of EN 12209 and EN 1906 locks and furniture and of bored locks after ANSI/BHMA A156.2.
    """
    is_set = kind == "grip_set"
    faces: Faces = "back" if is_set else "both"
    side = 1 if is_set else -1  # the face with the lock
    common = {"thickness": thickness, "rose_depth": rose_depth, "finish": finish, "faces": faces}
    pinned = lock if inside == "lever" else "none"  # a knob has the lock in itself
    # the pin of a lock needs a rose that reaches 3 mm past it
    across = max_(rose_across, 0.062) if pinned != "none" and rose_style != "plate" else rose_across

    # all is built about the spindle, and moved onto its stand at the end
    height = 0.35 if is_set else 0.145
    base = weld(
        _stand(thickness, backset, throw, low=-height, high=0.125, wood=leaf),
        rose(
            thickness=thickness,
            depth=rose_depth,
            across=across,
            finish=finish,
            style=rose_style,
            height=plate_height,
            faces=faces,
            pin=pinned != "none",
            pin_side=side,
        ),
        faceplate(backset=backset, finish=finish),
    )
    if is_set:
        outside = grip(thickness=thickness, depth=rose_depth, finish=finish, length=0.23, projection=0.055)
        base = weld(base, outside)

    lean = spring_turn(limit=turn, preload=preload, torque=preload * torque_ratio, damping=damping)
    if inside == "lever":
        base = base.attach(handle(**common), lean)
    else:
        base = base.attach(handle(**common, lock=lock, lock_side=side), lean)
    if pinned != "none":
        base = with_button(
            base,
            pinned,
            face=thickness / 2 + rose_depth,
            depth=rose_depth,
            finish=finish,
            side=side,
            below=PIN_BELOW,
        )
    bolt = latch_bolt(backset=backset, throw=throw, finish=finish)
    base = base.attach(bolt, latch_slide(lean, throw=throw, release=release * turn))
    if is_set:
        piece = thumb_piece(thickness=thickness, depth=rose_depth, finish=finish)
        press = thumb_press(lean, limit=turn, thickness=thickness, depth=rose_depth)
        base = base.attach(piece, press)
    shown = base.at(_WIDTH / 2 - backset, 0.0, height + _FOOT)
    return shown.mirror(X) if hand == "right" else shown


def _stand(
    thickness: Float, backset: Float, throw: Float, *, low: float, high: float, wood: Material
) -> Body:
    """Make a bored piece of door leaf from `low` to `high` about the spindle, on a foot."""
    middle = backset - _WIDTH / 2
    board = box(_WIDTH, thickness, high - low + 0.002, bevel=0.0015).at(middle, 0.0, (high + low) / 2 - 0.001)
    board = board - spindle_hole(thickness) - latch_pocket(backset=backset, throw=throw)
    foot = box(_WIDTH + 0.05, 0.15, _FOOT, bevel=0.004).at(middle, 0.0, low - _FOOT / 2)
    plate = box(0.052, 0.0006, 0.0095, bevel=0.0002).at(middle, -0.075, low - _FOOT / 2)
    return weld(
        part(foot, "stand", material("black_abs").with_(name="stand", density=1800.0), name="base"),
        part(board, "door", wood),
        detail(plate, "stand", material("stainless")),
    )
