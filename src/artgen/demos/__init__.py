"""Demonstrations of the scripted policy in a task for imitation learning; needs `artgen[demos]`.

`artgen demos OpenDrawer -n 100 --out DIR` and `make_demos` write `DIR/demo.hdf5`, in the layout of robomimic,
or `DIR/lerobot`, a LeRobotDataset.
"""

from artgen.demos.run import DEMO_FILE, Demo, DemoSummary, make_demos, record

__all__ = ["DEMO_FILE", "Demo", "DemoSummary", "make_demos", "record"]
