"""The benchmarks run with the smallest arguments, and what they measure with is right."""

import importlib
import json
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from artgen.validate.clients.install import python_of
from support.cases import some

pytestmark = pytest.mark.long  # scripts of maintainers

FOLDER = Path(__file__).parent.parent / "benchmarks"


@pytest.fixture
def module(monkeypatch):
    """Import a module of the benchmarks."""
    monkeypatch.syspath_prepend(str(FOLDER))
    return importlib.import_module


def benchmark(*arguments):
    return subprocess.run(
        [sys.executable, str(FOLDER / "run.py"), *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )


@pytest.mark.parametrize(
    ("name", "columns"),
    some(
        [
            ("colliders", ("CoACD [ms]", "open, exact [%]", "steps/s, exact")),
            ("certificate", ("ratio, p = 0.001", "verdict of the certificate", "of target")),
            ("cost", ("all / joint [ms]", "r²", "to the median of its seed")),
            ("scaling", ("assets/s", "largest worker [MiB]", "ratio to the first")),
            ("thousand", ("core-seconds an asset", "50 %", "asset.json")),
            ("training", ("MuJoCo, steps/s", "triangles, low", "frames/s, low")),
            ("stages", ("seed to asset", "certificate", "all / fixed workload")),
            ("textures", ("bake / transform", "warm png")),
        ],
        4,
        3,
    ),
)
def test_a_benchmark_runs_and_writes_its_section(name, columns, tmp_path):
    page = tmp_path / "benchmarks.md"
    page.write_text("# Benchmarks\n\n## peers: kept\n\nas it was\n")
    done = benchmark(name, "--quick", "--page", page)
    assert done.returncode == 0, done.stderr
    text = page.read_text()
    assert text.index("## peers: kept\n\nas it was\n") < text.index(f"## {name}: ")
    assert f"    python benchmarks/run.py {name}\n" in text
    assert "Measured on: " in text
    assert "nan" not in text.lower().split()
    for column in columns:
        assert f" {column} |" in text
        assert column.split(",")[0].split()[0] in done.stdout


def test_the_peer_is_measured_where_it_is_installed(module, tmp_path):
    peer = module("peer")
    if python_of(peer.directory() / peer.ENVIRONMENT) is None:
        pytest.skip("scene-synthesizer is not installed; `make bench` does")
    page = tmp_path / "benchmarks.md"
    done = benchmark("peers", "--quick", "--page", page)
    assert done.returncode == 0, done.stderr
    assert "scene-synthesizer [ms] | artgen, same work [ms] | ratio" in page.read_text()


def test_an_unknown_benchmark_is_refused_before_anything_runs(tmp_path):
    done = benchmark("cost", "pears", "--quick", "--page", tmp_path / "page.md")
    assert done.returncode == 1
    assert "error: there is no benchmark 'pears'. Did you mean 'peers'?" in done.stderr
    assert not done.stdout
    assert not list(tmp_path.iterdir())


def section(module, finding):
    report = module("report")
    table = report.Table(
        "Times", ("asset", "time [ms]", "quick"), [("a|b", 1234.5678, True), ("c", None, False)]
    )
    return report.Section("a title", "What is\ncompared.", [table], [finding])


def test_a_section_is_rewritten_alone_and_in_its_place(module, tmp_path):
    write = module("page").write_section
    page = tmp_path / "docs" / "page.md"
    write(page, "second", section(module, "of the second"), ["first", "second"])
    write(page, "first", section(module, "of the first"), ["first", "second"])
    before = page.read_text()
    assert (
        before.index("- of the first") < before.index("## second: a title") < before.index("- of the second")
    )
    assert "What is compared.\n" in before
    assert (
        "| asset | time [ms] | quick |\n| --- | ---: | ---: |\n| a\\|b | 1235 | yes |\n| c |  | no |\n"
        in before
    )
    write(page, "first", section(module, "once more"), ["first", "second"])
    assert page.read_text() == before.replace("of the first", "once more")
    assert [path.name for path in page.parent.iterdir()] == ["page.md"]


def test_a_row_that_does_not_fit_its_columns_is_refused(module):
    with pytest.raises(ValueError, match="'Times' has 2 columns, but the row of 'a' has 1 cells"):
        module("report").Table("Times", ("asset", "time"), [("a",)])


@pytest.mark.parametrize(
    ("cell", "text"),
    [
        (0.0, "0"),
        (0.123456, "0.123"),
        (99.96, "100"),
        (1999.6, "2000"),
        (3e-6, "3.0e-06"),
        (7, "7"),
        (None, ""),
    ],
)
def test_numbers_are_shown_with_three_digits(module, cell, text):
    assert module("report").shown(cell) == text


URDF = """<?xml version="1.0"?>
<robot name="slide">
  <link name="wall">
    <inertial><mass value="12"/><origin xyz="0 0 0"/>
      <inertia ixx="{wall}" iyy="2" izz="2" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry>
      <material name="a"><color rgba="1 0 0 1"/></material></visual>
    <collision><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <link name="block">
    <inertial><mass value="{mass}"/><origin xyz="0 0 0"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry>
      <material name="b"><color rgba="0 1 0 1"/></material></visual>
    <collision><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <joint name="slide" type="prismatic">
    <parent link="wall"/><child link="block"/><axis xyz="1 0 0"/><origin xyz="0.8 0 0"/>
    <limit lower="0" upper="0.8" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def test_links_in_each_other_are_found_as_often_and_as_deep_as_they_are(module, tmp_path):
    path = tmp_path / "slide.urdf"
    path.write_text(URDF.format(wall=2, mass=6))
    found = module("urdf").penetration(path, 400)
    assert found.share == pytest.approx(0.25, abs=0.06)  # the first 0.2 m of 0.8 m
    assert found.deepest == pytest.approx(0.2, abs=0.01)
    apart = module("urdf").penetration(path, 50, lambda q: q["slide"] < 0.2)
    assert apart.share == apart.deepest == 0.0


@pytest.mark.parametrize(
    ("wall", "mass", "triangular", "fitting"),
    [(2, 6, 2, 2), (5, 6, 1, 1), (2, 0.1, 2, 1)],
    ids=["of boxes", "one moment above the sum of the others", "too large for its mass"],
)
def test_a_tensor_has_to_be_one_of_the_body(module, tmp_path, wall, mass, triangular, fitting):
    path = tmp_path / "slide.urdf"
    path.write_text(URDF.format(wall=wall, mass=mass))
    found = module("urdf").contents(path)
    assert (found.bodies, found.massive, found.triangular, found.fitting) == (2, 2, triangular, fitting)
    assert (found.joints, found.colors, found.maps, found.colliders) == (1, 2, 0, 2)
    assert (found.vertices, found.faces) == (16, 24)
    assert found.mass == pytest.approx(12 + mass)


def test_the_number_of_poses_is_what_the_confidence_takes(module):
    certificate = module("bench_certificate")
    poses = certificate.poses_for(1e-3)
    assert 1.0 - (1.0 - 1e-3) ** poses >= certificate.CONFIDENCE > 1.0 - (1.0 - 1e-3) ** (poses - 1)


def test_a_thin_blade_meets_its_pin_on_the_share_that_is_asked_and_the_certificate_finds_it(module):
    certificate = module("bench_certificate")
    asset = certificate.thin_blade(1e-3)
    assert certificate.blade_share(asset) == pytest.approx(1e-3, rel=0.1)
    assert certificate.verdict(asset) == "collision"
    assert certificate.verdict(certificate.thin_blade(1e-5)) == "not proven"


def test_colliders_as_surfaces_and_one_by_one_collide_alike(module):
    contacts = module("contacts")
    asset = module("bench_certificate").thin_blade(0.1)
    pairs = contacts.moving_pairs(asset)
    found = []
    for make in (contacts.convex_links, contacts.surface_links):
        links = make(asset)
        found.append([])
        for angle in np.linspace(0.0, 3.0, 61):
            links.place(asset.pose({"hinge": angle}))
            found[-1].append(bool(links.collide(pairs)))
    assert found[0] == found[1]
    assert sum(found[0]) == pytest.approx(61 * 0.1, abs=2)


def test_random_positions_keep_limits_and_dependencies(module):
    import artgen

    asset = artgen.catalog.find("refrigerator").generate(0, certify=False)
    drawn = module("contacts").random_positions(asset, 40)
    assert len(drawn) == 40
    assert not any(asset.blocked(q) for q in drawn)
    for joint in asset.free_joints:
        low, high = joint.limits or (-math.pi, math.pi)
        assert all(low <= q[joint.name] <= high for q in drawn)
        assert len({q[joint.name] for q in drawn}) == 40


def test_all_volume_is_counted_where_colliders_are_known_by_construction(module):
    import artgen

    asset = artgen.generate("drawer", 0, certify=False)
    for link in asset.links:
        hollow, kept, solid, covered = module("bench_colliders")._volumes(link)
        assert covered == pytest.approx(solid, rel=1e-3)
        assert kept == pytest.approx(hollow, rel=0.05)


def test_the_cache_is_put_back(module, monkeypatch):
    timing = module("timing")
    monkeypatch.setenv("ARTGEN_CACHE", "before")
    with timing.empty_cache() as place:
        assert os.environ["ARTGEN_CACHE"] == str(place)
        assert not list(place.iterdir())
    assert os.environ["ARTGEN_CACHE"] == "before"


FIELD_URDF = """<robot name="gate">
  <link name="post"><collision><geometry><box size="0.1 0.1 1"/></geometry></collision></link>
  <link name="leaf"><collision><origin xyz="{at} 0 0"/><geometry><box size="0.8 0.05 0.9"/></geometry>
  </collision></link>
  <joint name="hinge" type="revolute"><parent link="post"/><child link="leaf"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1.5" effort="1" velocity="1"/></joint>
</robot>
"""

FIELD_MJCF = """<mujoco>
  <default><geom contype="{mask}" conaffinity="{mask}"/></default>
  <worldbody>
    <body name="rail"><joint name="lift" type="slide" axis="0 0 1" range="0 0.1"/>
      <geom name="plate" type="box" size="0.2 0.2 0.01"/>
      <body name="knob" pos="0 0 0.2"><joint name="push" type="slide" axis="0 0 1" range="-0.2 0"/>
        <geom name="ball" type="sphere" size="0.05"/></body></body>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def field_folder(tmp_path):
    folder = tmp_path / "files"
    (folder / "door").mkdir(parents=True)
    (folder / "door" / "free.xml").write_text(FIELD_MJCF.format(mask=1).replace("-0.2 0", "-0.1 0"))
    (folder / "door" / "knob.xml").write_text(FIELD_MJCF.format(mask=1))
    (folder / "part.xml").write_text("<mujocoinclude><body><joint/></body></mujocoinclude>")
    (folder / "still.urdf").write_text(FIELD_URDF.replace("revolute", "fixed").format(at=0.5))
    twice = '<body name="twice"><joint/></body>'
    (folder / "broken.xml").write_text(f"<mujoco><worldbody>{twice}{twice}</worldbody></mujoco>")
    return folder


def field_records(folder):
    return {
        record["path"]: record
        for line in (folder / "local.jsonl").read_text().splitlines()
        for record in [json.loads(line)]
    }


def test_the_field_judges_files_once_and_writes_its_page(field_folder, tmp_path):
    page, out = tmp_path / "field.md", tmp_path / "out"
    command = [sys.executable, str(FOLDER / "field.py"), "--local", field_folder, "--folder", out]
    command = [*map(str, command), "--page", str(page)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=600)
    assert done.returncode == 0, done.stderr
    records = field_records(out)
    assert set(records) == {"door/free.xml", "door/knob.xml", "part.xml", "broken.xml"}
    free, knob = records["door/free.xml"], records["door/knob.xml"]
    assert free["referee"]["verdict_with_excluded"] == "proven"
    assert free["sampled"]["with_parents"]["depth"] == 0.0
    # a joint connects the two: MuJoCo leaves the pair out, unless parents count
    assert knob["sampled"]["as_filed"]["depth"] == 0.0
    assert 0.01 < knob["sampled"]["with_parents"]["depth"] <= 0.0601
    assert knob["sampled"]["with_parents"]["pair"] == ["rail/plate", "knob/ball"]
    assert knob["sampled"]["with_parents"]["state"]["push"] < -0.13
    assert knob["referee"]["verdict_with_excluded"] == "collision"
    (witness,) = knob["referee"]["witnesses"]
    assert witness["depth"] > 1e-5
    assert witness["pair"] == ["rail/plate", "knob/ball"]
    assert knob["sampled"]["states"] == 1 + 2 * 21 + 64
    assert not records["part.xml"]["sampled"]["loadable"]
    assert "does not compile" in records["broken.xml"]["referee"]["error"]
    text = page.read_text()
    assert "# The field" in text
    assert "## Definitions" in text
    assert "In none of" in text
    again = subprocess.run(command, capture_output=True, text=True, check=False, timeout=600)
    assert again.returncode == 0, again.stderr
    assert not again.stdout
    assert page.read_text() == text


def test_a_sampled_overlap_in_a_proven_file_is_named_on_the_page(module):
    field_page = module("field_page")
    deep = {"depth": 0.002, "pair": ["a/1", "b/2"], "state": {"hinge": 0.5}}
    record = {
        "package": "some",
        "path": "a.urdf",
        "sampled": {"loadable": True, "complete": True, "joints": 1, "as_filed": deep, "with_parents": deep},
        "referee": {"verdict": "proven", "verdict_with_excluded": "collision"},
    }
    (line,) = field_page.contradictions([record])
    assert line == "some `a.urdf` (verdict): a/1 and b/2 overlap by 2 mm at hinge=0.5"
    assert not field_page.passes(record, "as_filed")
    assert not field_page.missed([record])
    deep["depth"] = 0.0
    assert field_page.missed([record]) == [record]


def test_sampled_urdf_leaves_joined_links_out_unless_parents_count(module, tmp_path):
    sampled = module("sampled").sampled
    path = tmp_path / "gate.urdf"
    for at, overlaps in ((0.5, False), (0.3, True)):
        path.write_text(FIELD_URDF.format(at=at))
        found = sampled(path, tmp_path, seconds=60.0)
        assert found.joints == 1
        assert found.states == 1 + 21 + 64
        assert found.as_filed.depth == 0.0
        assert (found.with_parents.depth > 0.0) == overlaps
    path.write_text(FIELD_URDF.format(at=0.5).replace('<box size="0.1 0.1 1"/>', '<mesh filename="no.stl"/>'))
    with pytest.raises(module("sampled").NotLoadableError, match=r"there is no mesh no\.stl"):
        sampled(path, tmp_path, seconds=60.0)


@pytest.mark.parametrize(
    ("path", "group"),
    [
        ("kitchen_assets/item_assets/microwave_chain.xml", "objects"),
        ("assets/objects/drawer.xml", "objects"),
        ("sawyer_xyz/sawyer_door_close.xml", "robots"),
        ("arms/ur5e.urdf", "robots"),
    ],
)
def test_the_field_tells_objects_from_robots(module, path, group):
    assert module("field").group_of(Path(path)) == group


def test_a_large_package_is_thinned_evenly(module):
    chosen = module("field").chosen
    paths = [Path(f"{number:03}") for number in range(132)]
    few = chosen(paths, 60)
    assert len(set(few)) == 60
    assert few[0] == paths[0]
    assert chosen(paths[:5], 60) == paths[:5]
