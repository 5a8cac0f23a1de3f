"""Feel of joints: damping, friction, inertia and effort of common mechanisms, with their sources.

    from artgen import feel
    Revolute("hinge", axis=Z, limits=(0, 1.6), feel=feel.HINGE)

A keyword of the joint replaces the value of the preset: `feel=feel.RUNNER, friction=3.0`.
"""

from artgen.nodes.handles import GRAVITY
from artgen.nodes.joint import Feel, detents, soft_closing

__all__ = [
    "CASTER", "DETENT", "DIAL", "GAS_SPRING", "GRAVITY", "HINGE", "LATCH", "LEVER", "PIVOT", "RUNNER",
    "SWITCH", "Feel", "detents", "soft_closing",
]  # fmt: skip

SWITCH = Feel(damping=6.0, friction=0.1, armature=0.03, effort=12.0)
"""Slide of a key of an appliance, with a spring of 2-4 N at a travel of 1-3 mm (catalogs of tactile
switches and of keys with a stroke); the armature is the mass of the mechanism, without which a cap of 1
g would sink into its stop at time steps of 2 ms."""

DIAL = Feel(damping=0.003, friction=0.045, armature=2e-5, effort=0.6)
"""Turn of a rotary switch or potentiometer: 0.02-0.06 N m in catalogs of controls for appliances; two
fingers of 20 N at a radius of 15 mm give 0.6 N m."""

DETENT = Feel(damping=0.006, friction=0.12, armature=2e-5, effort=1.2)
"""Turn of a knob with firm detents, such as that of a selector: 0.1-0.15 N m in catalogs of cam
switches."""

HINGE = Feel(damping=0.25, friction=0.15, effort=60.0, velocity=5.0)
"""Hinge of a furniture or cabinet door of 2-8 kg that stays where it is left: friction of some tenths of a
newton meter; EN 15570 tests such hinges at 60 N m and below."""

PIVOT = Feel(damping=0.002, friction=0.004, armature=1e-5, effort=5.0)
"""Hinge of a light flap, cap or lid of some grams that falls by its weight."""

LEVER = Feel(damping=0.02, friction=0.05, armature=2e-4, effort=12.0, velocity=8.0)
"""Spindle of a door handle with a return spring of 1-3 N m (EN 1906: the torque that opens is at most 2.4
N m)."""

LATCH = Feel(damping=4.0, friction=0.5, armature=0.05, effort=60.0)
"""Bolt of a latch with a spring of 2-12 N (EN 12209: at most 50 N close a door with its latch)."""

RUNNER = Feel(damping=12.0, friction=2.5, effort=80.0)
"""Runner of a drawer on balls or rollers: 2-5 N move a drawer of 5 kg; EN 15338 allows 50 N to open it."""

GAS_SPRING = Feel(damping=40.0, friction=20.0, armature=0.2, effort=900.0, velocity=0.3)
"""Slide of a gas spring: friction of 10-40 N, and 0.15-0.3 m/s by its oil (catalogs of 200-400 N
springs)."""

CASTER = Feel(damping=0.001, friction=0.005, armature=1e-5, effort=20.0, velocity=60.0)
"""Axle or swivel of a furniture caster: EN 12529 asks for a rolling resistance of at most a fiftieth of
its load."""
