"""A picture of an open door with the mask of its handle, as an image data set wants them."""

import sys
from pathlib import Path

import artgen
from artgen.errors import RenderError

door = artgen.generate("door", seed=7, opener="lever")
Path("out").mkdir(exist_ok=True)

try:
    picture = door.render({"door_hinge": 0.7}, size=(480, 640))
except RenderError as error:  # no MuJoCo or no OpenGL on this machine: the message says what to install
    print("no picture:", error)
    sys.exit()

print(picture.save("out/door.png"))
print("the handle covers", int(picture.links.mask("handle").sum()), "pixels")
print(f"the nearest point is {picture.depth.min():.2f} m away")
