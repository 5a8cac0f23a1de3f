"""The record of an asset at its place in a room."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from artgen._arrays import Array, FrozenArrays, Pose, cached_property
from artgen.asset.certificate import Certificate
from artgen.asset.record import Record, json_text, plain, rounded

if TYPE_CHECKING:
    from artgen.asset import Asset


@dataclass(frozen=True, eq=False)
class PlacedAsset(FrozenArrays, Record):
    """An asset at its place in a room.

    Its links and joints have its name and an underscore before their own names in the room.

    Attributes:
        name: Its name in the room.
        category: Its category, or the kind of a body without joints, such as `worktop`.
        seed: Seed of its parameters; None for bodies of the room.
        attempt: Number of infeasible draws before it.
        parameters: Value of every parameter by name.
        pose: Its place in the room, shape (4, 4) [m].
        carrier: Name of the link of the room that carries it.
        free: Whether it is a free body in simulation.
        certificate: Digest of the certificate of the asset alone; empty if it has none.
    """

    name: str
    category: str
    seed: int | None
    attempt: int
    parameters: Mapping[str, Any]
    pose: Pose
    carrier: str = ""
    free: bool = False
    certificate: str = ""

    @staticmethod
    def of(
        asset: "Asset", name: str, pose: Array, carrier: str = "", *, free: bool = False, digest: str = ""
    ) -> "PlacedAsset":
        """Return the record of an asset at a pose, shape (4, 4), with the digest of its certificate."""
        parameters = _Parameters(asset)
        return PlacedAsset(
            name, asset.category, asset.seed, asset.attempt, parameters, pose, carrier, free, digest
        )


class _Parameters(Mapping[str, Any]):
    """The rounded parameters of an asset, found on the first access: they may take a graph per option."""

    def __init__(self, asset: "Asset") -> None:
        self._asset = asset

    @cached_property
    def _found(self) -> dict[str, Any]:
        return dict(rounded(plain(self._asset.parameters)))

    def __getitem__(self, name: str) -> Any:
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __repr__(self) -> str:
        return repr(self._found)

    def __reduce__(self) -> tuple[type, tuple[dict[str, Any]]]:
        return dict, (self._found,)


def place_of(name: str) -> str:
    """Return the name of the locked joint that holds an asset of a room at its place."""
    return f"{name}_place"


def owners_of(asset: "Asset") -> dict[str, str]:
    """Return the name of the placed asset of every link of a room; empty for the room itself."""
    owners = {asset.links[0].name: ""}
    places = {place_of(each.name): each.name for each in asset.placed}
    for joint in asset.joints:
        owners[joint.child] = places.get(joint.name, owners[joint.parent])
    return owners


def certificate_digest(certificate: Certificate | None) -> str:
    """Return the SHA-256 of a certificate as `asset.json` has it, in hexadecimal; empty if there is none."""
    if certificate is None:
        return ""
    return hashlib.sha256(json_text(rounded(certificate.to_data())).encode()).hexdigest()
