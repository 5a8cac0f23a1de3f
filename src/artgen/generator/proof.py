"""Generated samples are proven free of collisions, or drawn again."""

from typing import Any, Literal, get_args

from artgen.asset import Asset
from artgen.asset.certificate import MOST_TOLERANCE
from artgen.errors import CheckError, InfeasibleError, ParameterError
from artgen.sampling.distributions import is_number

OnCollision = Literal["redraw", "fail", "keep"]
"""What becomes of a sample whose links are not proven apart."""


_REMEDY = (
    "give the parts more clearance, or declare a contact by design with body.allow_contact(...); "
    'on_collision="keep" returns the asset all the same, and its safe_limits() tell how far its joints may go'
)


def check_proof(certify: Any, tolerance: Any, on_collision: Any) -> None:
    """Check what a caller asks of the proof."""
    if not isinstance(certify, bool):
        raise ParameterError(f"certify = {certify!r} is not allowed: it must be True or False")
    if not is_number(tolerance) or not 0.0 <= tolerance <= MOST_TOLERANCE:
        raise ParameterError(
            f"tolerance = {tolerance!r} is not allowed: it is the clearance to prove, a number of metres "
            f"(not mm) that is not negative and at most {MOST_TOLERANCE:g}"
        )
    if on_collision not in get_args(OnCollision):
        allowed = ", ".join(map(repr, get_args(OnCollision)))
        raise ParameterError(f"on_collision = {on_collision!r} is not allowed: it must be one of {allowed}")


def certify_sample(asset: Asset, tolerance: float, on_collision: OnCollision) -> None:
    """Prove that the links of an asset never collide."""
    certificate = asset.certify(tolerance)
    if certificate.proven or on_collision == "keep":
        return
    if on_collision == "redraw":
        raise InfeasibleError(f"{certificate}\n  {_REMEDY}")
    raise CheckError(f"{asset.name}: {certificate}\n  {_REMEDY}")
