"""Findings of checks, and the report of all checks of one asset."""

import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from artgen.asset.record import Record, rounded

Severity = Literal["fault", "note"]

AGAIN = "export the asset again"  # the hint where a file is not as artgen writes it
CHANGED = f"the file was changed, or is of another asset: {AGAIN}"  # the hint where it contradicts the asset
_DIGITS = 9  # significant digits of numbers in a report
_NUMBER = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?")
_NUMBERS = re.compile(r"\d+(_\d+)*")  # the number or numbers in a name
_MOST_JOINTS = 6  # most joints of a printed pose


@dataclass(frozen=True)
class Finding(Record):
    """One fault or note that a check reports."""

    FIRST: ClassVar = ("check", "severity")

    check: str  # name of the check, such as `solids`
    message: str  # the fault in one sentence, with the number
    link: str = ""  # name of the faulty link, or of two links as `door, frame`
    joint: str = ""  # name of the faulty joint
    value: float | None = None  # the faulty number, in `unit`
    unit: str = ""  # its SI unit, such as `m`
    pose: Mapping[str, float] = field(default_factory=dict)  # joint positions of the fault [rad or m]
    hint: str = ""  # remedy
    severity: Severity = (
        "fault"  # a `fault` fails the check; a `note` is about something that the check could not judge
    )

    def __str__(self) -> str:
        return self.text(self.pose)

    def text(self, pose: Mapping[str, float], most: int | None = None) -> str:
        """Format the finding with another pose, of which `most` joints are named [rad or m]."""
        names = {"link": self.link, "joint": self.joint}
        place = ", ".join(f"{kind} {name}" for kind, name in names.items() if name)
        parts = [f"{name}={position:.4g}" for name, position in pose.items()][:most]
        if len(parts) < len(pose):
            parts.append(f"and {len(pose) - len(parts)} other joints")
        text = f"{place}: {self.message}" if place else self.message
        text += f" (at {', '.join(parts)})" if parts else ""
        return f"{text}; {self.hint}" if self.hint else text

    @property
    def alike(self) -> tuple[str, ...]:
        """The finding without numbers: the same for joints and links that are numbered and fail alike."""
        texts = (self.check, self.severity, self.link, self.joint, self.message, self.hint)
        return tuple(_NUMBER.sub("*", text) for text in texts)

    def to_data(self) -> dict[str, Any]:
        """Return the finding as JSON data."""
        data: dict[str, Any] = rounded(super().to_data(), _DIGITS)
        return {key: _finite(value) for key, value in data.items()}


def _finite(value: Any) -> Any:
    """Return None for a number that JSON does not have, also in a pose."""
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    return None if isinstance(value, float) and not math.isfinite(value) else value


@dataclass(frozen=True)
class CheckResult:
    """The result of one check of an asset."""

    check: str  # name of the check
    findings: tuple[Finding, ...] = ()  # its faults and notes
    detail: str = ""  # number of checked items, such as `5 links, 31 solids`
    skipped: str = ""  # reason why the check could not run; empty if it ran

    @property
    def faults(self) -> tuple[Finding, ...]:
        """The findings that fail the check."""
        return tuple(finding for finding in self.findings if finding.severity == "fault")

    @property
    def state(self) -> str:
        """`passed`, `failed` or `skipped`."""
        return "skipped" if self.skipped else "failed" if self.faults else "passed"

    @property
    def counted(self) -> str:
        """The detail, or the reason why the check was skipped, with the numbers of faults and notes."""
        parts = [self.skipped or self.detail]
        notes = len(self.findings) - len(self.faults)
        for count, word in ((len(self.faults), "fault"), (notes, "note")):
            if count:
                parts.append(f"{count} {word}{'' if count == 1 else 's'}")
        return "; ".join(part for part in parts if part)

    def to_data(self) -> dict[str, Any]:
        """Return the result as JSON data."""
        return {
            "check": self.check,
            "state": self.state,
            "detail": self.skipped or self.detail,
            "findings": [finding.to_data() for finding in self.findings],
        }


def grouped(
    findings: Iterable[Finding], near: Mapping[str, tuple[float, float]]
) -> list[tuple[Finding, str]]:
    """Return the first of all findings that are alike, and a text for them.

    Args:
        findings: Findings.
        near: For joints by name, the ends of the positions that are left out of poses [rad or m].
    """
    groups: dict[tuple[str, ...], list[Finding]] = {}
    for finding in findings:
        groups.setdefault(finding.alike, []).append(finding)
    return [(group[0], _group_text(group, near)) for group in groups.values()]


def _group_text(group: Sequence[Finding], near: Mapping[str, tuple[float, float]]) -> str:
    """Format findings that are alike by the first of them, with the joints that are away from rest."""
    first = group[0]
    pose = dict(first.pose)
    for name, (low, high) in near.items():
        if low <= pose.get(name, math.nan) <= high:
            del pose[name]
    text = first.text(pose, _MOST_JOINTS)
    if len(group) == 1:
        return text
    kind = "joints" if first.joint else "links"
    names = {each.joint or each.link for each in group}
    pattern = _NUMBERS.sub("*", first.joint or first.link)
    count = f"{len(names)} {kind}" if len(names) == len(group) else f"{len(group)} times"
    return f"{pattern} ({count}), such as {text}" if pattern else f"{count}, such as {text}"


@dataclass(frozen=True)
class Report:
    """The results of all checks of one asset.

    Printed, it is a table of the checks with the findings below; findings that differ only in numbers are one
    line, and poses name the joints away from rest only. `to_data` has all findings with full poses.
    """

    asset: str  # name of the asset
    results: tuple[CheckResult, ...]  # one for each check, in the order in which they ran
    # positions within 1 % of the range from rest, by joint [rad or m]
    near: Mapping[str, tuple[float, float]] = field(
        default_factory=dict, compare=False, repr=False, kw_only=True
    )

    @property
    def faults(self) -> tuple[Finding, ...]:
        """The faults of all checks."""
        return tuple(fault for result in self.results for fault in result.faults)

    @property
    def passed(self) -> bool:
        """Whether no check found a fault."""
        return not self.faults

    def __str__(self) -> str:
        rows = [(each.check, each.state, each.counted) for each in self.results]
        widths = [max(map(len, column)) for column in list(zip(*rows, strict=True))[:2]] if rows else []
        lines = [
            f"{check:{widths[0]}}  {state:{widths[1]}}  {detail}".rstrip() for check, state, detail in rows
        ]
        for finding, text in grouped(
            (each for result in self.results for each in result.findings), self.near
        ):
            lines.append(f"{finding.severity} {finding.check}: {text}")
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        results = [result.to_data() for result in self.results]
        return {"asset": self.asset, "passed": self.passed, "results": results}

    def to_json(self) -> str:
        """Return the report as JSON text."""
        return json.dumps(self.to_data(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
