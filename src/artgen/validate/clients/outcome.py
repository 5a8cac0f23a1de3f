"""Result of a client that read an export, and the report of all clients."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from artgen.asset.report import Finding, Report
from artgen.validate.clients.client import MACHINE, Client

State = Literal["passed", "failed", "timed out", "absent", "nothing to read"]


@dataclass(frozen=True)
class Tolerated:
    """Messages of a client that are not faults."""

    message: str  # first of these messages
    count: int  # number of these messages
    reason: str  # reason why no asset can avoid it


@dataclass(frozen=True)
class Outcome:
    """The result of a client for an export."""

    client: str  # name of the client
    format: str  # format that it reads
    version: str  # the client's version; empty if it is absent
    state: State  # only `passed` is a pass
    findings: tuple[Finding, ...] = ()  # faults, or how to get an absent client
    note: str = ""  # short note about the client or its answer
    seconds: float = 0.0  # duration [s]
    tolerated: tuple[Tolerated, ...] = ()  # messages that are not faults

    @property
    def fault(self) -> bool:
        """Whether there is a fault."""
        return any(finding.severity == "fault" for finding in self.findings)

    @property
    def message(self) -> str:
        """The first fault, or the first note."""
        first = next((finding for finding in self.findings if finding.severity == "fault"), None)
        found = first or next(iter(self.findings), None)
        return self.note if found is None else str(found)

    def to_data(self) -> dict[str, Any]:
        """Return the outcome as JSON data."""
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
    """Results of all checks and several clients for one asset."""

    outcomes: tuple[Outcome, ...] = ()  # one for each client

    @property
    def passed(self) -> bool:
        """Whether neither a check nor a client found a fault."""
        return super().passed and not any(outcome.fault for outcome in self.outcomes)

    def __str__(self) -> str:
        """Return one line for each check and client, and one line for each finding."""
        lines = [super().__str__()]
        for outcome in self.outcomes:
            name = f"{outcome.client} {outcome.version}".strip()
            lines.append(f"{name}: {outcome.state}" + (f" ({outcome.note})" if outcome.note else ""))
            lines += [f"  {finding.severity}: {finding}" for finding in outcome.findings]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        return {**super().to_data(), "clients": [outcome.to_data() for outcome in self.outcomes]}


_COLOURS = re.compile(r"\x1b(\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(\x07|\x1b\\)|[@-Z\\^_])")
_SERIOUS = re.compile(
    r"\b(error|warning|failed|failure|fatal|invalid|cannot|could not|unable to|not found)\b(?!\()",
    re.IGNORECASE,
)


def joined_lines(output: str) -> list[str]:
    """Return the messages of an output; an indented line belongs to the message before it."""
    result: list[str] = []
    for line in _COLOURS.sub("", output).replace("\r", "\n").splitlines():
        if not line.strip():
            continue
        if line[0].isspace() and result:
            result[-1] += "\n" + line.strip()
        else:
            result.append(line.strip())
    return result


def sorted_messages(client: Client, messages: Sequence[str]) -> tuple[tuple[str, ...], tuple[Tolerated, ...]]:
    """Return the messages that are faults, and those that no asset can avoid.

    A pattern has to match the whole message or its beginning; the rest, such as a line of source code, must
    not mention an error.
    """
    faults: list[str] = []
    tolerated: dict[str, Tolerated] = {}
    for text in messages:
        spelled = " ".join(text.split())
        for each in (*client.unavoidable, *MACHINE):
            found = re.match(rf"(?:{each.pattern})(?P<rest>(?:\s[\s\S]*)?)\Z", text)
            if found and not _SERIOUS.search(found["rest"]):
                known = tolerated.get(each.pattern, Tolerated(spelled, 0, each.reason))
                tolerated[each.pattern] = replace(known, count=known.count + 1)
                break
        else:
            faults.append(spelled)
    return tuple(faults), tuple(tolerated.values())
