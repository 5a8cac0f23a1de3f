"""Bodies of boxes: walls around a floor, the bottom flaps, hand holes, vents, and cells for bottles."""

import math

import artgen as ag
from artgen.categories.box.board import LAYER, SLIT, Board
from artgen.categories.box.marks import seam

_ROUND = 0.0018  # radius of upright edges, where the liner is scored [m]
_HOLE = (0.082, 0.030)  # of hand holes [m]
_RIM = 0.010  # of board around them, at least [m]
_NO_RIM = (
    "hand holes need a centimetre of board around them: take a larger width, aspect or height, or holes=False"
)


def walls(
    board: Board,
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    *,
    base: ag.Scalar = 0.0,
    floor: bool = True,
) -> ag.Solid:
    """Make four walls, and the floor between them."""
    t = board.thick
    shell = ag.box_between(
        (-width / 2.0, -depth / 2.0, base), (width / 2.0, depth / 2.0, height + 0.004), bevel=_ROUND
    )
    bottom = base + t if floor else base - 0.01
    shell = shell - ag.box_between((-width, -depth, height), (width, depth, height + 0.01)).paint(board.edge)
    inside = ag.box_between(
        (-width / 2.0 + t, -depth / 2.0 + t, bottom), (width / 2.0 - t, depth / 2.0 - t, height + 0.01)
    )
    return shell.paint(board.outside) - inside.paint(board.inside)


def bottom_flaps(board: Board, width: ag.Scalar, depth: ag.Scalar, *, label: str = "box") -> ag.Body:
    """Make the minor flaps of the bottom, which lie inside on the major ones, and the seam between those."""
    t = board.thick
    reach, half = depth / 2.0 - SLIT / 2.0, depth / 2.0 - t - SLIT
    near = width / 2.0 - t - 0.0004
    sheets = []
    for side in (-1.0, 1.0):
        flap = board.sheet(ag.rectangle(reach - t, 2.0 * half), relief=None)
        # turned over: the printed face is below
        flap = flap.rotate(ag.X, math.pi).at(side * (near - (reach - t) / 2.0), 0.0, t - 0.0002)
        sheets.append(ag.part(flap, label, board.outside))
    free = width / 2.0 - reach - 0.004
    line = seam((-free, -0.0012, t - 0.0002), (free, 0.0012, t + 0.0001))
    return ag.weld(*sheets, line)


def hand_holes(
    solid: ag.Solid,
    width: ag.Scalar,
    height: ag.Scalar,
    board: Board,
    *,
    depth: ag.Scalar,
    span: tuple[ag.Scalar, ag.Scalar],
) -> ag.Solid:
    """Cut a hand hole into each wall at a side, square: see `hole_corners`."""
    wide, tall = _HOLE
    beside, (low, high) = depth / 2.0 - board.thick - _RIM, span
    over = tall / 2.0 + _RIM
    fits = (beside >= wide / 2.0) & (height - over >= low) & (height + over <= high)
    solid = solid.require(fits, _NO_RIM)
    for side in (-1.0, 1.0):
        hole = ag.box(0.05, wide, tall).paint(board.edge)
        solid = solid - hole.at(side * width / 2.0, 0.0, height)
    return solid


def hole_corners(width: ag.Scalar, height: ag.Scalar, board: Board, *, label: str = "box") -> list[ag.Body]:
    """Show the slanted corners of hand holes; the walls collide without them, which are few boxes then."""
    x, y = _HOLE[0] / 2.0, _HOLE[1] / 2.0
    over = 0.0003  # into the wall
    corner = ag.polygon([(x, 0.4 * y), (x + over, 0.4 * y), (x + over, y + over), (x - 0.6 * y, y + over),
                      (x - 0.6 * y, y)])  # fmt: skip
    upper = corner | corner.mirror(1.0, 0.0)
    corners = ag.extrude(upper | upper.mirror(0.0, 1.0), board.thick - 0.0002, axis=ag.X)
    out = (width - board.thick) / 2.0
    return [ag.detail(corners.at(side * out, 0.0, height), label, board.outside) for side in (-1.0, 1.0)]


def cells(
    board: Board,
    width: ag.Scalar,
    depth: ag.Scalar,
    *,
    columns: int,
    rows: int,
    low: ag.Scalar,
    high: ag.Scalar,
    finish: ag.Material | None = None,
) -> ag.Body | None:
    """Make the dividers of a box for bottles, slotted into each other; none for a single cell."""
    thick = 0.6 * board.thick
    boards = []
    for number in range(1, columns):
        x = width * (number / columns - 0.5)
        boards.append(
            ag.box_between(
                (x - thick / 2.0, -depth / 2.0 + LAYER, low), (x + thick / 2.0, depth / 2.0 - LAYER, high)
            )
        )
    for number in range(1, rows):
        y = depth * (number / rows - 0.5)
        boards.append(
            ag.box_between(
                (-width / 2.0 + LAYER, y - thick / 2.0, low), (width / 2.0 - LAYER, y + thick / 2.0, high)
            )
        )
    if not boards:
        return None
    whole = boards[0]
    for each in boards[1:]:
        whole = whole | each
    return ag.part(
        whole, "divider", finish or board.inside, separate="they stand between the walls, a hair off them"
    )
