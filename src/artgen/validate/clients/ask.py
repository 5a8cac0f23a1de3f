"""Letting clients read one export: those that are there, each on its own."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from artgen.asset.report import Finding
from artgen.errors import ArtgenError
from artgen.validate.clients.client import Client
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.outcome import Outcome
from artgen.validate.clients.run import ask_all

_UNREAD = ("absent", "nothing to read")


def ask_clients(directory: str | Path, clients: Sequence[Client], *, by_name: bool) -> list[Outcome]:
    """Return what clients make of an export, in their order."""
    try:
        exported = read_exported(directory)
    except ArtgenError as error:
        return [
            Outcome(client.name, client.format, "", "failed", (Finding(client.name, str(error)),))
            for client in clients
        ]
    readers = [client for client in clients if exported.is_read_by(client)]
    outcomes = ask_all(clients if by_name or not readers else readers, exported)
    none_read = all(outcome.state in _UNREAD for outcome in outcomes)
    return [_required(outcome) for outcome in outcomes] if by_name or none_read else outcomes


def _required(outcome: Outcome) -> Outcome:
    if outcome.state not in _UNREAD:
        return outcome
    findings = tuple(replace(finding, severity="fault") for finding in outcome.findings)
    return replace(outcome, findings=findings)
