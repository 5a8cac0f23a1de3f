"""URDF of other tools: what is read, what is noted, and what is refused."""

import math
from collections.abc import Mapping

import numpy as np
import pytest
import trimesh

import artgen
from artgen.errors import AssetError, ExportError
from artgen.export import export
from artgen.referee import urdf
from artgen.referee.model import ForeignModel
from artgen.referee.urdf import read_urdf, repaired_urdf

ARM = """<?xml version="1.0"?>
<!-- an arm of a foreign tool -->
<robot name="arm">
  <link name="base"><collision><geometry><box size="0.4 0.2 0.1"/></geometry></collision></link>
  <link name="arm">
    <collision name="rod">
      <origin xyz="0.5 0 0" rpy="0 1.5707963267948966 0"/>
      <geometry><cylinder radius="0.02" length="0.8"/></geometry>
    </collision>
    <collision><geometry><sphere radius="0.05"/></geometry></collision>
  </link>
  <joint name="swing" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <origin xyz="0.2 0 0.3" rpy="0 0 1.5707963267948966"/>
    <axis xyz="0 2 0"/>
    <limit lower="-1.5" upper="0.5" effort="3" velocity="2"/>
  </joint>
</robot>
"""
SWING = ARM[ARM.index("  <joint") : ARM.index("</robot>")]


@pytest.fixture
def reads(tmp_path):
    """Read the text of a URDF, beside the meshes in the folder."""

    def read(text=ARM, *edits, **options):
        for old, new in edits:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "arm.urdf"
        path.write_text(text, encoding="utf-8")
        return read_urdf(path, **{"root": tmp_path, **options})

    return read


def refused(reads, *edits, text=ARM, **options):
    """Return the message about a damaged file, which must be one line."""
    with pytest.raises(AssetError) as caught:
        reads(text, *edits, **options)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def moved(model: ForeignModel, q: Mapping[str, float]):
    """Return the motion of each body from position 0."""
    motions = {"": np.eye(4)}
    for body in model.bodies:
        motions[body.name] = motions[body.parent]
        for joint in body.joints:
            motions[body.name] = motions[body.name] @ joint.motion(q[joint.name])
    return motions


def swing(reads, *edits):
    return reads(ARM, *edits).bodies[1]


@pytest.mark.parametrize("category", ["cabinet", "faucet", "lamp", "plier", "toaster", "trashcan"])
def test_the_files_of_artgen_say_what_their_asset_is(category, tmp_path):
    asset = artgen.generate(category, seed=3, certify=False)
    export(asset, tmp_path / "files", formats=["urdf"])
    model = read_urdf(tmp_path / "files" / f"{asset.name}.urdf", root=tmp_path)
    assert model.notes == ()
    moving = {joint.name: joint for joint in asset.joints if not joint.locked}
    read = {joint.name: joint for body in model.bodies for joint in body.joints}
    assert set(read) == set(moving)
    for found, joint in ((read[each], moving[each]) for each in moving):
        assert found.kind == joint.kind
        assert found.limits == (None if joint.limits is None else pytest.approx(joint.limits, abs=1e-9))
        assert np.allclose(found.axis, joint.axis, atol=1e-9)
        assert (found.follows is None) == (joint.follows is None)
        if joint.follows is not None:
            assert found.follows.leader == joint.follows.leader
            assert found.follows.ratio == pytest.approx(joint.follows.ratio, abs=1e-9)
    bodies = {body.name: body for body in model.bodies}
    for state in asset.sample_states(5):
        q = asset.positions(dict(zip(asset.dof_names, state.tolist(), strict=True)))
        motions, poses = moved(model, q), asset.pose(q)
        for link in asset.links:
            geoms = bodies[link.name].geoms
            assert len(geoms) == sum(3 if each.convex.kind == "capsule" else 1 for each in link.colliders)
            if geoms:
                boxes = [each.convex.transformed(motions[link.name]).bounds() for each in geoms]
                wanted = [each.convex.transformed(poses[link.name]).bounds() for each in link.colliders]
                assert np.allclose(np.min(boxes, axis=0)[0], np.min(wanted, axis=0)[0], atol=1e-6)
                assert np.allclose(np.max(boxes, axis=0)[1], np.max(wanted, axis=0)[1], atol=1e-6)


def test_bodies_joints_and_colliders_are_in_the_world(reads):
    model = reads()
    base, arm = model.bodies
    assert (model.format, base.parent, base.joints, base.apart) == ("urdf", "", (), "")
    assert arm.parent == "base"
    (joint,) = arm.joints
    assert (joint.name, joint.kind, joint.limits, joint.follows) == ("swing", "revolute", (-1.5, 0.5), None)
    assert np.allclose(joint.axis, (-1, 0, 0))
    assert np.allclose(joint.pivot, (0.2, 0, 0.3))
    assert [geom.name for geom in base.geoms + arm.geoms] == ["base_0", "rod", "arm_1"]
    rod = arm.geoms[0].convex
    assert (rod.kind, rod.size) == ("cylinder", (0.02, 0.8))
    assert np.allclose(rod.bounds(), ((0.18, 0.1, 0.28), (0.22, 0.9, 0.32)))
    assert base.geoms[0].convex.size == (0.4, 0.2, 0.1)


def test_each_type_of_joint(reads):
    kind = 'type="revolute"'
    assert swing(reads, (kind, 'type="continuous"')).joints[0].limits is None
    slide = swing(reads, (kind, 'type="prismatic"')).joints[0]
    assert (slide.kind, slide.limits) == ("prismatic", (-1.5, 0.5))
    fixed = swing(reads, (kind, 'type="fixed"'))
    assert (fixed.joints, fixed.apart, fixed.parent) == ((), "", "base")
    for name in ("floating", "planar", "spherical"):
        apart = swing(reads, (kind, f'type="{name}"'))
        assert (apart.joints, apart.apart) == ((), f"{name} joint 'swing'")
    ball = swing(reads, ("<joint", "<drake:joint"), ("</joint", "</drake:joint"), (kind, 'type="ball"'))
    assert ball.apart == "ball joint 'swing'"
    assert "'revolut'. Did you mean 'revolute'?" in refused(reads, (kind, 'type="revolut"'))
    assert np.allclose(swing(reads, ('<axis xyz="0 2 0"/>', "")).joints[0].axis, (0, 1, 0))


def test_limits(reads):
    limit = '<limit lower="-1.5" upper="0.5" effort="3" velocity="2"/>'
    assert "line 12: <joint> 'swing' has no <limit>; give its lower and upper" in refused(reads, (limit, ""))
    assert "from 2 to 0.5; exchange them" in refused(reads, ('lower="-1.5"', 'lower="2"'))
    assert "from -1.5 to 1e+300; give at most 1e+06" in refused(reads, ('upper="0.5"', 'upper="1e300"'))
    model = reads(ARM, ('lower="-1.5" upper="0.5"', ""))
    assert model.bodies[1].joints[0].limits == (0.0, 0.0)
    assert model.notes == ("1 joint ('swing'): limited without lower and upper: locked at 0, their default",)
    far = reads(ARM, ("-1.5", "-1e300"), ('"0.5"', '"1e300"'))
    assert far.bodies[1].joints[0].limits is None
    soft = '<safety_controller soft_lower_limit="0" soft_upper_limit="0.1" k_velocity="1"/>'
    assert swing(reads, (limit, limit + soft)).joints[0].limits == (-1.5, 0.5)


SECOND = """<link name="{0}"/><joint name="{0}" type="revolute"><parent link="arm"/><child link="{0}"/>
<limit lower="0" upper="1"/><mimic joint="{1}" {2}/></joint></robot>"""


def test_a_joint_that_mimics_another(reads):
    end = "</robot>"
    follows = reads(ARM, (end, SECOND.format("b", "swing", 'multiplier="-2" offset="0.1"')))
    follows = follows.bodies[2].joints[0].follows
    assert (follows.leader, follows.ratio, follows.offset) == ("swing", -2.0, 0.1)
    plain = reads(ARM, (end, SECOND.format("b", "swing", ""))).bodies[2].joints[0].follows
    assert (plain.ratio, plain.offset) == (1.0, 0.0)
    assert "'swong', which is no joint that moves. Did you mean 'swing'?" in refused(
        reads, (end, SECOND.format("b", "swong", ""))
    )
    fixed = refused(reads, ('"revolute"', '"fixed"'), (end, SECOND.format("b", "swing", "")))
    assert "no joint that moves" in fixed
    assert "circle; one must lead" in refused(reads, (end, SECOND.format("b", "b", "")))
    pair = SECOND.format("b", "c", "").replace(end, "") + SECOND.format("c", "b", "")
    assert "circle; one must lead" in refused(reads, (end, pair))
    assert "multiplier is 'nan'; give 1 finite number" in refused(
        reads, (end, SECOND.format("b", "swing", 'multiplier="nan"'))
    )


def test_capsules_and_shapes_that_are_not_judged(reads):
    ball = '<sphere radius="0.05"/>'
    capsule = swing(reads, (ball, '<capsule radius="0.05" length="0.3"/>')).geoms[1].convex
    assert (capsule.kind, capsule.size) == ("capsule", (0.05, 0.3))
    assert swing(reads, (ball, '<capsule radius="0.05" length="0"/>')).geoms[1].convex.kind == "sphere"
    assert swing(reads, (ball, '<drake:capsule radius="1" length="2"/>')).geoms[1].convex.size == (1.0, 2.0)
    for shape in ('<plane normal="0 0 1"/>', ""):
        model = reads(ARM, (ball, shape))
        assert model.notes == ("1 collider ('arm_1'): without a shape that URDF has: not judged",)
        assert len(model.bodies[1].geoms) == 1
    assert reads(ARM, ("0.4 0.2 0.1", "0.4 0.2 0")).notes == ("1 collider ('base_0'): flat: not judged",)


def test_bodies_without_colliders_and_ignored_elements(reads):
    visual = "<visual><geometry><box size='1 1 1'/></geometry></visual>"
    links = "".join(f'<link name="v{i}">{visual}</link>' for i in range(5)) + '<link name="frame"/>'
    joint = '<joint name="{0}" type="fixed"><parent link="base"/><child link="{0}"/></joint>'
    joints = "".join(joint.format(name) for name in ("v0", "v1", "v2", "v3", "v4", "frame"))
    other = "<transmission name='t'><joint name='swing'/></transmission><gazebo><link name='x'/></gazebo>"
    model = reads(
        ARM, ("</robot>", f"{links}{joints}{other}<drake:collision_filter_group name='g'/></robot>")
    )
    assert model.notes == (
        "5 bodies ('v0', 'v1', 'v2', ...): visible without a collider: not judged",
        "1 collision filter ('g'): obeyed by Drake alone: not obeyed",
    )
    assert len(model.bodies) == 8


def test_names_of_geoms_are_unique(reads):
    model = reads(ARM, ("<collision><geometry><box", '<collision name="rod"><geometry><box'))
    assert [g.name for body in model.bodies for g in body.geoms] == ["base_0", "arm_0", "arm_1"]
    model = reads(ARM, ('name="rod"', 'name="base_0"'))
    assert [g.name for body in model.bodies for g in body.geoms] == ["base_0_", "base_0", "arm_1"]


MESH = ('<sphere radius="0.05"/>', '<mesh filename="{}" {}/>')


def mesh(name, scale=""):
    return MESH[0], MESH[1].format(name, scale)


def test_meshes(reads, tmp_path, coacd_cache):
    trimesh.creation.box((1, 2, 3)).apply_translation((5, 0, 0)).export(tmp_path / "box.stl")
    convex = swing(reads, mesh("box.stl", 'scale="0.1 0.1 -0.2"')).geoms[1].convex
    assert convex.kind == "box"
    assert convex.volume == pytest.approx(6 * 0.002)
    center = np.mean(convex.bounds(), axis=0)
    assert np.allclose(center, (0.2, 0.5, 0.3))  # the frame of the link is turned to y
    assert swing(reads, mesh("box.stl", 'scale="0.1"')).geoms[1].convex.volume == pytest.approx(0.006)
    both = trimesh.util.concatenate([trimesh.creation.box((1, 1, 1)), trimesh.creation.box((3, 0.2, 0.2))])
    both.export(tmp_path / "both.obj")
    model = reads(ARM, mesh("both.obj"))
    assert model.notes == ("1 mesh ('both.obj'): not convex: taken as hulls, as most simulators take them",)
    assert len(model.bodies[1].geoms) == 2
    model = reads(ARM, mesh("both.obj"), meshes="coacd")
    assert [geom.name for geom in model.bodies[1].geoms] == ["rod", "arm_1_0", "arm_1_1"]
    assert "decomposed into convex pieces by CoACD" in model.notes[0]
    assert not reads(ARM, mesh("box.stl"), meshes="coacd").notes
    (tmp_path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    (tmp_path / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n", encoding="utf-8")
    assert "line 10: <mesh>: 'bad.obj' cannot be read as OBJ" in refused(reads, mesh("bad.obj"))
    assert reads(ARM, mesh("flat.obj")).notes == ("1 mesh ('flat.obj'): flat: not judged",)


def test_scenes_have_a_piece_for_each_mesh(reads, tmp_path):
    scene = trimesh.Scene(trimesh.creation.icosphere())
    scene.add_geometry(
        trimesh.creation.box(), transform=trimesh.transformations.translation_matrix((9, 0, 0))
    )
    scene.export(tmp_path / "scene.glb")
    geoms = swing(reads, mesh("scene.glb")).geoms[1:]
    assert [geom.name for geom in geoms] == ["arm_1_0", "arm_1_1"]
    centers = sorted(geom.convex.bounds().mean(axis=0).round(6).tolist() for geom in geoms)
    assert centers == [[0.2, 0.0, 0.3], [0.2, 9.0, 0.3]]
    data = trimesh.creation.box((1000, 1000, 1000)).export(file_type="dae")
    (tmp_path / "box.dae").write_bytes(data.replace(b"<asset>", b'<asset><unit meter="0.001"/>', 1))
    pytest.importorskip("collada")
    model = reads(ARM, mesh("box.dae"))
    assert model.bodies[1].geoms[1].convex.size == pytest.approx((1, 1, 1))
    assert "1 mesh ('box.dae'): Collada with an up axis other than Z" in model.notes[0]
    (tmp_path / "box.dae").write_bytes(data.replace(b"Y_UP", b"Z_UP"))
    assert reads(ARM, mesh("box.dae")).notes == ()


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (('"0.4 0.2 0.1"', '"0.4 0.2"'), "line 4: <box>: size is '0.4 0.2'; give 3 finite numbers"),
        (('"0.4 0.2 0.1"', '"0.4 nan 0.1"'), "size is '0.4 nan 0.1'; give 3 finite numbers"),
        (('"0.4 0.2 0.1"', '"0.4 1e9 0.1"'), "give 3 finite numbers from -1e+06 to 1e+06"),
        (('"0.4 0.2 0.1"', '"0.4 -1 0.1"'), "<box> of collider 'base_0' has a negative size"),
        (('radius="0.05"', ""), "<sphere>: radius is ''; give 1 finite number"),
        (('xyz="0 2 0"', 'xyz="0 0 0"'), "line 16: <axis> of joint 'swing' is 0 0 0; give a direction"),
        (('xyz="0 2 0"', 'xyz="0 inf 0"'), "<axis>: xyz is '0 inf 0'"),
        (('rpy="0 1.57', 'rpy="0 0 0 1.57'), "<origin>: rpy is"),
        (('xyz="0.2 0 0.3"', 'quat_xyzw="0 0 0 1"'), "has quat_xyzw, which is not read; give rpy"),
        (
            ('<link name="arm">', '<link name="base">'),
            "line 5: <link> 'base' has the name of the link in line 4",
        ),
        (('<link name="arm">', "<link>"), "line 5: <link> has no name"),
        (
            ('<parent link="base"/>', '<parent link="bse"/>'),
            "<parent> is 'bse', which is no link. Did you mean",
        ),
        (('<child link="arm"/>', ""), "<joint> 'swing' has no <child>; name a link"),
        (('<parent link="base"/>', '<parent link="arm"/>'), "is in a circle of joints, or below one"),
        (
            ("</robot>", '<link name="x"/></robot>'),
            "<link> 'x' has no parent, as 'base'; a URDF has one root",
        ),
        (("</robot>", SWING + "</robot>"), "<joint> 'swing' has the name of the joint in line 12"),
        (
            ("</robot>", SWING.replace('"swing"', '"b"') + "</robot>"),
            "has the child 'arm', as the joint in line 12",
        ),
        (("</robot>", ""), "line 20: it is not well-formed XML (no element found); correct it"),
        (
            ("<robot", "<!DOCTYPE r [<!ENTITY a 'b'>]><robot"),
            "line 3: it declares a document type or an entity",
        ),
        (
            ("</robot>", "<xacro:include filename='/etc/passwd'/></robot>"),
            "belongs to xacro; expand the file first",
        ),
        (('<sphere radius="0.05"/>', '<mesh filename="none.stl"/>'), "'none.stl', which does not exist"),
        (('<sphere radius="0.05"/>', "<mesh/>"), "filename is '', which is no regular file"),
        (('<sphere radius="0.05"/>', '<mesh filename="../x.stl"/>'), "give --root DIR to allow it"),
        (('<sphere radius="0.05"/>', '<mesh filename="a.stl" scale="1 0 1"/>'), "<mesh> has the scale 0"),
    ],
)
def test_a_damaged_file_has_one_clear_error(reads, edit, message):
    assert message in refused(reads, edit)


def test_files_that_are_no_urdf(reads, tmp_path, monkeypatch):
    assert "<sdf> is the root; the root of a URDF is <robot>" in refused(reads, text="<sdf/>")
    assert "has no <link>" in refused(reads, text="<robot/>")
    circle = ARM.replace("</robot>", SWING.replace('"base"', '"x"').replace('"arm"', '"base"'))
    circle = circle.replace('name="swing"', 'name="back"', 1).replace('"x"', '"arm"') + "</robot>"
    assert "is in a circle of joints" in refused(reads, text=circle)
    assert "more than 200 elements are nested" in refused(reads, text="<a>" * 100_000)
    with pytest.raises(AssetError, match="no regular file"):
        read_urdf(tmp_path, root=tmp_path)
    with pytest.raises(AssetError, match="does not exist"):
        read_urdf(tmp_path / "none.urdf", root=tmp_path)
    monkeypatch.setattr(urdf, "MOST_BODIES", 1)
    assert "has 2 links; at most 1 are read" in refused(reads)
    monkeypatch.undo()
    monkeypatch.setattr(urdf, "MOST_GEOMS", 2)
    assert "has 3 colliders; at most 2 are read" in refused(reads)


def test_a_long_chain_of_links_exhausts_nothing(reads):
    joint = '<joint name="j{0}" type="fixed"><parent link="l{0}"/><child link="l{1}"/></joint>'
    links = "".join(f'<link name="l{number}"/>' for number in range(1500))
    joints = "".join(joint.format(number, number + 1) for number in range(1499))
    assert len(reads(f"<robot>{links}{joints}</robot>").bodies) == 1500


def test_a_repaired_copy_differs_in_limits_alone(reads, tmp_path):
    reads()
    path, out = tmp_path / "arm.urdf", tmp_path / "repaired.urdf"
    repaired_urdf(path, {"swing": (-0.25, 0.1)}, out)
    text = out.read_text(encoding="utf-8")
    assert text == ARM.replace('"-1.5"', '"-0.25"').replace('upper="0.5"', 'upper="0.1"')
    repaired_urdf(path, {"swing": (0.0, 0.0)}, out)
    assert read_urdf(out, root=tmp_path).bodies[1].joints[0].locked
    limit = '<limit lower="-1.5" upper="0.5" effort="3" velocity="2"/>'
    for found in (limit, "<!-- no > limit -->", "<limit effort='3' velocity='2'\n/>"):
        reads(ARM, ('type="revolute"', "type = 'continuous'"), (limit, found))
        repaired_urdf(path, {"swing": (-math.pi, 0.5)}, out)
        joint = read_urdf(out, root=tmp_path).bodies[1].joints[0]
        assert (joint.kind, joint.limits) == ("revolute", (-math.pi, 0.5))
        assert "<!-- an arm of a foreign tool -->" in out.read_text(encoding="utf-8")


def test_what_cannot_be_repaired(reads, tmp_path):
    reads()
    path, out = tmp_path / "arm.urdf", tmp_path / "repaired.urdf"
    with pytest.raises(AssetError, match=r"no joint 'swong'\. Did you mean 'swing'"):
        repaired_urdf(path, {"swong": (0.0, 1.0)}, out)
    with pytest.raises(AssetError, match="cannot have the limits 1, 0"):
        repaired_urdf(path, {"swing": (1.0, 0.0)}, out)
    for place in (path, tmp_path / "other" / "arm.urdf"):
        with pytest.raises(AssetError, match="another file in the folder"):
            repaired_urdf(path, {}, place)
    out.mkdir()
    with pytest.raises(ExportError, match="cannot write"):
        repaired_urdf(path, {}, out)
    reads(ARM, ("revolute", "fixed"))
    with pytest.raises(AssetError, match="it must move"):
        repaired_urdf(path, {"swing": (0.0, 1.0)}, tmp_path / "b.urdf")
    path.write_bytes(ARM.replace('version="1.0"', 'version="1.0" encoding="utf-16"').encode("utf-16"))
    with pytest.raises(AssetError, match="save it as UTF-8"):
        repaired_urdf(path, {"swing": (0.0, 1.0)}, tmp_path / "b.urdf")
