"""Valid joint states of an asset that artgen exported. This file needs numpy alone; copy it where you like.

    states = ValidStates.read("door_7.xml")    # or .urdf, .usda, .glb, .sdf, asset.json
    q = states.sample(1000, seed=0)            # shape (1000, dof), all valid
    states.blocked(q)                          # shape (1000, joints): joints at a forbidden position
    q = states.project(q)                      # the same states, blocked joints at an allowed position

A state has the positions of `states.dofs` [rad or m], the joints that neither follow another nor are locked.
A joint may need a condition on others to leave 0; it is free up to `beyond` and farther open than `until`.
"""

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

KEY = "artgen_states"
_TEXT = f"""{KEY}" data="([^"]*)"|<!-- {KEY} (.*) -->|string {KEY} = '(.*)'"""  # in the text formats
Array = NDArray[np.float64]


class ValidStates:
    """The valid joint states of an asset: limits, couplings and dependencies."""

    def __init__(self, joints: list[dict[str, Any]], outputs: Sequence[dict[str, Any]] = ()) -> None:
        """Take the joints of the files: dictionaries with name, limits, follows and needs."""
        self.joints, self.outputs = tuple(rows := {str(each["name"]): each for each in joints}), outputs
        limits = {each["name"]: each["limits"] or (-np.inf, np.inf) for each in joints if not each["follows"]}
        self.dofs = tuple(name for name, (low, high) in limits.items() if low != high)
        ranges = np.array([limits[name] for name in self.dofs], float).reshape(-1, 2)
        ranges.setflags(write=False)
        self.lower, self.upper = ranges.T
        self._needs = {name: row["needs"] for name, row in rows.items() if row.get("needs")}
        self._laws = {}  # of each joint: degree of freedom (-1: none), ratio, offset and curve
        for name in rows:
            leader, ratio, offset, curve = name, 1.0, 0.0, None
            while law := rows[leader]["follows"]:
                leader, ratio, offset = law["leader"], ratio * law["ratio"], offset + ratio * law["offset"]
                curve = law.get("curve")  # only before a joint that follows none
            free = leader in self.dofs
            fixed = offset if free else offset + ratio * curve_at(curve, limits[leader][0])
            self._laws[name] = (self.dofs.index(leader) if free else -1, ratio, fixed, curve)
        self._order: list[str] = []  # joints with dependencies, those first that others depend on
        for name in self._needs:
            self._enter(name, ())

    @classmethod
    def read(cls, path: str | Path) -> "ValidStates":
        """Read an exported file; ValueError if it has no states."""
        if not (found := _data(Path(path))):
            raise ValueError(f"{path} has no {KEY}: artgen exports it to URDF, MJCF, USD, GLB and SDF")
        data = json.loads(found) if isinstance(found, str) else found
        return cls(data["joints"], data.get("outputs", ()))

    def positions(self, q: ArrayLike) -> Array:
        """Return the positions of all joints, shape (..., joints), for states of shape (..., dof)."""
        found = self._found(np.moveaxis(np.asarray(q, float), -1, 0), self.joints)
        return np.stack([np.broadcast_to(each, np.shape(q)[:-1]) for each in found.values()], axis=-1)

    def blocked(self, q: ArrayLike) -> NDArray[np.bool_]:
        """Tell which joints are at a position that their dependency forbids, shape (..., joints)."""
        columns = np.moveaxis(np.asarray(q, float), -1, 0)
        no = np.zeros(columns.shape[1:], bool)
        rows = [no | self._forbidden(columns, name) if name in self._needs else no for name in self.joints]
        return np.moveaxis(np.array([no, *rows])[1:], 0, -1)

    def project(self, q: ArrayLike) -> Array:
        """Return valid states: clipped to the limits, blocked joints at their nearest allowed position."""
        columns = np.moveaxis(np.clip(np.asarray(q, float), self.lower, self.upper), -1, 0).copy()
        for name in self._order * len(self._order):  # a joint moves once; others may be blocked then
            self._free(columns, name)
        return np.moveaxis(columns, 0, -1)

    def sample(self, count: int, seed: int = 0) -> Array:
        """Draw valid states, shape (count, dof): each joint uniformly over what the others allow."""
        random = np.random.default_rng(seed).random((len(self.dofs), count))
        low, high = np.maximum(self.lower, -np.pi)[:, None], np.minimum(self.upper, np.pi)[:, None]
        q = low + random * (high - low)
        for name in (each for each in self._order if each in self.dofs):  # drawn again near 0 if blocked
            at, near = self.dofs.index(name), self._needs[name].get("beyond") or 0.0
            start, end = np.clip((-near, near), low[at], high[at])
            q[at] = np.where(self._forbidden(q, name), start + random[at] * (end - start), q[at])
        return self.project(q.T)

    def _enter(self, name: str, above: tuple[str, ...]) -> None:
        if name in self._needs and name not in (*self._order, *above):
            needed = [(each, self._laws[each][0]) for each in _named(self._needs[name]["condition"])]
            for joint in (each for other, at in needed if at >= 0 for each in (other, self.dofs[at])):
                self._enter(joint, (*above, name))
            self._order.append(name)

    def _found(self, columns: Array, names: tuple[str, ...]) -> dict[str, Array]:
        laws = ((name, self._laws[name]) for name in names)
        return {
            name: ratio * curve_at(curve, columns[at]) + rest if at >= 0 else np.array(rest)
            for name, (at, ratio, rest, curve) in laws
        }

    def _forbidden(self, columns: Array, name: str) -> Any:
        needs = self._needs[name]
        found = self._found(columns, (name, *_named(needs["condition"])))
        distance, until = np.abs(found[name]), needs.get("until")
        free = (distance <= max(needs.get("beyond") or 0.0, 1e-9)) | holds(found, needs["condition"])
        return ~(free if until is None else free | (distance >= until))

    def _free(self, columns: Array, name: str) -> None:
        needs, shut = self._needs[name], self._forbidden(columns, name)
        at, ratio, rest, _ = self._laws[name]
        if at < 0 or not np.any(shut):
            return
        position, near = ratio * columns[at] + rest, (needs.get("beyond") or 0.0) * (1 - 1e-9)
        target, low, high = np.clip(position, -near, near), self.lower[at], self.upper[at]
        if needs.get("until") is not None:
            far = np.copysign(needs["until"] * (1 + 1e-9), position)
            inside = (low <= (far - rest) / ratio) & ((far - rest) / ratio <= high)
            target = np.where(inside & (abs(far - position) < abs(target - position)), far, target)
        columns[at] = np.where(shut, np.clip((target - rest) / ratio, low, high), columns[at])


def curve_at(curve: dict[str, Any] | None, position: Any) -> Any:
    """Return positions of a joint of a closed chain at those of its input; without a curve, the same."""
    if curve is None:
        return position
    (low, high), terms = curve["range"], np.asarray(curve["terms"])  # a Chebyshev series in the range
    turns = np.floor((position - low) / (2.0 * np.pi)) if curve["turns"] else 0.0
    place = (2.0 * (position - 2.0 * np.pi * turns) - low - high) / (high - low)
    return np.polynomial.chebyshev.chebval(place, terms) + 2.0 * turns * np.sum(terms[1::2])


def holds(found: dict[str, Array], condition: dict[str, Any]) -> Any:
    """Tell where a condition holds, for positions of joints by name."""
    rules = {"above": np.greater, "below": np.less, "all": np.logical_and, "any": np.logical_or}
    rule, terms = rules[condition["kind"]], [holds(found, each) for each in condition.get("terms") or ()]
    return rule.reduce(terms) if terms else rule(found[condition["joint"]], condition["value"])


def _named(condition: dict[str, Any]) -> list[str]:
    return [name for term in condition.get("terms") or () for name in _named(term)] or [condition["joint"]]


def _data(path: Path) -> Any:
    text, glb = path.read_bytes(), path.suffix == ".glb"
    if glb or path.suffix == ".json":
        found = json.loads(text[20 : 20 + int.from_bytes(text[12:16], "little")] if glb else text)
        return found["asset"].get("extras", {}).get(KEY) if glb else found
    return (match := re.search(_TEXT, text.decode())) and match[match.lastindex or 0].replace("&quot;", '"')
