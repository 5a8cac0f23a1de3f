"""Generate a door from a seed, look at what moves, and write it for every simulator."""

import artgen

asset = artgen.generate("door", seed=7)

print(f"{asset.name}: {len(asset.links)} links, {asset.mass:.1f} kg")
for joint in asset.joints:
    limits = "unlimited" if joint.limits is None else "{:.3f} to {:.3f}".format(*joint.limits)
    print(f"  {joint.name}: {joint.kind}, {joint.parent} -> {joint.child}, {limits}")

# the same door, but with its handle lower: nothing else changes
lower = artgen.generate("door", seed=7, handle_height=0.9)
changed = {name for name, value in lower.parameters.items() if value != asset.parameters[name]}
print(f"changed: {', '.join(sorted(changed))}")

directory = asset.export("out/door_7", formats=("urdf", "mjcf", "usd"))
print(f"written to {directory}: {', '.join(sorted(path.name for path in directory.glob('door_7*')))}")
