"""Whether a link has a mass that its solids can have: their volume times the densities of its materials."""

from collections.abc import Iterator

from manifold3d import Manifold, OpType

from artgen.asset import Link
from artgen.asset.report import Finding
from artgen.asset.stored_solids import link_parts

_CHECK = "solids"
_ROUNDING = 1e-3  # relative; meshes in files are rounded to 0.1 micrometre


def weight_findings(link: Link) -> Iterator[Finding]:
    """Yield a mass that is more or less than any share of the link's materials gives its volume.

    Where all solids of a link have one density there is no leeway.
    """
    parts = link_parts(link)
    if not parts:
        return
    volume = Manifold.batch_boolean([part.solid for part in parts], OpType.Add).volume()
    labels = {part.label for part in parts}
    densities = {part.material.density for part in parts}
    densities |= {surface.material.density for surface in link.surfaces if surface.label in labels}
    least, most = (density * volume for density in (min(densities), max(densities)))
    mass = link.mass_properties.mass
    if not least * (1.0 - _ROUNDING) <= mass <= most * (1.0 + _ROUNDING):
        span = f"{least:.5g}" if least == most else f"{least:.5g} to {most:.5g}"
        message = f"its mass is {mass:.5g} kg, but its solids of {1e6 * volume:.5g} cm^3 weigh {span} kg"
        yield Finding(_CHECK, message, link.name, value=mass, unit="kg", hint="export the asset again")
