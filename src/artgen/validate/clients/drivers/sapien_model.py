"""SAPIEN driver: reads a URDF and moves its joints, physics only, without a graphics device."""

from typing import Any

import numpy as np
from driver_protocol import ends, finite_limits, free, in_base, mass_properties, require, serve

require("sapien")
import sapien
from sapien.wrapper import urdf_loader
from sapien.wrapper.actor_builder import ActorBuilder

_SETTLE = 1.0  # time of an asset at rest before the motion [s]
_TURN = 1.0  # time of a joint from one end to the other [s]
_STEP = 1.0 / 240.0  # [s]


def _read(request: dict[str, Any]) -> dict[str, Any]:
    if request["layout"] == "flat":
        skip_visuals()
    scene = new_scene()
    loader = urdf_loader.URDFLoader()
    loader.set_scene(scene)
    loader.fix_root_link = request["base"] == "fixed"
    if request["layout"] == "partnet-mobility":
        loader.load_multiple_collisions_from_file = True  # as loaders of that dataset do
    articulations, actors, _ = loader.parse(request["file"])
    if not articulations:
        (actor,) = actors
        actor.visual_records = []
        return read_entity(scene.step, actor.build(), request)
    (builder,) = articulations
    for link in builder.link_builders:
        link.visual_records = []
    articulation = builder.build(build_mimic_joints=False)
    return read_articulation(scene.step, articulation, builder.mimic_joint_records, request)


def new_scene() -> Any:
    """Return a scene with physics on the CPU."""
    sapien.physx.set_body_config(sleep_threshold=0.0)  # a slow drive would fall asleep after 0.4 s
    scene = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    scene.set_timestep(_STEP)
    return scene


def skip_visuals() -> None:
    """Allow URDF with materials without a graphics device: visuals are skipped."""

    class Material:
        """Replacement that accepts the loader's settings."""

    def skip(builder: Any, *_: Any, **__: Any) -> Any:
        return builder

    urdf_loader.RenderMaterial = Material
    ActorBuilder.add_visual_from_file = skip


def read_entity(step: Any, entity: Any, request: dict[str, Any]) -> dict[str, Any]:
    """Return the response for a link without joints, which SAPIEN loads as an actor."""
    body = entity.find_component_by_type(sapien.physx.PhysxRigidDynamicComponent)
    for _ in range(round(_SETTLE / _STEP)):
        step()
    position = entity.pose.to_transformation_matrix()
    colliders = entity.find_component_by_type(sapien.physx.PhysxRigidBaseComponent).collision_shapes
    (name,) = request["links"]
    return {
        "links": {} if body is None else {name: _link(body)},  # fixed bodies have no mass
        "joints": {},
        "poses": [{name: np.eye(4)} for _ in request["poses"]],
        "moved": {},
        "steps": round(_SETTLE / _STEP),
        "finite": bool(np.isfinite(position).all()),
        "note": f"{len(colliders)} colliders",
    }


def read_articulation(step: Any, articulation: Any, mimics: Any, request: dict[str, Any]) -> dict[str, Any]:
    """Return the response for an articulation without couplings, and their records."""
    links = {link.name: link for link in articulation.links}
    joints = {joint.name: joint for joint in articulation.active_joints}
    _couple(articulation, joints, mimics)
    poses = []
    for q in request["poses"]:
        articulation.set_qpos(np.array([q.get(name, 0.0) for name in joints], np.float32))
        frames = {name: links[name].entity_pose.to_transformation_matrix() for name in request["links"]}
        poses.append(in_base(frames, request["links"]))
    return {
        "links": {name: _link(links[name]) for name in request["links"]},
        "joints": {name: _joint(joint) for name, joint in joints.items()},
        "couplings": {item.joint: [item.mimic, item.multiplier, item.offset] for item in mimics},
        "poses": poses,
        "note": f"{sum(len(link.collision_shapes) for link in links.values())} colliders, "
        f"{sum(link.mass for link in links.values()):.6g} kg",
        **_simulate(step, articulation, joints, request),
    }


def _couple(articulation: Any, joints: dict[str, Any], mimics: Any) -> None:
    """Correct couplings to the meaning of URDF."""
    # SAPIEN 3.0 reverses those of one body, divides the force by the ratio and couples to no further leader
    for item in mimics:
        follower, leader = joints[item.joint], joints[item.mimic]
        if follower.parent_link not in (leader.parent_link, leader.child_link):
            continue
        terms = [0.0, -item.multiplier, 1.0]
        articulation.create_fixed_tendon(
            [leader.parent_link, leader.child_link, follower.child_link],
            terms,
            terms,
            rest_length=item.offset,
            stiffness=1e5,
        )


def _link(link: Any) -> dict[str, Any]:
    pose = link.cmass_local_pose
    return mass_properties(link.mass, pose.p, link.inertia, pose.to_transformation_matrix()[:3, :3])


def _joint(joint: Any) -> dict[str, Any]:
    return {
        "kind": "prismatic" if joint.type == "prismatic" else "revolute",
        "limits": finite_limits(*np.asarray(joint.limit, float).reshape(-1)[:2]),
        "damping": joint.damping,  # SAPIEN 3.0 does not read the friction
    }


def _simulate(
    step: Any, articulation: Any, joints: dict[str, Any], request: dict[str, Any]
) -> dict[str, Any]:
    """Let the asset settle, then drive each free joint to both ends."""
    order = list(joints)
    articulation.set_qpos(np.array([request["poses"][0].get(name, 0.0) for name in order], np.float32))
    articulation.set_qvel(np.zeros(len(order), np.float32))
    moved: dict[str, list[float]] = {}
    seen: list[Any] = []

    def run(seconds: float) -> None:
        for _ in range(round(seconds / _STEP)):
            step()
            seen.append(np.array(articulation.qpos, float))

    run(_SETTLE)
    for joint in free(request):
        driven, number = joints[joint["name"]], order.index(joint["name"])
        low, high = ends(joint)
        gain = 100.0 * joint["effort"] * _TURN / (high - low)
        driven.set_drive_properties(0.0, gain, force_limit=joint["effort"])
        start = len(seen)
        for speed in ((high - low) / _TURN, (low - high) / _TURN):
            driven.set_drive_velocity_target(speed)
            run(1.5 * _TURN)
        driven.set_drive_velocity_target(0.0)
        positions = [row[number] for row in seen[start:]]
        moved[joint["name"]] = [min(positions), max(positions)]
    return {"moved": moved, "steps": len(seen), "finite": bool(np.isfinite(seen).all())}


if __name__ == "__main__":
    serve(_read)
