import json
import shutil
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen import Y, bounding_collider, box, part, torus
from artgen.asset import Asset, Collider
from artgen.asset.collision import with_colliders
from artgen.colliders import Convex
from artgen.validate.colliders import check_colliders
from support.blocks import STEEL


@artgen.generator
def drawer() -> artgen.Body:
    solid = box(0.4, 0.3, 0.12) - box(0.38, 0.28, 0.12).at(z=0.01)
    knob = box(0.03, 0.03, 0.03, bevel=0.002).at(0, -0.165, 0)
    return part(solid | knob, "drawer", STEEL)


@pytest.fixture(scope="module")
def asset():
    return drawer.generate(certify=False)


@pytest.fixture(scope="module")
def door():
    return artgen.generate("door", 3, certify=False)


def with_convexes(asset, change):
    """The asset with its base's colliders changed."""
    base, *others = asset.links
    found = change(list(base.colliders))
    base = replace(base)
    vars(base)["colliders"] = tuple(found)
    return replace(asset, links=(base, *others))


def collider(convex):
    return Collider(convex, "drawer", STEEL)


def messages(asset):
    return [finding.message for finding in check_colliders(asset).faults]


@pytest.mark.parametrize(("category", "seed"), [("door", 0), ("door", 3), ("handle", 3)])
@pytest.mark.long
def test_colliders_of_categories_are_valid_and_faithful(category, seed):
    result = check_colliders(artgen.generate(category, seed, certify=False))
    assert not result.findings
    assert "colliders, " in result.detail
    assert "hollows kept " in result.detail


def test_the_detail_tells_the_numbers(asset):
    result = check_colliders(asset)
    assert not result.findings
    count = len(asset.links[0].colliders)
    vertices = sum(len(each.convex.faces.points) for each in asset.links[0].colliders)
    assert result.detail.startswith(f"{count} colliders, {vertices} vertices, volume +")


def test_a_collider_that_is_missing_is_found(asset):
    largest = max(asset.links[0].colliders, key=lambda each: each.convex.volume)
    (message,) = messages(with_convexes(asset, lambda all_: [each for each in all_ if each is not largest]))
    assert message.startswith("its solid sticks out of its colliders by ")
    assert "150 mm" not in message  # the floor is thin, but far from the walls


def test_a_collider_that_fills_the_hollow_is_found(asset):
    filled = with_convexes(asset, lambda all_: [*all_, collider(Convex.box((0.4, 0.3, 0.12)))])
    off, kept = messages(filled)
    assert "% of volume and stand off the surface by 1" in off
    assert kept.startswith("its colliders leave only ")
    assert kept.endswith(" % of the space in its hollows empty")


def test_a_collider_that_stands_off_a_little_is_found_where_it_adds_much(asset):
    def thicker(all_):
        return [
            replace(each, convex=Convex.box(np.array(each.convex.size) + 0.002, each.convex.pose))
            if each.convex.kind == "box" else each for each in all_
        ]  # fmt: skip

    (message,) = messages(with_convexes(asset, thicker))
    # at a corner of the knob: 1 mm in each direction, and what its bevel takes
    assert "stand off the surface by 3.2 mm" in message
    assert "at most 1 mm is allowed where more than 3 % of volume is added" in message


def test_a_shrunk_collider_is_found(asset):
    def shrunk(all_):
        return [
            replace(each, convex=each.convex.transformed(np.diag([0.999, 0.999, 0.999, 1.0])))
            for each in all_
        ]

    (message,) = messages(with_convexes(asset, shrunk))
    assert message.startswith("its solid sticks out of its colliders by 0.2")


def hull(count=None, *, scale=(1.0, 1.0, 1.0), inner=False):
    """Points of a hull: of a box, or of a ring of `count` points."""
    if count is None:
        points = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * 0.1
    else:
        angles = np.linspace(0.0, 2.0 * np.pi, count // 2, endpoint=False)
        ring = np.column_stack([np.cos(angles), np.sin(angles)]) * 0.1
        points = np.concatenate([np.column_stack([ring, np.full(len(ring), z)]) for z in (-0.1, 0.1)])
    points = points * scale
    return np.concatenate([points, [[0.0, 0.0, 0.07]]]) if inner else points


def raw(kind="hull", pose=None, size=(), points=None):
    """A collider as a file may have it, unchecked."""
    pose = np.eye(4) if pose is None else pose
    return collider(Convex(kind, pose, size, np.zeros((0, 3)) if points is None else points))


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (raw(points=hull(66)), "collider 0 (hull of 'drawer') has 66 vertices; 4 to 64 are taken"),
        (raw(points=hull()[:3]), "collider 0 (hull of 'drawer') has 3 vertices; 4 to 64 are taken"),
        (raw(points=hull(scale=(1, 1, 0))), "is flat: its vertices lie in one plane"),
        (raw(points=hull(inner=True)), "is not convex: a vertex lies 30 mm inside the hull of the others"),
        (raw(points=hull() * np.nan), "has numbers that are not finite"),
        (raw("box", size=(0.1, -0.1, 0.1)), "collider 0 (box of 'drawer') has a length of -0.1 m"),
        (raw("box", np.diag([1.0, 1.0, -1.0, 1.0]), (0.1,) * 3), "is scaled or mirrored by its pose"),
        (raw("sphere", np.diag([2.0, 2.0, 2.0, 1.0]), (0.1,)), "is scaled or mirrored by its pose"),
    ],
)
def test_colliders_that_a_simulator_refuses_or_changes_are_found(asset, wrong, message):
    (found,) = messages(with_convexes(asset, lambda all_: [wrong, *all_]))
    assert message in found


def test_none_and_too_many_colliders_are_found(asset):
    assert messages(with_convexes(asset, lambda _: [])) == ["it has no colliders"]
    many = with_convexes(asset, lambda all_: (all_ * 20)[:65])
    assert messages(many) == ["it has 65 colliders; GPU simulators take at most 64"]


def test_what_chosen_colliders_lack_is_a_note(asset):
    result = check_colliders(with_colliders(asset, "hull"))
    assert result.findings
    assert not result.faults
    assert {finding.hint for finding in result.findings} == {"by choice of colliders"}


@pytest.fixture(scope="module")
def exported(door, tmp_path_factory):
    """A door on the disk, whose file tells what is only seen."""
    directory = door.export(tmp_path_factory.mktemp("exported") / "door", formats=("urdf",))
    data = json.loads((directory / "asset.json").read_text())
    for item in data["links"]:
        item["details"] = [
            {"label": piece.label, "bounds": np.reshape(solid.bounding_box(), (2, 3)).tolist()}
            for piece in door.link(item["name"]).pieces
            if piece.visual
            for solid in piece.shape.manifold.decompose()
        ]
    (directory / "asset.json").write_text(json.dumps(data))
    return directory


@pytest.fixture
def copy(exported, tmp_path):
    return shutil.copytree(exported, tmp_path / "door")


def edit(directory, change):
    """Change the data of a door's leaf on the disk."""
    path = directory / "asset.json"
    data = json.loads(path.read_text())
    change(next(item for item in data["links"] if item["name"] == "door"))
    path.write_text(json.dumps(data))
    return Asset.load(directory)


def test_colliders_read_back_are_compared_with_the_meshes(copy):
    assert not check_colliders(Asset.load(copy)).findings


def test_a_collider_that_was_removed_from_the_file_is_found(copy):
    def without_the_first(link):
        del link["colliders"][0]

    (finding,) = check_colliders(edit(copy, without_the_first)).faults
    assert finding.link == "door"
    assert finding.message.startswith("its solid sticks out of its colliders by ")


def test_a_file_that_does_not_tell_what_is_only_seen_is_not_judged(copy):
    result = check_colliders(edit(copy, lambda link: link.pop("details")))
    (note,) = result.findings
    assert not result.faults
    assert "does not tell which solids are only seen" in note.message


def test_a_hollow_read_back_is_not_taken_for_solid(tmp_path):
    @artgen.generator
    def safe() -> artgen.Body:
        return part(box(0.1, 0.1, 0.1) - box(0.09, 0.09, 0.09), "door", STEEL)

    directory = safe.generate(certify=False).export(tmp_path / "out", formats=("mjcf",))
    path = directory / "asset.json"
    data = json.loads(path.read_text())
    link = data["links"][0]
    link["details"] = []
    path.write_text(json.dumps(data))
    result = check_colliders(Asset.load(directory))
    assert not result.findings
    assert result.detail.endswith("hollows kept 100 %")
    block = {"kind": "box", "size": [0.1] * 3, "points": [], "pose": np.eye(4).tolist()}
    link["colliders"] = [link["colliders"][0] | block]
    path.write_text(json.dumps(data))
    (finding,) = check_colliders(Asset.load(directory)).faults
    assert finding.message == "its colliders leave only 0 % of the space in its hollows empty"


@artgen.generator
def hoop(*, kind: str = "covers") -> artgen.Body:
    """A ring whose hollow its colliders fill, turned and mirrored after that was declared."""
    ring = torus(0.1, 0.01)
    covers = {"none": [], "covers": [box(0.22, 0.22, 0.03)], "hull": [artgen.hull(ring)]}[kind]
    ring = bounding_collider(ring, *covers).rotate(Y, 0.3).mirror(Y)
    return part((ring | box(0.2, 0.02, 0.02).at(0.2)) - box(0.01, 0.01, 1.0), "door", STEEL)


@pytest.mark.parametrize("kind", ["covers", "hull"])
def test_declared_covers_may_stand_off_in_memory_and_in_files(kind, tmp_path):
    asset = hoop.generate(0, kind=kind, certify=False)
    asset.export(tmp_path / "hoop", formats=["urdf"])
    for each in (asset, Asset.load(tmp_path / "hoop")):
        result = check_colliders(each)
        assert not result.findings
        assert result.detail.endswith("coarse covers on 1 links")


def test_the_fault_of_colliders_that_stand_off_undeclared_names_how_to_declare_them():
    off, kept = check_colliders(hoop.generate(0, kind="none", certify=False)).faults
    assert "stand off the surface by" in off.message
    assert kept.message.endswith("of the space in its hollows empty")
    assert "bounding_collider(solid, box(...)) or bounding_collider(solid, hull(solid))" in off.hint


def test_beside_declared_covers_the_colliders_follow_the_solid():
    asset = hoop.generate(0, certify=False)
    message, *_ = messages(with_convexes(asset, lambda all_: [*all_, collider(Convex.box((0.4, 0.3, 0.12)))]))
    assert "stand off the surface by" in message


def test_covers_in_a_file_that_leave_the_solid_out_are_found(tmp_path):
    hoop.generate(0, certify=False).export(tmp_path / "hoop", formats=["urdf"])

    def shrink(link):
        for each in link["colliders"]:
            if max(each["size"], default=0.0) > 0.2:
                each["size"][2] *= 0.5

    (finding,) = check_colliders(edit(tmp_path / "hoop", shrink)).faults
    assert finding.message.startswith("its solid sticks out of its colliders by ")
    assert finding.hint.startswith("enlarge a cover of bounding_collider(solid, ...) there")
