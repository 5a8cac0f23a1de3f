"""robosuite driver: reads an object of the layout `robocasa`, twice in a task with a robot."""

from typing import Any

import numpy as np
from driver_protocol import ends, free, serve
from mujoco_fields import Fields

_NAMES = ("first_object", "second_object")
_APART = 4.0  # distance between the objects [m]
_CLEAR = 0.002  # height of a free object above the floor before it drops [m]
_STEPS = 1000
_TURN = 0.5  # time of a joint from one end to the other [s]
_MOST = 1.5  # time to one end [s]
_NEAR = 0.02  # tolerance at the end, as a share of the range
_GROWTH = 15.0  # growth of a force while its joint hardly moves [1/s]
_LEAST = 1e-4  # share of the effort at the start
_CORNERS = ("p0", "px", "py", "pz")


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import mujoco
    import robosuite

    objects = [_object(request, name) for name in _NAMES]
    model = _model(request, objects)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=_STEPS)
    said = [f"it warns {each.number} times while stepping" for each in data.warning if each.number]
    said += _missing(model, objects) + _misread(request)
    fields = Fields(model, lambda name: getattr(model, name), objects[-1].naming_prefix)
    poses = []
    for pose in request["poses"]:
        placed = mujoco.MjData(model)
        placed.qpos[:] = fields.placed(request, pose)
        mujoco.mj_kinematics(model, placed)
        poses.append(fields.frames(placed.xpos, placed.xmat, request["links"]))
    return {
        "version": robosuite.__version__,
        **fields.read(request),
        "poses": poses,
        "moved": {joint["name"]: _driven(mujoco, fields, joint, request) for joint in free(request)},
        "steps": _STEPS,
        "finite": bool(np.isfinite(data.qpos).all()),
        "said": said,
        "note": f"two in a task with a robot; regions {', '.join(_regions(objects[0]))}",
    }


def _object(request: dict[str, Any], name: str) -> Any:
    from robosuite.models.objects import MujocoXMLObject

    joints = "default" if request["base"] == "free" else None
    return MujocoXMLObject(request["file"], name, joints=joints, duplicate_collision_geoms=False)


def _model(request: dict[str, Any], objects: list[Any]) -> Any:
    """Return the model of a task with a robot and the objects next to each other on the floor."""
    from robosuite.models.arenas import EmptyArena
    from robosuite.models.robots.robot_model import create_robot
    from robosuite.models.tasks import ManipulationTask

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
    import mujoco

    kinds = {
        "bodies": "BODY",
        "joints": "JOINT",
        "contact_geoms": "GEOM",
        "visual_geoms": "GEOM",
        "sites": "SITE",
    }
    return [
        f"{kind} names {name!r}, which the model has not"
        for each in objects
        for kind, what in kinds.items()
        for name in getattr(each, kind)
        if mujoco.mj_name2id(model, getattr(mujoco.mjtObj, f"mjOBJ_{what}"), name) < 0
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


def _driven(mujoco: Any, fields: Fields, joint: dict[str, Any], request: dict[str, Any]) -> list[float]:
    """Return the range of a joint that is driven alone to both ends at a steady speed."""
    model, number = fields.model, fields.joints(request)[joint["name"]]
    data = mujoco.MjData(model)
    data.qpos[:] = fields.placed(request, request["poses"][0])
    place, degree = model.jnt_qposadr[number], model.jnt_dofadr[number]
    low, high = ends(joint)
    seen = [float(data.qpos[place])]
    for side, end in ((1.0, high), (-1.0, low)):
        speed, more = side * (high - low) / _TURN, 0.0
        for _ in range(round(_MOST / model.opt.timestep)):
            if side * (end - seen[-1]) <= _NEAR * (high - low):
                break  # it would be pressed into its limit, which gives way
            more = _push(mujoco, model, data, degree, speed, joint["effort"], more)
            seen.append(float(data.qpos[place]))
    return [min(seen), max(seen)]


def _push(mujoco: Any, model: Any, data: Any, degree: int, speed: float, effort: float, more: float) -> float:
    """Simulate a step with the torque that brings a degree of freedom to a speed."""
    mujoco.mj_forward(model, data)
    if abs(data.qvel[degree]) < 0.5 * abs(speed) or data.qvel[degree] * speed < 0.0:
        more = min(effort, max(_LEAST * effort, more * (1.0 + _GROWTH * model.opt.timestep)))
    else:
        more *= 0.5
    unit, column = np.zeros((1, model.nv)), np.zeros((1, model.nv))
    unit[0, degree] = 1.0
    mujoco.mj_solveM(model, data, column, unit)
    lack = (speed - data.qvel[degree]) / (5.0 * model.opt.timestep)
    force = data.qfrc_bias[degree] - data.qfrc_passive[degree] + lack / max(column[0, degree], 1e-12)
    force += np.sign(speed) * (model.dof_frictionloss[degree] + more)
    data.qfrc_applied[degree] = np.clip(force, -effort, effort)
    mujoco.mj_step(model, data)
    return more


if __name__ == "__main__":
    serve(read, "robosuite", "mujoco")
