"""What CoACD found is kept by content: found again, never wrong, never in the way."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from artgen import _disk_cache as disk_cache
from artgen.asset.collision import closed_mesh
from artgen.colliders import coacd
from artgen.colliders.coacd import canonical, coacd_pieces
from colliders.covering import block, pose

pytest.importorskip("coacd")


@pytest.fixture
def place(tmp_path, monkeypatch):
    """Keep pieces in an empty directory, and return it."""
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def runs(monkeypatch):
    """Count how often CoACD runs; each time it finds the two tetrahedra of that number."""
    counted = []

    def run(vertices, triangles, settings):
        counted.append(settings)
        corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
        return {"points": np.concatenate([corners * len(counted), corners - 1.0]), "counts": np.array([4, 4])}

    monkeypatch.setattr(coacd, "_run", run)
    return counted


def angle():
    return closed_mesh(block((0.2, 0.05, 0.05), pose()) + block((0.05, 0.05, 0.2), pose(0.075, 0.0, 0.075)))


def bytes_of(pieces):
    return [piece.points.tobytes() for piece in pieces]


def files_in(place):
    return sorted(path for path in place.rglob("*") if path.is_file())


def test_the_same_mesh_is_decomposed_once_in_whatever_order(place, runs):
    vertices, triangles = angle()
    first = coacd_pieces(vertices, triangles)
    order = np.random.default_rng(0).permutation(len(vertices))
    shuffled = np.roll(np.argsort(order)[triangles][::-1], 1, axis=1)
    assert bytes_of(coacd_pieces(vertices[order], shuffled)) == bytes_of(first)
    assert bytes_of(coacd_pieces(vertices + 1e-12, triangles)) == bytes_of(first)
    assert len(runs) == 1
    assert len(files_in(place)) == 1


@pytest.mark.parametrize(
    "change",
    [
        {"threshold": 0.1},
        {"most_pieces": 8},
        {"most_vertices": 16},
        {"scale": 1.001},
        {"version": "0"},
        {"flip": True},
    ],
)
def test_another_mesh_setting_or_version_is_another_entry(place, runs, change, monkeypatch):
    vertices, triangles = angle()
    coacd_pieces(vertices, triangles)
    change = dict(change)
    if "version" in change:
        version = change.pop("version")
        monkeypatch.setattr(coacd, "_version", lambda: version)
    if change.pop("flip", False):
        triangles = triangles[:, ::-1]
    coacd_pieces(vertices * change.pop("scale", 1.0), triangles, **change)
    assert len(runs) == 2
    assert len(files_in(place)) == 2


@pytest.mark.parametrize("damage", ["empty", "cut", "flipped", "pickle", "nonsense", "counts", "nan", "text"])
def test_a_damaged_entry_is_made_anew(place, runs, damage):
    vertices, triangles = angle()
    first = coacd_pieces(vertices, triangles)
    (entry,) = files_in(place)
    content = entry.read_bytes()
    points, counts = np.zeros((8, 3)), np.array([4, 4])
    if damage in ("empty", "cut", "flipped"):
        middle = content.index(np.float64(1.0).tobytes())
        flipped = content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]
        entry.write_bytes({"empty": b"", "cut": content[: len(content) // 2], "flipped": flipped}[damage])
    elif damage == "text":
        entry.write_text("no archive")
    else:
        content = {
            "pickle": {"points": np.array([print, None], object), "counts": counts},
            "nonsense": {"other": points},
            "counts": {"points": points, "counts": np.array([4, 5])},
            "nan": {"points": points * np.nan, "counts": counts},
        }[damage]
        np.savez(entry, **content)
    again = coacd_pieces(vertices, triangles)
    assert len(runs) == 2
    assert bytes_of(again) != bytes_of(first)  # the second finding is not the first
    assert bytes_of(coacd_pieces(vertices, triangles)) == bytes_of(again)
    assert len(runs) == 2
    assert files_in(place) == [entry]


def test_without_a_place_to_write_it_works(tmp_path, runs, monkeypatch):
    (tmp_path / "taken").write_text("mine")
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "taken" / "deeper"))
    assert len(coacd_pieces(*angle())) == 2
    assert len(coacd_pieces(*angle())) == 2
    assert len(runs) == 2
    assert files_in(tmp_path) == [tmp_path / "taken"]


def test_a_write_that_fails_leaves_nothing(place, runs, monkeypatch):
    def full(*arguments, **keywords):
        raise OSError("no space left")

    with monkeypatch.context() as patch:
        patch.setattr(coacd.np, "savez", full)
        coacd_pieces(*angle())
    assert files_in(place) == []
    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full)
        coacd_pieces(*angle())
    assert files_in(place) == []


def test_the_place_is_the_users(monkeypatch, tmp_path):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("ARTGEN_CACHE", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    assert disk_cache.cache_directory() == tmp_path / ".cache" / "artgen"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    assert disk_cache.cache_directory() == tmp_path / ".cache" / "artgen"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "shared"))
    assert disk_cache.cache_directory() == tmp_path / "shared" / "artgen"
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "mine"))
    assert disk_cache.cache_directory() == tmp_path / "mine"

    def homeless():
        raise RuntimeError

    monkeypatch.delenv("ARTGEN_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setattr(Path, "home", homeless)
    assert disk_cache.cache_directory() is None
    assert disk_cache.read("coacd", "key") is None
    disk_cache.write("coacd", "key", b"content")


def test_processes_and_threads_find_the_same_bytes(place):
    program = (
        "import hashlib, sys; sys.path[:0] = sys.argv[1:]\n"
        "from colliders.test_coacd_cache import angle, bytes_of, coacd_pieces\n"
        "print(hashlib.sha256(b''.join(bytes_of(coacd_pieces(*angle())))).hexdigest())"
    )
    found = set()
    for number, threads in enumerate(("1", "2")):
        environment = {
            **os.environ,
            "OMP_NUM_THREADS": threads,
            "PYTHONHASHSEED": threads,
            "ARTGEN_CACHE": str(place / threads),
        }
        command = [sys.executable, "-c", program, str(Path(__file__).parents[1])]
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, timeout=60
        )
        found.add(done.stdout)
        assert len(files_in(place)) == number + 1
    assert len(found) == 1


def test_a_mesh_on_which_coacd_dies_is_tried_otherwise_and_then_refused(place, monkeypatch):
    dying = """
import json, sys, numpy
if json.loads(sys.argv[1])["preprocess_mode"] == "off":
    sys.exit("unexpected")
numpy.savez(sys.stdout.buffer, points=numpy.eye(4)[:, :3], counts=[4])
"""
    with monkeypatch.context() as patch:
        patch.setattr(coacd, "_PROGRAM", dying)
        (piece,) = coacd_pieces(*angle())
        assert piece.volume == pytest.approx(1 / 6)
    with monkeypatch.context() as patch:
        patch.setattr(coacd, "_PROGRAM", "import sys; sys.exit('no such luck')")
        with pytest.raises(ValueError, match="CoACD fails on a mesh of 34 triangles: no such luck"):
            coacd_pieces(*angle(), threshold=0.2)
        patch.setattr(coacd, "_PROGRAM", "import time; time.sleep(60)")
        patch.setattr(coacd, "_MOST_SECONDS", 0.2)
        with pytest.raises(ValueError, match="of 34 triangles: it took more than 0 s"):
            coacd_pieces(*angle(), threshold=0.2)
    assert len(files_in(place)) == 1


def test_a_canonical_mesh_is_the_same_solid():
    vertices, triangles = angle()
    points, corners = canonical(vertices, triangles)
    assert (np.diff(points[:, 0]) >= 0.0).all()

    def volume(points, corners):
        a, b, c = points[corners].transpose(1, 0, 2)
        return np.sum(a * np.cross(b, c)) / 6.0

    assert volume(points, corners) == pytest.approx(volume(vertices, triangles))
    assert {tuple(point) for point in points} == {tuple(point) for point in np.round(vertices, 9)}
