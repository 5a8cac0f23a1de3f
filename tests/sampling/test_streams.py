"""Random streams: one for each name, the same everywhere."""

import os
import subprocess
import sys

from hypothesis import given
from hypothesis import strategies as st

from artgen.sampling import stream

NAMES = st.text(st.characters(codec="utf-8"), max_size=30)


@given(seed=st.integers(0, 2**70), name=NAMES, attempt=st.integers(0, 1000))
def test_a_stream_depends_on_seed_name_and_attempt_alone(seed, name, attempt):
    assert stream(seed, name, attempt).random(3).tolist() == stream(seed, name, attempt).random(3).tolist()


@given(seed=st.integers(0, 2**40), names=st.lists(NAMES, min_size=2, max_size=2, unique=True))
def test_different_names_give_different_draws(seed, names):
    assert stream(seed, names[0]).random() != stream(seed, names[1]).random()


@given(seeds=st.lists(st.integers(0, 2**40), min_size=2, max_size=2, unique=True))
def test_different_seeds_and_attempts_give_different_draws(seeds):
    a, b = seeds
    assert stream(a, "door/width").random() != stream(b, "door/width").random()
    assert stream(a, "door/width", 0).random() != stream(a, "door/width", 1).random()
    assert stream(a, "door/width", b).random() != stream(b, "door/width", a).random()


def test_known_draws_stay_what_they_are():
    """A change here changes every asset that was ever generated."""
    assert stream(7, "door/width").bit_generator.random_raw() == 7696212133433702156
    assert (
        stream(2**40, "door/handle.lever_handle.length", 3).bit_generator.random_raw() == 6761791839715064434
    )


def test_neighboring_names_are_not_correlated():
    draws = [(stream(seed, "a/x").random(), stream(seed, "a/y").random()) for seed in range(400)]
    mean = [sum(column) / 400 for column in zip(*draws, strict=True)]
    covariance = sum((x - mean[0]) * (y - mean[1]) for x, y in draws) / 400
    assert all(abs(value - 0.5) < 0.05 for value in mean)
    assert abs(covariance) * 12 < 0.15


def test_the_hash_seed_of_python_does_not_matter():
    code = "from artgen.sampling import stream; print(stream(7, 'door/width').random(4).tolist())"
    outputs = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for seed in ("0", "1", "12345")
    }
    assert len(outputs) == 1
