"""Messages of clients: which of what they print is a fault, and which no asset can avoid."""

import re
from collections.abc import Sequence
from dataclasses import replace

from artgen.validate.clients.client import MACHINE, Client
from artgen.validate.clients.outcome import Tolerated

_COLOURS = re.compile(r"\x1b(\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(\x07|\x1b\\)|[@-Z\\^_])")
_SERIOUS = re.compile(
    r"\b(error|warning|failed|failure|fatal|invalid|cannot|could not|unable to|not found)\b(?!\()",
    re.IGNORECASE,
)


def joined_lines(output: str) -> list[str]:
    """Return the messages of an output: an indented line belongs to the one before it."""
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

    A pattern has to match all of a message, or the beginning of it; what follows, such as a line of the
    source that warns, must not speak of an error itself.
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
