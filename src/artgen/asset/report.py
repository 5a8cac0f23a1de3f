"""Findings of checks, and the report of all checks of one asset."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from artgen.asset.record import significant

Severity = Literal["fault", "note"]

AGAIN = "export the asset again"
"""The hint where a file is not as artgen writes it."""

CHANGED = f"the file was changed, or is of another asset: {AGAIN}"
"""The hint where a file does not say what the asset is."""

_DIGITS = 9  # significant digits of numbers in a report


@dataclass(frozen=True)
class Finding:
    """One fault or note that a check reports.

    Attributes:
        check: Name of the check, such as `solids`.
        message: The fault in one sentence, with the number.
        link: Name of the faulty link, or of two links as `door, frame`.
        joint: Name of the faulty joint.
        value: The faulty number, in `unit`.
        unit: Its SI unit, such as `m`.
        pose: Joint positions of the fault [rad or m].
        hint: Remedy.
        severity: A `fault` fails the check; a `note` says what the check could not judge.
    """

    check: str
    message: str
    link: str = ""
    joint: str = ""
    value: float | None = None
    unit: str = ""
    pose: Mapping[str, float] = field(default_factory=dict)
    hint: str = ""
    severity: Severity = "fault"

    def __str__(self) -> str:
        """Return place, fault and remedy in one line."""
        place = ", ".join(
            f"{kind} {name}" for kind, name in (("link", self.link), ("joint", self.joint)) if name
        )
        pose = ", ".join(f"{name}={position:.4g}" for name, position in self.pose.items())
        text = f"{place}: {self.message}" if place else self.message
        text += f" (at {pose})" if pose else ""
        return f"{text}; {self.hint}" if self.hint else text

    def to_data(self) -> dict[str, Any]:
        """Return the finding as JSON data."""
        return {
            "check": self.check,
            "severity": self.severity,
            "message": self.message,
            "link": self.link,
            "joint": self.joint,
            "value": None if self.value is None else significant(self.value, _DIGITS),
            "unit": self.unit,
            "pose": {name: significant(position, _DIGITS) for name, position in self.pose.items()},
            "hint": self.hint,
        }


@dataclass(frozen=True)
class CheckResult:
    """The result of one check of an asset.

    Attributes:
        check: Name of the check.
        findings: Its faults and notes.
        detail: Number of checked items, such as `5 links, 31 solids`.
        skipped: Reason why the check could not run; empty if it ran.
    """

    check: str
    findings: tuple[Finding, ...] = ()
    detail: str = ""
    skipped: str = ""

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
        """Return one line for each check and one for each finding."""
        lines = []
        for result in self.results:
            data = result.to_data()
            lines.append(
                f"{result.check}: {data['state']}" + (f" ({data['detail']})" if data["detail"] else "")
            )
            lines += [f"  {finding.severity}: {finding}" for finding in result.findings]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        return {
            "asset": self.asset,
            "passed": self.passed,
            "results": [result.to_data() for result in self.results],
        }

    def to_json(self) -> str:
        """Return the report as JSON text."""
        return json.dumps(self.to_data(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
