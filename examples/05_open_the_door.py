"""Open a door in MuJoCo: it stays shut until its handle is turned."""

from math import degrees

import mujoco

import artgen

asset = artgen.generate("door", seed=7, layout="single", opener="lever", bolted=False)
directory = asset.export("out/door_to_open", formats=("mjcf",))
model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.xml"))
data = mujoco.MjData(model)


def simulate(seconds: float, **torques: float) -> None:
    """Step with torques at some joints [N m]."""
    data.qfrc_applied[:] = 0.0
    for name, torque in torques.items():
        data.joint(name).qfrc_applied[0] = torque
    mujoco.mj_step(model, data, nstep=round(seconds / model.opt.timestep))
    angles = (
        f"{name} {degrees(data.joint(name).qpos[0]):5.1f} deg" for name in ("door_hinge", "handle_turn")
    )
    print(f"{torques or 'let go'}: {', '.join(angles)}")


simulate(1.0, door_hinge=20.0)  # pull: the latch holds
simulate(0.5)
simulate(0.5, handle_turn=4.0)  # press the lever down: the latch draws back
simulate(0.8, handle_turn=4.0, door_hinge=20.0)  # and pull
simulate(2.0)  # the lever springs back, the door stays where it is
