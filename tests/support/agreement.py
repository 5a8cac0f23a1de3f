"""Whether what readers found in the files is what the asset says."""

from pathlib import Path

import numpy as np
from support.readers import draw_positions, expected_frames, read_all, silence, usd_faults

from artgen.asset import Asset

POSES = 20
EXACT = 1e-6


def check_formats_agree(asset: Asset, directory: Path) -> None:
    """Assert that every reader loads the files in silence and finds the asset in them."""
    with silence():
        readings = read_all(asset, directory)
    faults = usd_faults(directory / f"{asset.name}.usda")
    assert not faults, faults[:5]
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
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
                assert np.abs(np.subtract(limits, wanted)).max() <= EXACT, (reading.name, name, limits, wanted)
        for name, axis in reading.axes.items():
            assert np.abs(axis - moving[name].axis).max() <= EXACT, (reading.name, name, axis)
        if reading.name != "pinocchio" and reading.name != "mujoco urdf":
            found = {name: coupling[0] for name, coupling in reading.couplings.items()}
            coupled = {name: joint.follows for name, joint in moving.items() if joint.follows is not None}
            assert found == {name: follows.leader for name, follows in coupled.items()}, reading.name
            for name, (_, ratio, offset) in reading.couplings.items():
                error = max(abs(ratio - coupled[name].ratio), abs(offset - coupled[name].offset))
                assert error <= EXACT, (reading.name, name)
