"""Open a model with ManiSkill's task OpenCabinetDoor: its own code, without pictures and without a robot.

A program for ManiSkill's environment: `python partnet_open_cabinet.py EXPORT RESULT.json`, with a folder in
MS_ASSET_DIR where the export lies as model 1000 of the dataset.
"""

import json
import sys
from pathlib import Path

import numpy as np
import sapien
import torch
import trimesh
from mani_skill.envs.scene import ManiSkillScene
from mani_skill.envs.tasks.mobile_manipulation import open_cabinet_drawer
from mani_skill.envs.utils.system.backend import BackendInfo
from mani_skill.utils.building import articulations
from mani_skill.utils.building.articulations import partnet_mobility
from mani_skill.utils.structs import link as structs_link

MODEL = "1000"


class Draws:
    """The task's random numbers: the model, and which of its links to open."""

    def __init__(self, number):
        self.number = number

    def choice(self, _):
        return [MODEL]

    def randint(self, *_):
        return [self.number]


class Sphere:
    """What the task shows at the handle."""

    def set_pose(self, pose):
        self.pose = pose


class Shape:
    """What is seen of a link: one visual of the URDF, which the graphics device would hold."""

    def __init__(self, record):
        self.name = record.name
        self.record = record

    def meshes(self):
        mesh = trimesh.load(self.record.filename, force="mesh")
        mesh.apply_scale(self.record.scale)
        mesh.apply_transform(self.record.pose.to_transformation_matrix())
        return [mesh]


class Cabinet(open_cabinet_drawer.OpenCabinetDoorEnv):
    """The task without a robot and without pictures."""

    handle_types = ("revolute", "revolute_unwrapped")

    def __init__(self, scene, number):
        self.scene = scene
        self._batched_episode_rng = Draws(number)
        self.all_model_ids = [MODEL]
        self.robot_uids = "none"

    device = torch.device("cpu")
    gpu_sim_enabled = False

    def add_to_state_dict_registry(self, _):
        pass

    def remove_from_state_dict_registry(self, _):
        pass


def scene():
    inner = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    backend = BackendInfo(Cabinet.device, sapien.Device("cpu"), "physx_cpu", None, "none")
    return ManiSkillScene([inner], device=Cabinet.device, backend=backend)


def with_stand_ins(task):
    """Let what would be drawn come from the records of the builder."""
    builders = []
    build = articulations.get_articulation_builder

    def recorded(*arguments, **named):
        builders.append(build(*arguments, **named))
        return builders[-1]

    def shapes(link):
        (record,) = [item for item in builders[-1].link_builders if item.name == link.name]
        return [[Shape(visual) for visual in record.visual_records]]

    task.articulations.get_articulation_builder = recorded
    task.actors.build_sphere = lambda *_, **__: Sphere()
    structs_link.Link.render_shapes = property(shapes)
    structs_link.get_render_shape_meshes = Shape.meshes


def run(number):
    """Open one link and return what the task says of it."""
    task = Cabinet(scene(), number)
    task._load_cabinets(task.handle_types)
    task._after_reconfigure({})
    task._initialize_episode(torch.tensor([0]), {})
    closed, start = task.evaluate(), task.cabinet.get_qpos().tolist()
    task.cabinet.set_qpos(task.cabinet.get_qlimits()[:, :, 1])
    opened = task.evaluate()
    return {
        "link": task.handle_link.name,
        "links": [item.name for item in task.handle_link._objs],
        "height": task.cabinet_zs.tolist(),
        "start": start,
        "handle": closed["handle_link_pos"].tolist(),
        "closed": closed["success"].tolist(),
        "opened": opened["success"].tolist(),
    }


def main(directory, result):
    partnet_mobility._load_partnet_mobility_dataset()
    about = json.loads((Path(directory) / "maniskill.json").read_text())
    partnet_mobility.PARTNET_MOBILITY["model_data"][MODEL] = about
    with_stand_ins(open_cabinet_drawer)
    answers = [run(number) for number in range(about["num_target_links"])]
    path = partnet_mobility.PARTNET_MOBILITY["model_urdf_paths"][MODEL]
    Path(result).write_text(json.dumps({"file": str(path), "runs": answers}, default=np.ndarray.tolist))


if __name__ == "__main__":
    main(*sys.argv[1:])
