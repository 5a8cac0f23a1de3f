"""Allowed contacts between pieces."""

from dataclasses import replace

from artgen import asset as values
from artgen.asset import AllowedContact, Link, Tree
from artgen.asset.link import MovedLink
from artgen.errors import nearest
from artgen.graph import kernel
from artgen.nodes.condition import Condition
from artgen.nodes.handles import Body, Scalar
from artgen.nodes.validators import finite

Place = tuple[str, str]
"""A link and a label of solid pieces on it."""


@kernel
def _allow_contact(
    body: Tree, a: str, b: str, depth: float, reason: str, when: values.AssetCondition | None
) -> Tree:
    if finite("depth", depth) < 0.0:
        raise ValueError(f"depth must not be negative, got {depth:.6g} m; 0 allows them to touch")
    if not reason.strip():
        raise ValueError(f"the contact of {a!r} with {b!r} has no reason; say why they may touch")
    found: dict[frozenset[Place], AllowedContact] = {}
    first, second = _places(body, a), _places(body, b)
    for one in first:
        for other in second:
            if one[0] != other[0]:
                links, labels = (one[0], other[0]), (one[1], other[1])
                contact = AllowedContact(links, labels, depth, reason.strip(), when)
                found.setdefault(frozenset((one, other)), contact)
    if not found:
        raise ValueError(
            f"{a!r} and {b!r} are both on link {first[0][0]!r} and on no other; pieces of one link never "
            "move against each other: name pieces of two links"
        )
    return replace(body, contacts=(*body.contacts, *found.values()))


def allow_contact(
    body: Body, a: str, b: str, *, depth: Scalar, reason: str = "", when: Condition | None = None
) -> Body:
    """Allow contact between pieces of two links of a body; see `Body.allow_contact`."""
    return body.allow_contact(a, b, depth=depth, reason=reason, when=when)


def _places(body: Tree, name: str) -> list[Place]:
    """Return the links and labels of `label` or `link/label` in a body, at least one."""
    labels = {link.name: _solid_labels(link) for link in body.links()}
    link, slash, label = name.rpartition("/")
    if slash:
        if link not in labels:
            raise ValueError(f"{name!r}: this body has no link {link!r}.{nearest(link, labels)}")
        if label not in labels[link]:
            options = nearest(label, labels[link])
            raise ValueError(f"{name!r}: link {link!r} has no solid labelled {label!r}.{options}")
        return [(link, label)]
    found = [(each, name) for each, carried in labels.items() if name in carried]
    if not found and name in labels:
        raise ValueError(
            f"{name!r} is a link, and contacts are declared per labelled piece; write "
            + " or ".join(f"'{name}/{each}'" for each in labels[name])
        )
    if not found:
        every = {each for carried in labels.values() for each in carried}
        raise ValueError(f"no solid of this body is labelled {name!r}.{nearest(name, every)}")
    return found


def _solid_labels(link: Link) -> tuple[str, ...]:
    """Return the labels of a link's solids, without visual details."""
    while isinstance(link, MovedLink):  # accessing its own pieces would move them all
        link = link.source
    return tuple(dict.fromkeys(piece.label for piece in link.pieces if not piece.visual))
