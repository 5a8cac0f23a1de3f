"""What is special to scissors: blades that pass each other, springs that open, a ring that locks tongs."""

from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.hands import check_grasps


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("scissors").generate(seed, certify=False, **given)


def released(asset: Asset, **positions: float) -> dict[str, float]:
    """Return where the joints stand a second after they were let go."""
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    for name, position in positions.items():
        data.joint(name).qpos[0] = position
    mujoco.mj_step(model, data, nstep=round(1.0 / model.opt.timestep))
    return {name: float(data.joint(name).qpos[0]) for name in positions}


@pytest.mark.parametrize("style", ["household", "tailor", "kitchen", "craft"])
def test_blades_lie_on_each_other_and_part_at_the_tips(style: str) -> None:
    asset = made(1, style=style)
    flats = [
        next(piece for piece in asset.link(name).pieces if piece.label == name).shape.bounds()
        for name in ("body", "blade")
    ]
    assert flats[1][0][2] - flats[0][1][2] == pytest.approx(0.0003, abs=1e-5), "the gap in the lap"
    assert abs(flats[0][1][1] - flats[1][1][1]) < 0.003, "both tips are at the same place"
    (_, end) = asset.joint("blade_hinge").limits or (0.0, 0.0)
    tip = np.array([*flats[1][1], 1.0])
    assert np.linalg.norm((asset.pose({"blade_hinge": end})["blade"] @ tip - tip)[:3]) > 0.05


def test_bent_handles_turn_both_blades_to_one_side() -> None:
    sides = []
    for bend in (0.0, 0.2):
        asset = made(2, style="tailor", bend=bend)
        sides.append([asset.link(name).pieces[0].shape.bounds()[:, 0].mean() for name in ("body", "blade")])
    moved = np.subtract(sides[1], sides[0])
    assert (moved < -0.004).all()


def test_a_spring_opens_snips_and_scissors_stay() -> None:
    snips = made(3, style="snips", squeeze=6.0)
    (_, end) = snips.joint("blade_hinge").limits or (0.0, 0.0)
    assert released(snips, blade_hinge=0.1)["blade_hinge"] == pytest.approx(end, abs=0.02)
    assert released(made(3, style="household"), blade_hinge=0.4)["blade_hinge"] == pytest.approx(
        0.4, abs=0.01
    )


def test_the_ring_holds_closed_tongs() -> None:
    asset = made(4, style="tongs")
    (_, end), (_, travel) = (asset.joint(name).limits or (0.0, 0.0) for name in ("arm_hinge", "ring_slide"))
    assert released(asset, arm_hinge=0.0, ring_slide=travel)["arm_hinge"] < 0.03
    assert released(asset, arm_hinge=0.0, ring_slide=0.0)["arm_hinge"] == pytest.approx(end, abs=0.02)
    assert asset.blocked({"arm_hinge": 0.05, "ring_slide": travel})
    assert min(asset.clearance({"arm_hinge": 0.05, "ring_slide": travel}).values()) < 0.0, "metal blocks it"
    assert not asset.blocked({"arm_hinge": end, "ring_slide": 0.0})


@pytest.mark.parametrize(
    ("style", "least", "most"), [("craft", 0.02, 0.045), ("kitchen", 0.085, 0.18), ("tongs", 0.09, 0.19)]
)
def test_masses_are_those_of_catalogs(style: str, least: float, most: float) -> None:
    assert least < made(5, style=style).mass < most


@pytest.mark.parametrize(("style", "least"), [("household", 0.14), ("tailor", 0.15)])
def test_scissors_that_are_too_short_for_a_hand_are_refused(style: str, least: float) -> None:
    short = find("scissors").generate(8861, style=style, bows="offset", length=least)
    assert short.certificate.proven
    assert not check_grasps(short).faults
    with pytest.raises(InfeasibleError, match=f"length of {style} scissors must be >= {least:g} m"):
        made(8861, style=style, bows="offset", length=least - 0.01)
