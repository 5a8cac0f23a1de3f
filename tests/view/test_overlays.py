"""What viewers draw over assets: it lies where the asset is, at rest and in any pose."""

import numpy as np
import pytest

import artgen
from artgen.asset import Asset
from artgen.view.overlays import PALETTE, axis_poses, collider_mesh, joint_symbol, label_colors
from artgen.view.viewer import viewer_data


@pytest.fixture(scope="module", params=["plier", "drawer", "faucet"])
def asset(request: pytest.FixtureRequest) -> Asset:
    return artgen.generate(request.param, seed=1, certify=False)


def carried(matrix: np.ndarray, point: np.ndarray) -> np.ndarray:
    return matrix[:3, :3] @ point + matrix[:3, 3]


def test_colliders_are_closed_and_as_large_as_the_pieces(asset: Asset) -> None:
    for link in asset.links:
        for collider in link.colliders:
            vertices, triangles = collider_mesh(collider.convex)
            corners = vertices[triangles]
            volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
            assert collider.convex.volume * 0.999 <= volume <= 1.3 * collider.convex.volume
            outer = [vertices.min(axis=0), vertices.max(axis=0)]
            assert np.abs(np.array(outer) - collider.convex.bounds()).max() < 0.0015


def test_hands_of_joints_go_along_their_ranges(asset: Asset) -> None:
    for joint in asset.free_joints:
        for number, position in enumerate(joint.limits or ()):
            q = {joint.name: position}
            sign = joint_symbol(asset, joint)
            pose = axis_poses(asset, q)[joint.name]
            tip = carried(pose @ joint.motion(position), sign.hand[1])
            assert np.abs(tip - carried(pose, sign.range[-number])).max() < 1e-9
            middle = np.cross(sign.axis[1] - sign.axis[0], joint.axis)
            assert np.abs(middle).max() < 1e-9


def test_an_axis_moves_with_what_it_is_on(asset: Asset) -> None:
    q = {joint.name: joint.limits[1] if joint.limits else 1.0 for joint in asset.free_joints}
    poses, axes = asset.pose(q), axis_poses(asset, q)
    positions = asset.positions(q)
    for parent, child, joints in asset.pairs():
        assert np.abs(axes[joints[0].name] - poses[parent]).max() < 1e-12
        last = axes[joints[-1].name] @ joints[-1].motion(positions[joints[-1].name])
        assert np.abs(last - poses[child]).max() < 1e-12


def test_the_viewer_has_the_overlays_of_the_asset(asset: Asset) -> None:
    data = viewer_data(asset)
    for drawn, link in zip(data["links"], asset.links, strict=True):
        assert drawn["mass"] == link.mass_properties.mass
        assert [each["label"] for each in drawn["colliders"]] == [each.label for each in link.colliders]
    total = sum(link["mass"] * np.array(link["center"]) for link in data["links"]) / asset.mass
    assert np.abs(total - asset.mass_properties().center).max() < 1e-5  # centers have 5 decimals
    holds = [hold["name"] for link in data["links"] for hold in link["holds"]]
    assert holds == [each.name for each in asset.affordances]
    moving = [joint.name for joint in asset.joints if not joint.locked]
    assert [joint["name"] for joint in data["joints"] if joint["symbol"]] == moving


def test_a_label_has_the_same_color_in_every_asset_of_a_category() -> None:
    first, second = (label_colors(artgen.generate("plier", seed=seed, certify=False)) for seed in (0, 5))
    assert all(first[label] == second[label] for label in first.keys() & second.keys())
    assert len(set(first.values())) == len(first)
    assert len(set(PALETTE)) == len(PALETTE)


def test_the_refrigerator_with_most_labels_has_a_color_for_each() -> None:
    colors = label_colors(artgen.generate("refrigerator", seed=0, certify=False))
    assert len(colors) > 25
    assert len(set(colors.values())) == len(colors)
