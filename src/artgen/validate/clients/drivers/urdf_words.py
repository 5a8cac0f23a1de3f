"""What readers of URDF that keep its words, yourdfpy and urchin, say of joints."""

from collections.abc import Mapping
from typing import Any


def joints_and_couplings(moving: Mapping[str, Any], kinds: Mapping[str, str]) -> dict[str, Any]:
    """Return `joints` and `couplings` of a response."""
    return {
        "joints": {name: _joint(joint, kinds[name]) for name, joint in moving.items()},
        "couplings": {
            name: [joint.mimic.joint, joint.mimic.multiplier, joint.mimic.offset]
            for name, joint in moving.items()
            if joint.mimic is not None
        },
    }


def _joint(joint: Any, kind: str) -> dict[str, Any]:
    return {
        "kind": "prismatic" if kind == "prismatic" else "revolute",
        "limits": None if kind == "continuous" else [joint.limit.lower, joint.limit.upper],
        "damping": joint.dynamics.damping,
        "friction": joint.dynamics.friction,
    }
