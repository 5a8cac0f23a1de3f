"""Values of the outputs of many equal products over time. This file needs `valid_states.py` and numpy alone.

    controller = Controller(ValidStates.read("lamp_3.xml"), worlds=64)
    q = np.zeros((64, len(controller.dofs)))   # positions by `dofs` [rad or m]
    controller.step(q, 0.01)["bulb"]           # shape (64,), from 0 for off to 1

A signal rises when it passes from below a half to above it. In the first step after a reset no signal rises.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from artgen.asset.valid_states import ValidStates, holds

Array = NDArray[np.float64]
Data = dict[str, Any]
_ON, _OFF = 2.0 / 3.0, 1.0 / 3.0  # levels at which a pressed control switches on and off


class Controller:
    """The electronics, taps and burners of products: outputs as functions of the motion of joints."""

    def __init__(self, states: ValidStates, worlds: int = 1) -> None:
        """Take the states of an asset or a file, with their outputs, for a number of equal products."""
        self._states, self.worlds, self.dofs = states, worlds, states.dofs
        self.outputs: dict[str, Data] = {row["name"]: row for row in states.outputs}
        self._order: list[tuple[Data, list[int], int]] = []  # signals after those that they read
        self._last = {name: self._enter(row["signal"]) for name, row in self.outputs.items()}
        self.reset()

    def reset(self, which: ArrayLike | None = None) -> None:
        """Let products be as at delivery: all of them, or those of a mask, shape (worlds,)."""
        if which is None:
            self._memory: list[Any] = [None] * len(self._order)
            self._fresh = np.ones(self.worlds, bool)
        else:
            self._fresh = self._fresh | np.asarray(which, bool)

    def step(self, q: ArrayLike, seconds: float) -> dict[str, Array]:
        """Return the values of all outputs by name, shape (worlds,), after a step of time.

        Args:
            q: Positions by `dofs`, shape (worlds, dof), or (dof,) of one product [rad or m].
            seconds: Time since the last step [s].

        Raises:
            ValueError: The positions have another shape.
        """
        rows, shape = np.asarray(q, float), (self.worlds, len(self.dofs))
        if rows.shape not in (shape, shape[1:]):
            raise ValueError(f"positions have the shape {shape}, by {', '.join(self.dofs)}; got {rows.shape}")
        rows = np.broadcast_to(rows, shape)
        found = dict(zip(self._states.joints, self._states.positions(rows).T, strict=True))
        values: list[Array] = []
        for number, (signal, terms, unless) in enumerate(self._order):
            read = np.array([values[each] for each in terms]).reshape(len(terms), self.worlds)
            before = self._memory[number]
            if before is None:
                before = np.zeros((len(terms) + 1, self.worlds))
            before = np.where(self._fresh, 0.0, before)
            rises = (read > 0.5) & (before[1:] < 0.5) & ~self._fresh
            value = _RULES[signal["kind"]](signal, found, read, rises, before[0], seconds)
            value = value if unless < 0 else np.where(values[unless] > 0.5, 0.0, value)
            self._memory[number] = np.concatenate([value[None], read])
            values.append(np.where(value > 0.0, 1.0, 0.0) if signal["kind"] == "timer" else value)
        self._fresh = np.zeros(self.worlds, bool)
        return {name: values[number] for name, number in self._last.items()}

    def _enter(self, signal: Data) -> int:
        """Add a signal after those that it reads; return its place."""
        terms = [self._enter(each) for each in signal.get("terms") or ()]
        unless = self._enter(signal["unless"]) if signal.get("unless") else -1
        self._order.append((signal, terms, unless))
        return len(self._order) - 1


def _level(signal: Data, found: dict[str, Array], *_: Any) -> Array:
    """Return the share of the way of a joint from one end to the other."""
    start, end = signal["ends"]
    return np.asarray(np.clip((found[signal["joint"]] - start) / (end - start), 0.0, 1.0)) + 0.0


def _pressed(signal: Data, found: dict[str, Array], _: Array, __: Array, before: Array, ___: float) -> Array:
    level = _level(signal, found)
    return np.where(before > 0.5, level > _OFF, level > _ON) * 1.0


def _toggle(_: Any, __: Any, ___: Array, rises: Array, before: Array, ____: float) -> Array:
    return np.where(rises[0], 1.0 - before, before)


def _timer(signal: Data, _: Any, __: Array, rises: Array, left: Array, seconds: float) -> Array:
    """Return the time that is left [s]."""
    return np.where(rises[0], signal["seconds"], np.maximum(left - seconds, 0.0))


def _latest(signal: Data, _: Any, __: Array, rises: Array, before: Array, ___: float) -> Array:
    result = before
    for value, rise in zip(signal["values"], rises, strict=True):
        result = np.where(rise, value, result)
    return result


_RULES: dict[str, Callable[..., Array]] = {
    "level": _level,
    "pressed": _pressed,
    "where": lambda signal, found, *_: holds(found, signal["condition"]) * 1.0,
    "toggle": _toggle,
    "timer": _timer,
    "latest": _latest,
    "all": lambda _, __, read, *___: read.min(axis=0),
    "any": lambda _, __, read, *___: read.max(axis=0),
    "not": lambda _, __, read, *___: 1.0 - read[0],
    "scaled": lambda signal, _, read, *__: signal["factor"] * read[0],
}
"""Value of each kind of signal, from its data, positions of joints, terms, rises, value before, and time."""
