"""From an evaluated body to the links, joints and contacts of an asset, which must fit together."""

from collections.abc import Mapping
from dataclasses import replace

from artgen.asset.contact import AllowedContact
from artgen.asset.joint import Joint, positions_of_followers
from artgen.asset.link import Link
from artgen.asset.tree import Tree, check_contact
from artgen.errors import AssetError, nearest


def assembled(tree: Tree) -> tuple[tuple[Link, ...], tuple[Joint, ...], tuple[AllowedContact, ...]]:
    """Return the links, the joints and the contacts by design of a body; coupled joints get their ranges."""
    links = tuple(tree.links())
    for link in links:
        if all(piece.visual for piece in link.pieces):
            raise AssetError(
                f"link {link.name!r} is made of details only, which have no mass; weld them to a part",
                link=link.name,
            )
    joints = {joint.name: joint for joint in tree.joints()}
    for joint in joints.values():
        _check_references(joint, joints)
    leaders = positions_of_followers(
        joints, {joint.name: 0.0 for joint in joints.values() if joint.follows is None}
    )
    assert len(leaders) == len(joints)
    ranged = tuple(_with_followed_limits(joint, joints) for joint in joints.values())
    contacts = tuple(tree.all_contacts())
    for contact in contacts:
        check_contact(contact, [link.name for link in links], joints)
    return links, ranged, contacts


def _check_references(joint: Joint, joints: Mapping[str, Joint]) -> None:
    named = [("follows", joint.follows.leader)] if joint.follows is not None else []
    if joint.needs is not None:
        named += [("needs", name) for name in joint.needs.condition.joints()]
    others = [other for other in joints if other != joint.name]
    for verb, name in named:
        if name not in joints:
            raise AssetError(
                f"joint {joint.name!r} {verb} {name!r}, which is no joint of this asset; "
                f"attach {name!r} as well.{nearest(name, others)}",
                joint=joint.name,
            )
        if name == joint.name:
            raise AssetError(f"joint {joint.name!r} {verb} itself; name another joint", joint=joint.name)


def _with_followed_limits(joint: Joint, joints: Mapping[str, Joint]) -> Joint:
    """Give a coupled joint the range over which its leader takes it."""
    if joint.follows is None:
        return joint
    leader = _with_followed_limits(joints[joint.follows.leader], joints)
    if leader.limits is None:
        return replace(joint, limits=None)
    ends = sorted(joint.follows.ratio * end + joint.follows.offset for end in leader.limits)
    return replace(joint, limits=(ends[0], ends[1]))
