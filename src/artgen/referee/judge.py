"""The judgment of a file: each pair of its links is proven apart, refuted, or open."""

import math
import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from artgen._names import ByName, checked_path
from artgen.asset import Asset, AssetJoint
from artgen.asset.certificate import PairResult
from artgen.asset.joint import is_number
from artgen.asset.record import plain
from artgen.asset.report import Finding
from artgen.errors import AssetError, ExportError, ParameterError
from artgen.materials import Material
from artgen.proof import certify as proof
from artgen.proof.limits import narrowed_limits
from artgen.proof.overlap import PRESSED
from artgen.proof.paths import JointPath, space_of
from artgen.proof.recheck import recheck
from artgen.referee.files import parse_xml
from artgen.referee.mjcf import read_mjcf, repaired_mjcf
from artgen.referee.model import SUFFIXES, ForeignModel, Format, Meshes
from artgen.referee.states import collisions
from artgen.referee.trees import MATERIAL, ColliderLink, JudgedTree, trees_of
from artgen.referee.urdf import read_urdf, repaired_urdf
from artgen.referee.usd import read_usd, repaired_usd

Verdict = Literal["proven", "collision", "not proven", "nothing moves"]

_READERS: dict[Format, Callable[..., ForeignModel]] = {"urdf": read_urdf, "mjcf": read_mjcf, "usd": read_usd}
_REPAIRS: dict[Format, Callable[..., None]] = {
    "urdf": repaired_urdf,
    "mjcf": repaired_mjcf,
    "usd": repaired_usd,
}
_LEVELS_UP = 2  # folders above that of the file from which it may read by default
_SMALLEST_RANGE = 1e-6  # a joint with a smaller range is locked [rad or m]
_PAINTS = tuple(
    replace(MATERIAL, name=name, base_color=color)
    for name, color in (("first", (0.85, 0.25, 0.1)), ("second", (0.1, 0.3, 0.85)))
)
_REPAIR_SECONDS = 10.0  # time limit for each step of a repair [s]
_OWN_SLACK = 1e-6  # by which a coupled joint may exceed its own limits [rad or m]
_FEW_JOINTS = 3  # most joints between two links of pairs that are proven together
_SHOWN = 20  # most pairs in the text


@dataclass(frozen=True)
class JudgedPair:
    """The result for two links of a file.

    Attributes:
        result: Result of the proof, in the file's names of links, joints and geoms.
        excluded: Reason why the file permits no collision between the links; empty if it permits them.
        restricted: Constraint that may forbid the pose of a collision, which is then not proven; or empty.
        seconds: Time limit that the proof exceeded [s]; 0 if it exceeded none, or if no time was left.
    """

    result: PairResult
    excluded: str = ""
    restricted: str = ""
    seconds: float = 0.0

    @property
    def verdict(self) -> Verdict:
        """Verdict on the pair."""
        if self.result.verdict == "collision" and self.restricted:
            return "not proven"
        return self.result.verdict

    @property
    def examined(self) -> bool:
        """Whether the pair was examined; not after the first collision, if it decides, or without time."""
        return self.result.verdict != "not proven" or bool(self.result.open_cells)

    def __str__(self) -> str:
        text = str(self.result)
        if not self.examined:
            text = f"{self.result.links[0]} and {self.result.links[1]}: left open, not proven"
        if self.result.verdict == "proven":
            text = f"{self.result.links[0]} and {self.result.links[1]}: proven apart"
        if self.restricted and self.result.verdict == "collision":
            text += f"; not proven, for the {self.restricted} may forbid this pose"
        if self.seconds:
            text += f"; not proven after {self.seconds:.3g} s"
        return text + (f" [the file excludes this pair: {self.excluded}]" if self.excluded else "")

    def to_data(self) -> dict[str, Any]:
        """Return the pair as JSON data."""
        added = {"verdict": self.verdict, "excluded": self.excluded, "restricted": self.restricted}
        return {**plain(self.result), **added, "seconds": self.seconds}


@dataclass(frozen=True, eq=False)
class Judgment:
    """What the referee found out about a file.

    Attributes:
        path: The file.
        model: What was read.
        trees: Groups of links that were judged, each an asset whose solids are the file's colliders.
        pairs: Every pair of links that move against each other.
        findings: Statements of the proofs that the recheck refuted; empty if all hold.
        notes: What was not judged, or not exactly as the file says.
        seconds: Time for everything [s].
    """

    path: Path
    model: ForeignModel = field(repr=False)
    trees: tuple[JudgedTree, ...] = field(repr=False)
    pairs: tuple[JudgedPair, ...]
    findings: tuple[Finding, ...]
    notes: tuple[str, ...]
    seconds: float

    @property
    def verdict(self) -> Verdict:
        """Verdict on the pairs that the file lets collide."""
        return _verdict([pair.verdict for pair in self.pairs if not pair.excluded], bool(self.pairs))

    @property
    def verdict_with_excluded(self) -> Verdict:
        """Verdict on all pairs, also those that the file excludes."""
        return _verdict([pair.verdict for pair in self.pairs], bool(self.pairs))

    @property
    def rechecked(self) -> bool:
        """Whether the recheck, which knows nothing of the search, confirms all proofs."""
        return not self.findings

    @property
    def failures(self) -> tuple[JudgedPair, ...]:
        """The pairs that are not proven, collisions first, excluded pairs last."""
        failed = [pair for pair in self.pairs if pair.verdict != "proven"]
        return tuple(sorted(failed, key=lambda pair: (bool(pair.excluded), pair.verdict != "collision")))

    @property
    def links(self) -> int:
        """Number of links: of groups of bodies that are welded together."""
        return sum(len(tree.asset.links) for tree in self.trees)

    @property
    def joints(self) -> int:
        """Number of joints."""
        return sum(len(tree.asset.joints) for tree in self.trees)

    @property
    def colliders(self) -> int:
        """Number of convex colliders."""
        return sum(len(body.geoms) for body in self.model.bodies)

    def __str__(self) -> str:
        counted = f"{self.links} links, {self.joints} joints, {self.colliders} colliders"
        lines = [f"{self.path}: {self.verdict} ({counted}, {self.seconds:.1f} s)"]
        proven = sum(pair.verdict == "proven" for pair in self.pairs)
        lines.append(f"  {proven} of {len(self.pairs)} pairs that move are proven apart")
        if any(pair.excluded for pair in self.pairs):
            lines.append(f"  with the pairs that the file excludes: {self.verdict_with_excluded}")
        failed = [pair for pair in self.failures if pair.examined]
        lines += [f"  {pair}" for pair in failed[:_SHOWN]]
        if len(failed) > _SHOWN:
            lines.append(f"  and {len(failed) - _SHOWN} more pairs")
        if left := len(self.failures) - len(failed):
            lines.append(f"  {left} pairs are left open: the first collision decides, or the time was over")
        lines += [f"  the recheck refutes: {finding}" for finding in self.findings]
        lines += [f"  note: {note}" for note in self.notes]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return everything but the proofs as JSON data."""
        return {
            "file": str(self.path),
            "format": self.model.format,
            "verdict": self.verdict,
            "verdict_with_excluded": self.verdict_with_excluded,
            "rechecked": self.rechecked,
            "links": self.links,
            "joints": self.joints,
            "colliders": self.colliders,
            "seconds": round(self.seconds, 3),
            "pairs": [pair.to_data() for pair in self.pairs],
            "findings": [str(finding) for finding in self.findings],
            "notes": list(self.notes),
        }

    def picture(self, out: str | Path, *, size: int = 768) -> JudgedPair:
        """Draw the first failing pair at its witness: its links red and blue, the other links grey.

        Args:
            out: PNG file.
            size: Pixels per side.

        Returns:
            The pair that is drawn.

        Raises:
            AssetError: No pair collides.
        """
        pair = next((each for each in self.failures if each.result.witness is not None), None)
        if pair is None or pair.result.witness is None:
            raise AssetError(f"{self.path}: no pair collides; there is nothing to draw")
        both = set(pair.result.links)
        tree = next(each for each in self.trees if both <= {link.name for link in each.asset.links})
        paints: dict[str, Material] = dict(zip(pair.result.links, _PAINTS, strict=True))
        links = ByName(
            ColliderLink.of(link.name, link.geoms, paints.get(link.name, MATERIAL))
            for link in tree.asset.links
            if isinstance(link, ColliderLink)
        )
        free = {joint.name for joint in tree.asset.free_joints}
        pose = {name: value for name, value in pair.result.witness.pose.items() if name in free}
        replace(tree.asset, links=links).render(pose, size=size, textures=0).save(out)
        return pair

    def repair(self, out: str | Path | None = None) -> Path:
        """Write a copy of the file with the largest joint limits around rest that are proven free.

        Joints are narrowed one after another, the other ones keep the ranges that they have by then.

        Args:
            out: The copy, in the folder of the file, for its meshes; by default NAME.repaired.SUFFIX.

        Raises:
            AssetError: Links overlap at rest, which no limits mend.
            ExportError: The copy is the file itself or lies in another folder.
        """
        suffix = ".usda" if self.path.suffix.lower() == ".usdz" else self.path.suffix  # a layer is no package
        out = self.path.with_name(f"{self.path.stem}.repaired{suffix}") if out is None else Path(out)
        if out.absolute().parent != self.path.absolute().parent or out.absolute() == self.path.absolute():
            raise ExportError(
                f"cannot write {out}: name another file in {self.path.parent}, where the meshes are found"
            )
        limits: dict[str, tuple[float, float]] = {}
        for tree in self.trees:
            counted = partial(_counts, tree)
            limits |= narrowed_limits(_permitted(tree), counted, overlap=PRESSED, seconds=_REPAIR_SECONDS)
        _REPAIRS[self.model.format](self.path, limits, out)
        return out


def _verdict(verdicts: Sequence[Verdict], moves: bool) -> Verdict:  # noqa: FBT001 - a private helper
    if not moves:
        return "nothing moves"
    return next((each for each in ("collision", "not proven") if each in verdicts), "proven")


def certify(
    path: str | Path,
    *,
    meshes: Meshes = "hull",
    root: str | Path | None = None,
    seconds: float = 10.0,
    total: float = 120.0,
    first: bool = False,
    progress: Callable[[str], None] = lambda text: None,
) -> Judgment:
    """Prove or refute that the links of a file collide nowhere in their joint ranges.

    The file's colliders are judged. Pieces may touch, and overlap by 0.01 mm, as numbers in files are
    rounded. Parents and children count, as do all pairs that the file excludes, in a verdict of their own.

    Args:
        path: URDF (.urdf), MJCF (.xml, .mjcf) or USD (.usd, .usda, .usdc, .usdz).
        meshes: `hull`: each mesh is its convex hull, as most simulators take it; `coacd`: it is decomposed.
        root: Folder that the file may read from; by default two folders above its own.
        seconds: Time limit for the proof of a pair [s].
        total: Time after which the pairs that are left are not proven [s].
        first: Whether to stop at the first collision, which decides the verdict: the pairs that are left are
            not proven.
        progress: Function that is called with what happens next.

    Raises:
        AssetError: The file is damaged or beyond the referee.
        ExportError: There is no such file.
        ParameterError: An argument is not allowed.
    """
    start = time.monotonic()
    path = checked_path(path, "path")
    _check(path, meshes, seconds=seconds, total=total)
    folder = path.parent.resolve()
    allowed = [folder, *folder.parents][: _LEVELS_UP + 1][-1] if root is None else Path(root).resolve()
    progress(f"reading {path.name}")
    form = SUFFIXES[path.suffix.lower()]
    if form == "mjcf" and parse_xml(path).tag == "robot":  # URDF under another name
        form = "urdf"
    model = _READERS[form](path, meshes=meshes, root=allowed)
    trees, notes = trees_of(model)
    trees = [replace(tree, asset=_with_locked(tree.asset)) for tree in trees]
    pairs: list[JudgedPair] = []
    findings: list[Finding] = []
    for runs in zip(*(_runs(tree) for tree in trees), strict=True):  # excluded pairs last
        for run in runs:
            decided = first and any(pair.verdict == "collision" for pair in pairs)
            pairs += _judged(
                run, model, seconds, -np.inf if decided else start + total, progress, first=first
            )
            findings += run.findings
    seconds = time.monotonic() - start
    return Judgment(path, model, tuple(trees), tuple(pairs), tuple(findings), (*model.notes, *notes), seconds)


def _check(path: Path, meshes: str, **limits: float) -> None:
    if path.suffix.lower() not in SUFFIXES:
        raise ParameterError(f"cannot certify {path}: its name must end in {', '.join(SUFFIXES)}")
    if not path.is_file():
        raise ExportError(f"there is no file {path}")
    if meshes not in get_args(Meshes):
        raise ParameterError(f"meshes must be {' or '.join(get_args(Meshes))}, got {meshes!r}")
    for name, limit in limits.items():
        if not is_number(limit) or not 0.0 < limit < np.inf:
            raise ParameterError(f"{name} must be a positive number [s], got {limit!r}")


def _with_locked(asset: Asset) -> Asset:
    """Return an asset in which joints with a tiny range are locked."""

    def locked(joint: AssetJoint) -> AssetJoint:
        if joint.limits is None or not 0.0 < joint.limits[1] - joint.limits[0] <= _SMALLEST_RANGE:
            return joint
        middle = sum(joint.limits) / 2.0
        return replace(joint, limits=(middle, middle))

    return replace(asset, joints=ByName(map(locked, asset.joints)))


def _judged(
    run: "_Run",
    model: ForeignModel,
    seconds: float,
    end: float,
    progress: Callable[[str], None],
    *,
    first: bool,
) -> list[JudgedPair]:
    """Refute or prove the pairs of a run."""
    tree, decided = run.tree, False
    progress(f"examining {len(run.results)} pairs of {len(tree.asset.links)} links in some states")
    for pair in collisions(run.asset, run.joint_paths, end):
        run.results[pair.links] = pair, 0.0
        decided = first and not _restriction(pair, tree.asset, model)
        if decided:
            break
    if not decided:
        progress(f"proving the pairs of {len(tree.asset.links)} links")
        run.prove(seconds, end, progress)
    return [
        JudgedPair(
            pair,
            tree.excluded.get(frozenset(pair.links), run.reason),
            _restriction(pair, tree.asset, model),
            limit if pair.verdict == "not proven" else 0.0,
        )
        for pair, limit in run.results.values()
    ]


class _Run:
    """Some pairs of a tree and their results; they are open before they are refuted or proven."""

    def __init__(
        self, tree: JudgedTree, asset: Asset, counts: Callable[[JudgedTree, JointPath], bool], reason: str
    ) -> None:
        self.tree, self.asset, self.reason = tree, asset, reason
        self.findings: list[Finding] = []
        self._given_up: set[tuple[str, str]] = set()  # pairs that the proof leaves open within its time
        self.joint_paths = [each for each in space_of(asset).joint_paths() if counts(tree, each)]
        opened = [
            PairResult(each.links, each.variables, "not proven", "not proven", open_fraction=1.0)
            for each in self.joint_paths
        ]
        # with the limit that was exceeded [s]
        self.results: dict[tuple[str, str], tuple[PairResult, float]] = {
            pair.links: (pair, 0.0) for pair in opened
        }

    def prove(self, seconds: float, end: float, progress: Callable[[str], None]) -> None:
        """Prove the open pairs: those with few joints together, and each that takes long on its own."""
        few = [each.links for each in self._open() if len(each.variables) <= _FEW_JOINTS]
        self._prove(few, min(seconds, end - time.monotonic()))
        for joint_path in sorted(self._open(), key=lambda each: len(each.variables)):
            a, b = joint_path.links
            progress(f"proving {a} and {b}")
            self._prove([joint_path.links], min(seconds, end - time.monotonic()))

    def _open(self) -> list[JointPath]:
        return [
            each
            for each in self.joint_paths
            if self.results[each.links][0].verdict == "not proven" and each.links not in self._given_up
        ]

    def _prove(self, pairs: Sequence[tuple[str, str]], limit: float) -> None:
        """Add the results of some pairs."""
        if not pairs or limit <= 0.0:
            return
        only, begin = partial(_is_among, frozenset(pairs)), time.monotonic()
        certificate = proof.certify(self.asset, only=only, seconds=limit, overlap=PRESSED)
        late = time.monotonic() - begin > limit
        self.findings += recheck(self.asset, certificate, overlap=PRESSED, only=only)
        self.results.update({pair.links: (pair, limit * late) for pair in certificate.pairs})
        self._given_up |= set() if late else set(pairs)


def _runs(tree: JudgedTree) -> Iterator[_Run]:
    """Yield the pairs that the file lets collide, and the excluded ones as if it did."""
    yield _Run(tree, _permitted(tree), _counts, "")
    yield _Run(tree, tree.asset, _excluded, "some of their geoms")


def _permitted(tree: JudgedTree) -> Asset:
    return replace(tree.asset, contacts=tree.contacts)


def _solid(tree: JudgedTree, joint_path: JointPath) -> bool:
    return all(tree.members[name] for name in joint_path.links)


def _counts(tree: JudgedTree, joint_path: JointPath) -> bool:
    return _solid(tree, joint_path) and frozenset(joint_path.links) not in tree.excluded


def _excluded(tree: JudgedTree, joint_path: JointPath) -> bool:
    pair = frozenset(joint_path.links)
    return _solid(tree, joint_path) and (pair in tree.excluded or pair in tree.partly)


def _is_among(pairs: Collection[tuple[str, str]], joint_path: JointPath) -> bool:
    return joint_path.links in pairs


def _restriction(pair: PairResult, asset: Asset, model: ForeignModel) -> str:
    """Return the constraint that restricts a joint between two links, or an empty text."""
    led = {joint.name for joint in asset.joints if joint.follows and joint.follows.leader in pair.joints}
    moving = [name for name in model.restricted if name in pair.joints or name in led]
    if moving:
        return model.restricted[moving[0]]
    if pair.witness is None:
        return ""
    poses = (pair.witness.pose, pair.witness.first_contact)
    beyond = [_beyond_own(asset, model, led, pose) for pose in poses]
    return f"limits of {beyond[0]!r}" if all(beyond) else ""


def _beyond_own(asset: Asset, model: ForeignModel, led: Collection[str], pose: Mapping[str, float]) -> str:
    """Return the coupled joint whose own limits in the file forbid a pose, or an empty text."""
    own = {joint.name: joint.limits for body in model.bodies for joint in body.joints}
    free = {name: place for name, place in pose.items() if asset.joint(name).follows is None}
    positions = asset.positions(free)
    for name in sorted(led):
        low, high = own.get(name) or (-math.inf, math.inf)
        if not low - _OWN_SLACK <= positions[name] <= high + _OWN_SLACK:
            return name
    return ""
