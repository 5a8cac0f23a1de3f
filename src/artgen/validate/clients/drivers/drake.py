"""Drake driver: reads a URDF, MJCF or SDFormat and moves its joints."""

import xml.etree.ElementTree as ET
from typing import Any

import numpy as np
from driver_motion import lags
from driver_protocol import ends, finite_limits, free, mass_properties, require, serve

require("pydrake")
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.multibody.tree import PdControllerGains
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

_STEP = 2e-3  # [s]
_TURN = 1.0  # time of a joint from one end to the other [s]
_PARTS = 20  # samples between two positions
_KINDS = {"RevoluteJoint": "revolute", "PrismaticJoint": "prismatic"}


def _read(request: dict[str, Any]) -> dict[str, Any]:
    diagram, plant, instance = _plant(request)
    # in URDF, a pair of links with several joints has intermediate bodies, which are not requested
    bodies = {name: plant.GetBodyByName(name, instance) for name in request["links"]}
    joints = {
        joint.name(): joint
        for joint in (plant.get_joint(index) for index in plant.GetJointIndices(instance))
        if type(joint).__name__ in _KINDS
    }
    poses = []
    context = diagram.CreateDefaultContext()
    inner = plant.GetMyMutableContextFromRoot(context)
    base = bodies[request["links"][0]].body_frame()
    for q in request["poses"]:
        _set_positions(plant, inner, {joint: q[name] for name, joint in joints.items()})
        found = {name: body.body_frame().CalcPose(inner, base) for name, body in bodies.items()}
        poses.append({name: pose.GetAsMatrix4() for name, pose in found.items()})
    following = sum(joint["follows"] is not None and joint["curve"] is None for joint in request["joints"])
    motion, track = _simulate(request)
    said = []
    # its MJCF reader skips couplings with a message; not every layout of URDF has all of them
    if request["format"] in ("urdf", "sdf") and request["layout"] == "flat":
        said += lags(request, track)  # it does not report their laws
        if plant.num_constraints() != following:
            said.append(f"it has {plant.num_constraints()} of {following} couplings")
    return {
        "links": {name: _link(body) for name, body in bodies.items()},
        "joints": {name: _joint(joint) for name, joint in joints.items()},
        "poses": poses,
        "said": said,
        **motion,
    }


def _plant(request: dict[str, Any], driven: tuple[dict[str, Any], ...] = ()) -> tuple[Any, Any, Any]:
    """Return a diagram with the asset, motors on the driven joints, its plant and the model instance."""
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, _STEP)
    (instance,) = Parser(plant).AddModels(request["file"])
    if request["base"] == "fixed" and request["format"] == "urdf":
        base = plant.GetBodyByName(_root(request["file"]), instance)
        plant.WeldFrames(plant.world_frame(), base.body_frame())
    for joint in driven:
        if request["format"] == "sdf":  # its reader makes a motor for each joint
            motor = plant.GetJointActuatorByName(joint["name"], instance)
        else:
            found = plant.GetJointByName(joint["name"], instance)
            motor = plant.AddJointActuator(f"{joint['name']}_motor", found, joint["effort"])
        # the force stays within the effort, and exceeds a spring within a small part of a short range
        low, high = ends(joint)
        gain = joint["effort"] / min(1.0, high - low)
        motor.set_controller_gains(PdControllerGains(p=50.0 * gain, d=5.0 * gain))
    plant.Finalize()
    return builder.Build(), plant, instance


def _root(path: str) -> str:
    """Return the name of the link of a URDF without a parent."""
    robot = ET.parse(path).getroot()  # noqa: S314 - Drake has read it
    children = {child.get("link") for child in robot.iterfind("joint/child")}
    return next(str(link.get("name")) for link in robot.iterfind("link") if link.get("name") not in children)


def _set_positions(plant: Any, context: Any, positions: dict[Any, float]) -> None:
    result = plant.GetPositions(context)
    for joint, position in positions.items():
        result[joint.position_start()] = position
    plant.SetPositions(context, result)


def _link(body: Any) -> dict[str, Any]:
    spatial = body.default_spatial_inertia()
    inertia = spatial.CalcRotationalInertia().ShiftToCenterOfMass(spatial.get_mass(), spatial.get_com())
    return mass_properties(spatial.get_mass(), spatial.get_com(), inertia.CopyToFullMatrix3())


def _joint(joint: Any) -> dict[str, Any]:
    return {
        "kind": _KINDS[type(joint).__name__],
        "limits": finite_limits(joint.position_lower_limits()[0], joint.position_upper_limits()[0]),
        "damping": joint.default_damping(),
    }


def _simulate(request: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Drive each free joint to both ends by a motor with its effort; return the motion and all positions."""
    joints, start = tuple(free(request)), request["poses"][0]
    diagram, plant, instance = _plant(request, joints)
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    found = {joint["name"]: plant.GetJointByName(joint["name"], instance) for joint in request["joints"]}
    _set_positions(plant, context, {joint: start[name] for name, joint in found.items()})
    port = plant.get_desired_state_input_port(instance)
    motors = [plant.get_joint_actuator(index) for index in plant.GetJointActuatorIndices(instance)]
    order = [motor.joint().name() for motor in motors]
    targets = np.array([start[name] for name in order])
    moved, passed = {}, [plant.GetPositions(context)]
    time, finite = 0.0, True
    for joint in joints:
        number = order.index(joint["name"])
        seen, begin, (low, high) = [], targets[number], ends(joint)
        for before, after in ((begin, high), (high, low), (low, begin)):
            for target in np.linspace(before, after, _PARTS + 1)[1:]:
                targets[number] = target
                port.FixValue(context, np.concatenate([targets, np.zeros(len(order))]))
                time += _TURN / _PARTS
                simulator.AdvanceTo(time)
                q = plant.GetPositions(context)
                passed.append(q)
                seen.append(q[found[joint["name"]].position_start()])
                finite = finite and bool(np.isfinite(q).all())
        moved[joint["name"]] = [min(seen), max(seen)]
    if not joints:
        simulator.AdvanceTo(0.2)
        time, finite = 0.2, bool(np.isfinite(plant.GetPositions(context)).all())
    track = {name: np.array(passed)[:, joint.position_start()] for name, joint in found.items()}
    return {"moved": moved, "steps": round(time / _STEP), "finite": finite}, track


if __name__ == "__main__":
    serve(_read)
