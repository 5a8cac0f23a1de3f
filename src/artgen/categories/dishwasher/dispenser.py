"""The detergent dispenser inside the door of a dishwasher, with its sliding flap and a cap for rinse aid."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.dishwasher.space import DISH, Space

FLAP_TRAVEL = 0.036
"""How far the detergent flap slides [m]."""

_TAB = 0.011  # how far the tab of the flap stands out of the rim of the liner [m]
_ABOVE = 0.0032  # from the lower rack up to the tab, which would strike it [m]
_FACE = 0.002  # the dispenser lies behind the rim of the liner by this much [m]
_PLATE = 0.0034  # thickness of the flap [m]


@dataclass(frozen=True)
class Dispenser:
    """A dispenser on the liner of the door."""

    space: Space  # the measures of the machine
    rim: ag.Scalar  # height of the front rim of the lower rack [m]
    beside: ag.Scalar  # how far it is to the right of the middle [m]

    def housing(self) -> list[ag.Body]:
        """Make the housing on which the flap slides, with the cap of the rinse aid."""
        space = self.space
        face, floor = space.inner - _FACE, space.inner - DISH
        x, low, high = self.beside, self.rim - 0.042, self.rim + 0.075
        grey = ag.colored("abs", "light_grey").with_(name="dispenser_grey")
        housing = ag.board((x - 0.058, x + 0.058), (floor - 0.001, face), (low, high), bevel=0.004)
        cup = ag.rectangle(0.046, 0.036, radius=0.005)
        chamber = details.relief(
            cup, (x - 0.014, face, self.rim + _ABOVE + 0.022), facing=(0.0, 1.0, 0.0), proud=0.0003
        )
        dark = ag.colored("abs", "slate").with_(name="chamber_shade")
        cap = ag.cylinder(0.017, 0.0014, axis=ag.Y, bevel=0.0006).at(
            x + 0.036, face + 0.0004, self.rim + 0.040
        )
        arrow = details.icon("drop", 0.014)
        print_ = details.printed(
            arrow, (x + 0.036, face + 0.0012, self.rim + 0.040), material=dark, facing=(0.0, 1.0, 0.0)
        )
        guides = [
            ag.detail(
                ag.board(
                    (x - 0.014 + side * 0.030 - 0.0015, x - 0.014 + side * 0.030 + 0.0015),
                    (face - 0.001, face + 0.0028),
                    (low + 0.002, self.rim + _ABOVE + 0.046),
                    bevel=0.0006,
                ),
                "dispenser",
                grey,
            )
            for side in (-1, 1)
        ]
        return [
            ag.part(housing, "dispenser", grey),
            ag.detail(chamber, "dispenser", dark),
            ag.detail(cap, "rinse_cap", ag.colored("abs", "sky")),
            print_,
            *guides,
        ]

    def flap(self) -> ag.Body:
        """Make the detergent flap: a plate with a tab, by which fingers slide it."""
        space = self.space
        near = space.inner - _FACE + 0.0006
        x, low = self.beside - 0.014, self.rim + _ABOVE
        plate = ag.board((x - 0.027, x + 0.027), (near, near + _PLATE), (low, low + 0.044), bevel=0.001)
        tab = ag.board(
            (x - 0.017, x + 0.017), (near + 0.001, space.inner + _TAB), (low, low + 0.010), bevel=0.002
        )
        hold: ag.Frame = ag.frame(
            (x, space.inner + _TAB + 0.002, low + 0.005), approach=(0.0, -1.0, 0.0), closing=ag.Z
        )
        blue = ag.colored("abs", "light_grey").with_(name="flap_grey")
        return ag.weld(
            ag.part(plate, "detergent_flap", blue, grasp=hold, grasp_width=0.020),
            ag.part(tab, "detergent_flap", blue),
        )

    def slide(self, needs: ag.Condition | ag.Dependency) -> ag.Joint:
        """Make the joint of the flap, which a spring shuts."""
        preload, force = 1.2, 4.0  # a thumb slides it
        stiffness = (force - preload) / FLAP_TRAVEL
        return ag.Prismatic(
            "detergent_flap_slide",
            axis=-ag.Z,
            pivot=(self.beside, self.space.inner, self.rim),
            limits=(0.0, FLAP_TRAVEL),
            stiffness=stiffness,
            rest=-preload / stiffness,
            damping=8.0,
            friction=0.2,
            armature=0.05,
            effort=8.0,
            needs=needs,
        )

    @cached_property
    def slack(self) -> float:
        """How far the flap moves until its tab strikes the lower rack [m]."""
        return _ABOVE - 0.0006
