"""Fewer colliders: pieces of a link are joined where no opening closes and no links collide."""

import heapq
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import fcl
import numpy as np
from manifold3d import Manifold, OpType

from artgen import _portable
from artgen._arrays import Array, cached_property
from artgen._names import ByName
from artgen.asset import Asset, Collider, Link
from artgen.asset.affordance import GRIPPER, Affordance
from artgen.asset.asset import remember
from artgen.asset.collision import RecollidedLink, need_solids
from artgen.asset.joint import is_number
from artgen.asset.manifolds import mesh_of
from artgen.colliders.budget import around
from artgen.colliders.convex import Convex
from artgen.colliders.openings import BALL, Openings
from artgen.colliders.polytope import Polytope
from artgen.errors import AssetError, ParameterError, nearest
from artgen.proof.certify import certify, doubtful_colliders
from artgen.proof.paths import JointPath

_LEAST_OPENING = 0.01  # [m]
_MOST_OPENING = 1.0  # [m]
_APART = 1e-4  # least distance of a joined piece from other links in the states that are tried first [m]
_COMES_FROM = 0.100  # length of the straight way of a hand to its grasp that stays free [m]
_PLAY = 0.002  # distance by which held pieces may grow towards each finger [m]
_SURFACE = 5e-4  # distance by which a surface may grow towards a pushing finger [m]
_SIDES = 16  # sides of a pushing finger
_RANDOM = 64  # states that are drawn at random
_STEPS = 24  # states along the range of each joint
_DECIMALS = 9  # decimals of motions that count as equal
_VOLUME_DECIMALS = 12  # decimals of volumes that are compared [m^3]
_JOINED = "joined"  # kind of such colliders in the data of a link, and key of the facts about them
_REQUEST = fcl.DistanceRequest()

Budget = int | Mapping[str, int]
"""Most colliders of an asset, or of some of its links by name."""


def with_colliders(asset: Asset, most: Budget, openings: float = BALL) -> Asset:
    """Return an asset with fewer colliders, which still contain the solids and still never collide.

    Two pieces of a link become their hull, or a box, cylinder or capsule around it, those first that add the
    least volume. A pair stays apart if the joined piece would

    - touch another link in a joint state,
    - stand in the way of a hand to a grasp or a push,
    - or close an opening, where a ball fits that comes from outside; see `artgen.colliders.openings`. Balls
      of 24 mm come first, and wider ones only if the number is not reached with narrower ones.

    Looks, masses and joints stay the same. The certificate is that of the new colliders; the asset has one
    also if it had none before.

    Args:
        asset: An asset with its solids.
        most: Largest number of colliders of the asset, or of single links by name; other links keep theirs.
        openings: Diameter of the widest ball whose ways from outside stay open [m].

    Raises:
        ParameterError: A number is not allowed.
        AssetError: The asset was read from files, it has no link of a name, or it needs more colliders; the
            message has the fewest that were found for each link.
    """
    result, missed = fewer_colliders(asset, most, openings)
    if missed:
        raise AssetError(missed)
    return result


def fewer_colliders(asset: Asset, most: Budget, openings: float = BALL) -> tuple[Asset, str]:
    """Return the asset of `with_colliders` or, where it fails, of the fewest colliders, and the reason."""
    check_budget(most, openings)
    if asset.originals:
        raise AssetError(
            f"asset {asset.name!r} is padded to a topology, which sets its colliders; join colliders first, "
            "and pad the result to a topology of such assets: topology.pad(asset.with_colliders(...))"
        )
    need_solids(asset, "its colliders cannot be joined", "fewer colliders when it is generated")
    names = [link.name for link in asset.links]
    for name in most if isinstance(most, Mapping) else ():
        if name not in names:
            raise AssetError(f"asset {asset.name!r} has no link {name!r}.{nearest(name, names)}")
    joining = _Joining(asset)
    tolerance = 0.0 if asset.certificate is None else max(asset.certificate.tolerance, 0.0)
    for ball in _balls(openings):
        joining.leave_open(ball)
        joining.join(most)
        changed = joining.changed
        while changed:
            doubtful = doubtful_colliders(joining.asset(most), tolerance, partial(_moves_one, changed))
            changed = joining.undo(doubtful)
            if changed:
                joining.join(most)
                changed |= joining.changed
        if not joining.missed(most):
            break
    result = joining.asset(most)
    return remember(result, certify(result, tolerance)), joining.missed(most)


def _balls(widest: float) -> Iterator[float]:
    """Yield the diameters of balls whose ways are left open in turn, each twice as wide as the last [m]."""
    ball = BALL
    while ball < widest:
        yield ball
        ball *= 2.0
    yield widest


def check_budget(most: Budget, openings: float, collision: str = "exact") -> None:
    """Check the options of `with_colliders`, and of an export with its result.

    Raises:
        ParameterError: A number is not allowed, or the export would replace the colliders.
    """
    if collision != "exact":
        raise ParameterError(
            f"colliders={most!r} joins exact colliders, which collision={collision!r} replaces; leave one out"
        )
    if not is_number(openings) or not _LEAST_OPENING <= openings <= _MOST_OPENING:
        raise ParameterError(
            f"openings must be a width of {_LEAST_OPENING:g} to {_MOST_OPENING:g} m (metres, not mm), got "
            f"{openings!r}"
        )
    for name, number in most.items() if isinstance(most, Mapping) else (("", most),):
        if not is_number(number) or not number >= 1 or number % 1:
            place = f" of link {name!r}" if name else ""
            raise ParameterError(
                f"the number of colliders{place} must be a whole number from 1, got {number!r}"
            )


def _moves_one(links: set[str], joint_path: JointPath) -> bool:
    return not links.isdisjoint(joint_path.links)


@dataclass(frozen=True, eq=False)
class _Body:
    """A polytope that can touch others."""

    faces: Polytope

    @cached_property
    def box(self) -> tuple[Array, Array]:
        """Center of the bounding box and half its lengths, shape (3,) each [m]."""
        low, high = self.faces.bounds
        return (low + high) / 2.0, (high - low) / 2.0

    @cached_property
    def object(self) -> fcl.CollisionObject:
        corners, triangles = mesh_of(self.faces.manifold())
        faces = np.column_stack((np.full(len(triangles), 3), triangles)).astype(np.int32).ravel()
        return fcl.CollisionObject(fcl.Convex(np.ascontiguousarray(corners), len(triangles), faces))

    def touches(self, others: "Sequence[_Body]", motions: Array) -> Iterator[tuple[int, int]]:
        """Yield the numbers of other bodies that touch this one, and of their motions, shape (4, 4)."""
        if not others:
            return
        turns, shifts = motions[:, :3, :3], motions[:, :3, 3]
        middle, half = (np.array(each) for each in zip(*(other.box for other in others), strict=True))
        center = np.einsum("sij,pj->spi", turns, middle) + shifts[:, None] - self.box[0]
        reach = np.einsum("sij,pj->spi", np.abs(turns), half) + self.box[1] + _APART
        near = (np.abs(center) <= reach).all(axis=2)
        for number in np.flatnonzero(near.any(axis=0)).tolist():
            other = others[number]
            states = np.flatnonzero(near[:, number])
            turn, shift = turns[states], shifts[states]
            moved = other.faces.points @ turn.swapaxes(1, 2) + shift[:, None]
            back = (self.faces.points - shift[:, None]) @ turn
            gap = np.maximum(_gaps(self.faces, moved), _gaps(other.faces, back))
            for state in states[gap <= _APART].tolist():
                other.object.setTransform(fcl.Transform(turns[state], shifts[state]))
                if fcl.distance(self.object, other.object, _REQUEST, fcl.DistanceResult()) <= _APART:
                    yield number, state


def _gaps(faces: Polytope, points: Array) -> Array:
    """Return the largest height of whole sets of points, shape (s, n, 3), above a face of a polytope."""
    heights = points @ faces.planes[:, :3].T - faces.planes[:, 3]
    return np.asarray(heights.min(axis=1).max(axis=1))


class _Surroundings:
    """The space around the links of an asset that joined pieces have to leave free."""

    def __init__(self, asset: Asset, colliders: Mapping[str, Sequence[Collider]]) -> None:
        self._exact = {
            name: [_Body(each.convex.faces) for each in found] for name, found in colliders.items()
        }
        self._hands = [(each.link, _hand(each)) for each in asset.affordances]
        self._blocked: dict[tuple[int, str], set[tuple[int, int]]] = {}
        names = [link.name for link in asset.links]
        placed = asset.fk(_states(asset))
        placed[..., :3, 3] -= (placed[..., :3, :3] @ [[[o] for o in asset.origin(n)] for n in names])[..., 0]
        self._motions: dict[tuple[str, str], Array] = {}
        for row, first in enumerate(names):
            back = _portable.inverse(placed[:, row])
            for column, second in enumerate(names):
                relative = back @ placed[:, column] if row != column else np.eye(4)[None]
                _, chosen = np.unique(
                    np.round(relative, _DECIMALS).reshape(-1, 16), axis=0, return_index=True
                )
                self._motions[first, second] = relative[np.sort(chosen)]

    def leave_open(self, ball: float) -> None:
        """Leave open the ways of balls of a diameter [m]."""
        self._ball, self._openings = ball, dict[str, Openings]()

    def allow(self, link: str, convex: Convex, bodies: Mapping[str, Sequence[_Body]]) -> bool:
        """Tell whether a piece of a link may be there, beside the pieces of the other links."""
        if link not in self._openings:
            self._openings[link] = Openings([body.faces for body in self._exact[link]], self._ball)
        if self._openings[link].closed_by(convex.faces):
            return False
        body = _Body(convex.faces)
        for number, (holder, (before, between)) in enumerate(self._hands):
            hand = before if holder == link else before + between
            touched = list(body.touches(hand, self._motions[link, holder]))
            if touched and not self._known(number, link, hand).issuperset(touched):
                return False
        return not any(
            any(body.touches(others, self._motions[link, other]))
            for other, others in bodies.items()
            if other != link and len(self._motions[link, other]) > 1
        )

    def _known(self, number: int, link: str, hand: Sequence[_Body]) -> set[tuple[int, int]]:
        """Return the parts of a hand that pieces of a link touch before any are joined, with the motions."""
        if (number, link) not in self._blocked:
            motions = self._motions[link, self._hands[number][0]]
            touched = (pair for piece in self._exact[link] for pair in piece.touches(hand, motions))
            self._blocked[number, link] = set(touched)
        return self._blocked[number, link]


def _states(asset: Asset) -> Array:
    """Return valid states: random ones, and for each joint its whole range with the others at rest."""
    states = asset.valid_states
    low, high = np.maximum(states.lower, -np.pi), np.minimum(states.upper, np.pi)
    rest = asset.project(np.zeros(len(asset.dof_names)))
    along = np.repeat(rest[None], _STEPS * len(rest), axis=0)
    for number in range(len(rest)):
        rows = slice(_STEPS * number, _STEPS * (number + 1))
        along[rows, number] = np.linspace(low[number], high[number], _STEPS)
    return np.concatenate((asset.sample_states(_RANDOM), asset.project(along)))


def _hand(affordance: Affordance) -> tuple[list[_Body], list[_Body]]:
    """Return the bodies of a hand on its way to a grasp or push, and the space between its fingers."""
    if affordance.kind == "push":
        angle = np.arange(_SIDES) * (2.0 * np.pi / _SIDES)
        circle = np.column_stack((_portable.cos(angle), _portable.sin(angle))) * GRIPPER.finger / 2.0
        finger = Polytope.prism(circle, -_COMES_FROM, -_SURFACE)
        return [_Body(finger.transformed(affordance.frame))], []
    half = affordance.width / 2.0
    blocks = [*GRIPPER.blocks(_PLAY - half, half - _PLAY, _COMES_FROM).values(), GRIPPER.between(half)]
    hand = [_Body(Polytope.box(*corners).transformed(affordance.frame)) for corners in blocks]
    return hand[:-1], hand[-1:]


@dataclass(frozen=True, eq=False)
class _Group:
    """Pieces of a link that were joined."""

    link: str
    numbers: frozenset[int]  # numbers of the pieces among the colliders of the link
    convex: Convex  # the joined piece
    finer: tuple[Convex, ...] = ()  # other joined pieces, tried if this one is refused later
    parts: "tuple[_Group, ...]" = ()  # the groups that it was made of

    @cached_property
    def body(self) -> _Body:
        return _Body(self.convex.faces)

    @cached_property
    def points(self) -> Array:
        """Vertices of a polytope around it, shape (n, 3) [m]."""
        return self.convex.outer_points()


@dataclass(eq=False)
class _Joining:
    """Pieces of the links of an asset that are joined step by step, smallest added volume first."""

    source: Asset  # the asset before
    openings: float = field(default=BALL, init=False)  # diameter of the balls whose ways stay open [m]
    changed: set[str] = field(default_factory=set)  # links whose pieces the last `join` changed

    def __post_init__(self) -> None:
        self._colliders = {link.name: link.colliders for link in self.source.links}
        self._around = _Surroundings(self.source, self._colliders)
        self._groups = {
            name: [_Group(name, frozenset((number,)), each.convex) for number, each in enumerate(found)]
            for name, found in self._colliders.items()
        }
        self._queue: list[tuple[float, int, _Group, _Group]] = []
        self._refused: set[tuple[str, frozenset[int]]] = set()
        self._count = 0

    def leave_open(self, ball: float) -> None:
        """Leave open the ways of balls of a diameter [m], and queue all pairs."""
        self.openings = ball
        self._around.leave_open(ball)
        self._queue.clear()
        for name, groups in self._groups.items():
            self._groups[name] = []
            for group in groups:
                self._add(group)

    def join(self, most: Budget) -> None:
        """Join pairs until the budget is met or no pair is left."""
        self.changed = set()
        later = []
        while self._queue and self._over(most):
            entry = heapq.heappop(self._queue)
            first, second = entry[2:]
            if first not in self._groups[first.link] or second not in self._groups[first.link]:
                continue
            if not self._over(most, first.link):
                later.append(entry)
                continue
            joined = self._joined(first, second)
            if joined is not None:
                inside = [each for each in self._groups[first.link] if each.numbers <= joined.numbers]
                self._groups[first.link] = [each for each in self._groups[first.link] if each not in inside]
                self._add(joined)
                self.changed.add(first.link)
        for entry in later:
            heapq.heappush(self._queue, entry)

    def undo(self, doubtful: Sequence[Sequence[tuple[str, int]]]) -> set[str]:
        """Take apart a joined piece of each group of pieces that are not proven apart; return their links."""
        listed = {name: self._in_order(name) for name in self._groups}
        found: dict[_Group, None] = {}
        for pieces in doubtful:
            joined = [group for link, number in pieces if (group := listed[link][number]).parts]
            if joined and not any(group in found for group in joined):
                found[max(joined, key=lambda group: round(_added(group), _VOLUME_DECIMALS))] = None
        for group in found:
            self._groups[group.link].remove(group)
            if group.finer:
                convex, *rest = group.finer
                self._add(replace(group, convex=convex, finer=tuple(rest)))
                continue
            self._refused.add((group.link, group.numbers))
            for part in group.parts:
                self._add(part)
        return {group.link for group in found}

    def asset(self, most: Budget) -> Asset:
        """Return the asset with the joined pieces."""
        links = ByName(self._link(link, most) for link in self.source.links)
        return replace(self.source, links=links)

    def missed(self, most: Budget) -> str:
        """Return why the budget is not met; an empty text if it is."""
        counts = {name: len(groups) for name, groups in self._groups.items()}
        if isinstance(most, Mapping):
            over = {name: number for name, number in counts.items() if number > most.get(name, number)}
            needs = ", ".join(f"{name} {number}, not {most[name]}" for name, number in over.items())
        else:
            over = counts if sum(counts.values()) > most else {}
            links = ", ".join(f"{name} {number}" for name, number in over.items())
            needs = f"{sum(over.values())}, not {most}: {links}"
        if not over:
            return ""
        return (
            f"the fewest colliders that were found for asset {self.source.name!r} are {needs}; with fewer, "
            "links would collide, a grasp would be blocked, or an opening would close; ask for more, or let "
            f"wider openings close: openings={2.0 * self.openings:g}"
        )

    def _over(self, most: Budget, link: str = "") -> bool:
        """Tell whether there are more pieces than the budget allows, on one link or on any."""
        if isinstance(most, Mapping):
            names = [link] if link else list(most)
            return any(len(self._groups[name]) > most.get(name, np.inf) for name in names)
        return sum(map(len, self._groups.values())) > most

    def _add(self, group: _Group) -> None:
        """Add a group, and the pairs with the others of its link to the queue."""
        for other in self._groups[group.link]:
            hull = Manifold.hull_points(np.concatenate((other.points, group.points))).volume()
            added = round(hull - other.convex.volume - group.convex.volume, _VOLUME_DECIMALS)
            heapq.heappush(self._queue, (added, self._count, other, group))
            self._count += 1
        self._groups[group.link].append(group)

    def _joined(self, first: _Group, second: _Group) -> _Group | None:
        """Return two groups of a link joined, with all that lie inside, if that is allowed."""
        link, colliders = first.link, self._colliders[first.link]
        joined = first.numbers | second.numbers
        if self._is_refused(link, joined):
            return None
        others = {name: [each.body for each in groups] for name, groups in self._groups.items()}
        pieces = [colliders[number].convex for number in sorted(joined)]
        least = Convex.hull(np.concatenate([each.outer_points() for each in pieces]))
        if not self._around.allow(link, least, others):
            return None  # a polytope with fewer vertices, or a primitive, is larger
        found = around(pieces)
        for index, convex in enumerate(found):
            inside = tuple(
                each
                for each in self._groups[link]
                if each in (first, second) or convex.faces.contains(each.points)
            )
            numbers = frozenset(number for each in inside for number in each.numbers)
            if not self._is_refused(link, numbers) and self._around.allow(link, convex, others):
                return _Group(link, numbers, convex, tuple(found[index + 1 :]), inside)
        return None

    def _is_refused(self, link: str, numbers: frozenset[int]) -> bool:
        """Tell whether a joined piece was refused that is part of another."""
        return any(name == link and refused <= numbers for name, refused in self._refused)

    def _in_order(self, link: str) -> list[_Group]:
        return sorted(self._groups[link], key=lambda group: min(group.numbers))

    def _link(self, link: Link, most: Budget) -> Link:
        groups = self._in_order(link.name)
        if not any(group.parts for group in groups):
            return link
        exact = self._colliders[link.name]
        colliders = tuple(_collider(group, exact) for group in groups)
        before = _volume([each.convex for each in exact])
        facts = {
            "budget": most[link.name] if isinstance(most, Mapping) else most,
            "exact_colliders": len(exact),
            "volume_added": round(_volume([each.convex for each in colliders]) / before - 1.0, 6),
        }
        return RecollidedLink.of(link, replacing=colliders, collision=_JOINED, facts={_JOINED: facts})


def _added(group: _Group) -> float:
    return group.convex.volume - sum(part.convex.volume for part in group.parts)


def _volume(pieces: Sequence[Convex]) -> float:
    return float(Manifold.batch_boolean([piece.faces.manifold() for piece in pieces], OpType.Add).volume())


def _collider(group: _Group, exact: Sequence[Collider]) -> Collider:
    """Return the collider of a group, with label and material of its largest piece."""
    if not group.parts:
        return exact[min(group.numbers)]
    colliders = [exact[number] for number in sorted(group.numbers)]
    largest = max(colliders, key=lambda each: round(each.convex.volume, _VOLUME_DECIMALS))
    labels = tuple(dict.fromkeys(each.label for each in colliders if each.label != largest.label))
    return Collider(group.convex, largest.label, largest.material, joined=labels)
