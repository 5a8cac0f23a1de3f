"""Demonstrations of the scripted policy in a task, in the HDF5 layout of robomimic; needs `artgen[demos]`.

`artgen demos OpenDrawer -n 100 --out DIR` and `make_demos` write `DIR/demo.hdf5` for imitation learning.
"""

from artgen.demos.run import DEMO_FILE, Demo, DemoSummary, make_demos, record

__all__ = ["DEMO_FILE", "Demo", "DemoSummary", "make_demos", "record"]
