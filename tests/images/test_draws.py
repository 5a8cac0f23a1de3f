"""Random draws of pictures: possible poses, cameras that see the asset, parts of a split."""

import math

import numpy as np
import pytest

import artgen
from artgen.asset.placed import owners_of
from artgen.images import ImagePlan
from artgen.images.draws import (
    CLEAR,
    camera_in,
    extrinsics,
    intrinsics,
    random_camera,
    random_positions,
    random_setting,
    random_surroundings,
)
from artgen.images.pictures import split_of


@pytest.fixture(scope="module")
def dishwasher() -> artgen.Asset:
    return artgen.generate("dishwasher", seed=3, certify=False)


def test_poses_satisfy_dependencies_and_move_racks(dishwasher: artgen.Asset) -> None:
    draw = np.random.default_rng(0)
    poses = [random_positions(dishwasher, draw) for _ in range(60)]
    needing = [joint.name for joint in dishwasher.joints if joint.needs is not None]
    assert len(needing) >= 2
    assert not any(dishwasher.blocked(q) for q in poses)
    for name in needing:
        away = sum(dishwasher.positions(q)[name] != dishwasher.joint(name).closed for q in poses)
        assert 5 <= away <= 55
    door = [q["door_hinge"] for q in poses]
    assert sum(angle < 1.0 for angle in door) > 5  # not only wide open
    assert poses[0] != poses[1]


def test_followers_move_with_their_leaders() -> None:
    bin_ = artgen.generate("trashcan", seed=0, certify=False, style="pedal")
    draw = np.random.default_rng(1)
    followers = [joint for joint in bin_.joints if joint.follows is not None]
    assert followers
    for _ in range(10):
        q = random_positions(bin_, draw)
        positions = bin_.positions(q)
        for joint in followers:
            law = joint.follows
            assert positions[joint.name] == pytest.approx(law.ratio * positions[law.leader] + law.offset)


@pytest.fixture(scope="module")
def room() -> artgen.Asset:
    return artgen.generate("hall", 1, detail="low")


def test_cameras_in_a_room_stand_free_and_look_at_its_assets(room: artgen.Asset) -> None:
    plan, draw = ImagePlan(("hall",), 1), np.random.default_rng(8)
    owners = owners_of(room)
    assert set(owners.values()) == {"", *(each.name for each in room.placed)}
    looked, inside = set(), 0
    for _ in range(40):
        poses = room.pose(random_positions(room, draw))
        points = {
            link.name: np.concatenate([surface.mesh.vertices for surface in link.surfaces])
            @ poses[link.name][:3, :3].T
            + poses[link.name][:3, 3]
            for link in room.links
        }
        camera = camera_in(room, poses, points, plan, draw)
        at, low, high = np.array(camera.position), *room.links[0].bounds()
        assert (low[[0, 2]] < at[[0, 2]]).all()
        assert (at < high).all()
        inside += int(at[1] > low[1])
        for name, each in points.items():
            if owners[name]:
                assert ((at < each.min(axis=0) - CLEAR) | (at > each.max(axis=0) + CLEAR)).any(), name
        # one asset is in the picture as a whole
        whole = set()
        for placed in room.placed:
            own = np.concatenate([each for name, each in points.items() if owners[name] == placed.name])
            ahead = (own - at) @ camera.axes()[2]
            if ahead.min() > 0.0 and (abs(camera.pixels(own, (1, 1)) - 0.5) < 0.5).all():
                whole.add(placed.name)
        assert whole
        looked |= whole
    assert inside > 10
    assert len(looked) > 3


def test_cameras_are_above_the_horizon_and_see_all_points() -> None:
    points = np.random.default_rng(5).uniform((-0.4, -0.3, 0.0), (0.4, 0.3, 1.2), (500, 3))
    draw = np.random.default_rng(6)
    plan = ImagePlan(("plier",), 1, field_of_view=(0.5, 1.0), elevation=(0.2, 1.2), margin=(0.05, 0.4))
    shares = []
    for _ in range(50):
        camera = random_camera(points, plan, draw)
        seen = camera.pixels(points, (100, 100))
        assert seen.min() >= -2.0
        assert seen.max() <= 102.0
        shares.append(np.ptp(seen, axis=0).max() / 100)
        away = np.subtract(camera.position, camera.target)
        assert 0.2 - 1e-9 <= math.asin(away[2] / np.linalg.norm(away)) <= 1.2 + 1e-9
        assert camera.position[2] > 0.0
        own = points @ extrinsics(camera)[:3, :3].T + extrinsics(camera)[:3, 3]
        image = own @ intrinsics(camera, 100).T
        assert image[:, :2] / image[:, 2:] == pytest.approx(seen, abs=1e-6)
    assert min(shares) < 0.7  # from farther
    assert max(shares) > 0.85  # and nearer


def test_parts_that_do_not_vary_are_plain() -> None:
    draw = np.random.default_rng(0)
    around = random_surroundings(("light",), draw)
    assert around == {"floor": (), "wall": ()}
    lit = [random_setting(around, ("light",), draw) for _ in range(2)]
    assert lit[0].light != lit[1].light
    assert lit[0].horizon == lit[1].zenith
    assert (lit[0].floor, lit[0].wall) == (-1, -1)
    plain = random_setting(around, (), draw)
    assert plain.light == random_setting(around, (), draw).light


@pytest.mark.parametrize("count", [10, 50, 250])
def test_a_split_has_its_shares_and_a_longer_one_begins_with_it(count: int) -> None:
    shares = (0.8, 0.1, 0.1)
    found = split_of(7, count, shares)
    assert list(found) == list(range(7, 7 + count))
    assert [list(found.values()).count(part) for part in ("train", "val", "test")] == [
        round(share * count) for share in shares
    ]
    assert list(split_of(7, count + 13, shares).items())[:count] == list(found.items())


def test_labels_can_be_chosen_and_joined() -> None:
    texts = ("handle", "door:body=door+glass", "cabinet:front=door")
    plan = ImagePlan(("door", "cabinet"), 2, labels=texts)
    found = plan.mask_names()
    assert found["door"] == {"handle": "handle", "door": "body", "glass": "body"}
    assert found["cabinet"] == {"handle": "handle", "door": "front"}
    assert plan.coco_categories() == [
        {"id": 1, "name": "handle", "supercategory": "door"},
        {"id": 2, "name": "body", "supercategory": "door"},
        {"id": 3, "name": "handle", "supercategory": "cabinet"},
        {"id": 4, "name": "front", "supercategory": "cabinet"},
    ]
    every = ImagePlan(("plier",), 1).mask_names()
    assert list(every["plier"]) == list(artgen.catalog.find("plier").labels)
