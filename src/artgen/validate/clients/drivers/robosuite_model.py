"""robosuite driver: reads an object of the layout `robocasa`, twice in a task with a robot."""

from typing import Any

import numpy as np
from driver_protocol import require, serve

require("robosuite", "mujoco")
import mujoco
from mujoco_model import Model, warnings_of
from robosuite.models.arenas import EmptyArena
from robosuite.models.objects import MujocoXMLObject
from robosuite.models.robots.robot_model import create_robot
from robosuite.models.tasks import ManipulationTask

_NAMES = ("first_object", "second_object")
_APART = 4.0  # distance between the objects [m]
_CLEAR = 0.002  # height of a free object above the floor before it drops [m]
_STEPS = 1000
_CORNERS = ("p0", "px", "py", "pz")


def _read(request: dict[str, Any]) -> dict[str, Any]:
    objects = [_object(request, name) for name in _NAMES]
    model = _model(request, objects)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=_STEPS)
    said = warnings_of(data) + _missing(model, objects) + _misread(request)
    fields = Model(model, prefix=objects[-1].naming_prefix)
    return {
        **fields.read(request),
        **fields.simulate(request),
        "steps": _STEPS,
        "finite": bool(np.isfinite(data.qpos).all()),
        "said": said,
        "note": f"two in a task with a robot; regions {', '.join(_regions(objects[0]))}",
    }


def _object(request: dict[str, Any], name: str) -> Any:
    joints = "default" if request["base"] == "free" else None
    return MujocoXMLObject(request["file"], name, joints=joints, duplicate_collision_geoms=False)


def _model(request: dict[str, Any], objects: list[Any]) -> Any:
    """Return the model of a task with a robot and the objects next to each other on the floor."""
    clear = _CLEAR if request["base"] == "free" else 0.0
    for number, each in enumerate(objects):
        each.set_pos([_APART, _APART * number, clear - each.bottom_offset[2]])
    task = ManipulationTask(EmptyArena(), [create_robot("Panda")], objects)
    for each in objects:
        for element in each.equality:  # a task takes bodies and assets of its objects only
            task.equality.append(element)
    return task.get_model("mujoco")


def _missing(model: Any, objects: list[Any]) -> list[str]:
    """Return the names of robosuite's objects that are missing in the model."""
    kinds = {
        "bodies": mujoco.mjtObj.mjOBJ_BODY,
        "joints": mujoco.mjtObj.mjOBJ_JOINT,
        "contact_geoms": mujoco.mjtObj.mjOBJ_GEOM,
        "visual_geoms": mujoco.mjtObj.mjOBJ_GEOM,
        "sites": mujoco.mjtObj.mjOBJ_SITE,
    }
    return [
        f"{part} has the name {name!r}, which is missing in the model"
        for each in objects
        for part, kind in kinds.items()
        for name in getattr(each, part)
        if mujoco.mj_name2id(model, kind, name) < 0
    ]


def _regions(thing: Any) -> dict[str, Any]:
    """Return the regions of an object as RoboCasa reads them: corners of boxes in the frame of the object."""
    found = {}
    for geom in thing.worldbody.iter("geom"):
        name = geom.get("name").split(thing.naming_prefix)[1]
        if name.startswith("reg_"):
            middle, half, _ = (np.array(geom.get(key).split(), float) for key in ("pos", "size", "rgba"))
            ways = np.array([[-1, -1, -1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
            found[name[4:]] = dict(zip(_CORNERS, middle + half * ways, strict=True))
    return found


def _misread(request: dict[str, Any]) -> list[str]:
    """Return the missing sizes and regions of an object."""
    thing = _object(request, "sized")
    regions = _regions(thing)
    said = [f"there is no region {name!r}" for name in ("main", "bbox") if name not in regions]
    if said:
        return said
    low, high = (regions["main"][corner][2] for corner in ("p0", "pz"))
    wanted = {"bottom": (thing.bottom_offset[2], low), "top": (thing.top_offset[2], high)}
    said += [
        f"its {name} is at {found:.6g} m, but its main region ends at {end:.6g} m"
        for name, (found, end) in wanted.items()
        if abs(found - end) > 1e-6
    ]
    half = (regions["main"]["px"] - regions["main"]["p0"])[0] / 2.0
    if thing.horizontal_radius < half - 1e-6:
        said.append(
            f"its radius is {thing.horizontal_radius:.6g} m, less than half its width of {2 * half:.6g} m"
        )
    return said


if __name__ == "__main__":
    serve(_read)
