"""The table of colliders: true numbers for solids whose numbers are known, in memory and read back."""

import builtins
import json

import pytest

import artgen
from artgen import box, part
from artgen.asset import Asset
from artgen.asset.collision import link_parts, made_colliders
from artgen.errors import AssetError
from artgen.validate import colliders as collider_table
from artgen.validate.colliders import compare_colliders, fidelity, steps_per_second
from support.trays import STEEL, tray

pytest.importorskip("coacd")

TRAY = 0.2 * 0.1 * 0.05 - 0.18 * 0.08 * 0.04  # [m^3]
FOOT = 0.02 * 0.02 * 0.01


@artgen.generator
def crate() -> artgen.Body:
    """A box with a closed hollow."""
    return part(box(0.1, 0.1, 0.1) - box(0.08, 0.08, 0.08), "crate", STEEL)


pytestmark = pytest.mark.usefixtures("coacd_cache")


@pytest.fixture(scope="module")
def asset():
    return tray.generate(certify=False)


def export(asset, directory, kind="exact"):
    return Asset.load(asset.export(directory / kind, formats=("mjcf",), collision=kind))


@pytest.mark.parametrize("stored", [False, True])
def test_numbers_of_a_tray(asset, stored, tmp_path):
    rows = compare_colliders(export(asset, tmp_path) if stored else asset, speed=False)
    assert [(row["kind"], row["stored"]) for row in rows] == [
        ("exact", True),
        ("coacd", False),
        ("hull", False),
    ]
    exact, coacd, hull = rows
    assert exact["volume_error"] == pytest.approx(0.0, abs=1e-4)
    assert exact["surface_error"] == pytest.approx(0.0, abs=1e-6)
    assert exact["interior_kept"] == pytest.approx(1.0, abs=1e-4)
    assert (hull["pieces"], hull["vertices"]) == (4, 32)
    solids = TRAY + FOOT + 0.2 * 0.1 * 0.004 + 1e-6
    niche = 0.18 * 0.08 * 0.04
    assert hull["volume_error"] == pytest.approx(niche / solids, rel=1e-3)
    assert hull["links"]["lid"]["volume_error"] == pytest.approx(0.0, abs=1e-4)
    assert hull["surface_error"] == pytest.approx(
        0.04, rel=0.1
    )  # from the middle of the mouth to floor and walls
    around_foot = hull["links"]["tray"]["interior_kept"]  # what is left is below the tray, around its foot
    assert hull["interior_kept"] == pytest.approx(around_foot, abs=1e-9)
    assert 0.1 < around_foot < 0.5
    assert exact["volume_error"] <= coacd["volume_error"] < 0.1 < hull["volume_error"]
    assert coacd["interior_kept"] > 0.98
    assert all(row["steps_per_second"] is None for row in rows)


def test_an_asset_with_other_colliders_is_compared_without_exact_ones(asset, tmp_path):
    for kind, other in (("hull", "coacd"), ("coacd", "hull")):
        rows = compare_colliders(export(asset, tmp_path, kind), speed=False)
        assert [(row["kind"], row["stored"]) for row in rows] == [(kind, True), (other, False)]


def test_details_are_no_solids(asset, tmp_path):
    loaded = export(asset, tmp_path).link("tray")
    assert {part.label: part.material.name for part in link_parts(loaded)} == {
        "tray": "steel",
        "foot": "rubber",
    }
    volumes = {part.label: part.solid.volume() for part in link_parts(loaded)}
    assert volumes == pytest.approx({"tray": TRAY, "foot": FOOT}, rel=1e-4)
    assert [part.label for part in link_parts(asset.link("tray"))] == ["tray", "foot"]
    for kind in ("hull", "coacd"):
        parts = link_parts(export(asset, tmp_path, kind).link("tray"))
        assert sorted(part.label for part in parts) == ["foot", "tray"]


def test_a_closed_hollow_is_no_solid(tmp_path):
    loaded = Asset.load(crate.generate(certify=False).export(tmp_path / "crate", formats=("urdf",)))
    (found,) = link_parts(loaded.links[0])
    assert found.solid.volume() == pytest.approx(0.1**3 - 0.08**3, rel=1e-4)
    (hull,) = made_colliders([found], "hull")
    assert fidelity(found.solid, [hull.convex]).interior_kept == pytest.approx(0.0, abs=1e-3)


def test_meshes_that_do_not_close_are_refused(asset, tmp_path):
    directory = asset.export(tmp_path / "tray", formats=("mjcf",))
    mesh = directory / "meshes" / "lid_lid_steel.obj"
    lines = mesh.read_text().splitlines()
    mesh.write_text("\n".join(lines[:-1]) + "\n")
    with pytest.raises(
        AssetError, match=r"the meshes of link 'lid' with label 'lid' do not close to a solid \(NotManifold\)"
    ):
        compare_colliders(Asset.load(directory))


def test_the_data_of_a_row_is_json(asset):
    row = compare_colliders(asset, speed=False)[2]
    data = json.loads(json.dumps(row))
    assert data["links"]["lid"]["pieces"] == 1
    assert {key: data[key] for key in ("kind", "stored", "pieces", "vertices", "steps_per_second")} == {
        "kind": "hull",
        "stored": False,
        "pieces": 4,
        "vertices": 32,
        "steps_per_second": None,
    }
    assert data == row


def test_steps_are_counted_by_the_clock(asset, monkeypatch, tmp_path):
    mujoco = pytest.importorskip("mujoco")
    monkeypatch.setattr(collider_table, "_TIMED", 0.05)
    made = []
    step = mujoco.mj_step

    def counting(model, data, nstep):
        made.append(nstep)
        step(model, data, nstep=nstep)

    monkeypatch.setattr(mujoco, "mj_step", counting)
    ticks = iter(range(100))
    monkeypatch.setattr(collider_table.time, "perf_counter", lambda: 0.02 * next(ticks))
    # three looks until the clock passes 0.05 s: at 0.02, 0.04 and 0.06, with two batches between
    assert steps_per_second(export(asset, tmp_path)) == pytest.approx(sum(made[1:]) / 0.06)
    assert len(made) == 3
    assert made[0] == 500  # a second at 2 ms


def test_without_mujoco_there_is_no_speed(asset, monkeypatch):
    real = builtins.__import__

    def without(name, *arguments, **keywords):
        if name == "mujoco":
            raise ImportError(name)
        return real(name, *arguments, **keywords)

    monkeypatch.setattr(builtins, "__import__", without)
    assert steps_per_second(asset) is None
