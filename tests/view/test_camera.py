"""Cameras: what they frame, and where points appear."""

import math

import numpy as np
import pytest

from artgen.catalog import find
from artgen.errors import AssetError, ParameterError
from artgen.view import VIEWS, Camera, View
from artgen.view.camera import camera_of


@pytest.mark.parametrize("seed", range(30))
def test_a_view_frames_points_tightly(seed) -> None:
    stream = np.random.default_rng(seed)
    points = stream.normal(size=(50, 3)) * stream.uniform(0.05, 2.0, 3) + stream.uniform(-3, 3, 3)
    view = View(
        stream.uniform(-4, 4),
        stream.uniform(-1.5, math.pi / 2),
        stream.uniform(0.1, 1.2),
        margin=stream.uniform(0, 0.4),
    )
    size = (300, 200) if seed % 2 else (200, 300)
    camera = view.camera(points, size[0] / size[1])
    places = camera.pixels(points, size) / size * 2.0 - 1.0
    share = np.abs(places)
    # the picture minus its margin is filled in one direction, and nothing sticks out
    assert share.max() == pytest.approx(1.0 - view.margin, abs=1e-6)
    np.testing.assert_allclose(places.max(axis=0), -places.min(axis=0), atol=1e-6)  # centered in the other
    assert (camera.axes()[2] @ (points - camera.position).T > 0.0).all()


def test_rays_run_through_the_pixels_that_points_appear_in() -> None:
    camera, size = Camera((1.0, -3.0, 2.0), (0.2, 0.1, 0.4), 0.7), (64, 48)
    rays = camera.rays(size)
    assert rays.shape == (48, 64, 3)
    np.testing.assert_allclose(rays @ camera.axes()[2], 1.0)
    points = camera.position + 2.5 * rays[10, [3, 60]]
    np.testing.assert_allclose(camera.pixels(points, size), [[3.5, 10.5], [60.5, 10.5]], atol=1e-9)


@pytest.mark.parametrize(
    ("name", "direction"), [("front", (0, -1, 0)), ("side", (1, 0, 0)), ("top", (0, 0, 1))]
)
def test_named_views_stand_where_they_say(name, direction, red_cabinet) -> None:
    points = {"body": np.array([[-1.0, -1, -1], [1, 1, 1]])}
    camera = camera_of(name, red_cabinet, points, 1.0)
    away = np.subtract(camera.position, camera.target)
    assert away @ direction > 0.98 * np.linalg.norm(away)
    right = camera.axes()[0]
    assert right[0] > 0.99 or name == "side"
    assert abs(right[2]) < 1e-9


def test_a_close_up_frames_one_link(red_cabinet) -> None:
    points = {"body": np.array([[-1.0, -1, -1], [1, 1, 1]]), "door": np.array([[0.0, 0, 0], [0.1, 0, 0.1]])}
    near = camera_of("close-up:door", red_cabinet, points, 1.0)
    far = camera_of(None, red_cabinet, points, 1.0)
    assert math.dist(near.position, near.target) < 0.2 * math.dist(far.position, far.target)


def test_a_flat_asset_is_seen_from_higher(red_cabinet) -> None:
    laptop = find("laptop").generate(1, certify=False)
    points = {link.name: link.bounds() for link in laptop.links}
    x, y, z = np.negative(camera_of(None, laptop, points, 1.0).axes()[2])
    assert math.atan2(z, math.hypot(x, y)) > 0.7
    points = {link.name: link.bounds() for link in red_cabinet.links}
    x, y, z = np.negative(camera_of(None, red_cabinet, points, 1.0).axes()[2])
    assert math.atan2(z, math.hypot(x, y)) < 0.45


def test_unknown_views_and_links_are_named(red_cabinet) -> None:
    points = {"body": np.zeros((1, 3))}
    with pytest.raises(ParameterError, match=r"there is no view 'fron'. Did you mean 'front'?"):
        camera_of("fron", red_cabinet, points, 1.0)
    with pytest.raises(AssetError, match=r"has no link 'dor'. Did you mean 'door'?"):
        camera_of("close-up:dor", red_cabinet, points, 1.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Camera((0, 0, math.nan)), "position .* must be 3 finite numbers"),
        (lambda: Camera((0, 0)), "position .* must be 3 finite numbers"),
        (lambda: Camera((0, 0, 0), (0, 0, 0)), "position and target are both"),
        (lambda: Camera((0, -1, 0), (0, 0, 0), 3.2), "field_of_view 3.2 must be in 0.01..2.5"),
        (lambda: View(elevation=2.0), "elevation 2.0 must be in -pi/2..pi/2"),
        (lambda: View(math.inf), "azimuth inf must be a finite number"),
        (lambda: View("front"), "azimuth 'front' must be a finite number"),
        (lambda: Camera("front"), "position 'front' must be 3 finite numbers"),
        (lambda: Camera((0, -1, 0), field_of_view="wide"), "field_of_view 'wide' must be in 0.01..2.5"),
        (lambda: View(margin=1.0), "margin 1.0 must be in 0..0.9"),
    ],
)
def test_wrong_fields_are_refused(make, message) -> None:
    with pytest.raises(ParameterError, match=message):
        make()


def test_every_view_has_an_upright_camera() -> None:
    points = np.random.default_rng(0).normal(size=(20, 3))
    for view in VIEWS.values():
        axes = view.camera(points).axes()
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
        assert axes[1][2] > -1e-9
