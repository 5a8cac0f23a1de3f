"""Findings of checks, and the report of all checks of one asset."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from artgen.asset.record import Record, rounded

Severity = Literal["fault", "note"]

AGAIN = "export the asset again"  # the hint where a file is not as artgen writes it
CHANGED = f"the file was changed, or is of another asset: {AGAIN}"  # the hint where it contradicts the asset
_DIGITS = 9  # significant digits of numbers in a report


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
        names = {"link": self.link, "joint": self.joint}
        place = ", ".join(f"{kind} {name}" for kind, name in names.items() if name)
        pose = ", ".join(f"{name}={position:.4g}" for name, position in self.pose.items())
        text = f"{place}: {self.message}" if place else self.message
        text += f" (at {pose})" if pose else ""
        return f"{text}; {self.hint}" if self.hint else text

    def to_data(self) -> dict[str, Any]:
        """Return the finding as JSON data."""
        data: dict[str, Any] = rounded(super().to_data(), _DIGITS)
        return data


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

    def to_data(self) -> dict[str, Any]:
        """Return the result as JSON data."""
        state = "skipped" if self.skipped else "failed" if self.faults else "passed"
        return {
            "check": self.check,
            "state": state,
            "detail": self.skipped or self.detail,
            "findings": [finding.to_data() for finding in self.findings],
        }


@dataclass(frozen=True)
class Report:
    """The results of all checks of one asset."""

    asset: str  # name of the asset
    results: tuple[CheckResult, ...]  # one for each check, in the order in which they ran

    @property
    def faults(self) -> tuple[Finding, ...]:
        """The faults of all checks."""
        return tuple(fault for result in self.results for fault in result.faults)

    @property
    def passed(self) -> bool:
        """Whether no check found a fault."""
        return not self.faults

    def __str__(self) -> str:
        lines = []
        for result in self.results:
            data = result.to_data()
            detail = f" ({data['detail']})" if data["detail"] else ""
            lines += [f"{result.check}: {data['state']}{detail}"]
            lines += [f"  {finding.severity}: {finding}" for finding in result.findings]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        results = [result.to_data() for result in self.results]
        return {"asset": self.asset, "passed": self.passed, "results": results}

    def to_json(self) -> str:
        """Return the report as JSON text."""
        return json.dumps(self.to_data(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
