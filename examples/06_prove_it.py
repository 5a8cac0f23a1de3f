"""A proof that nothing collides anywhere in the joint ranges, and what it says where something does."""

import artgen
from artgen import Body, Float, Prismatic, Y, box, category, material, part, uniform


@category(labels=("carcass", "drawer", "stop"))
def shelf(*, gap: Float = uniform(0.002, 0.004, "m"), reach: Float = uniform(0.15, 0.25, "m")) -> Body:
    """A drawer in a carcass, with a stop in front of it where it may not be."""
    oak = material("oak")
    carcass = part(box(0.5, 0.4, 0.3) - box(0.46, 0.4, 0.26).at(0, -0.02), "carcass", oak)
    stop = part(box(0.04, 0.04, 0.3).at(0, -0.42), "stop", oak, name="post")
    drawer = part(box(0.46 - 2 * gap, 0.37, 0.26 - 2 * gap).at(0, -0.01), "drawer", oak)
    fixed = Prismatic("post_slide", axis=Y, limits=(-0.2, 0.0))
    return carcass.attach(drawer, Prismatic("slide", axis=-Y, limits=(0, reach))).attach(stop, fixed)


asset = shelf.generate(seed=3, on_collision="keep")  # by default a sample that collides is drawn again
print(asset.certificate)

limits = asset.safe_limits()
print("safe:", {name: tuple(round(end, 4) for end in ends) for name, ends in limits.items()})
print("apart at rest:", {pair: round(gap, 4) for pair, gap in asset.clearance().items()})

shorter = shelf.generate(seed=3, reach=0.15, gap=0.003)
certificate = shorter.certify(measure=True)
for pair in certificate.pairs:
    print(pair, "" if pair.found is None else f"(found {1e3 * pair.found:.3f} mm)")

door = artgen.generate("door", seed=7)  # certified when it was generated
print(f"door: {str(door.certificate).splitlines()[0]}")
report = door.validate(behavior=False)  # everything on exported files; `artgen validate` prints a table
print("door:", ", ".join(f"{result.check} {len(result.faults)}" for result in report.results))
