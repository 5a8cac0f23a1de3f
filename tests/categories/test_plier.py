"""What is special to pliers: jaws that meet and never cross, a spring, a bolt that passes when aligned."""

import numpy as np
import pytest
from manifold3d import Manifold

from artgen import generate
from artgen.asset import Asset
from artgen.errors import ArtgenError

STYLES = ("combination", "needle_nose", "cutter", "slip_joint")


def pliers(style: str, seed: int = 3, **overrides: object) -> Asset:
    return generate("plier", seed, style=style, certify=False, **overrides)


@pytest.mark.parametrize("style", STYLES)
def test_closed_jaws_nearly_touch_and_open_by_the_hinge(style: str) -> None:
    asset = pliers(style)
    ((_, closed),) = asset.clearance({}).items()
    assert 0.0001 < closed < 0.0008
    jaw = asset.link("jaw").bounds()
    tip = np.array([jaw[1, 0], jaw[1, 1], jaw[1, 2], 1.0])
    opened = asset.pose({"jaw_hinge": asset.joint("jaw_hinge").limits[1]})["jaw"] @ tip
    assert opened[0] < tip[0] - 0.3 * (jaw[1, 1] - asset.joint("jaw_hinge").pivot[1])


def test_each_half_has_half_of_the_thickness_in_the_lap() -> None:
    asset = pliers("combination", grips="bare")
    pivot = asset.joint("jaw_hinge").pivot

    column = Manifold.cylinder(0.1, 0.008, center=True).translate(pivot)  # inside the lap's 11 mm

    def reach(name: str) -> tuple[float, float]:
        """Return between which heights a half lies around the pivot [m]."""
        (steel,) = [piece for piece in asset.link(name).pieces if piece.label == name and not piece.visual]
        box = (steel.shape.manifold ^ column).bounding_box()
        return box[2], box[5]

    lower, upper = reach("body"), reach("jaw")
    assert lower[1] < upper[0]
    assert upper[1] - upper[0] == pytest.approx(lower[1] - lower[0], abs=1e-6)


def test_a_leaf_spring_opens_jaws_and_is_pressed_by_a_hand() -> None:
    for length in (0.135, 0.175):
        asset = pliers("cutter", sprung=True, preload=0.25, squeeze=0.6, length=length)
        hinge = asset.joint("jaw_hinge")
        torque = [hinge.stiffness * (hinge.rest - at) for at in hinge.limits]
        handles = np.abs(asset.bounds()[:, 1] - hinge.pivot[1]).max()
        assert np.array(torque) / handles == pytest.approx([0.6 / 0.15, 0.25 / 0.15], rel=0.05)
        assert torque[1] > 2.0 * hinge.friction  # it opens all the way


def test_pliers_without_a_spring_stay() -> None:
    hinge = pliers("needle_nose", sprung=False).joint("jaw_hinge")
    assert hinge.stiffness == 0.0
    assert hinge.friction > 0.05


def test_only_slip_joint_pliers_have_a_second_place_for_the_pivot() -> None:
    for style in STYLES:
        names = {joint.name for joint in pliers(style).joints}
        assert ("pivot_slide" in names) == (style == "slip_joint")


def test_the_keyed_bolt_passes_the_neck_only_with_the_jaws_open() -> None:
    asset = pliers("slip_joint")
    way = asset.joint("pivot_slide").limits[1]
    on_the_way = {"pivot_slide": 0.2 * way}
    assert asset.blocked(on_the_way)
    assert not asset.blocked({**on_the_way, "jaw_hinge": 0.45})
    assert not asset.blocked({"pivot_slide": way})  # in the second hole it turns freely
    # it is metal that blocks: flats that are not aligned do not fit the neck
    assert min(asset.clearance(on_the_way).values()) <= 0.0
    assert min(asset.clearance({**on_the_way, "jaw_hinge": 0.45}).values()) > 0.0


@pytest.mark.parametrize("count", [8, 20])
def test_teeth_are_counted(count: int) -> None:
    asset = pliers("combination", jagged=True, teeth_count=count)
    (row,) = [
        piece
        for piece in asset.link("body").pieces
        if piece.label == "teeth" and np.ptp(piece.shape.bounds()[:, 0]) < 0.0012
    ]
    # along the flat, points alternate between crests and grooves
    crests = np.unique(
        row.shape.mesh.vertices[row.shape.mesh.vertices[:, 0] < row.shape.bounds()[0, 0] + 1e-6][:, 1].round(
            6
        )
    )
    assert len(crests) in (count, count + 1)


@pytest.mark.parametrize(("spread", "fits"), [(0.118, False), (0.130, True)])
def test_thick_handles_of_slip_joint_pliers_pass_each_other_in_the_wide_place(
    spread: float, *, fits: bool
) -> None:
    given = {"length": 0.165, "grips": "two_component", "handle_width": 0.0104, "spread": spread}
    if fits:
        certificate = pliers("slip_joint", **given).certify()
        assert certificate.proven
        return
    with pytest.raises(ArtgenError, match="thick handles would touch each other below the joint: lower"):
        pliers("slip_joint", **given)
