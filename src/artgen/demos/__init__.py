"""Demonstrations of the scripted policy in a task, in the HDF5 layout of robomimic; needs `artgen[demos]`.

`artgen demos OpenDrawer -n 100 --out DIR` and `make_demos` write `DIR/demo.hdf5` for imitation learning.
"""

from artgen.demos.episode import Demo, record
from artgen.demos.run import DEMO_FILE, DemoSummary, make_demos

__all__ = ["DEMO_FILE", "Demo", "DemoSummary", "make_demos", "record"]
