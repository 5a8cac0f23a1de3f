"""Whether a client told all that it has to tell: what it leaves out cannot be compared."""

from collections.abc import Iterator, Mapping
from typing import Any

from artgen.asset.report import Finding
from artgen.validate.clients.client import Client
from artgen.validate.clients.exported import Exported

_OF_LINKS = ("mass", "center", "inertia")
_OF_JOINTS = ("kind", "limits")


def silences(client: Client, exported: Exported, response: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield what is missing in a client's answer, as a whole, of a link or of a joint.

    A key of `Client.tells` such as `joints.damping` is a quantity of each joint. A client that tells of
    links has to tell masses, centres and inertias, one that tells of joints their kinds and limits.
    """
    whole = [key for key in client.tells if "." not in key]
    missing = [key for key in whole if key not in response]
    if missing:
        yield Finding(client.name, f"it tells nothing of {', '.join(missing)}")
    required = {"links": [*_OF_LINKS], "joints": [*_OF_JOINTS]}
    for part, _, quantity in (key.partition(".") for key in client.tells if "." in key):
        required[part].append(quantity)
    for part, quantities in required.items():
        for name, read in response.get(part, {}).items() if part in whole else ():
            lost = [
                quantity
                for quantity in quantities
                if quantity not in read and f"{part}.{quantity}" not in client.withholds
            ]
            if lost:
                where = {"link" if part == "links" else "joint": name}
                yield Finding(client.name, f"it does not tell its {', '.join(lost)}", **where)
    if "moved" in client.tells and "moved" in response:
        yield from _unmoved(client, exported, response["moved"])
    if "steps" in client.tells and not response.get("steps", 1) > 0:
        yield Finding(client.name, "it simulated no steps")


def _unmoved(client: Client, exported: Exported, moved: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield the joints that were not driven, but for those that others keep where they are."""
    for joint in exported.asset.free_joints:
        if joint.name not in moved and not exported.is_blocked(joint):
            yield Finding(client.name, "it was not driven in simulation", joint=joint.name)
