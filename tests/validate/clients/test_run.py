"""What is made of clients that answer rightly, wrongly, half, or not at all."""

import json
import sys
import time
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen.validate.clients import install as place
from artgen.validate.clients import run
from artgen.validate.clients.exported import differences, moved_by_several, read_exported
from artgen.validate.clients.registry import CLIENTS
from artgen.validate.clients.run import joined_lines, run_all, run_client, sorted_messages
from artgen.validate.readback.compare import expected_frames

ANSWER = """
import json, sys
for request, response in zip(sys.argv[1::2], sys.argv[2::2]):
    json.dump({answer}, open(response, "w"))
"""


@pytest.fixture
def truth(exported):
    """The answer of a client that read everything rightly."""
    asset = exported.asset
    frames = []
    for positions in exported.poses():
        found = expected_frames(asset, positions)
        frames.append({name: frame.tolist() for name, frame in found.items()})
    slide = asset.joint("slide")
    return {
        "version": "1.2",
        "links": {
            link.name: {
                "mass": link.mass_properties.mass,
                "center": (link.mass_properties.center - asset.origin(link.name)).tolist(),
                "inertia": link.mass_properties.inertia.tolist(),
            }
            for link in asset.links
        },
        "joints": {
            "slide": {
                "kind": "prismatic",
                "limits": list(slide.limits),
                "damping": 10.0,
                "friction": 1.0,
                "stiffness": 15.0,
                "rest": slide.rest,
                "armature": 0.0,
            }
        },
        "couplings": {},
        "poses": frames,
        "moved": {"slide": [0.0, 0.2]},
        "steps": 100,
        "finite": True,
        "note": "3 things",
    }


@pytest.fixture
def answer(fake, exported):
    """Return a function that gives the outcome of an answer."""

    def outcome(data, **fields):
        text = json.dumps(data)
        client = fake(ANSWER.format(answer=f"json.loads({text!r})"), **fields)
        return run_client(client, [exported])[0]

    return outcome


def test_a_right_answer_passes(answer, truth):
    outcome = answer(truth)
    assert (outcome.state, outcome.version, outcome.note, outcome.findings) == (
        "passed",
        "1.2",
        "3 things",
        (),
    )
    assert outcome.message == "3 things"


def changed(data, path, value):
    *way, last = path
    for key in way:
        data = data[key]
    data[last] = value


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (("links", "drawer", "mass"), 5.0, "link drawer: its mass is 5 kg in stand_0.urdf, not "),
        (("links", "drawer", "mass"), float("nan"), "link drawer: its mass is nan kg"),
        (("links", "drawer", "center", 0), 0.3, "link drawer: its center of mass is 300 mm away"),
        (("links", "drawer", "inertia", 0, 0), 0.0, "link drawer: its inertia differs by "),
        (("links",), {}, "link drawer: stand_0.urdf has no such link with a mass"),
        (("joints", "slide", "kind"), "revolute", "joint slide: it is revolute in stand_0.urdf"),
        (("joints", "slide", "limits"), [0, 0.1], "joint slide: its limits are 0 to 0.1 m in stand_0.urdf"),
        (("joints", "slide", "limits"), None, "joint slide: its limits are none in stand_0.urdf, not 0"),
        (("joints", "slide", "limits"), [0, float("nan")], "joint slide: its limits are 0 to nan m"),
        (("joints", "slide", "stiffness"), 0.26, "joint slide: its stiffness is 0.26 N/m in stand_0.urdf"),
        (("joints", "slide", "rest"), 0.5, "joint slide: its rest is 0.5 m in stand_0.urdf (fake), not 0"),
        (("joints", "other"), {}, "joint other: it can move in stand_0.urdf, but"),
        (("joints",), {}, "joint slide: stand_0.urdf has no such joint that can move"),
        (("couplings", "slide"), ["other", 1.0, 0.0], "joint slide: it follows 'other' in stand"),
        (("poses", 1, "drawer", 1, 3), 7.0, "link drawer: its frame is off by 7"),
        (("poses", 0, "drawer"), [[0.0]], "an array has the shape (1, 1) instead of (4, 4)"),
        (("poses",), [], "its answer has 0 of 5 poses"),
        (("moved", "slide"), [0.0, 0.001], "joint slide: driven by 100 N it moves only from 0 to 0.001"),
        (("moved", "slide"), [-0.2, 0.2], "joint slide: it leaves its limits of 0 to 0.2"),
        (("moved", "slide"), [float("nan")] * 2, "joint slide: driven by 100 N it moves only from nan"),
        (("finite",), False, "positions become infinite or NaN in simulation"),
        (("said",), ["a tab\n and more"], "it reports: a tab and more"),
        (("links",), 3, "its answer is damaged: "),
        (("links", "lid"), {"mass": 1.0}, "its answer is damaged: AssetError"),
    ],
)
def test_what_differs_is_told(answer, truth, path, value, message):
    changed(truth, path, value)
    outcome = answer(truth)
    assert outcome.state == "failed"
    assert message in "\n".join(str(finding) for finding in outcome.findings)


def test_links_of_several_joints_and_what_hangs_on_them_are_known(tmp_path):
    metal = artgen.material("stainless")

    @artgen.generator
    def stack() -> artgen.Body:
        knob = artgen.part(artgen.box(0.01, 0.01, 0.01).at(0.0, 0.0, 0.2), "knob", metal)
        head = artgen.part(artgen.box(0.05, 0.05, 0.05).at(0.0, 0.0, 0.1), "head", metal)
        base = artgen.part(artgen.box(0.1, 0.1, 0.1), "base", metal)
        head = head.attach(knob, artgen.Revolute("knob_turn", axis=artgen.Z, limits=(0.0, 1.0)))
        rise = artgen.Prismatic("head_slide", axis=artgen.Z, limits=(0.0, 0.02))
        return base.attach(head, artgen.Revolute("head_turn", axis=artgen.Z, limits=(0.0, 1.0)), rise)

    asset = stack.generate(0, certify=False)
    assert moved_by_several(asset) == {"head", "knob"}
    assert moved_by_several(artgen.generate("toaster", 0, certify=False)) == frozenset()

    exported = read_exported(asset.export(tmp_path, formats=("mjcf",), textures=0))
    client, still = replace(CLIENTS["drake_mjcf"], reports=()), {"moved": {"head_turn": [0.0, 0.0]}}
    assert not list(differences(client, exported, still))
    assert list(differences(replace(client, misplaces=False), exported, still))
    assert list(differences(client, exported, {"moved": {"head_turn": [0.0, 2.0]}}))


def test_an_answer_without_what_the_client_has_to_tell_fails(answer, truth):
    del truth["poses"], truth["joints"]
    outcome = answer(truth, reports=("links", "joints", "poses"))
    assert outcome.message == "its answer lacks joints, poses"


def test_a_client_may_have_no_word_for_something(answer, truth):
    for joint in truth["joints"].values():
        del joint["kind"]
    told = answer(truth, reports=("joints",))
    assert "joint slide: its answer lacks kind" in "\n".join(map(str, told.findings))
    assert answer(truth, reports=("joints",), omits=("joints.kind",)).state == "passed"


@pytest.mark.parametrize(
    ("way", "tells", "message"),
    [
        (("links", "drawer", "inertia"), ("links",), "link drawer: its answer lacks inertia"),
        (("joints", "slide", "limits"), ("joints",), "joint slide: its answer lacks limits"),
        (
            ("joints", "slide", "damping"),
            ("joints", "joints.damping"),
            "joint slide: its answer lacks damping",
        ),
        (("moved", "slide"), ("moved",), "joint slide: it was not driven in simulation"),
    ],
)
def test_a_client_that_falls_silent_in_part_fails(answer, truth, way, tells, message):
    *path, last = way
    data = truth
    for key in path:
        data = data[key]
    del data[last]
    outcome = answer(truth, reports=tells)
    assert (outcome.state, outcome.message) == ("failed", message)
    assert answer(truth).state == "passed"


def test_a_simulation_without_steps_is_none(answer, truth):
    truth["steps"] = 0
    assert answer(truth, reports=("steps",)).message == "it simulated no steps"


def test_tolerances_are_the_clients(answer, truth, exported):
    changed(truth, ("links", "drawer", "mass"), exported.asset.link("drawer").mass_properties.mass * 1.00001)
    assert answer(truth).state == "failed"
    assert answer(truth, tolerances=(1e-6, 1e-4)).state == "passed"


@pytest.mark.parametrize(
    ("code", "message"),
    [
        (
            "open(__import__('sys').argv[2], 'w').write('{\"links\": {')",
            "its answer is damaged: JSONDecodeError: Expecting",
        ),
        (
            "open(__import__('sys').argv[2], 'w').write('[1, 2]')",
            "its answer is damaged: TypeError: it is a list",
        ),
        (
            "open(__import__('sys').argv[2], 'wb').write(b'\\xff')",
            "its answer is damaged: UnicodeDecodeError: 'utf-8' codec",
        ),
        (
            "open(__import__('sys').argv[2], 'w').write('[' * 100000)",
            "its answer is damaged: RecursionError: ",
        ),
        ("pass", "it gave no answer"),
        ("raise ValueError('no such mesh')", "it ended with exit code 1: ValueError: no such mesh"),
        ("import os, signal; os.kill(os.getpid(), signal.SIGABRT)", "it crashed: SIGABRT"),
        ("import sys; sys.exit(4)", "it ended with exit code 4"),
    ],
)
def test_half_and_missing_answers_are_failures(fake, exported, code, message):
    (outcome,) = run_client(fake(code), [exported])
    assert outcome.state == "failed"
    assert outcome.message.startswith(message)


def test_a_client_that_hangs_is_timed_out(fake, exported):
    (outcome,) = run_client(fake("import time; time.sleep(60)", seconds=0.5), [exported])
    assert outcome.state == "timed out"
    assert outcome.fault
    assert outcome.message.startswith("it was killed after ")


def test_an_answer_before_a_crash_is_no_pass(fake, exported):
    code = (
        ANSWER.format(answer="{'version': '3'}") + "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)"
    )
    (outcome,) = run_client(fake(code), [exported])
    assert (outcome.state, outcome.version) == ("failed", "3")
    assert outcome.message == "it crashed: SIGSEGV"


def test_what_is_printed_is_a_fault_unless_no_asset_can_avoid_it(fake, exported):
    code = (
        ANSWER.format(answer="{}") + "print('built on Monday'); print('built on Monday'); print('bad mesh')"
    )
    monday = ("built on .*day", "it always says so")
    (outcome,) = run_client(fake(code, unavoidable=(monday,)), [exported])
    assert [str(finding) for finding in outcome.findings] == ["it reports: bad mesh"]
    assert [(each.count, each.reason) for each in outcome.tolerated] == [(2, "it always says so")]
    longer = ("built on", "only its beginning")
    (outcome,) = run_client(fake(code, unavoidable=(("uilt on Monday", ""), longer)), [exported])
    assert outcome.message == "it reports: bad mesh"
    (outcome,) = run_client(fake("print('a' * 3)\nprint('b')" + ANSWER.format(answer="{}")), [exported])
    assert [str(finding) for finding in outcome.findings] == ["it reports: aaa", "it reports: b"]


def test_many_messages_are_counted(fake, exported):
    code = ANSWER.format(answer="{}") + "for number in range(9): print('message', number)"
    (outcome,) = run_client(fake(code), [exported])
    assert len(outcome.findings) == 6
    assert str(outcome.findings[-1]) == "it reports 4 more messages"


def test_an_indented_line_belongs_to_the_one_before():
    lines = joined_lines("a.py:3: UserWarning: old\n  call()\n\nnext\r\n")
    assert lines == ["a.py:3: UserWarning: old\ncall()", "next"]


def test_colors_are_no_part_of_messages():
    assert joined_lines("\x1b[1;33m[warn]\x1b[0m old\n\x1b]0;title\x07") == ["[warn] old"]


def test_an_error_below_a_message_that_is_no_fault_is_a_fault(fake):
    client = fake("", unavoidable=(("it is Monday.*", "it always says so"),))
    lines = joined_lines("it is Monday\n  print(day)\nit is Monday\n  Error: no such mesh\n")
    faults, tolerated = sorted_messages(client, lines)
    assert faults == ("it is Monday Error: no such mesh",)
    assert [(each.message, each.count) for each in tolerated] == [("it is Monday print(day)", 1)]


def test_a_client_that_ends_with_the_code_of_absence_and_says_why_has_failed(fake, exported):
    (outcome,) = run_client(fake("import sys; print('abort() was called'); sys.exit(3)"), [exported])
    assert (outcome.state, outcome.message) == ("failed", "it ended with exit code 3: abort() was called")


def test_a_client_whose_interpreter_does_not_start_has_failed(fake, exported, monkeypatch, tmp_path):
    program = tmp_path / "drake/bin/python"
    program.parent.mkdir(parents=True)
    program.write_text("no program")
    monkeypatch.setenv(place.VARIABLE, str(tmp_path))
    (outcome,) = run_client(fake("pass", distribution="no-such-thing", environment="drake"), [exported])
    assert outcome.state == "failed"
    assert outcome.message.endswith("/drake/bin/python cannot be started: Permission denied")


def test_a_driver_finds_its_package_and_works_in_an_empty_directory(fake, exported):
    code = ANSWER.format(answer="{'said': os.listdir('.') + [json.__file__[-13:]]}").replace(
        "import json, sys", "import json, os, sys"
    )
    (outcome,) = run_client(fake(code, name="json"), [exported])
    assert [str(finding) for finding in outcome.findings] == ["it reports: n/__init__.py"]


def test_a_driver_whose_client_is_missing_is_absent(fake, exported):
    (outcome,) = run_client(fake("import sys; sys.exit(3)", obtain="buy it"), [exported])
    assert outcome.state == "absent"
    assert not outcome.fault
    assert outcome.message == "it is not installed; buy it"


def test_a_client_without_interpreter_is_absent(fake, exported, monkeypatch, tmp_path):
    monkeypatch.setenv(place.VARIABLE, str(tmp_path / "none"))
    client = fake("pass", distribution="no-such-thing", environment="drake")
    (outcome,) = run_client(client, [exported])
    assert (outcome.state, outcome.version) == ("absent", "")
    assert "artgen clients --install fake" in outcome.message


def test_what_it_does_not_read_it_is_not_asked(fake, exported):
    client = fake("raise SystemExit(9)", format="glb")
    (outcome,) = run_client(client, [exported])
    assert outcome.state == "nothing to read"
    assert outcome.message == "it reads glb, which the export does not have"
    (outcome,) = run_client(fake("raise SystemExit(9)", layouts=("simready",)), [exported])
    assert outcome.message == "it reads the layouts simready, not flat"


COUNTING = """
import json, pathlib, sys
with open({log!r}, "a") as log:
    log.write(f"{{len(sys.argv) // 2}}\\n")
for number, (request, response) in enumerate(zip(sys.argv[1::2], sys.argv[2::2])):
    asked = json.load(open(request))
    if "bad" in asked["directory"]:
        {bad}
    json.dump({{"version": "1"}}, open(response, "w"))
"""


@pytest.mark.parametrize("bad", ["raise ValueError('bad')", "print('bad')", "continue"])
def test_several_exports_are_read_by_one_process_and_the_bad_one_is_found(
    fake, drawer, tmp_path, bad, exported
):
    from dataclasses import replace

    log = tmp_path / "log"
    client = fake(COUNTING.format(log=str(log), bad=bad))
    good = [exported] * 3
    assert [outcome.state for outcome in run_client(client, good)] == ["passed"] * 3
    assert log.read_text() == "3\n"
    worse = replace(exported, directory=tmp_path / "bad")
    states = [outcome.state for outcome in run_client(client, [exported, exported, worse, exported])]
    assert states == ["passed", "passed", "failed", "passed"]


def test_all_clients_answer_in_their_order(fake, exported):
    clients = [fake(ANSWER.format(answer="{}"), name=name) for name in ("third", "first", "second")]
    outcomes = run_all(clients, exported)
    assert [outcome.client for outcome in outcomes] == ["third", "first", "second"]


def test_an_interruption_does_not_wait_for_clients(fake, exported, monkeypatch):
    slow = [fake("import time; time.sleep(60)", name=name, seconds=60.0) for name in ("first", "second")]

    def interrupted(client, exports):
        if client.name == "first":
            time.sleep(1.0)
            raise KeyboardInterrupt
        return run_client(client, exports)

    monkeypatch.setattr(run, "run_client", interrupted)
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        run_all(slow, exported)
    assert time.monotonic() - start < 20.0


def test_requests_hold_what_drivers_are_promised(fake, exported):
    request = exported.request(fake("pass"))
    assert request["links"] == ["body", "drawer"]
    (joint,) = request["joints"]
    assert (joint["name"], joint["kind"], joint["limits"]) == ("slide", "prismatic", [0.0, 0.2])
    assert (joint["follows"], joint["blocked"], joint["effort"]) == (None, False, 100.0)
    assert request["poses"][0] == {"slide": 0.0}
    assert len({pose["slide"] for pose in request["poses"]}) == 5
    assert all(0.0 <= pose["slide"] <= 0.2 for pose in request["poses"])
    assert np.isfinite(list(request["poses"][1].values())).all()
    assert json.loads(json.dumps(request)) == request
    assert sys.executable
