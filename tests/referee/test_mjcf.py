"""Reading of MJCF: what collides, what moves, what the file excludes, and hostile files."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

import artgen as ag
from artgen.errors import AssetError
from artgen.referee import certify
from artgen.referee.mjcf import read_mjcf
from artgen.referee.model import ForeignModel
from artgen.referee.trees import trees_of


def read(folder: Path, body: str, rest: str = "", compiler: str = "") -> ForeignModel:
    """Read a file with a world of `body`, and `rest` beside it."""
    path = folder / "file.xml"
    path.write_text(f"<mujoco><compiler {compiler}/><worldbody>{body}</worldbody>{rest}</mujoco>")
    return read_mjcf(path, root=folder)


def two(joint: str = '<joint name="j" axis="0 0 1" range="0 90"/>', geom: str = "") -> str:
    """Return a body with a box, and a body that moves against it."""
    moved = geom or '<geom name="b" size=".1 .1 .1" type="box"/>'
    return (
        '<body name="base"><geom name="a" type="box" size=".1 .1 .1"/>'
        f'<body name="arm" pos="0 0 .5">{joint}{moved}</body></body>'
    )


@pytest.mark.parametrize("category", ["microwave", "drawer", "faucet", "soap_dispenser", "plier", "lamp"])
def test_own_exports_read_back_as_they_are(category: str, tmp_path: Path) -> None:
    asset = ag.generate(category, 3, certify=False)
    folder = asset.export(tmp_path / category, formats=("mjcf",), textures=0)
    model = read_mjcf(next(folder.glob("*.xml")), root=folder)
    (tree,) = (each for each in trees_of(model)[0] if each.asset.joints)
    read_joints = {joint.name: joint for joint in tree.asset.joints}
    assert set(read_joints) == {joint.name for joint in asset.joints}
    for joint in asset.joints:
        found = read_joints[joint.name]
        assert found.kind == joint.kind
        assert found.axis == pytest.approx(joint.axis, abs=1e-6)
        if joint.limits is not None and joint.follows is None:
            assert found.limits == pytest.approx(joint.limits, abs=1e-6)
        if joint.follows is not None:
            assert found.follows is not None
            assert found.follows.leader == joint.follows.leader
            assert found.follows.ratio == pytest.approx(joint.follows.ratio, rel=1e-6)
    count = sum(len(link.colliders) for link in asset.links)
    assert sum(len(body.geoms) for body in model.bodies) == count
    rng = np.random.default_rng(0)
    for _ in range(5):
        q = {joint.name: rng.uniform(*(joint.limits or (-math.pi, math.pi))) for joint in asset.free_joints}
        ours, theirs = asset.pose(q), tree.asset.pose(q)
        for name in set(ours) & set(theirs):
            assert theirs[name] == pytest.approx(ours[name], abs=1e-5), name


def test_limits_are_radians_and_unlimited_joints_have_none(tmp_path: Path) -> None:
    degrees = read(tmp_path, two())
    assert degrees.bodies[-1].joints[0].limits == pytest.approx((0.0, math.pi / 2))
    free = read(tmp_path, two('<joint name="j" axis="0 0 1"/>'))
    assert free.bodies[-1].joints[0].limits is None
    slide = read(tmp_path, two('<joint name="j" type="slide" axis="1 0 0" range="-.1 .2"/>'))
    assert (slide.bodies[-1].joints[0].kind, slide.bodies[-1].joints[0].limits) == ("prismatic", (-0.1, 0.2))


def test_geometry_is_that_of_position_0_whatever_the_reference_position(tmp_path: Path) -> None:
    joint = '<joint name="j" type="slide" axis="1 0 0" range="0 1" ref=".5"/>'
    model = read(tmp_path, two(joint))
    assert model.bodies[-1].geoms[0].convex.pose[:3, 3] == pytest.approx([-0.5, 0.0, 0.5])


@pytest.mark.parametrize(
    ("geom", "kind", "size"),
    [
        ('type="sphere" size=".1"', "sphere", (0.1,)),
        ('type="capsule" size=".1 .2"', "capsule", (0.1, 0.4)),
        ('type="cylinder" size=".1 .2"', "cylinder", (0.1, 0.4)),
        ('type="box" size=".1 .2 .3"', "box", (0.2, 0.4, 0.6)),
        ('type="ellipsoid" size=".1 .2 .3"', "hull", ()),
    ],
)
def test_primitives_are_exact(geom: str, kind: str, size: tuple[float, ...], tmp_path: Path) -> None:
    (found,) = read(tmp_path, two(geom=f"<geom {geom}/>")).bodies[-1].geoms
    assert (found.convex.kind, found.convex.size) == (kind, pytest.approx(size))
    if kind == "hull":
        assert np.abs(found.convex.bounds() - [[-0.1, -0.2, 0.2], [0.1, 0.2, 0.8]]).max() < 3e-3


def test_visual_geoms_planes_and_height_fields_are_no_colliders(tmp_path: Path) -> None:
    visual = '<geom name="v" type="box" size=".1 .1 .1" contype="0" conaffinity="0"/>'
    model = read(tmp_path, two(geom=visual) + '<geom name="floor" type="plane" size="1 1 1"/>')
    assert not model.bodies[-1].geoms
    assert model.notes == ("planes are not judged: floor",)


def test_free_and_ball_joints_divide_the_model(tmp_path: Path) -> None:
    free = '<body name="box" pos="0 0 2"><freejoint name="root"/><geom name="c" size=".1"/></body>'
    trees, notes = trees_of(read(tmp_path, two() + free))
    assert [len(tree.asset.links) for tree in trees] == [2, 1]
    assert notes == ["2 groups of bodies are judged apart, and no pair between two groups: free joint 'root'"]
    ball = read(tmp_path, two('<joint name="neck" type="ball"/>'))
    assert ball.bodies[-1].apart == "ball joint 'neck'"


def test_what_mujoco_lets_not_collide_is_excluded_with_its_reason(tmp_path: Path) -> None:
    chain = (
        '<body name="one"><joint name="j1" axis="0 0 1" range="0 9"/><geom name="a" size=".1"/>'
        '<body name="two" pos="0 0 1"><joint name="j2" axis="0 0 1" range="0 9"/><geom name="b" size=".1"/>'
        '<geom name="m" size=".1" pos="1 0 0" contype="2" conaffinity="2"/>'
        '<body name="three" pos="0 0 1"><joint name="j3" axis="0 0 1" range="0 9"/><geom name="c" size=".1"/>'
        "</body></body></body>"
    )
    model = read(tmp_path, chain, '<contact><exclude body1="one" body2="three"/></contact>')
    assert model.excluded == {
        frozenset(("one", "two")): "parent and child",
        frozenset(("two", "three")): "parent and child",
        frozenset(("one", "three")): "<exclude>",
    }
    flag = '<option><flag filterparent="disable"/></option>'
    model = read(tmp_path, chain, flag)
    assert not model.excluded
    assert model.exempt == {frozenset(("a", "m")), frozenset(("c", "m"))}
    paired = read(tmp_path, chain, flag + '<contact><pair geom1="a" geom2="m"/></contact>')
    assert paired.exempt == {frozenset(("c", "m"))}


def test_linear_equalities_are_couplings_and_others_restrict(tmp_path: Path) -> None:
    arms = two() + two().replace('"base"', '"base2"').replace('"arm"', '"arm2"').replace(
        '"j"', '"k"'
    ).replace('"a"', '"a2"').replace('"b"', '"b2"')
    follow = '<equality><joint joint1="j" joint2="k" polycoef="0.1 -2 0 0 0"/></equality>'
    (joint,) = next(body for body in read(tmp_path, arms, follow).bodies if body.name == "arm").joints
    assert joint.follows is not None
    assert (joint.follows.leader, joint.follows.ratio, joint.follows.offset) == ("k", -2.0, 0.1)
    curved = read(tmp_path, arms, follow.replace("-2 0", "-2 1"))
    assert curved.restricted == {"j": "joint equality on 'j'"}
    loop = '<equality><connect body1="arm" body2="arm2" anchor="0 0 0"/></equality>'
    assert read(tmp_path, arms, loop).restricted == {"j": "connect equality", "k": "connect equality"}
    circle = follow + follow.replace('"j"', '"x"').replace('"k"', '"j"').replace('"x"', '"k"')
    assert read(tmp_path, arms, circle).restricted == {"k": "joint equality on 'k'"}


def test_a_collision_that_a_loop_may_forbid_is_not_proven(tmp_path: Path) -> None:
    slide = '<joint name="j" type="slide" axis="0 0 -1" range="0 1"/>'
    path = tmp_path / "loop.xml"
    other = '<body name="far" pos="5 0 0"><joint name="k" axis="0 0 1" range="0 9"/><geom size=".1"/></body>'
    loop = '<equality><connect body1="arm" body2="far" anchor="0 0 0"/></equality>'
    path.write_text(f"<mujoco><worldbody>{two(slide)}{other}</worldbody>{loop}</mujoco>")
    judgment = certify(path)
    assert judgment.verdict == "not proven"
    assert "not proven, for the connect equality may forbid this pose" in str(judgment)


def test_a_concave_mesh_is_a_hull_or_decomposed(tmp_path: Path) -> None:
    import trimesh

    parts = [
        trimesh.creation.box(size, trimesh.transformations.translation_matrix(at))
        for size, at in (
            ((1.0, 0.2, 0.2), (0.0, 0.0, 0.0)),
            ((0.2, 0.2, 1.0), (-0.4, 0.0, 0.5)),
            ((0.2, 0.2, 1.0), (0.4, 0.0, 0.5)),
        )
    ]
    trimesh.boolean.union(parts, engine="manifold").export(tmp_path / "u.stl")
    mesh = '<asset><mesh name="u" file="u.stl"/></asset>'
    body = two(geom='<geom name="u" type="mesh" mesh="u"/>')
    hull = read(tmp_path, body, mesh)
    assert [geom.name for geom in hull.bodies[-1].geoms] == ["u"]
    assert hull.notes == ("1 mesh ('u'): not convex: taken as hulls, as most simulators take them",)
    pieces = read_mjcf(tmp_path / "file.xml", meshes="coacd", root=tmp_path)
    volume = sum(geom.convex.volume for geom in pieces.bodies[-1].geoms)
    assert len(pieces.bodies[-1].geoms) >= 3
    assert volume == pytest.approx(0.104, rel=0.15)
    assert "decomposed into convex pieces by CoACD" in pieces.notes[0]


def test_faults_beside_the_colliders_do_not_stop_the_reading(tmp_path: Path) -> None:
    looks = '<asset><texture name="t" type="2d" file="none.png"/><material name="m" texture="t"/>'
    looks += '<mesh name="none" file="none.stl"/></asset>'
    visual = '<geom type="mesh" mesh="none" contype="0" conaffinity="0" material="m"/>'
    other = '<sensor><touch site="none"/></sensor><actuator><motor joint="none"/></actuator>'
    other += '<contact><pair geom1="a" geom2="none"/></contact>'
    massless = '<body name="tip" pos="1 0 0"><joint name="spin"/></body>'
    model = read(tmp_path, two().replace("</body>", f"{visual}{massless}</body>", 1), looks + other)
    assert [body.name for body in model.bodies] == ["world", "base", "arm", "tip"]
    assert [geom.name for body in model.bodies for geom in body.geoms] == ["a", "b"]
    assert [joint.name for body in model.bodies for joint in body.joints] == ["j", "spin"]


def test_a_body_that_follows_another_does_not_restrict_its_joints(tmp_path: Path) -> None:
    hand = '<body name="{0}" mocap="true"><geom name="{0}" size=".1" contype="0" conaffinity="0"/></body>'
    world = two() + hand.format("hand") + hand.format("other")
    weld = '<weld body1="{}" body2="arm"/>'
    one = f"<equality>{weld.format('hand')}</equality>"
    assert read(tmp_path, world, one).restricted == {}
    both = f'<equality>{weld.format("hand")}<connect body1="hand" body2="base" anchor="0 0 0"/></equality>'
    assert read(tmp_path, world, both).restricted == {"j": "weld equality"}


def test_a_fixed_tendon_restricts_its_own_joints_only(tmp_path: Path) -> None:
    arms = "".join(
        two(f'<joint name="{name}" range="0 90"/>').replace("base", f"{name}base") for name in "jk"
    )
    arms = arms.replace('"arm"', '"arm2"', 1).replace('name="a"', "").replace('name="b"', "")
    tendon = '<tendon><fixed name="t"><joint joint="k" coef="1"/></fixed></tendon>'
    equality = '<equality><tendon tendon1="t"/></equality>'
    assert read(tmp_path, arms, tendon + equality).restricted == {"k": "tendon or other equality"}


def test_a_limited_tendon_restricts_the_joints_that_it_pulls(tmp_path: Path) -> None:
    arms = two('<joint name="j" range="0 90"/>').replace("</worldbody>", "")
    arms += '<site name="here"/><site name="there" pos="0 0 1"/>'
    fixed = '<tendon><fixed {}><joint joint="j" coef="1"/></fixed></tendon>'
    assert read(tmp_path, arms, fixed.format("")).restricted == {}
    assert read(tmp_path, arms, fixed.format('range="-.1 .1"')).restricted == {"j": "range of a tendon"}
    spatial = '<spatial limited="true" range="0 1"><site site="here"/><site site="there"/></spatial>'
    assert read(tmp_path, arms, f"<tendon>{spatial}</tendon>").restricted == {"j": "range of a tendon"}


@pytest.mark.long
def test_damaged_and_hostile_files_give_one_line(tmp_path: Path) -> None:
    def fault(text: str) -> str:
        path = tmp_path / "inner" / "bad.xml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        with pytest.raises(AssetError) as caught:
            read_mjcf(path, root=path.parent)
        message = str(caught.value)
        assert "\n" not in message
        return message

    (tmp_path / "secret.stl").write_text("solid")
    world = f"<worldbody>{two()}</worldbody>"
    mesh = '<asset><mesh file="{}"/></asset>'
    shown = '<worldbody><geom type="mesh" mesh="none"/></worldbody>'
    assert "not well-formed XML" in fault("<mujoco>")
    assert "declares a document type" in fault('<!DOCTYPE m [<!ENTITY a "b">]><mujoco/>')
    assert "outside" in fault(f"<mujoco>{mesh.format('../secret.stl')}{world}</mujoco>")
    assert "outside" in fault(f"<mujoco>{mesh.format('/etc/passwd')}{world}</mujoco>")
    there = f'<mujoco><compiler meshdir=".."/>{mesh.format("secret.stl")}{world}</mujoco>'
    assert "outside" in fault(there)
    assert "MuJoCo does not compile it" in fault(f"<mujoco>{mesh.format('none.stl')}{shown}</mujoco>")
    assert "MuJoCo does not compile it" in fault('<mujoco><include file="none.xml"/></mujoco>')
    assert "MuJoCo does not compile it" in fault(f"<mujoco><worldbody>{two()}<joint/></worldbody></mujoco>")
    assert "its root is <sdf>; give a file with <mujoco>" in fault("<sdf/>")
    many = '<replicate count="3000000000" offset="1 0 0"><geom size=".1"/></replicate>'
    assert "at most 20000 are read" in fault(f"<mujoco><worldbody>{many}</worldbody></mujoco>")
    grid = '<flexcomp name="f" type="grid" count="500 500 10" spacing=".1 .1 .1" dim="3"/>'
    assert "at most 2000 are read" in fault(f"<mujoco><worldbody>{grid}</worldbody></mujoco>")


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ('pos="0 0 .5"', 'pos="0 nan .5"', "position of geom 'b'"),
        ('pos="0 0 .5"', 'pos="0 0 1e30"', "position of geom 'b' is 0 0 1e+30; give finite numbers from -1e"),
        ('pos="0 0 .5"', 'quat="nan 0 0 1"', "position of geom 'b'"),
        ('size=".1 .1 .1"', 'size="1e300 .1 .1"', "size of geom 'a'"),
        ('axis="0 0 1"', 'axis="nan 0 1"', "axis of joint 'j'"),
        ('range="0 90"', 'range="0 1e300"', "range of joint 'j'"),
        ('range="0 90"', 'range="0 inf"', "range of joint 'j'"),
    ],
)
def test_numbers_that_mujoco_takes_and_no_proof_can_use_are_named(
    old: str, new: str, fault: str, tmp_path: Path
) -> None:
    body = two()
    assert old in body
    with pytest.raises(AssetError, match=f"the {re.escape(fault)}"):
        read(tmp_path, body.replace(old, new, 1))
    assert read(tmp_path, body).bodies  # as it was


def test_an_equality_with_a_number_that_is_none_is_named(tmp_path: Path) -> None:
    joints = two('<joint name="j" axis="0 0 1" range="0 90"/><joint name="k" axis="0 1 0" range="0 90"/>')
    law = '<equality><joint joint1="j" joint2="k" polycoef="nan 1 0 0 0"/></equality>'
    with pytest.raises(AssetError, match="the data of equality '0' is nan 1 0"):
        read(tmp_path, joints, law)
