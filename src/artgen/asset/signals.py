"""Outputs of an asset, such as lights and motors, and the signals of its joints that control them."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Literal

from artgen.asset.joint import AssetCondition, AssetJoint
from artgen.asset.record import Record
from artgen.errors import AssetError, nearest

SignalKind = Literal["level", "pressed", "where", "toggle", "timer", "latest", "all", "any", "not", "scaled"]
OutputKind = Literal["light", "heat", "motor", "flow", "display", "sound"]

_PHRASES: Mapping[str, str] = {
    "level": "level of {joint}",
    "pressed": "{joint} pressed",
    "where": "{condition}",
    "toggle": "toggled by {0}",
    "timer": "{seconds:g} s after {0}",
    "not": "not {0}",
    "scaled": "{factor:g} x {0}",
}
_NEEDED: Mapping[str, tuple[str, ...]] = {
    "level": ("joint",),
    "pressed": ("joint",),
    "where": ("condition",),
    "timer": ("terms", "seconds"),
    "latest": ("terms", "values"),
    "scaled": ("terms", "factor"),
    **dict.fromkeys(("toggle", "all", "any", "not"), ("terms",)),
}
"""Fields that a signal of each kind reads."""

_MANY = ("latest", "all", "any")  # kinds that combine several terms
_FAR = 2.0 / 3.0  # level from which a control counts as pressed
_MOST = 4  # controls that are named
_LINKED = {"all": " and ", "any": " or "}


@dataclass(frozen=True)
class AssetSignal(Record):
    """A number from 0 to 1 that follows from the motion of joints, see `artgen.signals`."""

    OPTIONAL: ClassVar = frozenset(
        {"joint", "ends", "condition", "terms", "unless", "seconds", "values", "factor"}
    )

    kind: SignalKind
    joint: str | None = None  # joint of `level` and `pressed`
    ends: tuple[float, float] | None = None  # its positions at level 0 and 1, known in an asset [rad or m]
    condition: AssetCondition | None = None  # of `where`
    terms: tuple["AssetSignal", ...] | None = None  # the signals that it combines
    unless: "AssetSignal | None" = None  # signal that holds `toggle` and `timer` at 0
    seconds: float | None = None  # duration of `timer` [s]
    values: tuple[float, ...] | None = None  # value of `latest` after each term rose
    factor: float | None = None  # of `scaled`

    def __post_init__(self) -> None:
        """Check that the signal has what its kind reads.

        Raises:
            AssetError: It has not.
        """
        needed, terms = _NEEDED[self.kind], len(self.terms or ())
        missing = [name for name in needed if getattr(self, name) is None]
        if missing:
            raise AssetError(f"a signal of the kind {self.kind!r} has no {missing[0]}")
        if "terms" in needed and (terms < 1 or (terms > 1 and self.kind not in _MANY)):
            raise AssetError(f"a signal of the kind {self.kind!r} cannot have {terms} terms")
        if self.values is not None and len(self.values) != terms:
            raise AssetError(
                f"a signal has {terms} terms and {len(self.values)} values; give a value for each"
            )

    def parts(self) -> "list[AssetSignal]":
        """Return the signals that this one reads directly."""
        return [*(self.terms or ()), *([] if self.unless is None else [self.unless])]

    def joints(self) -> tuple[str, ...]:
        """Return the names of the joints that it reads, in order of appearance."""
        own = [self.joint] if self.joint is not None else []
        own += self.condition.joints() if self.condition is not None else ()
        return tuple(dict.fromkeys([*own, *(name for each in self.parts() for name in each.joints())]))

    def renamed(self, names: Mapping[str, str]) -> "AssetSignal":
        """Return the signal with joints renamed; names not in `names` stay."""
        return self._with(
            lambda signal: replace(
                signal,
                joint=None if signal.joint is None else names.get(signal.joint, signal.joint),
                condition=None if signal.condition is None else signal.condition.renamed(names),
            )
        )

    def between(self, joints: Mapping[str, AssetJoint]) -> "AssetSignal":
        """Return the signal with the positions at which its joints have levels 0 and 1.

        Raises:
            AssetError: A joint has no limits, or one position only.
        """
        return self._with(lambda signal: signal._measured(joints))

    def _measured(self, joints: Mapping[str, AssetJoint]) -> "AssetSignal":
        if self.joint is None or self.ends is not None:
            return self
        joint = joints[self.joint]
        if joint.limits is None or joint.locked:
            raise AssetError(
                f"signal {self.kind!r} reads joint {self.joint!r}, which has no range; give it limits, or "
                "compare its position: joint > 0.5",
                joint=self.joint,
            )
        return replace(self, ends=(joint.closed, joint.opened))

    def _with(self, change: Any) -> "AssetSignal":
        """Return the signal with a change of it and all signals that it reads."""
        terms = None if self.terms is None else tuple(each._with(change) for each in self.terms)
        unless = None if self.unless is None else self.unless._with(change)
        changed: AssetSignal = change(replace(self, terms=terms, unless=unless))
        return changed

    def __str__(self) -> str:
        plain = [each.kind in _PHRASES and each.unless is None for each in self.terms or ()]
        terms = [
            str(each) if bare else f"({each})" for each, bare in zip(self.terms or (), plain, strict=True)
        ]
        pressed = [each.joint for each in self.terms or () if each.kind == "pressed"]
        if self.kind == "any" and len(pressed) == len(terms) > _MOST:
            text = f"any of {len(terms)} controls pressed: {pressed[0]} to {pressed[-1]}"
        elif self.kind in _LINKED:
            text = _LINKED[self.kind].join(terms)
        elif self.kind == "latest":
            pairs = zip(self.values or (), terms, strict=True)
            text = ", ".join(f"{value:g} after {term}" for value, term in pairs)
        elif self.kind == "pressed" and self.ends is not None and self.ends[0]:
            start, end = self.ends
            text = f"{self.joint} beyond {start + _FAR * (end - start):.3g}"
        else:
            text = _PHRASES[self.kind].format(*terms, **vars(self))
        return text if self.unless is None else f"{text}, off while {self.unless}"


@dataclass(frozen=True)
class AssetOutput(Record):
    """What a product does when its controls are used.

    Attributes:
        name: Identifier, unique in the asset.
        kind: `light`, `heat`, `motor`, `flow` of water, air or gas, `display` or `sound`.
        signal: Its value, from 0 for off to 1.
        material: Name of the material that shines with the output, on no other part; None if no part does.
        color: Emission of that material at 1, linear RGB.
        joint: Name of the joint that a motor moves; None without a motor.
        speed: Speed of that joint at 1 [rad/s or m/s].
    """

    OPTIONAL: ClassVar = frozenset({"material", "color", "joint", "speed"})

    name: str
    kind: OutputKind
    signal: AssetSignal
    material: str | None = None
    color: tuple[float, float, float] | None = None
    joint: str | None = None
    speed: float | None = None

    def joints(self) -> tuple[str, ...]:
        """Return the names of its joints: those that control it, then the one that it moves."""
        return (*self.signal.joints(), *([self.joint] if self.joint is not None else []))

    def renamed(self, name: str, joints: Mapping[str, str], materials: Mapping[str, str]) -> "AssetOutput":
        """Return the output with another name and renamed joints and materials; others stay."""
        return replace(
            self,
            name=name,
            signal=self.signal.renamed(joints),
            joint=None if self.joint is None else joints.get(self.joint, self.joint),
            material=None if self.material is None else materials.get(self.material, self.material),
        )

    def __str__(self) -> str:
        return f"{self.name} ({self.kind}): {self.signal}"


def checked_outputs(
    outputs: tuple[AssetOutput, ...], joints: Mapping[str, AssetJoint]
) -> tuple[AssetOutput, ...]:
    """Return outputs with the ranges of their joints.

    Raises:
        AssetError: A name is used twice, an asset has no such joint, or a joint has no range.
    """
    names = [each.name for each in outputs]
    for output in outputs:
        if names.count(output.name) > 1:
            raise AssetError(f"the output name {output.name!r} is used twice; give one another name")
        for name in output.joints():
            if name not in joints:
                raise AssetError(
                    f"output {output.name!r} reads {name!r}, which is not a joint of this asset; "
                    f"attach {name!r} as well.{nearest(name, joints)}",
                    joint=name,
                )
    return tuple(replace(each, signal=each.signal.between(joints)) for each in outputs)
