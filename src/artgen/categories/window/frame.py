"""Window systems: their sections, finishes and frames, rebated for hinged or tracked for sliding sashes.

A window is modeled about the middle of its opening: x to the right, z up, and y = 0 in the front plane of the
frame, on the side to which sashes open (-y).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import OUTDOORS, known, paints, weighing

SEAM = 0.00003  # gap between adjacent boards [m]
SEALED = 0.0035  # gap between the lip of a sash and the frame, filled by a seal [m]
STOP = 0.018  # projection of stops into an opening [m]
MULLION = 0.068  # width of the posts and transoms between two sashes [m]
SILL = 0.030  # thickness of the sill under a frame [m]
STRIP = 0.013  # projection of the strips of tracks into the opening [m]

_STRIP = 0.010  # thickness of the outer strips of tracks [m]
_PLAY = 0.003  # gap between a sliding sash and its track, in depth [m]
_BEAD = 0.008  # gap between two tracks [m]
_NOSE = 0.048  # projection of a sill from the frame [m]

Kind = Literal["wood", "pvc", "aluminium"]


class Section:
    """Sections of a window system [m], as one line of a maker's catalog."""

    def __init__(
        self, *, frame: float, sash: float, depth: float, lip: float, slide: float, eased: float
    ) -> None:
        self.frame = frame  # width of the face of the frame
        self.sash = sash  # width of a hinged sash, from its edge to the glass
        self.face = 0.92 * sash  # width of a sliding sash, which is slimmer
        self.depth = depth  # position of the back of a closed sash along y
        self.lip = lip  # thickness of the lip of a sash, in front of the frame
        self.slide = slide  # thickness of a sliding sash
        self.eased = eased  # radius of edges
        self.stop = depth + 0.004  # position of the front of the stop behind a closed sash along y
        self.back = self.stop + 0.014  # depth of the frame of hinged sashes
        self.outer = _STRIP + _PLAY + slide / 2  # position of the middle of the outer track along y
        self.inner = self.outer + slide + 2 * _PLAY + _BEAD  # that of the inner track
        self.tracked = self.inner + self.outer  # depth of the frame of sliding sashes


SECTIONS: dict[Kind, Section] = {
    # 68 mm timber of IV68, 70 mm five-chamber systems, slim systems with a thermal break
    "wood": Section(frame=0.056, sash=0.054, depth=0.052, lip=0.0140, slide=0.042, eased=0.0025),
    "pvc": Section(frame=0.060, sash=0.056, depth=0.054, lip=0.0160, slide=0.044, eased=0.0035),
    "aluminium": Section(frame=0.048, sash=0.046, depth=0.046, lip=0.0120, slide=0.036, eased=0.0010),
}


def _hollow(base: str, *colors: str, density: float = 640.0) -> list[ag.Material]:
    """Return chambered profiles: 2.0-2.4 kg/m of PVC with steel inside, 1.7 kg/m of aluminum."""
    made = [ag.colored(base, color) for color in colors] or [ag.material(base)]
    return [each.with_(name=f"{each.name}_profile", density=density) for each in made]


_TIMBER = known("oak", "pine", "mahogany", "ash", "walnut")
_COATED = _hollow("powder_coat", "anthracite", "black", "white", "slate", "forest", "burgundy")

FINISHES = {
    "wood": ag.shades(
        *_TIMBER,
        *paints(500.0, "window_paint"),
        weights=(*(1.6,) * len(_TIMBER), *(0.7 * each for each in OUTDOORS)),
        color=0.06,
        roughness=0.04,
    ),
    "pvc": ag.shades(  # white, or a colored foil
        *_hollow("abs", "white", "cream", "anthracite", "light_grey", "brown", density=560.0),
        weights=(4.0, 1.0, 1.6, 0.8, 1.0),
        color=0.02,
        roughness=0.04,
    ),
    "aluminium": ag.shades(  # coated or anodized
        *(*_COATED, *_hollow("brushed_aluminium"), *_hollow("aged_bronze")),
        weights=(4.0, 2.0, 1.5, 1.0, 0.5, 0.3, 1.5, 0.7),
        color=0.03,
        roughness=0.04,
    ),
}
"""Finishes of frames by their material."""

SILLS = ag.shades(
    *weighing(known("granite", "marble"), 2700.0, "sill"),
    *_hollow("powder_coat", "silver", "white", "anthracite"),
    weights=(1.0, 0.7, 1.2, 1.5, 1.0),
    color=0.03,
)
"""Stone and folded sheet for sills."""


@dataclass(frozen=True)
class Draft:
    """Common data of windows."""

    opening: ag.Region  # opening in the frame, without depth
    section: Section  # sections of the window system
    finish: ag.Material  # finish of the frame, the sashes and the bars
    metal: ag.Material  # metal of levers, locks and hinges
    glass: ag.Material  # material of the panes
    columns: int  # number of vertical bars on the glass
    rows: int  # number of horizontal bars on the glass
    friction: ag.Float  # friction of the gear or detent of a lock [N m], or of a latch [N]

    def turned(self) -> "Draft":
        """Return the data of a window that is to be turned by 90 degrees."""
        opening = ag.Region(self.opening.z, self.opening.y, self.opening.x)
        return replace(self, opening=opening, columns=self.rows, rows=self.columns)


def band(x: ag.Span, y: ag.Span, radius: float = 0.0) -> ag.Profile:
    """Make a rectangle of the section of a ring: x from its edge to its middle, y to the back [m]."""
    return ag.rectangle(x[1] - x[0], y[1] - y[0], radius=radius).at((x[0] + x[1]) / 2, -(y[0] + y[1]) / 2)


def ring_along(section: ag.Profile, width: ag.Scalar, height: ag.Scalar) -> ag.Solid:
    """Sweep a section around a rectangle about the origin, with mitered corners."""
    x, z = width / 2, height / 2
    course = ag.polyline([(-x, -z, 0.0), (x, -z, 0.0), (x, z, 0.0), (-x, z, 0.0)], closed=True)
    # swept on the floor, with the section's y up, then rotated upright: up becomes the front
    return ag.sweep(section, course).rotate(ag.X, math.pi / 2)


def under(eased: float) -> float:
    """Return the depth of boards under the surface of a ring with edges rounded by a radius [m]."""
    return 0.3 * eased + 0.0002


def ring_of(
    bands: Sequence[tuple[ag.Span, ag.Span]],
    width: ag.Scalar,
    height: ag.Scalar,
    label: str,
    finish: ag.Material,
    *,
    eased: float,
    outline: ag.Profile | None = None,
    push: ag.Frame | Sequence[ag.Frame] = (),
) -> ag.Body:
    """Make a visible mitered ring, over boards just under its surface that have the mass and collide."""
    inside = under(eased)
    seen = ring_along(band(*bands[0], eased) if outline is None else outline, width, height)
    boards = []
    for (outer, inner), depth in bands:
        edge, wide = outer + inside, inner - outer - 2 * inside
        whole = ag.Region.centered(width, 0.0, height).with_(y=depth).shrink(x=edge, y=inside, z=edge)
        stile, between, _ = whole.across(wide, None, wide, gap=SEAM)
        # rails between the stiles are a little thinner: boards must not share corners
        rail = between.stack(None, wide)[1].shrink(y=0.0001, bottom=0.0001).box()
        boards += [stile.box(), stile.mirror().box(), rail, rail.mirror(ag.Z)]
    return ag.weld(ag.part(boards, label, finish, push=push), ag.detail(seen, label, finish))


def rebated_frame(draft: Draft, rows: Sequence[Sequence[ag.Region]], *, solid: bool) -> ag.Body:
    """Make the frame around rows of openings: a mitered ring, posts and transoms, stops and seals."""
    section, finish, opening = draft.section, draft.finish, draft.opening
    eased, soft = section.eased, min(section.eased, 0.002)
    width, height, deep = opening.x.size, opening.z.size, (0.0002, section.back - 0.0002)
    ring = ring_of([((-section.frame, 0), (0, section.back))], width, height, "frame", finish, eased=eased)
    bars = []
    for below, above in pairwise(rows):
        bar = ag.Region(opening.x, deep, (below[0].z.high, above[0].z.low))
        bars.append(bar.shrink(x=SEAM / 2).box(bevel=eased))
    for left, right in (pair for row in rows for pair in pairwise(row)):
        bar = ag.Region((left.x.high, right.x.low), deep, left.z)
        bars.append(bar.shrink(z=SEAM / 2).box(bevel=eased))
    bodies = [ring, *(ag.part(bar, "frame", finish) for bar in bars)]
    back = (section.stop, section.back - 0.0004)
    seal = ag.rectangle(0.0045, SEALED - 0.0008, radius=0.001).at(-0.0028, (SEALED - 0.0008) / 2)
    for cell in (cell for row in rows for cell in row):
        wide, tall = cell.x.size, cell.z.size
        outline = band((0, STOP), back, soft)
        if solid:  # a stop reaches 2 mm into its base
            bands = [((-0.002, STOP), back)]
            stop = ring_of(bands, wide, tall, "frame", finish, eased=soft, outline=outline)
        else:
            stop = ag.detail(ring_along(outline, wide, tall), "frame", finish)
        strip = ag.detail(ring_along(seal, wide, tall), "seal", ag.material("rubber"))
        bodies += [each.at(cell.center) for each in (stop, strip)]
    return ag.weld(*bodies)


def tracked_frame(draft: Draft) -> ag.Body:
    """Make the frame around sliding sashes: a mitered ring with three strips that form two tracks."""
    section, finish, deep = draft.section, draft.finish, draft.section.tracked
    width, height = draft.opening.x.size, draft.opening.z.size
    ring = [((-section.frame, 0), (0, deep))]
    bodies = [ring_of(ring, width, height, "frame", finish, eased=section.eased)]
    pile = ag.material("rubber").with_(name="pile", base_color=(0.09, 0.09, 0.095), specular_roughness=0.95)
    low, high = (deep - _BEAD) / 2, (deep + _BEAD) / 2
    # ends of the strips, and the face on which a brush is
    for start, end, brushed in ((0, _STRIP, 1), (low, high, 1), (deep - _STRIP, deep, -1)):
        outline = band((0, STRIP), (start + 0.0002, end - 0.0002), 0.0012)
        bands = [((-0.002, STRIP), (start, end))]
        bodies.append(ring_of(bands, width, height, "frame", finish, eased=0.0012, outline=outline))
        y = (end if brushed > 0 else start) + 0.0004 * brushed
        brush = band((STRIP - 0.0075, STRIP - 0.0015), (y - 0.0006, y + 0.0006))
        bodies.append(ag.detail(ring_along(brush, width, height), "seal", pile))
    return ag.weld(*bodies)


def sill_under(frame: ag.Region, finish: ag.Material, *, horns: ag.Scalar) -> ag.Body:
    """Make the sill under the frame; its top slopes down to the outside, its nose has a drip groove."""
    front, back, top = frame.y.low, frame.y.high, frame.z.low
    nose, low = front - _NOSE, top - SILL
    section = ag.polygon(
        [(back, low), (back, top - SEAM), (front, top - SEAM), (nose, top - 0.008), (nose, low)], radius=0.002
    )
    solid = ag.extrude(section, frame.x.size + 2 * horns, axis=ag.X, bevel=0.0015)
    groove = ag.box(frame.x.size, 0.005, 0.004).at(y=nose + 0.014, z=low + 0.0021)
    return ag.weld(ag.part(solid, "sill", finish), ag.detail(groove, "sill", ag.material("black_abs")))


def drip_cap(frame: ag.Region, finish: ag.Material) -> ag.Body:
    """Make the drip cap over the head, on the outside."""
    section = ag.polygon(
        [(0.0, 0.0), (0.0, 0.016), (-0.026, 0.010), (-0.030, -0.003), (-0.0275, -0.003), (-0.024, 0.004)]
    )
    cap = ag.extrude(section, frame.x.size, axis=ag.X)
    return ag.part(cap.at(y=frame.y.low + 0.0005, z=frame.z.high - 0.018), "frame", finish)


def trickle_vent(frame: ag.Region, finish: ag.Material) -> ag.Body:
    """Make a trickle vent on the inside of the head: a case with a row of slots and a slider."""
    case = ag.box(0.300, 0.014, 0.020, bevel=0.004).at(y=0.0068)
    at = ag.row((-0.099, 0.0132, 0.0), (0.018, 0.0, 0.0), 12)
    slots = ag.array(ag.box(0.012, 0.002, 0.007, bevel=0.0008), at=at)
    knob = ag.box(0.024, 0.006, 0.006, bevel=0.0015).at(0.128, 0.0155, 0.0)
    vent = ag.weld(
        ag.part(case, "vent", finish),
        ag.detail(slots, "vent", ag.material("black_abs")),
        ag.detail(knob, "vent", finish),
    )
    return vent.at(0.0, frame.y.high, frame.z.high - 0.020)


def window_board(frame: ag.Region, finish: ag.Material) -> ag.Body:
    """Make the board on the inside of the wall under a window, level with the sill."""
    back, top = frame.y.high, frame.z.low
    board = ag.Region(frame.x, (back + SEAM, back + 0.14), (top - 0.022, top - SEAM)).grow(x=0.03)
    return ag.part(board.box(bevel=0.003), "sill", finish)
