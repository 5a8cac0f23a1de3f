"""Write a category of your own: a wooden box with a hinged lid."""

from artgen import Body, Float, Revolute, X, box, category, material, part, uniform


@category(labels=("box", "lid"))
def keepsake_box(
    *,
    width: Float = uniform(0.15, 0.40, "m", doc="outside, along x"),
    depth: Float = uniform(0.10, 0.30, "m", doc="outside, along y"),
    height: Float = uniform(0.06, 0.20, "m", doc="without the lid"),
    wall: Float = uniform(0.006, 0.010, "m"),
) -> Body:
    """A box with a lid that is hinged at the back."""
    outside = box(width, depth, height, bevel=0.001).at(z=height / 2)
    inside = box(width - 2 * wall, depth - 2 * wall, height).at(z=height / 2 + wall)
    lid = box(width, depth, wall, bevel=0.001).at(z=height + wall / 2 + 0.001)  # a gap of 1 mm
    hinge = Revolute(
        "lid_hinge", axis=-X, pivot=lid.anchor(y=1, z=-1), limits=(0, 1.9), friction=0.05, damping=0.01
    )
    body = part(outside - inside, "box", material("walnut"))
    return body.attach(part(lid, "lid", material("walnut")), hinge)


for seed in range(3):
    asset = keepsake_box.generate(seed)
    x, y, z = asset.bounds()[1] - asset.bounds()[0]
    print(f"{asset.name}: {x:.3f} x {y:.3f} x {z:.3f} m, {asset.mass:.2f} kg")
    asset.export(f"out/{asset.name}")
