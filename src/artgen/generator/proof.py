"""Generated samples are proven free of collisions, or drawn again."""

from typing import Any, Literal, get_args

from artgen.asset import Asset
from artgen.errors import CheckError, InfeasibleError, ParameterError
from artgen.sampling.distributions import is_number

OnCollision = Literal["redraw", "fail", "keep"]
"""What becomes of a sample whose links are not proven apart."""


def check_proof(certify: Any, tolerance: Any, on_collision: Any) -> None:
    """Check what a caller asks of the proof.

    Raises:
        ParameterError: One of the values is not allowed.
    """
    if not isinstance(certify, bool):
        raise ParameterError(f"certify = {certify!r} is not allowed: it must be True or False")
    if not is_number(tolerance) or tolerance < 0.0:
        raise ParameterError(
            f"tolerance = {tolerance!r} is not allowed: it is the clearance to prove, a number of metres "
            "that is not negative"
        )
    if on_collision not in get_args(OnCollision):
        allowed = ", ".join(map(repr, get_args(OnCollision)))
        raise ParameterError(f"on_collision = {on_collision!r} is not allowed: it must be one of {allowed}")


def certify_sample(asset: Asset, tolerance: float, on_collision: OnCollision) -> None:
    """Prove that the links of an asset never collide.

    Raises:
        InfeasibleError: It is not proven, and another sample is to be drawn.
        CheckError: It is not proven, and that is a failure.
    """
    certificate = asset.certify(tolerance)
    if certificate.proven or on_collision == "keep":
        return
    if on_collision == "redraw":
        raise InfeasibleError(str(certificate))
    error = CheckError(f"{asset.name}: {certificate}")
    error.add_note(
        'on_collision="keep" returns the asset all the same, to look at; asset.safe_limits() tells how far '
        "its joints may go"
    )
    raise error
