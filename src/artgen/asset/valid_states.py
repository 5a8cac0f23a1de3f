"""Valid joint states of an asset that artgen exported. This file needs numpy alone; copy it where you like.

    states = ValidStates.read("door_7.xml")    # or .urdf, .usda, .glb, .sdf, asset.json
    q = states.sample(1000, seed=0)            # shape (1000, dof), all valid
    states.blocked(q)                          # shape (1000, joints): joints at a forbidden position
    q = states.project(q)                      # the same states, blocked joints at an allowed position

A state has the position of every degree of freedom, in the order of `states.dofs` [rad or m]: of the joints
that neither follow another joint nor are locked. A joint with a dependency may leave its closed position, 0,
only while a condition on other joints holds; it is free up to `beyond` and farther open than `until`.
"""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

KEY = "artgen_states"
_PLACES = {  # where the text formats have the states
    ".xml": f'{KEY}" data="([^"]*)"',
    ".urdf": f"<!-- {KEY} (.*) -->",
    ".sdf": f"<!-- {KEY} (.*) -->",
    ".usda": f"string {KEY} = '(.*)'",
}
Array = NDArray[np.float64]


class ValidStates:
    """The valid joint states of an asset: limits, couplings and dependencies."""

    def __init__(self, joints: list[dict[str, Any]]) -> None:
        """Take the joints of the files: dictionaries with name, limits, follows and needs."""
        rows = {str(joint["name"]): joint for joint in joints}
        self.joints = tuple(rows)
        leaders = [joint for joint in joints if not joint["follows"]]
        limits = {joint["name"]: joint["limits"] or (-np.inf, np.inf) for joint in leaders}
        self.dofs = tuple(name for name, (low, high) in limits.items() if low != high)
        ranges = np.array([limits[name] for name in self.dofs], float).reshape(-1, 2)
        ranges.setflags(write=False)
        self.lower, self.upper = ranges.T
        self._needs = {name: joint["needs"] for name, joint in rows.items() if joint.get("needs")}
        self._laws = {}  # of each joint: degree of freedom (-1: none), ratio and offset
        self._curves: dict[str, dict[str, Any]] = {}  # of joints of closed chains, in place of the position
        for name in rows:
            leader, ratio, offset = name, 1.0, 0.0
            while law := rows[leader]["follows"]:
                leader, ratio, offset = law["leader"], ratio * law["ratio"], offset + ratio * law["offset"]
                if law.get("curve"):  # it leads to a degree of freedom
                    arrays = {key: np.array(law["curve"][key], float) for key in ("positions", "slopes")}
                    self._curves[name] = {**law["curve"], **arrays}
            free = leader in self.dofs
            fixed = offset
            if not free:
                held = limits[leader][0]
                fixed += ratio * float(curve_at(self._curves[name], held) if name in self._curves else held)
            self._laws[name] = (self.dofs.index(leader) if free else -1, ratio, fixed)
        self._order: list[str] = []  # joints with dependencies, those first that others depend on
        for name in self._needs:
            self._enter(name, ())

    @classmethod
    def read(cls, path: str | Path) -> "ValidStates":
        """Read an exported file; ValueError if it has no states."""
        found = _data(Path(path))
        if not found:
            raise ValueError(
                f"{path} has no {KEY}: export the asset with artgen to URDF, MJCF, USD, GLB or SDFormat"
            )
        return cls((json.loads(found) if isinstance(found, str) else found)["joints"])

    def positions(self, q: ArrayLike) -> Array:
        """Return the positions of all joints, shape (..., joints), for states of shape (..., dof)."""
        found = self._found(np.moveaxis(np.asarray(q, float), -1, 0), self.joints)
        return np.stack([np.broadcast_to(each, np.shape(q)[:-1]) for each in found.values()], axis=-1)

    def blocked(self, q: ArrayLike) -> NDArray[np.bool_]:
        """Tell which joints are at a position that their dependency forbids, shape (..., joints)."""
        columns = np.moveaxis(np.asarray(q, float), -1, 0)
        result = np.zeros((*columns.shape[1:], len(self.joints)), bool)
        for name in self._needs:
            result[..., self.joints.index(name)] = self._forbidden(columns, name)
        return result

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
        for name in self._order:
            if name in self.dofs:  # a blocked joint is drawn again, from its positions near 0
                at, near = self.dofs.index(name), self._needs[name].get("beyond") or 0.0
                start, end = np.clip((-near, near), low[at], high[at])
                q[at] = np.where(self._forbidden(q, name), start + random[at] * (end - start), q[at])
        return self.project(q.T)

    def _enter(self, name: str, above: tuple[str, ...]) -> None:
        if name in self._needs and name not in (*self._order, *above):
            for other in _named(self._needs[name]["condition"]):
                at = self._laws[other][0]
                for joint in (other, self.dofs[at]) if at >= 0 else ():
                    self._enter(joint, (*above, name))
            self._order.append(name)

    def _found(self, columns: Array, names: tuple[str, ...]) -> dict[str, Array]:
        found: dict[str, Array] = {}
        for name in names:
            at, ratio, rest = self._laws[name]
            if at < 0:
                found[name] = np.array(rest)
            elif name in self._curves:
                found[name] = ratio * curve_at(self._curves[name], columns[at]) + rest
            else:
                found[name] = ratio * columns[at] + rest
        return found

    def _forbidden(self, columns: Array, name: str) -> Any:
        needs = self._needs[name]
        found = self._found(columns, (name, *_named(needs["condition"])))
        distance, until = np.abs(found[name]), needs.get("until")
        free = (distance <= max(needs.get("beyond") or 0.0, 1e-9)) | _holds(found, needs["condition"])
        return ~(free if until is None else free | (distance >= until))

    def _free(self, columns: Array, name: str) -> None:
        needs, (at, ratio, offset), shut = self._needs[name], self._laws[name], self._forbidden(columns, name)
        if at < 0 or not np.any(shut):
            return
        position, near = ratio * columns[at] + offset, (needs.get("beyond") or 0.0) * (1 - 1e-9)
        target, low, high = np.clip(position, -near, near), self.lower[at], self.upper[at]
        if needs.get("until") is not None:
            far = np.copysign(needs["until"] * (1 + 1e-9), position)
            inside = (low <= (far - offset) / ratio) & ((far - offset) / ratio <= high)
            target = np.where(inside & (abs(far - position) < abs(target - position)), far, target)
        columns[at] = np.where(shut, np.clip((target - offset) / ratio, low, high), columns[at])


def curve_at(curve: dict[str, Any], position: ArrayLike, *, slope: bool = False) -> Any:
    """Return the position of a joint of a closed chain, or its slope, at positions of its input."""
    start, step, found = curve["start"], curve["step"], np.asarray(curve["positions"], float)
    slopes = np.asarray(curve["slopes"], float) * step
    place = np.asarray(position, float) - start
    turns = np.floor(place / (2.0 * np.pi)) if curve["turns"] else 0.0
    place = (place - turns * 2.0 * np.pi) / step
    number = np.clip(np.floor(place).astype(int), 0, len(found) - 2)
    share, rise = place - number, found[number + 1] - found[number]
    second = 3.0 * rise - 2.0 * slopes[number] - slopes[number + 1]
    third = slopes[number] + slopes[number + 1] - 2.0 * rise
    if slope:
        return (slopes[number] + share * (2.0 * second + share * 3.0 * third)) / step
    inside = found[number] + share * (slopes[number] + share * (second + share * third))
    return inside + turns * (found[-1] - found[0])


def _holds(found: dict[str, Array], condition: dict[str, Any]) -> Any:
    if condition["kind"] == "above":
        return found[condition["joint"]] > condition["value"]
    if condition["kind"] == "below":
        return found[condition["joint"]] < condition["value"]
    combine = np.logical_and if condition["kind"] == "all" else np.logical_or
    return combine.reduce([_holds(found, term) for term in condition["terms"]])


def _named(condition: dict[str, Any]) -> list[str]:
    terms = condition.get("terms")
    return [name for term in terms for name in _named(term)] if terms else [condition["joint"]]


def _data(path: Path) -> Any:
    raw = path.read_bytes()
    if path.suffix == ".glb":
        scene = json.loads(raw[20 : 20 + int.from_bytes(raw[12:16], "little")])
        return scene["asset"].get("extras", {}).get(KEY)
    if path.suffix == ".json":
        return json.loads(raw)
    match = re.search(_PLACES.get(path.suffix, "(?!)"), raw.decode())
    return match and match[1].replace("&quot;", '"')
