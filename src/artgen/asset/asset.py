"""The asset: a tree of links and joints with its parameters."""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from threading import Lock
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from artgen import _portable
from artgen._arrays import Array, cached_property
from artgen._names import ByName
from artgen.asset import summary
from artgen.asset.affordance import Affordance, affordance_data, affordances
from artgen.asset.certificate import Certificate
from artgen.asset.controller import Controller
from artgen.asset.coupling import AssetCoupling, AssetLoop
from artgen.asset.joint import (
    FEELS,
    AllowedContact,
    AssetJoint,
    is_number,
    joints_above,
    positions_of_followers,
)
from artgen.asset.link import Link, RepaintedLink, RoundedLink
from artgen.asset.mass import MassProperties, total
from artgen.asset.placed import PlacedAsset
from artgen.asset.record import json_text, plain, rounded
from artgen.asset.signals import AssetOutput, checked_outputs
from artgen.asset.tree import Tree, check_contact
from artgen.asset.valid_states import ValidStates
from artgen.errors import AssetError, CheckError, ParameterError, nearest
from artgen.materials import Material

if TYPE_CHECKING:
    from artgen import asset_methods


def _check_references(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> None:
    named = [("follows", joint.follows.leader)] if joint.follows is not None else []
    if joint.needs is not None:
        named += [("needs", name) for name in joint.needs.condition.joints()]
    others = [other for other in joints if other != joint.name]
    for verb, name in named:
        if name not in joints:
            raise AssetError(
                f"joint {joint.name!r} {verb} {name!r}, which is not a joint of this asset; "
                f"attach {name!r} as well.{nearest(name, others)}",
                joint=joint.name,
            )
        if name == joint.name:
            raise AssetError(f"joint {joint.name!r} {verb} itself; name another joint", joint=joint.name)


def _check_holds(link: Link, joints: Mapping[str, AssetJoint]) -> None:
    """Check that grasps and pushes of a link depend on joints of the asset."""
    for hold in (*link.grasps, *link.pushes):
        for name in hold.when.joints() if hold.when is not None else ():
            if name not in joints:
                raise AssetError(
                    f"{hold.name!r} is reached when {hold.when}, but {name!r} is not a joint of this asset; "
                    f"attach {name!r} as well.{nearest(name, joints)}",
                    link=link.name,
                )


def check_references(
    links: Sequence[Link],
    joints: Sequence[AssetJoint],
    contacts: Sequence[AllowedContact],
    loops: Sequence[AssetLoop] = (),
) -> None:
    """Check that couplings, dependencies, holds, contacts and loops name links and joints of an asset.

    Raises:
        AssetError: They do not, couplings form a circle, the joint of a contact does not move its links, or a
            condition or dependency is on a joint of a closed chain.
    """
    named = {joint.name: joint for joint in joints}
    for joint in joints:
        _check_references(joint, named)
    for link in links:
        _check_holds(link, named)
    free = {joint.name: 0.0 for joint in joints if joint.follows is None}
    positions_of_followers(named, free)  # refuses couplings that form a circle
    for contact in contacts:
        check_contact(contact, [link.name for link in links], named)
    for loop in loops:
        unknown = [name for name in loop.links if name not in {link.name for link in links}]
        unknown += [loop.joint] * (loop.joint not in named)
        if unknown:
            raise AssetError(f"a closed chain names {unknown[0]!r}, which this asset does not have")
    curved = {joint.name: joint for joint in joints if joint.follows and joint.follows.curve}
    if curved:
        _check_curved(curved, links, joints, contacts)


def _check_curved(
    curved: Mapping[str, AssetJoint],
    links: Sequence[Link],
    joints: Sequence[AssetJoint],
    contacts: Sequence[AllowedContact],
) -> None:
    """Check that curves cover the ranges of free joints, and that no condition is on a joint with a curve."""
    named = {joint.name: joint for joint in joints}
    for name, joint in curved.items():
        assert joint.follows is not None
        leader, curve = named[joint.follows.leader], joint.follows.curve
        assert curve is not None
        low, high = leader.limits or (-np.inf, np.inf)
        start, end = curve.range
        covered = curve.turns or (start - _CURVE_SLACK <= low and high <= end + _CURVE_SLACK)
        if leader.follows is not None or not (covered and start < end and curve.terms):
            raise AssetError(
                f"the curve of joint {name!r} does not cover the range of {leader.name!r}; declare the loop "
                f"after the limits of {leader.name!r} are set",
                joint=name,
            )
    whens = [(f"joint {each.name!r}", each.needs.condition) for each in joints if each.needs is not None]
    holds = [hold for link in links for hold in (*link.grasps, *link.pushes)]
    whens += [(f"{hold.name!r}", hold.when) for hold in holds if hold.when is not None]
    whens += [(f"the contact of {each.links}", each.when) for each in contacts if each.when is not None]
    names = [(user, name) for user, condition in whens for name in condition.joints()]
    names += [(f"joint {each.name!r}", each.name) for each in joints if each.needs is not None]
    for user, name in names:
        head = name
        while head not in curved and (law := named[head].follows) is not None:
            head = law.leader
        if head in curved:
            law = curved[head].follows
            assert law is not None
            raise AssetError(
                f"{user} has a condition with joint {name!r}, which moves with a closed chain; "
                f"put the condition on its input {law.leader!r}",
                joint=name,
            )


def with_followed_limits(joint: AssetJoint, joints: Mapping[str, AssetJoint]) -> AssetJoint:
    """Return a coupled joint with the limits that follow from the limits of its leader."""
    if joint.follows is None:
        return joint
    leader = with_followed_limits(joints[joint.follows.leader], joints)
    return replace(joint, limits=followed_limits(joint.follows, leader))


def followed_limits(law: AssetCoupling, leader: AssetJoint) -> tuple[float, float] | None:
    """Return the limits of a joint that follow from its law and the limits of its leader."""
    curve = law.curve
    if curve is None:
        return law.span(*leader.limits) if leader.limits is not None else None
    if leader.limits is None and abs(law.gain) >= _CURVE_SLACK:  # else it swings while its input turns
        return None
    # a series is less exact than this, and simulators warn if 0 is 1e-13 outside
    low, high = (round(end, _CURVE_DIGITS) + 0.0 for end in law.span(*(leader.limits or curve.range)))
    return low, high


Base = Literal["fixed", "free"]
Limits = Literal["full", "independent"]
"""Ranges of joints: full with dependencies, or narrowed so that every state is free, see `with_limits`."""

DetailName = Literal["full", "medium", "low"]
"""Level of detail of the solids."""

_CERTIFICATE = "_certificate"  # attribute in which an asset keeps its certificate
OUTDATED = "_outdated"  # attribute that tells that a file was changed after its certificate
_LATER = "_later"  # attribute in which an asset keeps how to make its certificate
_FIND = "_find_parameters"  # attribute in which an asset keeps how to find its parameters
_LIMIT_SLACK = 1e-9  # tolerance of joint limits [rad or m]
_CURVE_SLACK = 1e-9  # tolerance of the ends of the curves of closed chains [rad or m]
_CURVE_DIGITS = 9  # decimals of the limits of joints in closed chains


@dataclass(frozen=True, eq=False)
class Asset:
    """An articulated object at rest, in metres, kilograms and radians; z up, front to -y.

    Attributes:
        name: Identifier, also the name of its files.
        category: Name of its category.
        links: Rigid bodies, parents before their children; the first is the base. `links["door"]` is the link
            of that name.
        joints: Degrees of freedom, also by name: `joints["door_hinge"]`; those of the same two links are
            consecutive.
        seed: Seed of its parameters; None if they were not sampled.
        attempt: Number of infeasible draws before this one.
        parameters: Value of every parameter by name.
        base: Whether the base is fixed to the world or free to move.
        version: Version of artgen that made it.
        labels: Semantic labels that the category declares.
        contacts: Contacts that the category allows.
        limits: Whether the joints have their full ranges, or narrowed ones without dependencies.
        originals: Original name of each link and joint of a padded asset, by its name; without those that
            fill empty slots. Empty for other assets, see `artgen.topology`.
        detail: Level of detail of its solids.
        loose: Names of links that are free bodies in simulation, with all that hangs on them: a locked joint
            holds them at rest, and the proof is for that place.
        placed: Of a room, the assets in it with their places.
        loops: Closed chains of links, whose joints follow one input.
        outputs: Lights, motors and other outputs, with the joints that control them.
    """

    name: str
    category: str
    links: ByName[Link]
    joints: ByName[AssetJoint]
    seed: int | None = None
    attempt: int = 0
    parameters: Mapping[str, Any] = field(default_factory=dict)
    base: Base = "fixed"
    version: str = ""
    labels: tuple[str, ...] = ()
    contacts: tuple[AllowedContact, ...] = ()
    limits: Limits = "full"
    originals: Mapping[str, str] = field(default_factory=dict)
    detail: DetailName = "full"
    loose: tuple[str, ...] = ()
    placed: tuple[PlacedAsset, ...] = ()
    loops: tuple[AssetLoop, ...] = ()
    outputs: tuple[AssetOutput, ...] = ()

    def __post_init__(self) -> None:
        """Let links and joints be read by name."""
        for kind in ("link", "joint"):
            named = ByName(vars(self)[f"{kind}s"])
            named.missing = f"asset {self.name!r} has no {kind}"
            vars(self)[f"{kind}s"] = named

    @staticmethod
    def from_tree(tree: Tree, name: str, category: str, **fields: Any) -> "Asset":
        """Make an asset from an evaluated body.

        Raises:
            AssetError: A link has no mass; a coupling, dependency, contact or output names an unknown
                joint; couplings form a circle; or the joint of a contact does not move its links.
        """
        links = tuple(tree.links())
        for link in links:
            if link.visual:
                raise AssetError(
                    f"link {link.name!r} consists of details only, which have no mass; weld them to a part",
                    link=link.name,
                )
        joints = {joint.name: joint for joint in tree.joints()}
        contacts, loops = tuple(tree.all_contacts()), tuple(tree.all_loops())
        check_references(links, tuple(joints.values()), contacts, loops)
        ranged = tuple(with_followed_limits(joint, joints) for joint in joints.values())
        outputs = checked_outputs(tuple(tree.all_outputs()), {joint.name: joint for joint in ranged})
        fields |= {"contacts": contacts, "loops": loops, "outputs": outputs}
        return Asset(name, category, ByName(links), ByName(ranged), **fields)

    def __copy__(self) -> "Asset":
        return self  # it never changes

    def __deepcopy__(self, memo: dict[int, Any]) -> "Asset":
        return self

    def __repr__(self) -> str:
        certificate = None if self.certified_later else self.certificate
        state = "not certified" if certificate is None else "proven" if certificate.proven else "not proven"
        return f"<Asset {self.name}: {len(self.links)} links, {len(self.joints)} joints, {state}>"

    def __str__(self) -> str:
        return summary.text(self)

    def link(self, name: str) -> Link:
        """Return the link of that name, like `links[name]`."""
        return self.links[name]

    def joint(self, name: str) -> AssetJoint:
        """Return the joint of that name, like `joints[name]`."""
        return self.joints[name]

    @cached_property
    def materials(self) -> tuple[Material, ...]:
        """Materials of surfaces and colliders, in order of appearance."""
        found: dict[str, Material] = {}
        for link in self.links:
            used = [each.material for each in link.surfaces] + [each.material for each in link.colliders]
            for material in used:
                if found.setdefault(material.name, material) != material:
                    raise AssetError(
                        f"asset {self.name!r} has two different materials named {material.name!r}; "
                        "give one of them another name"
                    )
        return tuple(found.values())

    @cached_property
    def free_joints(self) -> tuple[AssetJoint, ...]:
        """The joints that are free to be set: neither coupled to another nor locked."""
        return tuple(joint for joint in self.joints if joint.follows is None and not joint.locked)

    @cached_property
    def affordances(self) -> tuple[Affordance, ...]:
        """Grasps and pushes, each with the joints that it moves."""
        return affordances(self)

    def positions(self, q: Mapping[str, float] | None = None) -> dict[str, float]:
        """Return the positions of all joints for the given positions of some, by name [rad or m].

        Other joints have the position nearest to 0 within their limits; coupled joints follow.

        Raises:
            AssetError: A joint is unknown, coupled to another, or beyond its limits, or `q` is no mapping.
        """
        result = {joint.name: joint.closed for joint in self.joints if joint.follows is None}
        if not isinstance(q, Mapping | None):
            free = [joint.name for joint in self.free_joints] or ["JOINT"]
            raise AssetError(f"positions are a mapping such as {{{free[0]!r}: 0.1}}, not {q!r}")
        for name, position in (q or {}).items():
            joint = self.joint(name)
            if joint.follows is not None:
                raise AssetError(
                    f"joint {name!r} follows {joint.follows.leader!r}; set {joint.follows.leader!r} instead"
                )
            if not is_number(position):
                raise AssetError(f"joint {name!r} cannot be at {position!r}; give a number [rad or m]")
            low, high = joint.limits or (-np.inf, np.inf)
            if not low - _LIMIT_SLACK <= position <= high + _LIMIT_SLACK:
                raise AssetError(
                    f"joint {name!r} cannot be at {position:.6g}; its limits are {low:.6g} to {high:.6g}"
                )
            result[name] = float(position)
        result = positions_of_followers(self.joints.by_name, result)
        return {joint.name: result[joint.name] for joint in self.joints}

    def blocked(self, q: Mapping[str, float] | None = None) -> tuple[str, ...]:
        """Return the names of the joints whose dependencies forbid their position in `q`."""
        positions = self.positions(q)
        return tuple(
            joint.name
            for joint in self.joints
            if joint.needs is not None and not joint.needs.allows(positions[joint.name], positions)
        )

    @cached_property
    def valid_states(self) -> ValidStates:
        """The valid joint states as arrays, as every export carries them."""
        data = self.states_data()
        return _CheckedStates(data["joints"], data.get("outputs", ()))

    def controller(self, worlds: int = 1) -> Controller:
        """Return the controller of a number of equal products, which computes their outputs over time.

        Raises:
            AssetError: The number is no whole number of at least 1.
        """
        if not is_number(worlds) or not float(worlds).is_integer() or worlds < 1:
            raise AssetError(f"the number of worlds must be a whole number of at least 1, got {worlds!r}")
        return Controller(self.valid_states, int(worlds))

    def with_outputs(self, values: Mapping[str, float]) -> "Asset":
        """Return the asset with lights and displays shining, for pictures and files.

        Args:
            values: Values from 0 to 1 by the names of outputs; others stay dark.

        Raises:
            AssetError: There is no such output, it has no material that shines, or its value is no number
                from 0 to 1.
        """
        named = {each.name: each for each in self.outputs}
        shines: dict[str | None, Array] = {}
        for name, value in values.items():
            output = named.get(name)
            if output is None or output.color is None:
                lights = [each.name for each in self.outputs if each.color is not None]
                has = "no such output" if output is None else "no material that shines"
                raise AssetError(f"output {name!r}: asset {self.name!r} has {has}.{nearest(name, lights)}")
            if not is_number(value) or not 0.0 <= value <= 1.0:
                raise AssetError(f"output {name!r} cannot be {value!r}; give a number from 0 to 1")
            before = shines.get(output.material, np.zeros(3))
            shines[output.material] = before + value * np.array(output.color)
        if not values:
            return self
        repainted = {
            each: each.with_(emission=tuple(np.minimum(shines[each.name], 1.0).tolist()))
            for each in self.materials
            if each.name in shines
        }
        links = ByName(RepaintedLink.of(link, materials=repainted) for link in self.links)
        return remember(replace(self, links=links), self.certificate)

    @property
    def is_room(self) -> bool:
        """Whether it is a scene: its base is a room."""
        return bool(self.links) and self.links[0].name == "room"

    def states_data(self) -> dict[str, Any]:
        """Return limits, couplings, dependencies and tendons of joints, and outputs, as JSON data."""
        fields = ("name", "limits", "follows", "needs", "detents", "closing")
        data = plain(tuple(map(rounded, self.joints)))
        rows = [{name: row[name] for name in fields if name in row} for row in data]
        loops = {"loops": plain(rounded(self.loops))} if self.loops else {}
        outputs = {"outputs": plain(rounded(self.outputs))} if self.outputs else {}
        return {"format": "artgen-states-1", "joints": rows, **loops, **outputs}

    @property
    def dof_names(self) -> tuple[str, ...]:
        """Names of the degrees of freedom: of the joints that neither follow another joint nor are locked."""
        return self.valid_states.dofs

    def sample_states(self, count: int, seed: int = 0) -> Array:
        """Draw valid joint states: limits, couplings and dependencies hold.

        Each joint is drawn uniformly from its range; where its dependency forbids that position, it is drawn
        from the range that the dependency leaves free, which for most joints is the closed position.

        Args:
            count: Number of states.
            seed: Seed of the draws.

        Returns:
            Positions by `dof_names`, shape (count, dof) [rad or m]; unlimited joints within half a turn.

        Raises:
            AssetError: The count or the seed is no whole number of at least 0.
        """
        for name, value in (("number of states", count), ("seed", seed)):
            if not is_number(value) or not float(value).is_integer() or value < 0:
                raise AssetError(f"the {name} must be a whole number of at least 0, got {value!r}")
        return self.valid_states.sample(int(count), int(seed))

    def project(self, q: ArrayLike) -> Array:
        """Return the valid states near given ones: clipped to limits, and blocked joints moved.

        A blocked joint moves to its nearest allowed position; joints that others depend on come first.

        Args:
            q: Positions by `dof_names`, shape (..., dof) [rad or m].

        Returns:
            Valid positions, shape (..., dof).

        Raises:
            AssetError: The states have another shape, or are no numbers.
        """
        return self.valid_states.project(q)

    def fk(self, q: ArrayLike) -> Array:
        """Return the poses of all links for many states: forward kinematics.

        Args:
            q: Positions by `dof_names`, shape (..., dof) [rad or m].

        Returns:
            Transforms from the frames of the links, in the order of `links`, to asset coordinates,
            shape (..., links, 4, 4) [m]. The frame of a link is that of the exported files, see `origin`.

        Raises:
            AssetError: The states have another shape, or are no numbers.
        """
        found = self.valid_states.positions(q)
        positions = np.moveaxis(found, -1, 0)[..., None, None]
        moved: dict[str, tuple[Array, Array]] = {self.links[0].name: (np.eye(3), np.zeros((3, 1)))}
        for joint, position in zip(self.joints, positions, strict=True):
            turn, shift = moved.get(joint.child, moved[joint.parent])
            if joint.kind == "prismatic":
                moved[joint.child] = (turn, shift + position * (turn @ joint.axis[:, None]))
                continue
            terms = joint.rotation_terms
            factors = (1.0, _portable.sin(position), 1.0 - _portable.cos(position))
            pivot = joint.pivot[:, None]
            turned = sum(factor * (turn @ term) for factor, term in zip(factors, terms, strict=True))
            swung = sum(factor * (turn @ (term @ pivot)) for factor, term in zip(factors, terms, strict=True))
            moved[joint.child] = (turned, shift + turn @ pivot - swung)
        result = np.zeros((len(self.links), *positions.shape[1:-2], 4, 4))
        for link, matrix in zip(self.links, result, strict=True):
            turn, shift = moved[link.name]
            matrix[..., :3, :3] = turn
            matrix[..., :3, 3:] = shift + turn @ self.origin(link.name)[:, None]
            matrix[..., 3, 3] = 1.0
        return np.moveaxis(result, 0, -3)

    def pose(self, q: Mapping[str, float] | None = None) -> dict[str, Array]:
        """Return the displacement of each link from rest.

        Args:
            q: Positions by joint name, completed as in `positions` [rad or m].

        Returns:
            For each link the transform, shape (4, 4), that takes its geometry from rest (asset coordinates)
            to the pose.

        Raises:
            AssetError: A joint is unknown, coupled to another, or beyond its limits.
        """
        positions = self.positions(q)
        result = {self.links[0].name: np.eye(4)}
        for joint in self.joints:  # several joints of one link act in order
            before = result.get(joint.child, result[joint.parent])
            result[joint.child] = before @ joint.motion(positions[joint.name])
        return result

    def pairs(self) -> list[tuple[str, str, tuple[AssetJoint, ...]]]:
        """Return each pair of joined links, parent first, with its joints in order."""
        grouped: dict[str, list[AssetJoint]] = {}
        for joint in self.joints:
            grouped.setdefault(joint.child, []).append(joint)
        return [(joints[0].parent, child, tuple(joints)) for child, joints in grouped.items()]

    def origin(self, link: str) -> Array:
        """Return the origin of a link's frame at rest in asset coordinates, shape (3,) [m].

        The base has the asset's frame. The origin of any other link lies on its nearest joint. At rest all
        frames are parallel to the asset's axes.
        """
        above = joints_above(self.joints, self.link(link).name)
        return above[0].pivot if above else np.zeros(3)

    @property
    def mass(self) -> float:
        """Mass of all links [kg]."""
        return float(sum(link.mass_properties.mass for link in self.links))

    def mass_properties(self) -> MassProperties:
        """Return mass, center and inertia of the whole asset at rest."""
        return total(link.mass_properties.moments() for link in self.links)

    def bounds(self) -> Array:
        """Return the corners of the bounding box at rest, shape (2, 3) [m]."""
        boxes = np.array([link.bounds() for link in self.links])
        return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])

    def with_base(self, base: Base) -> "Asset":
        """Return the asset with its base fixed to the world or free.

        Raises:
            ParameterError: The base is another word, or is to be free and the asset is a room.
        """
        check_base(base)
        if base == "free" and self.placed:
            raise ParameterError(f"base = 'free' is not allowed: {self.name} is a room, fixed to the world")
        return remember(replace(self, base=base), self.certificate)

    @property
    def certified_later(self) -> bool:
        """Whether the first use of `certificate` will make it, see `generate(..., certify="later")`."""
        return _LATER in vars(self)

    @property
    def certificate(self) -> Certificate | None:
        """The certificate of the last `certify`; None before it and on changed copies.

        Of an asset that was generated with `certify="later"`, the first access makes it.

        Raises:
            CheckError: Its links are not proven apart.
        """
        later: _Later | None = vars(self).get(_LATER)
        if later is not None:
            remember(self, later.certificate())
        certificate: Certificate | None = vars(self).get(_CERTIFICATE)
        return certificate

    if TYPE_CHECKING:  # bound at run time, by `artgen.asset_methods.bind`
        certify = asset_methods.certify
        safe_limits = asset_methods.safe_limits
        with_limits = asset_methods.with_limits
        with_colliders = asset_methods.with_colliders
        clearance = asset_methods.clearance
        validate = asset_methods.validate
        export = asset_methods.export
        to_mjspec = asset_methods.to_mjspec
        to_trimesh = asset_methods.to_trimesh
        to_usd = asset_methods.to_usd
        render = asset_methods.render
        show = asset_methods.show
        load = staticmethod(asset_methods.load)

    def rounded(self) -> "Asset":
        """Return the asset with as many digits as its files keep.

        Numbers have 12 significant digits; poses and points of colliders have 12 decimals, and surfaces as
        many as `artgen.asset.surface` says. The digits beyond differ between machines. An asset that was
        read from files has no more digits and is returned unchanged.
        """
        if all(link.rounded for link in self.links):
            return self
        joints, contacts = ByName(map(rounded, self.joints)), rounded(self.contacts)
        result = replace(self, joints=joints, parameters=rounded(self.parameters), contacts=contacts)
        result = replace(result, loops=rounded(self.loops), outputs=rounded(self.outputs))
        links = [RoundedLink.at(link, result.origin(link.name)) for link in self.links]
        return remember(replace(result, links=ByName(links)), self.certificate)

    def to_data(self) -> dict[str, Any]:
        """Return everything but the triangles as JSON data, with as many digits as `rounded` keeps."""
        asset, certificate = self.rounded(), self.certificate
        links = [link.to_data() for link in asset.links]
        return {
            "format": FORMAT,
            **{name: getattr(self, name) for name in PLAIN},
            **({} if self.detail == "full" else {"detail": self.detail}),
            "labels": list(self.labels),
            "parameters": plain(asset.parameters),
            "mass": rounded(sum(link["mass"] for link in links)),
            "materials": [material.to_data() for material in asset.materials],
            "links": links,
            "joints": plain(asset.joints),
            "affordances": [affordance_data(each, asset) for each in asset.affordances],
            "contacts": plain(asset.contacts),
            **({"originals": dict(self.originals)} if self.originals else {}),
            **({"loose": list(self.loose)} if self.loose else {}),
            **({"placed": rounded(plain(self.placed))} if self.placed else {}),
            **({"loops": plain(asset.loops)} if self.loops else {}),
            **({"outputs": plain(asset.outputs)} if self.outputs else {}),
            "certificate": None if certificate is None else rounded(certificate.to_data()),
            **({} if certificate is None else {"certified": subject(asset)}),
        }

    def to_json(self) -> str:
        """Return everything but the triangles as JSON text."""
        return json_text(self.to_data())


# fields that files store as they are
PLAIN = ("name", "category", "seed", "attempt", "version", "base", "limits")
FORMAT = "artgen-asset-1"  # format of `asset.json` that this version reads and writes


def subject(asset: Asset) -> str:
    """Return the SHA-256 of everything that a certificate depends on: colliders, motions, contacts."""
    pieces = {
        link.name: [
            (each.kind, each.pose, each.size, each.points)
            for each in (*(collider.convex for collider in link.colliders), *link.covers)
        ]
        for link in asset.links
    }
    motions = [{**joint.to_data(), **dict.fromkeys(FEELS)} for joint in asset.joints]
    data = plain([pieces, motions, asset.contacts, asset.loops, asset.loose])
    return hashlib.sha256(json_text(data).encode()).hexdigest()


class _CheckedStates(ValidStates):
    """Valid states that refuse arrays of another shape; the file of `ValidStates` stands alone."""

    def positions(self, q: ArrayLike) -> Array:
        """Return the positions of all joints."""
        return super().positions(_states(self.dofs, q))

    def blocked(self, q: ArrayLike) -> NDArray[np.bool_]:
        """Tell which joints are blocked."""
        return super().blocked(_states(self.dofs, q))

    def project(self, q: ArrayLike) -> Array:
        """Return valid states."""
        return super().project(_states(self.dofs, q))


def _states(dofs: tuple[str, ...], q: ArrayLike) -> Array:
    """Return states as an array, shape (..., dof); AssetError if they are none."""
    try:
        states = np.asarray(q, float)
    except (TypeError, ValueError):
        states = np.array(np.nan)
    count = len(dofs)
    if not states.ndim or states.shape[-1] != count or not np.isfinite(states).all():
        count_out = (~np.isfinite(states)).sum()
        found = f"the shape {states.shape} with {count_out} NaN or infinite" if states.ndim else repr(q)
        names = ", ".join(dofs) or "no joint"
        raise AssetError(
            f"states must be an array of shape (..., {count}), positions of {names}; got {found}"
        )
    return states


def check_base(base: Any) -> None:
    """Check a word for the base."""
    if base not in get_args(Base):
        raise ParameterError(f"base = {base!r} is not allowed: it must be 'fixed' or 'free'")


def remember(asset: Asset, certificate: Certificate | None) -> Asset:
    """Attach a certificate to an asset and return it; changed copies do not inherit the certificate."""
    if certificate is not None:
        vars(asset)[_CERTIFICATE] = certificate
        vars(asset).pop(_LATER, None)
    return asset


def find_parameters_later(asset: Asset, find: Callable[[], Mapping[str, Any]]) -> None:
    """Let the first access to the parameters of an asset find them; it may take a graph for each option."""
    vars(asset)[_FIND] = find
    del vars(asset)["parameters"]


_found: cached_property[Mapping[str, Any]] = cached_property(lambda asset: vars(asset)[_FIND]())
_found.__set_name__(Asset, "parameters")
setattr(Asset, "parameters", _found)  # noqa: B010 - the field of an instance hides it until it is deleted


class _Later:
    """A certificate that is made on the first request; threads wait for the one that makes it."""

    def __init__(self, make: Callable[[], Certificate]) -> None:
        self._make, self._lock = make, Lock()
        self._result: Certificate | CheckError | None = None

    def certificate(self) -> Certificate:
        with self._lock:
            if self._result is None:
                try:
                    self._result = self._make()
                except CheckError as error:
                    self._result = error
        if isinstance(self._result, CheckError):
            raise self._result
        return self._result


def certify_later(asset: Asset, make: Callable[[], Certificate]) -> None:
    """Let the first access to the certificate of an asset make it."""
    vars(asset)[_LATER] = _Later(make)
