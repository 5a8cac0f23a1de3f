"""Draw docs/family.jpg: a room with a product of each category, many open. `make sheets` runs it."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from artgen import box
from artgen.asset.shape import Mesh
from artgen.catalog import find
from artgen.graph.evaluation import evaluate
from artgen.materials import Material, material
from artgen.view import Camera, opened
from artgen.view.shading import colors
from artgen.view.sheet import save_sheet
from artgen.view.studio import Backdrop, ribbon
from artgen.view.tracing import World

DOCS = Path(__file__).parents[1] / "docs"
_RADIUS = 3.6  # size of the scene for the lamps [m]
_CENTER = np.array([1.6, -0.4, 1.0])
_CAMERA = Camera((1.3, -12.4, 2.2), (1.72, 0.0, 1.0), 0.31)
_WORKTOP, _THICK = 0.885, 0.035  # height of what stands below a worktop, and its thickness [m]
_TOP = _WORKTOP + _THICK
_SAMPLES, _TEXELS = 32, 1024


@dataclass(frozen=True)
class Placed:
    """A product in the room; its back is at a distance from the wall."""

    category: str
    seed: int
    x: float  # of its middle [m]
    z: float = 0.0  # of its lowest point [m]
    gap: float = 0.01  # between its back and the wall [m]
    share: float = 0.0  # how far it is open
    turn: float = 0.0  # about its vertical axis [rad]

    def surfaces(self) -> list[tuple[Mesh, Material]]:
        """Return its posed surfaces, the wall at y = 0."""
        asset = find(self.category).generate(self.seed, certify=False)
        low, high = asset.bounds()
        poses = asset.pose(opened(asset, self.share))
        cosine, sine = math.cos(self.turn), math.sin(self.turn)
        matrix = np.eye(4)
        matrix[:2, :2] = [[cosine, -sine], [sine, cosine]]
        corners = np.array([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])
        back = (corners @ matrix[:2, :2].T)[:, 1].max()
        middle = matrix[:2, :2] @ ((low + high) / 2.0)[:2]
        matrix[:3, 3] = self.x - middle[0], -self.gap - back, self.z - low[2]
        return [
            (surface.mesh.moved(matrix @ poses[link.name]), surface.material)
            for link in asset.links
            for surface in link.surfaces
        ]


ROOM = (
    Placed("door", 4, -2.80),
    Placed("refrigerator", 3, -1.72, share=0.75, gap=0.03),
    Placed("washing_machine", 4, -0.84, gap=0.02, share=0.6),
    Placed("dishwasher", 7, -0.2, share=0.55),
    Placed("oven", 0, 0.42, z=0.25, share=0.75),
    Placed("cabinet", 7, 1.07, share=0.0),
    Placed("faucet", 1, -0.22, z=_TOP, gap=0.12),
    Placed("soap_dispenser", 7, 0.0, z=_TOP, gap=0.25, turn=0.3),
    Placed("cooktop", 3, 0.42, z=_TOP, gap=0.03),
    Placed("kettle", 4, 0.30, z=_TOP + 0.045, gap=0.12, share=0.0, turn=0.9),
    Placed("coffee_machine", 6, -0.47, z=_TOP, gap=0.14, turn=0.35),
    Placed("bottle", 3, -0.66, z=_TOP, gap=0.10, share=0.0),
    Placed("toaster", 3, -0.68, z=_TOP, gap=0.36, turn=0.3),
    Placed("pot", 1, 0.56, z=_TOP + 0.045, gap=0.34, share=0.0, turn=0.5),
    Placed("pepper_grinder", 3, 0.84, z=_TOP, gap=0.3),
    Placed("blender", 1, 0.96, z=_TOP, gap=0.14, share=0.0, turn=0.3),
    Placed("stand_mixer", 1, 1.22, z=_TOP, gap=0.06, share=0.6, turn=-0.5),
    Placed("window", 1, -0.62, z=1.22),
    Placed("range_hood", 4, 0.42, z=1.52, share=0.0),
    Placed("cabinet", 3, 1.4, z=1.42, share=0.8),
    Placed("drawer", 3, 2.24, share=1.0),
    Placed("rice_cooker", 0, 2.36, z=0.83, gap=0.03, share=0.0, turn=-0.2),
    Placed("microwave", 3, 1.88, z=0.83, gap=0.03),
    Placed("toaster_oven", 1, -0.93, z=_TOP, gap=0.03, turn=0.2),
    Placed("lamp", 2, 2.72, z=0.83, gap=0.03),
    Placed("scissors", 4, 2.34, z=0.83, gap=0.36, share=0.4, turn=-0.6),
    Placed("plier", 3, 2.56, z=0.83, gap=0.3, share=0.5, turn=0.9),
    Placed("table", 3, 3.98, gap=0.06),
    Placed("laptop", 8, 4.06, z=0.70, gap=0.22, share=0.9, turn=-0.15),
    Placed("display", 6, 3.56, z=0.70, gap=0.10, share=0.0, turn=0.05),
    Placed("printer", 1, 4.50, z=0.70, gap=0.10, share=0.0),
    Placed("stapler", 5, 4.08, z=0.70, gap=0.5, share=0.0, turn=0.7),
    Placed("keyboard", 9, 3.65, z=0.70, gap=0.36, share=0.0),
    Placed("mouse", 2, 3.89, z=0.70, gap=0.38, share=0.0, turn=-0.1),
    Placed("phone", 2, 4.36, z=0.70, gap=0.46, share=0.0, turn=-0.2),
    Placed("pen", 3, 3.98, z=0.70, gap=0.62, share=0.0, turn=0.4),
    Placed("usb_stick", 1, 4.22, z=0.70, gap=0.66, share=0.6, turn=0.3),
    Placed("clock", 5, 3.02, z=1.42),
    Placed("camera", 5, 3.37, z=0.70, gap=0.30, share=0.0, turn=0.3),
    Placed("knife", 11, 2.20, z=0.83, gap=0.40, share=0.6, turn=0.3),
    Placed("lighter", 1, 2.78, z=0.83, gap=0.30, share=0.7, turn=-0.4),
    Placed("remote", 3, 2.70, z=0.83, gap=0.34, share=0.0, turn=-0.8),
    Placed("eyeglasses", 8, 3.86, z=0.70, gap=0.58, share=1.0, turn=0.25),
    Placed("valve", 0, 3.36, z=0.70, gap=0.58, share=0.0, turn=-0.4),
    Placed("handle", 2, 3.84, z=0.70, gap=0.10, share=0.7),
    Placed("switch", 5, 4.42, z=0.70, gap=0.12, share=0.0, turn=-0.2),
    Placed("chair", 4, 4.22, gap=0.95, turn=2.7),
    Placed("trashcan", 0, 1.25, gap=0.75, share=0.7),
    Placed("box", 4, 2.2, gap=1.0, share=0.7, turn=-0.35),
    Placed("bucket", 8, 1.72, gap=0.85, share=0.0, turn=0.2),
    Placed("cart", 2, -2.62, gap=0.55, share=0.0, turn=0.35),
    Placed("safe", 5, 2.95, gap=0.85, share=0.6, turn=-0.3),
    Placed("globe", 4, 2.97, z=0.510, gap=1.0, share=0.0),
    Placed("suitcase", 1, 5.62, gap=0.95, share=0.0, turn=-0.3),
    Placed("fan", 1, 5.05, gap=0.2, turn=0.1),
    Placed("sink", 4, 5.62, gap=0.01),
    Placed("toilet", 1, 6.25, gap=0.01, share=0.5),
    Placed("shower", 11, 7.15, gap=0.01, share=0.5),
    Placed("grill", 9, -3.42, gap=0.75, share=0.0, turn=0.35),
    Placed("clothespin", 3, 3.98, z=0.70, gap=0.50, share=0.0, turn=0.6),
    Placed("syringe", 3, 4.30, z=0.70, gap=0.58, share=0.0, turn=0.2),
)


def main(
    *, out: Annotated[Path, typer.Option(help="JPEG or PNG.")] = DOCS / "family.jpg", width: int = 1900
) -> None:
    """Draw the picture, and print its path."""
    surfaces = [surface for placed in ROOM for surface in placed.surfaces()]
    surfaces += _joinery() + _room()
    world = World(surfaces, Backdrop("room", _CENTER, _RADIUS, 0.0, ()))
    size = (width, round(width * 0.31))
    typer.echo(save_sheet(colors(world, _CAMERA, size, _SAMPLES, _TEXELS), out))


def _joinery() -> list[tuple[Mesh, Material]]:
    """Return the worktop, the plinth of the oven, and the light outside of the window."""
    day = material("led_white").with_(name="day", emission=(0.75, 0.86, 1.0))
    worktop, white = material("marble"), material("lacquered_mdf")
    return [
        (_block((-1.15, -0.66, _WORKTOP), (1.43, 0.0, _TOP)), worktop),
        (_block((0.115, -0.58, 0.0), (0.725, 0.0, 0.24)), white),
        (_block((-1.23, -0.012, 1.3), (-0.01, -0.004, 2.08)), day),
    ]


def _room() -> list[tuple[Mesh, Material]]:
    """Return the floor and the wall."""
    columns = np.linspace(-9.0, 9.0, 91)
    rows = np.linspace(-9.0, 0.0, 46)
    heights = np.linspace(0.0, 6.0, 31)
    floor = np.column_stack([rows, 0.0 * rows])
    wall = np.column_stack([0.0 * heights, heights])
    paint = material("mdf").with_(
        name="wall", base_color=(0.5, 0.53, 0.5), texture="", specular_roughness=0.9
    )
    floorboards = material("ash").with_(name="floorboards", base_color=(0.56, 0.49, 0.4))
    return [
        (ribbon(floor, np.tile([0.0, 0.0, 1.0], (len(rows), 1)), columns), floorboards),
        (ribbon(wall, np.tile([0.0, -1.0, 0.0], (len(heights), 1)), columns), paint),
    ]


def _block(low: tuple[float, float, float], high: tuple[float, float, float]) -> Mesh:
    """Return a box between two corners."""
    size = np.subtract(high, low)
    middle = np.add(high, low) / 2.0
    matrix = np.eye(4)
    matrix[:3, 3] = middle
    mesh: Mesh = evaluate(box(*size.tolist())).value.mesh
    return mesh.moved(matrix)


if __name__ == "__main__":
    typer.run(main)
