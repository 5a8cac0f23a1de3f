"""Independent readers agree with the asset: yourdfpy, pinocchio, MuJoCo and OpenUSD."""

from pathlib import Path

import numpy as np
import pinocchio
import pytest

from artgen.asset import Asset
from support.agreement import check_formats_agree


@pytest.fixture(scope="module")
def directory(asset: Asset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return asset.export(tmp_path_factory.mktemp("agreement") / asset.name)


def test_every_reader_is_silent_and_finds_the_asset_in_its_file(asset: Asset, directory: Path) -> None:
    check_formats_agree(asset, directory)


def test_pinocchio_sees_the_asset_weigh_what_it_weighs(asset: Asset, directory: Path) -> None:
    """The base counts only where it may move; bodies between joints and grasp marks add a millionth."""
    path = str(directory / f"{asset.name}.urdf")
    pin = pinocchio.buildModelFromUrdf(path, pinocchio.JointModelFreeFlyer())
    data = pin.createData()
    positions = asset.positions()
    q = pinocchio.neutral(pin)
    for name, index, length in zip(pin.names[2:], pin.idx_qs[2:], pin.nqs[2:], strict=True):
        q[index : index + length] = (
            [positions[name]] if length == 1 else [np.cos(positions[name]), np.sin(positions[name])]
        )
    center = pinocchio.centerOfMass(pin, data, q)
    moved = asset.pose()
    mass = sum(link.mass_properties.mass for link in asset.links)
    expected = (
        sum(
            link.mass_properties.mass
            * (moved[link.name][:3, :3] @ link.mass_properties.center + moved[link.name][:3, 3])
            for link in asset.links
        )
        / mass
    )
    assert data.mass[0] == pytest.approx(mass, abs=1e-5)
    np.testing.assert_allclose(center, expected, atol=1e-6)
