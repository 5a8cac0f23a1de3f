"""ManiSkill driver: reads a URDF and moves its joints, physics only, without a graphics device.

ManiSkill's reader of PartNet-Mobility reads exports in the layout `partnet-mobility`.
"""

import json
from pathlib import Path
from typing import Any

from driver_protocol import serve
from partnet_request import numbered
from sapien_model import couple, read_alone, read_articulation, simulate, without_graphics

_STEP = 1.0 / 240.0  # [s]
_ABOUT = "maniskill.json"  # ManiSkill's table of models
_TWIN = "mobility_cvx.urdf"  # the file that it opens


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    from importlib.metadata import version

    import sapien
    import torch
    from mani_skill.envs.scene import ManiSkillScene
    from mani_skill.envs.utils.system.backend import BackendInfo

    sapien.physx.set_body_config(sleep_threshold=0.0)  # a slow drive would fall asleep after 0.4 s
    inner = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    inner.set_timestep(_STEP)
    device = torch.device("cpu")
    backend = BackendInfo(device, sapien.Device("cpu"), "physx_cpu", None, "none")
    scene = ManiSkillScene([inner], device=device, backend=backend)
    builder = _builder(scene, request)
    builder.initial_pose = sapien.Pose()
    if not hasattr(builder, "link_builders"):
        actor = builder.build(name=request["asset"])
        return {"version": version("mani_skill"), **read_alone(inner.step, actor._objs[0], request)}
    built = builder.build(name=request["asset"], build_mimic_joints=False)
    articulation = built._objs[0]  # the object that ManiSkill wraps
    for item in (*articulation.links, *articulation.joints):
        item.name = item.name.removeprefix(f"scene-0-{request['asset']}_")
    couple(articulation, builder.mimic_joint_records)
    told = read_articulation(articulation, builder.mimic_joint_records, request)
    note = told["note"]
    if request["layout"] == "partnet-mobility":
        note += f", {_handles(builder)} links with a handle"
    moved = simulate(inner.step, articulation, request)
    return {"version": version("mani_skill"), **told, **moved, "note": note}


def _builder(scene: Any, request: dict[str, Any]) -> Any:
    fixed = request["base"] == "fixed"
    if request["layout"] == "partnet-mobility":
        from mani_skill.utils.building import articulations
        from mani_skill.utils.building.articulations import partnet_mobility

        folder, name = Path(request["directory"]), request["asset"]
        partnet_mobility.PARTNET_MOBILITY = {
            "model_data": {name: json.loads((folder / _ABOUT).read_text(encoding="utf-8"))},
            "model_urdf_paths": {name: folder / _TWIN},
        }
        return articulations.get_articulation_builder(scene, f"partnet-mobility:{name}", fix_root_link=fixed)
    from sapien.wrapper import urdf_loader

    without_graphics(urdf_loader)
    loader = scene.create_urdf_loader()
    loader.fix_root_link = fixed
    loader.name = request["asset"]
    found = loader.parse(request["file"])
    (builder,) = found["articulation_builders"] or found["actor_builders"]  # without joints it is an actor
    return builder


def _handles(builder: Any) -> int:
    """Count the links in which ManiSkill's tasks find a handle by the name of a visual."""
    return sum(any("handle" in item.name for item in link.visual_records) for link in builder.link_builders)


if __name__ == "__main__":
    serve(numbered(read), "mani_skill")
