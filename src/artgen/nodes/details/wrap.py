"""Print around turned solids: a profile bent onto the outline of a lathe."""

import math

import numpy as np

from artgen._arrays import Array
from artgen.asset.shape import Curve, Outline, Shape
from artgen.colliders import Pieces
from artgen.graph import records
from artgen.materials import Material
from artgen.nodes import validators as inputs
from artgen.nodes.body import detail
from artgen.nodes.contours import refined
from artgen.nodes.details.relief import prisms
from artgen.nodes.handles import Body, Path, Profile, Scalar, Solid
from artgen.nodes.primitive_colliders import around_hull
from artgen.nodes.surfaces import Skin

_STEP = 0.10  # angle that one straight side of the print may span [rad]


def _wrap(profile: Outline, path: Curve, height: float, proud: float) -> Shape:
    inputs.positive("proud", proud)
    line = path.points[:, [0, 2]]
    line = line[np.argsort(line[:, 1], kind="stable")]
    plan = np.concatenate([contour.points for contour in profile.contours])
    low, high = height + plan[:, 1].min(), height + plan[:, 1].max()
    if low < line[0, 1] or high > line[-1, 1]:
        raise ValueError(
            f"the print reaches from {low:.4g} to {high:.4g} m, the line only from {line[0, 1]:.4g} to "
            f"{line[-1, 1]:.4g} m"
        )
    radius = float(np.interp(height, line[:, 1], line[:, 0]))
    wide = float(np.abs(plan[:, 0]).max())
    if wide > math.pi * radius:
        raise ValueError(f"the print is {2.0 * wide:.4g} m wide, more than once around {radius:.4g} m")
    bent = prisms(refined(profile, _STEP * radius).contours, 2.0 * proud)
    vertices, normals = _bent(bent, line, radius, height)
    skin = Skin(vertices, normals, bent.uvs, bent.triangles, bent.targets)
    # pieces of visual details: none
    return skin.shape(Pieces(around_hull(vertices).outer, lambda tolerance: ()))


def _bent(flat: Skin, line: Array, radius: float, height: float) -> tuple[Array, Array]:
    """Return vertices and normals of a flat print, outward along z, bent onto the outline of a lathe."""
    across, up, out = flat.vertices.T
    level = height + up
    angle = across / radius - math.pi / 2.0
    here = np.interp(level, line[:, 1], line[:, 0]) + out
    cosine, sine = np.cos(angle), np.sin(angle)
    vertices = np.column_stack([here * cosine, here * sine, level])
    x, y, z = flat.normals.T
    normals = np.column_stack([z * cosine - x * sine, z * sine + x * cosine, y])
    return vertices, normals


@records(_wrap)
def wrap(profile: Profile, path: Path, height: Scalar, *, proud: Scalar = 0.0002) -> Solid:
    """Bend a profile onto a turned solid, readable from the front.

    Args:
        profile: The profile; its x points to the reader's right and its y upward.
        path: Outline that was turned about z, as for `half_section`; it must cover the height of the print.
        height: Height of the profile's origin on the outline [m].
        proud: Height above the surface and depth below it [m].

    Examples:
        >>> around = line((0.04, 0, 0), (0.04, 0, 0.1))
        >>> cylinder(0.04, 0.1).at(z=0.05) | details.wrap(text("MILK", 0.009), around, 0.05, proud=0.001)
    """


def wrapped(
    profile: Profile,
    path: Path,
    height: Scalar,
    *,
    material: Material,
    label: str = "print",
    proud: Scalar = 0.0002,
) -> Body:
    """Print a profile around the front of a turned solid: a visual film of ink.

    Args:
        profile: The profile, such as `text("Salt", 0.006)`.
        path: Outline that was turned about z, as for `half_section`.
        height: Height of the profile's origin on the outline [m].
        material: Material of the ink.
        label: Semantic label.
        proud: Height of the ink above the surface and depth below it [m].

    Examples:
        >>> around = line((0.04, 0, 0), (0.04, 0, 0.1))
        >>> can = part(cylinder(0.04, 0.1).at(z=0.05), "can", material("steel"))
        >>> weld(can, details.wrapped(text("MILK", 0.009), around, 0.05, material=material("copper")))
    """
    return detail(wrap(profile, path, height, proud=proud), label, material, reads=(1.0, 0.0, 0.0))
