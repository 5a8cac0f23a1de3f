"""A small set of images for many tests."""

from pathlib import Path

import pytest

from artgen.dataset import generate_many
from artgen.errors import RenderError
from artgen.images import ImagePlan
from artgen.view import gl


@pytest.fixture(scope="session")
def image_plan() -> ImagePlan:
    return ImagePlan(
        ("plier", "drawer"),
        5,
        certify=False,
        images=2,
        size=192,
        random=("backdrop", "floor", "light"),
        depth=True,
        normals=True,
        samples=1,
        texture_size=0,
        split=(0.4, 0.3, 0.3),
    )


@pytest.fixture(scope="session")
def opengl() -> None:
    """Skip the tests if pictures cannot be drawn."""
    pytest.importorskip("mujoco", reason="needs MuJoCo: artgen[images]")
    pytest.importorskip("pycocotools", reason="needs pycocotools: artgen[images]")
    try:
        gl.available()
    except RenderError as error:
        pytest.skip(f"needs OpenGL: {error}")


@pytest.fixture(scope="session")
def image_set(tmp_path_factory: pytest.TempPathFactory, image_plan: ImagePlan, opengl: None) -> Path:
    """Ten pictures of three pliers and two drawers, by one process."""
    folder = tmp_path_factory.mktemp("images") / "set"
    summary = generate_many(image_plan, folder, jobs=1)
    assert (summary.made, summary.existing, summary.failed) == (5, 0, ())
    return folder
