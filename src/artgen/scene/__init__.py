"""Scenes: rooms of articulated assets, placed by relations and proven as one asset.

A scene is an asset whose base is the room, so that a scene can do all that an asset can: export, rendering,
valid states, simulation. `Scene` places assets one after another; `kitchen` draws a whole room from a seed.
"""

from artgen.scene.kitchens import kitchen
from artgen.scene.room import Placement, Scene, Wall
from artgen.scene.rooms import ROOMS, Room, bathroom, hall, living_room, office, workshop

__all__ = [
    "ROOMS", "Placement", "Room", "Scene", "Wall", "bathroom", "hall", "kitchen", "living_room", "office",
    "workshop",
]  # fmt: skip
