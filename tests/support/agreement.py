"""Whether what readers found in the files is what the asset says."""

from pathlib import Path

import numpy as np

from artgen.asset import Asset
from support.readers import draw_positions, expected_frames, read_all, silence, usd_faults

POSES = 20
EXACT = 1e-6


def check_formats_agree(asset: Asset, directory: Path) -> None:
    """Assert that every reader loads the files in silence and finds the asset in them."""
    with silence():
        readings = read_all(asset, directory)
    faults = usd_faults(directory / f"{asset.name}.usda")
    assert not faults, faults[:5]
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
    # of formats with trees and ratios; pins hold the joints of closed chains
    coupled = {name for name, joint in moving.items() if joint.follows and joint.follows.curve is None}
    links = {link.name: link.mass_properties for link in asset.links}
    for seed in range(POSES):
        q = draw_positions(asset, seed)
        positions, expected = asset.positions(q), expected_frames(asset, q)
        for reading in readings:
            for name, frame in reading.frames(positions).items():
                error = np.abs(frame - expected[name]).max()
                assert error <= EXACT, f"{reading.name}: link {name} is off by {error:.2e} at {q}"
    for reading in readings:
        for name, mass in reading.masses.items():
            properties = links[name]
            place = f"{reading.name}: link {name}"
            assert abs(mass - properties.mass) <= EXACT * properties.mass, (place, mass, properties.mass)
            center = properties.center - asset.origin(name)
            assert np.abs(reading.centers[name] - center).max() <= EXACT, place
            error = np.abs(reading.inertias[name] - properties.inertia).max()
            assert error <= EXACT * max(np.abs(properties.inertia).max(), 1e-3), (place, error)
        assert set(reading.limits) == set(moving), reading.name
        for name, limits in reading.limits.items():
            wanted = moving[name].limits
            assert (limits is None) == (wanted is None), f"{reading.name}: joint {name}"
            if limits is not None and wanted is not None:
                assert np.abs(np.subtract(limits, wanted)).max() <= EXACT, (
                    reading.name,
                    name,
                    limits,
                    wanted,
                )
        for name, axis in reading.axes.items():
            assert np.abs(axis - moving[name].axis).max() <= EXACT, (reading.name, name, axis)
        if reading.name not in {"pinocchio", "mujoco urdf"}:
            assert set(reading.couplings) == coupled, reading.name
            for name, (leader, ratio, offset) in reading.couplings.items():
                for position in (0.0, 1.0):
                    expected_position = _followed(asset, name, leader, position)
                    error = abs(ratio * position + offset - expected_position)
                    assert error <= EXACT, (reading.name, name, leader, error)


def _followed(asset: Asset, name: str, leader: str, position: float) -> float:
    """Return where a joint stands when a leader, near or far along its chain, is at a position."""
    if name == leader:
        return position
    follows = asset.joint(name).follows
    assert follows is not None, f"{name} does not follow {leader}"
    return follows.ratio * _followed(asset, follows.leader, leader, position) + follows.offset
