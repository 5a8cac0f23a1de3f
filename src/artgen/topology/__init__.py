"""Fixed topology: assets of one batch with equal links, joints and colliders.

`Topology.of` finds a small tree of slots that holds every given asset, and `Topology.pad` returns an asset
with exactly these links, joints and colliders under canonical names.
"""

from artgen.topology.template import Slot, SlotJoint, Topology

__all__ = ["Slot", "SlotJoint", "Topology"]
