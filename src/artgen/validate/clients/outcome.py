"""What a client made of an export, and the report that holds it beside the checks."""

from dataclasses import dataclass
from typing import Any, Literal

from artgen.asset.report import Finding, Report

State = Literal["passed", "failed", "timed out", "absent", "nothing to read"]


@dataclass(frozen=True)
class Tolerated:
    """Messages of a client that are no fault.

    Attributes:
        message: The first of them.
        count: How many there were.
        reason: Why no asset can avoid it.
    """

    message: str
    count: int
    reason: str


@dataclass(frozen=True)
class Outcome:
    """What a client made of an export.

    Attributes:
        client: Name of the client.
        format: The format that it reads.
        version: The client's version; empty if it is absent.
        state: Only `passed` is a pass.
        findings: What is wrong, or for an absent client how to get it.
        note: A few words of the client, or of what it told.
        seconds: How long it took.
        tolerated: Its messages that are no fault.
    """

    client: str
    format: str
    version: str
    state: State
    findings: tuple[Finding, ...] = ()
    note: str = ""
    seconds: float = 0.0
    tolerated: tuple[Tolerated, ...] = ()

    @property
    def fault(self) -> bool:
        """Whether something is wrong."""
        return any(finding.severity == "fault" for finding in self.findings)

    @property
    def message(self) -> str:
        """The first thing that is wrong, or what it noted."""
        first = next((finding for finding in self.findings if finding.severity == "fault"), None)
        found = first or next(iter(self.findings), None)
        return self.note if found is None else str(found)

    def to_data(self) -> dict[str, Any]:
        """Return it as JSON data."""
        return {
            "client": self.client,
            "format": self.format,
            "version": self.version,
            "state": self.state,
            "note": self.note,
            "seconds": round(self.seconds, 1),
            "findings": [finding.to_data() for finding in self.findings],
            "tolerated": [
                {"message": each.message, "count": each.count, "reason": each.reason}
                for each in self.tolerated
            ],
        }


@dataclass(frozen=True)
class ClientReport(Report):
    """What all checks and some clients said of one asset.

    Attributes:
        outcomes: One for each client.
    """

    outcomes: tuple[Outcome, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether neither a check nor a client found a fault."""
        return super().passed and not any(outcome.fault for outcome in self.outcomes)

    def __str__(self) -> str:
        """Tell the result of each check and client in one line, and each finding in one more."""
        lines = [super().__str__()]
        for outcome in self.outcomes:
            name = f"{outcome.client} {outcome.version}".strip()
            lines.append(f"{name}: {outcome.state}" + (f" ({outcome.note})" if outcome.note else ""))
            lines += [f"  {finding.severity}: {finding}" for finding in outcome.findings]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        return {**super().to_data(), "clients": [outcome.to_data() for outcome in self.outcomes]}
