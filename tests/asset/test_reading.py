"""Print stays readable on mirrored products."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen import Graph, X, Y, Z, box, detail, details, extrude, material, part, polygon, text, weld

_FLAG = [(0.0, 0.0), (0.03, 0.0), (0.03, 0.01), (0.01, 0.01), (0.01, 0.05), (0.0, 0.05)]


def _sign(reads):
    """A board with an L on its front, right of the middle."""
    letter = extrude(polygon(_FLAG), 0.002, axis=-Y).at(0.2, -0.02, 0.5)
    return weld(
        part(box(0.6, 0.04, 1.0).at(z=0.5), "board", material("oak")),
        detail(letter, "print", material("brass"), reads=reads),
    )


def _print(body):
    (surface,) = [
        surface for surface in Graph(body).evaluate({}).value.link.surfaces if surface.label == "print"
    ]
    return surface.mesh.vertices


def _turning(points):
    """Which way round the L is: the sign of its third moment about the reading direction and upwards."""
    x, z = (points - 0.5 * (points.min(axis=0) + points.max(axis=0)))[:, [0, 2]].T
    return np.sign((x * z).mean())


@pytest.mark.parametrize("normal", [X, Y])
def test_print_stays_readable_in_the_mirrored_place(normal):
    before, after = _print(_sign(X)), _print(_sign(X).mirror(normal))
    plain = _print(_sign(None).mirror(normal))
    assert np.allclose(after.min(axis=0), plain.min(axis=0), atol=1e-12)
    assert np.allclose(after.max(axis=0), plain.max(axis=0), atol=1e-12)
    if normal is X:  # seen from the front, as before
        assert _turning(after) == _turning(before)
        assert _turning(plain) == -_turning(before)
    else:  # on the back now, where the reader's right is the other way
        assert _turning(after) == -_turning(before)
        assert _turning(plain) == _turning(before)


def test_twice_mirrored_print_is_as_it_was():
    before, after = _print(_sign(X)), _print(_sign(X).mirror(X).mirror(X))
    order = [np.lexsort(np.round(points, 9).T) for points in (before, after)]
    assert np.allclose(before[order[0]], after[order[1]], atol=1e-12)


@given(st.floats(-3.0, 3.0), st.sampled_from("XYZ"))
def test_rotations_carry_print_along(angle, name):
    axis, sense = {"X": (X, 1.0), "Y": (Y, -1.0), "Z": (Z, -1.0)}[name]
    turned = _print(_sign(X).rotate(axis, angle).mirror(X))
    again = _print(_sign(X).mirror(X).rotate(axis, sense * angle))
    order = [np.lexsort(np.round(points, 7).T) for points in (turned, again)]
    assert np.allclose(turned[order[0]], again[order[1]], atol=1e-6)


def _surfaces(body):
    return {surface.name: surface.mesh for surface in Graph(body).evaluate({}).value.link.surfaces}


def _panel(*prints):
    return weld(part(box(0.3, 0.02, 0.1).at(0.0, 0.01), "board", material("oak")), *prints)


def _moved_only(before, after):
    """Tell whether print was moved along X and not mirrored."""
    rows = [np.round(mesh.vertices - mesh.vertices.min(axis=0), 7) for mesh in (before, after)]
    return all(
        np.array_equal(*(np.unique(each[:, axes], axis=0) for each in rows))
        for axes in ([0, 1], [1, 2], [0, 2])
    )


@pytest.mark.parametrize("make", [details.printed, details.raised, details.engraved])
def test_printed_words_stay_readable(make):
    word = make(text("Ebb 27", 0.02, align="left"), (0.02, 0.0, 0.0), material=material("brass"))
    before, after = _surfaces(_panel(word)), _surfaces(_panel(word).mirror(X))
    (name,) = [each for each in before if each.startswith("print")]
    assert _moved_only(before[name], after[name])
    # in the place of its mirror image: it ended at the reader's right, now it starts at the left
    assert after[name].vertices[:, 0].max() == pytest.approx(-before[name].vertices[:, 0].min(), abs=1e-9)


def test_a_scale_stays_about_its_knob():
    scale = details.dial_scale(0.02, 11, major_every=5, numbers=("0", "50", "100"))
    body = _panel(details.printed(scale, (0.05, 0.0, 0.0), material=material("brass")))
    before, after = (_surfaces(each)["print_brass"].vertices[:, 0] for each in (body, body.mirror(X)))
    assert after.min() + 0.05 == pytest.approx(before.min() - 0.05, abs=1e-9)


def test_a_display_stays_whole():
    body = _panel(details.display("12:30", 0.06, 0.02, at=(0.05, 0.0, 0.0), color="amber"))
    before, after = _surfaces(body), _surfaces(body.mirror(X))
    assert len([name for name in before if name.startswith("display")]) == 3
    for name, mesh in before.items():
        if name.startswith("display"):
            assert after[name].vertices[:, 0].min() == pytest.approx(
                mesh.vertices[:, 0].min() - 0.1, abs=1e-9
            )
