"""Scenes: rooms of articulated assets, placed by relations and proven as one asset.

A scene is an asset whose base is the room, so that a scene can do all that an asset can: export, rendering,
valid states, simulation. `Scene` places assets one after another; `kitchen`, `bathroom`, `office`, `workshop`
and `hall` draw a whole room from a seed.
"""

from artgen.scene.kitchens import kitchen
from artgen.scene.room import Placement, Scene, Wall
from artgen.scene.rooms import bathroom, hall, office, workshop

__all__ = ["ROOMS", "Placement", "Scene", "Wall", "bathroom", "hall", "kitchen", "office", "workshop"]

ROOMS = {"kitchen": kitchen, "bathroom": bathroom, "office": office, "workshop": workshop, "hall": hall}
"""Rooms that are drawn from a seed, by name."""
