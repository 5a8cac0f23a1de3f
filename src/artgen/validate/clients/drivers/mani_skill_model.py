"""ManiSkill driver: reads a URDF and moves its joints, physics only, without a graphics device.

ManiSkill's reader of PartNet-Mobility reads exports in the layout `partnet-mobility`.
"""

import json
from pathlib import Path
from typing import Any

from driver_protocol import require, serve
from sapien_model import new_scene, read_articulation, read_entity, skip_visuals

require("mani_skill")
import sapien
import torch
from mani_skill.envs.scene import ManiSkillScene
from mani_skill.envs.utils.system.backend import BackendInfo

_MODELS = "maniskill.json"  # ManiSkill's table of models
_URDF = "mobility_cvx.urdf"  # the file that it opens


def _read(request: dict[str, Any]) -> dict[str, Any]:
    inner = new_scene()
    device = torch.device("cpu")
    backend = BackendInfo(device, sapien.Device("cpu"), "physx_cpu", None, "none")
    scene = ManiSkillScene([inner], device=device, backend=backend)
    builder = _builder(scene, request)
    builder.initial_pose = sapien.Pose()
    if not hasattr(builder, "link_builders"):
        return read_entity(inner.step, builder.build(name=request["asset"])._objs[0], request)
    built = builder.build(name=request["asset"], build_mimic_joints=False)
    articulation = built._objs[0]  # the object that ManiSkill wraps
    for item in (*articulation.links, *articulation.joints):
        item.name = item.name.removeprefix(f"scene-0-{request['asset']}_")
    answer = read_articulation(inner.step, articulation, builder.mimic_joint_records, request)
    if request["layout"] == "partnet-mobility":
        answer["note"] += f", {_handles(builder)} links with a handle"
    return answer


def _builder(scene: Any, request: dict[str, Any]) -> Any:
    fixed = request["base"] == "fixed"
    if request["layout"] == "partnet-mobility":
        from mani_skill.utils.building import articulations
        from mani_skill.utils.building.articulations import partnet_mobility

        folder, name = Path(request["directory"]), request["asset"]
        partnet_mobility.PARTNET_MOBILITY = {
            "model_data": {name: json.loads((folder / _MODELS).read_text(encoding="utf-8"))},
            "model_urdf_paths": {name: folder / _URDF},
        }
        return articulations.get_articulation_builder(scene, f"partnet-mobility:{name}", fix_root_link=fixed)
    skip_visuals()
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
    serve(_read)
