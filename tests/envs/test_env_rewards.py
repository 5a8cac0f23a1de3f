"""Rewards: success is worth more than all earlier rewards, and progress never costs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.envs.env import BONUS, DENSE, dense, penalty, reward

STILL, FULL = np.zeros(7), np.ones(7)


def test_success_is_worth_more_than_the_best_episode_without_it():
    steps = 160
    best = sum(
        reward(dense([1.0, 1.0], [True, True], 0.0), STILL, steps, success=False) for _ in range(steps)
    )
    assert best == pytest.approx(DENSE)
    worst = sum(reward(0.0, FULL, steps, success=False) for _ in range(steps))
    assert worst < 0.0
    assert worst + BONUS > best
    assert reward(0.0, STILL, steps, success=True) == BONUS


@given(st.floats(0.0, 2.0), st.floats(0.01, 0.5))
def test_nearer_and_further_along_is_better(distance, step):
    assert dense([0.2], [False], distance) > dense([0.2], [False], distance + step)
    assert dense([0.2 + step], [False], distance) > dense([0.2], [False], distance)


@given(st.floats(0.0, 1.0), st.floats(0.0, 2.0), st.floats(0.0, 2.0))
def test_a_stage_that_is_done_is_never_worth_less(share, near, far):
    before = dense([share, 0.0], [False, False], near)
    after = dense([share, 0.0], [True, False], far)  # the next handle may be far away
    assert after >= before
    assert dense([share, 1.0], [False, False], near) == before, "the second stage counts after the first"


def test_actions_cost_little_and_more_the_larger_they_are():
    assert penalty(STILL) == 0.0
    assert 0.0 < penalty(0.5 * FULL) < penalty(FULL) <= 0.05
