"""Approximate pieces by CoACD, an optional dependency."""

from pathlib import Path

import numpy as np
import pytest

from artgen.colliders.coacd import coacd_pieces
from colliders.covering import block, joined_manifold, pose


def test_an_angle_is_two_or_more_hulls(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    pytest.importorskip("coacd")
    solid = block((0.2, 0.05, 0.05), pose()) + block((0.05, 0.05, 0.2), pose(0.075, 0.0, 0.075))
    mesh = solid.to_mesh64()
    points, triangles = np.array(mesh.vert_properties)[:, :3], np.array(mesh.tri_verts).astype(np.int64)
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "first"))
    pieces = coacd_pieces(points, triangles)
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "second"))
    again = coacd_pieces(points, triangles)
    assert 2 <= len(pieces) <= 4
    assert all(piece.kind != "hull" or len(piece.points) <= 64 for piece in pieces)
    assert joined_manifold(pieces).volume() == pytest.approx(solid.volume(), rel=0.05)
    assert [piece.points.tobytes() for piece in pieces] == [piece.points.tobytes() for piece in again]
    assert capfd.readouterr() == ("", "")


def test_the_threshold_is_limited() -> None:
    with pytest.raises(ValueError, match=r"threshold of CoACD must be within 0\.01 and 1, got 2"):
        coacd_pieces(np.zeros((0, 3)), np.zeros((0, 3), np.int64), 2.0)
