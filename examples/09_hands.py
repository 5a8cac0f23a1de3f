"""Tell where hands act: a handle that a gripper holds, a button that a finger pushes, and prove it."""

import artgen
from artgen import Body, Float, Prismatic, X, Y, Z, box, cylinder, grasp_on, material, part, push_on


@artgen.category(labels=("body", "drawer", "handle", "button"))
def till(*, width: Float = artgen.uniform(0.30, 0.45), bar: Float = artgen.uniform(0.005, 0.009)) -> Body:
    """A drawer with a bar handle, and a button above it."""
    steel, black = material("stainless"), material("black_abs")
    case = box(width, 0.35, 0.20).at(0, 0, 0.10) - box(width - 0.02, 0.34, 0.11).at(0, -0.01, 0.07)
    case = case - cylinder(0.0125, 0.04, axis=Y).at(0, -0.17, 0.165)

    # a level bar on the front: the hand comes along +y (the default) and closes along z
    tray = box(width - 0.026, 0.32, 0.104).at(0, -0.015, 0.07)
    grip = cylinder(bar, 0.16, axis=X).at(0, -0.22, 0.07)
    posts = artgen.array(cylinder(0.004, 0.05, axis=Y), at=[(-0.06, -0.197, 0.07), (0.06, -0.197, 0.07)])
    handle = part(grip | posts, "handle", steel, grasp=grasp_on(grip, closing=Z))
    drawer = artgen.weld(part(tray, "drawer", steel), handle)
    slide = Prismatic("slide", axis=-Y, limits=(0, 0.25), friction=2.0, damping=5.0)

    # a button that is pressed in by 4 mm
    cap = cylinder(0.012, 0.018, axis=Y).at(0, -0.174, 0.165)
    button = part(cap, "button", black, push=push_on(cap))
    press = Prismatic("press", axis=Y, limits=(0, 0.004), stiffness=400.0, damping=2.0)
    return part(case, "body", black).attach(drawer, slide).attach(button, press)


asset = till.generate(3)
for each in asset.affordances:
    at = ", ".join(f"{1000 * number:.0f}" for number in each.frame[:3, 3])
    print(f"{each.kind} {each.name} at ({at}) mm, opened {1000 * each.width:.1f} mm, moves {each.joints[0]}")
report = asset.validate(behavior=False)
print(next(result for result in str(report).splitlines() if result.startswith("grasps")))
