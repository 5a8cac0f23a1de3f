"""Which clients are asked about an export, and what becomes of those that are not there."""

import json

import pytest

from artgen.asset.report import CheckResult, Finding
from artgen.errors import ParameterError
from artgen.validate.clients import run as module
from artgen.validate.clients.registry import CLIENTS, chosen_clients
from artgen.validate.clients.run import ClientReport, Outcome, run_clients
from support.exports import edit_json

PASSED = Outcome("one", "urdf", "1", "passed", note="all of it")
ABSENT = Outcome("two", "urdf", "", "absent", (Finding("two", "not there", severity="note"),))


@pytest.fixture
def asked(monkeypatch):
    """Let no client run, and remember which were asked."""
    names = []

    def run_all(clients, exported):
        names.extend(client.name for client in clients)
        return [PASSED, ABSENT][: len(clients)]

    monkeypatch.setattr(module, "run_all", run_all)
    return names


def test_of_all_only_those_are_asked_that_have_something_to_read(asked, drawer):
    outcomes = run_clients(drawer, list(CLIENTS.values()), by_name=False)
    assert {"pinocchio", "drake_mjcf", "newton_usd"} <= set(asked)
    assert not {"gltf_validator", "simready_validate", "robosuite"} & set(asked)
    assert outcomes == [PASSED, ABSENT]
    assert not any(outcome.fault for outcome in outcomes)


def test_an_absent_client_is_a_fault_if_it_was_named(asked, drawer):
    outcomes = run_clients(drawer, list(CLIENTS.values())[:2], by_name=True)
    assert [outcome.fault for outcome in outcomes] == [False, True]
    assert outcomes[1].state == "absent"


def test_where_no_client_reads_the_export_that_is_no_pass(drawer, monkeypatch):
    monkeypatch.setattr(module, "run_all", lambda clients, exported: [ABSENT for _ in clients])
    outcomes = run_clients(drawer, list(CLIENTS.values()), by_name=False)
    assert outcomes
    assert all(outcome.fault and outcome.state == "absent" for outcome in outcomes)


def test_where_no_client_knows_the_layout_all_have_failed(directory):
    edit_json(directory / "asset.json", lambda data: data.update(layout="flatt"))
    outcomes = run_clients(directory, list(CLIENTS.values()), by_name=False)
    assert {outcome.state for outcome in outcomes} == {"nothing to read"}
    assert all(outcome.fault for outcome in outcomes)


def test_an_export_that_cannot_be_read_fails_every_client(directory):
    (directory / "asset.json").write_text("{}")
    (outcome,) = run_clients(directory, [CLIENTS["drake_urdf"]], by_name=False)
    assert outcome.state == "failed"
    assert "has format None" in outcome.message


def test_a_report_with_clients_passes_if_checks_and_clients_do():
    fault = Outcome("three", "usd", "2", "timed out", (Finding("three", "slow"),))
    good = ClientReport("it", (CheckResult("tree"),), (PASSED, ABSENT))
    assert good.passed
    assert str(good).splitlines() == [
        "tree  passed",
        "one 1: passed (all of it)",
        "two: absent",
        "  note: not there",
    ]
    assert not ClientReport("it", (CheckResult("tree"),), (PASSED, fault)).passed
    assert not ClientReport("it", (CheckResult("tree", (Finding("tree", "bad"),)),), (PASSED,)).passed
    data = json.loads(good.to_json())
    assert [(each["client"], each["state"]) for each in data["clients"]] == [
        ("one", "passed"),
        ("two", "absent"),
    ]


def test_clients_are_chosen_by_name():
    assert chosen_clients("all") == (tuple(CLIENTS.values()), False)
    found, by_name = chosen_clients(" pybullet, drake_urdf,pybullet")
    assert ([client.name for client in found], by_name) == (["pybullet", "drake_urdf"], True)


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ("pybulet", "there is no client 'pybulet'. Did you mean 'pybullet'?"),
        ("mujoco,nothing_like_it_all", "there is no client 'nothing_like_it_all'. Allowed: all, "),
        (" , ", "' , ' names no client; give 'all' or some of: mujoco, "),
    ],
)
def test_an_unknown_client_has_the_nearest_name(names, message):
    with pytest.raises(ParameterError) as caught:
        chosen_clients(names)
    assert str(caught.value).startswith(message)
