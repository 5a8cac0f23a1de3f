"""Make a door and a handle, load the files with independent readers, and open the door in MuJoCo."""

import math
import sys
import warnings
from pathlib import Path

import mujoco
import pinocchio
import yourdfpy
from pxr import Usd, UsdPhysics, UsdValidation
from rich.console import Console

import artgen

OUT = Path("out")
console = Console(highlight=False, soft_wrap=True)


def read_yourdfpy(stem: Path) -> str:
    """Load the URDF with all its meshes."""
    with warnings.catch_warnings():
        # yourdfpy calls trimesh in a way that trimesh is about to drop, whatever the file
        warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
        robot = yourdfpy.URDF.load(
            str(stem.with_suffix(".urdf")), load_collision_meshes=True, build_collision_scene_graph=True
        )
    if not robot.validate():
        raise ValueError(f"yourdfpy finds faults: {robot.errors}")
    return f"{len(robot.link_map)} links, {len(robot.actuated_joint_names)} joints to move"


def read_pinocchio(stem: Path) -> str:
    """Load the URDF with its geometry."""
    model, _, _ = pinocchio.buildModelsFromUrdf(str(stem.with_suffix(".urdf")), [str(stem.parent)])
    return f"{model.njoints - 1} joints, {pinocchio.computeTotalMass(model):.2f} kg on them"


def read_mujoco(stem: Path, suffix: str) -> str:
    """Compile, and simulate a tenth of a second."""
    model = mujoco.MjModel.from_xml_path(str(stem.with_suffix(suffix)))
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, nstep=50)
    if any(warning.number for warning in data.warning):
        raise ValueError("MuJoCo warns while it steps")
    return f"{model.nbody - 1} bodies, {model.njnt} joints"


def read_usd(stem: Path) -> str:
    """Open the stage and run every validator of OpenUSD."""
    stage = Usd.Stage.Open(str(stem.with_suffix(".usda")))
    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    faults = [error.GetMessage() for error in context.Validate(stage)]
    if faults:
        raise ValueError(f"OpenUSD finds faults: {faults}")
    bodies = sum(prim.HasAPI(UsdPhysics.RigidBodyAPI) for prim in stage.Traverse())
    return f"{bodies} rigid bodies, no validator complains"


READERS = {
    "yourdfpy, URDF": read_yourdfpy,
    "pinocchio, URDF": read_pinocchio,
    "MuJoCo, URDF": lambda stem: read_mujoco(stem, ".urdf"),
    "MuJoCo, MJCF": lambda stem: read_mujoco(stem, ".xml"),
    "OpenUSD, USD": read_usd,
}


def open_door(stem: Path) -> list[float]:
    """Pull at the closed door, then turn the handle and pull again.

    Returns:
        The angles of the door after each pull [rad].
    """
    model = mujoco.MjModel.from_xml_path(str(stem.with_suffix(".xml")))
    data = mujoco.MjData(model)

    def push(seconds: float, **torques: float) -> float:
        for name, torque in torques.items():
            data.joint(name).qfrc_applied[0] = torque
        mujoco.mj_step(model, data, nstep=round(seconds / model.opt.timestep))
        return float(data.joint("door_hinge").qpos[0])

    pulled = push(1.0, door_hinge=20.0, handle_turn=0.0)
    push(0.5, door_hinge=0.0, handle_turn=4.0)
    return [pulled, push(1.0, door_hinge=20.0)]


def main() -> int:
    """Run the demo; 1 means that a reader refused a file or the door did not behave."""
    for category, seed in (("door", 7), ("handle", 7)):
        asset = artgen.generate(category, seed)
        directory = asset.export(OUT / asset.name)
        joints = ", ".join(joint.name for joint in asset.joints)
        console.print(f"[bold]{asset.name}[/]: {asset.mass:.1f} kg, {len(asset.links)} links; {joints}")
        for reader, read in READERS.items():
            console.print(f"  {reader:16} {read(directory / asset.name)}")
    pulled, opened = (math.degrees(angle) for angle in open_door(OUT / "door_7" / "door_7"))
    console.print(
        f"door_7 in MuJoCo: pulled while latched {pulled:.1f} deg, with the handle turned {opened:.0f} deg"
    )
    console.print(f"written to {OUT.resolve()}")
    return 0 if pulled < 2.0 and opened > 30.0 else 1


if __name__ == "__main__":
    sys.exit(main())
