"""What a USD stage says to single simulators: by their schemas, or in variants that are enabled for them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pxr import Usd

from artgen.asset import Asset
from artgen.validate.readback.reading import Said
from artgen.validate.readback.usd_joints import arms, couplings, dynamics, physx_couplings

Law = tuple[str, float, float]

_ENABLED = "Enabled"
_NEWTON, _PHYSX, _MUJOCO = "Newton", "PhysX", "MuJoCo"


@dataclass(frozen=True, eq=False)
class Profile:
    """What a stage says of the joints to a simulator."""

    dynamics: dict[str, tuple[Said, ...]]  # springs, friction and so on of each joint
    couplings: dict[str, dict[str, Law]]  # leader, ratio and offset of each joint that follows, by simulator


def variants(stage: Any) -> Iterator[str]:
    """Enable each variant of a stage that is for one simulator, one after the other, and yield its name.

    A stage without such variants yields an empty name once. In the end none is enabled.
    """
    root = stage.GetDefaultPrim()
    names = list(root.GetVariantSets().GetNames()) if root else []
    names = [name for name in names if _ENABLED in root.GetVariantSet(name).GetVariantNames()]
    if not names:
        yield ""
    for name in names:
        layer = stage.GetSessionLayer()
        with Usd.EditContext(stage, layer):
            root.GetVariantSet(name).SetVariantSelection(_ENABLED)
        yield name
        layer.Clear()


def profile(stage: Any, asset: Asset, variant: str) -> Profile:
    """Read what a stage says with a variant enabled."""
    said = {arm.name: tuple(dynamics(arm)) for arm in arms(stage) if arm.kind and arm.parent}
    if variant == _PHYSX:
        return Profile(said, {_PHYSX: physx_couplings(stage)})
    if variant == _MUJOCO:
        return Profile(said, {_MUJOCO: _of_mujoco(couplings(stage, "mjc:target"), asset)})
    # Newton takes MuJoCo's schema between a rotation and a slide, of which it then counts from 0
    of_newton = couplings(stage, "mjc:target") | couplings(stage, "newton:mimicJoint")
    result = {_NEWTON: of_newton}
    if not variant:
        result[_PHYSX] = physx_couplings(stage)
    return Profile(said, result)


def _of_mujoco(laws: dict[str, Law], asset: Asset) -> dict[str, Law]:
    """Return couplings of MuJoCo, which are of what joints have moved from where they stand at first."""
    positions = asset.positions()
    return {
        follower: (
            leader,
            ratio,
            offset + positions.get(follower, 0.0) - ratio * positions.get(leader, 0.0),
        )
        for follower, (leader, ratio, offset) in laws.items()
    }
