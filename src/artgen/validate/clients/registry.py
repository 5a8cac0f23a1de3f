"""All clients."""

from collections.abc import Mapping, Sequence

from artgen.errors import ParameterError, nearest
from artgen.validate.clients.client import Client
from artgen.validate.clients.robosuite import ROBOSUITE
from artgen.validate.clients.sapien import SAPIEN
from artgen.validate.clients.urdf import URDF
from artgen.validate.clients.usd import USD

CLIENTS: Mapping[str, Client] = {client.name: client for client in (*URDF, *SAPIEN, *ROBOSUITE, *USD)}
"""Every client by its name."""

ALL = "all"
"""The word for all of them."""


def chosen_clients(names: str) -> tuple[Sequence[Client], bool]:
    """Return the clients that a text names, such as `all` or `pybullet,drake_urdf`, each once."""
    words = list(dict.fromkeys(word for part in names.split(",") if (word := part.strip())))
    if not words:
        raise ParameterError(f"{names!r} names no client; give {ALL!r} or some of: {', '.join(CLIENTS)}")
    for word in words:
        if word not in (ALL, *CLIENTS):
            raise ParameterError(f"there is no client {word!r}.{nearest(word, [ALL, *CLIENTS])}")
    if ALL in words:
        return tuple(CLIENTS.values()), False
    return tuple(CLIENTS[word] for word in words), True
