"""Behind closed doors: a refrigerator's drawers wait for its doors, and its certificate knows."""

import artgen
from artgen.validate.hands.motion import hand_forces

fridge = artgen.generate("refrigerator", seed=3, layout="bottom_freezer", outer_drawers=1, crispers=1)
door, drawer = fridge.joint("door_hinge"), fridge.joint("inner_drawer_slide_0")
assert door.limits is not None
assert drawer.limits is not None

print(f"{fridge.name}: {fridge.mass:.0f} kg, {len(fridge.links)} links; {fridge.certificate}")
print(f"{drawer.name} needs {drawer.needs}")

out = {drawer.name: drawer.limits[1]}
print("blocked while the door is closed:", fridge.blocked(out))
print("blocked when it is open:", fridge.blocked({**out, door.name: door.limits[1]}))
assert fridge.blocked(out) == (drawer.name,)
assert fridge.blocked({**out, door.name: door.limits[1]}) == ()

for name, force in hand_forces(fridge).items():
    print(f"a hand moves {name} with {force:.0f} N")
