"""Reading an exported asset into MuJoCo."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


@contextmanager
def collected_warnings() -> Iterator[list[str]]:
    """Collect what MuJoCo warns of, which it would otherwise print and write to a file."""
    import mujoco

    before = mujoco.get_mju_user_warning()
    found: list[str] = []
    mujoco.set_mju_user_warning(found.append)
    try:
        yield found
    finally:
        mujoco.set_mju_user_warning(before)


def fixed_model(path: Path) -> Any:
    """Read a file with the base fixed to the world."""
    import mujoco

    spec = mujoco.MjSpec.from_file(str(path))
    for joint in list(spec.joints):
        if joint.type == mujoco.mjtJoint.mjJNT_FREE:
            spec.delete(joint)
    return spec.compile()


def standing_model(path: Path) -> Any:
    """Read a file and put a floor under its base, as hard as the colliders."""
    import mujoco

    spec = mujoco.MjSpec.from_file(str(path))
    colliders = [geom for geom in spec.geoms if geom.contype or geom.conaffinity]
    floor = spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0.0, 0.0, 1.0])
    if colliders:
        floor.solref, floor.solimp = colliders[0].solref, colliders[0].solimp
    return spec.compile()
