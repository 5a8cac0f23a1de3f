"""Rewards: near the handle, far along the joints, gentle, and above all done.

In each step, every stage of a task gives up to its share of 1: a part for how near the tip is to what it has
to move, a part for how far that has moved. A stage that is done gives its share in full, one that has not
begun nothing, so that going on to the next stage never costs. Scaled so that all steps of an episode give at
most `DENSE` together, the bonus for success is worth more than to stay just before it until the time is over.
"""

import math
from collections.abc import Sequence

from artgen._arrays import Array

DENSE = 10.0
"""Most that all steps of an episode give without the bonus."""

BONUS = 20.0
"""What success gives, once."""

NEAR, ALONG = 0.3, 0.7  # shares of being near and of progress, in that of a stage
STEEPNESS = 5.0  # at 0.2 m a quarter of the reward for being near is left [1/m]
ACTION = 0.05  # what an action of 1 in all directions costs, as a share of all stages


def dense(progress: Sequence[float], done: Sequence[bool], distance: float) -> float:
    """Return what a state is worth, 0-1.

    Args:
        progress: Of each stage, 0-1.
        done: Whether each stage is reached. The first that is not is the one that the robot is at.
        distance: From the tip to what the robot has to move in that stage [m].
    """
    total = 0.0
    for share, reached in zip(progress, done, strict=True):
        if not reached:
            total += NEAR * (1.0 - math.tanh(STEEPNESS * distance)) + ALONG * share
            break
        total += 1.0
    return total / len(progress)


def penalty(action: Array) -> float:
    """Return what an action costs, 0-0.05."""
    return ACTION * float(action @ action) / len(action)


def reward(state: float, action: Array, steps: int, *, success: bool) -> float:
    """Return the reward of a step.

    Args:
        state: What the state after it is worth: `dense` of it.
        action: What was done, shape (7,).
        steps: How many steps an episode has.
        success: Whether this step is the first at which the task is done.
    """
    return DENSE / steps * (state - penalty(action)) + (BONUS if success else 0.0)
