"""The soak: interrupted runs, anomalies, and commands that reproduce them."""

import json
import os
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from surveys.extreme_sample import measure_extreme
from surveys.extremes import category_of, draw_extreme
from surveys.rest import oddities
from surveys.run import read_records
from surveys.soak import again, anomalies, soak, soaked, tallies
from typer.testing import CliRunner

from artgen import Body, Prismatic, Revolute, X, Z, box, material, part
from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.cli import command_line
from artgen.dataset.places import locked
from artgen.errors import ExportError
from artgen.graph import evaluate
from surveys import extreme_sample, rest

pytestmark = pytest.mark.long  # scripts of maintainers

ROOT = Path(__file__).parents[2]
NAMES = categories()
OAK, STEEL = material("oak"), material("steel")


def counted(number: int, *, run: int, folder: Path) -> dict[str, Any]:
    """Replace `measure_extreme`, which is slow."""
    if number == 1:
        raise ValueError("no such sample")
    if number == 2:
        os._exit(1)
    assert folder.is_dir()
    return {"run": run, "sample": number, "category": category_of(number), "state": "sound", "anomalies": []}


def slow(number: int, *, run: int, folder: Path) -> dict[str, Any]:
    """Replace `measure_extreme`, with a file that stays when a process is killed."""
    (folder / "left").write_text(str(number))
    time.sleep(0.0 if number == 0 else 60.0)
    return counted(number, run=run, folder=folder)


def brief(number: int, *, run: int, folder: Path) -> dict[str, Any]:
    """Replace `measure_extreme`, and record the process."""
    time.sleep(0.05)
    return {
        "run": run,
        "sample": number,
        "category": category_of(number),
        "state": "sound",
        "anomalies": [],
        "process": os.getpid(),
    }


def run_of(path: Path, samples: int, task: Any = counted, names: Any = NAMES, **options: Any) -> None:
    """Run until a number of samples is done: the time is over when the next one would begin."""
    done: list[Any] = []

    def stop(record: Any) -> None:
        done.append(record)
        if len(done) == samples:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        soak(path, run=0, names=names, seconds=60.0, progress=stop, task=task, **options)


def made(body: Body) -> Asset:
    return Asset.from_tree(evaluate(body).value, "toy", "test")


def odd(asset: Asset, folder: Path) -> dict[str, str]:
    directory = asset.export(folder / "toy", formats=("mjcf", "urdf"))
    return dict(oddities(asset, directory / "toy.xml", directory / "toy.urdf"))


def slide(**options: Any) -> Body:
    base = part(box(0.2, 0.2, 0.1).at(0.0, 0.0, 0.05), "base", OAK)
    block = part(box(0.1, 0.1, 0.1).at(0.0, 0.0, 8.0), "block", STEEL)
    return base.attach(block, Prismatic("slide", **{"axis": -Z, "limits": (0.0, 7.8)} | options))


def test_a_run_ends_in_time_and_continues_later(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    soak(path, run=0, names=NAMES, seconds=0.0, task=counted)
    assert read_records(path) == []
    run_of(path, 5)
    first = soaked(path, 0)
    assert [(each["sample"], each["state"]) for each in first] == [
        (0, "sound"),
        (1, "failed"),
        (2, "crashed"),
        (3, "sound"),
        (4, "sound"),
    ]
    assert [each["category"] for each in first] == list(NAMES[:5])
    path.write_text(path.read_text() + '{"run": 0, "sam')  # as a kill leaves it
    run_of(path, 2)
    assert [each["sample"] for each in soaked(path, 0)] == list(range(7))
    assert soaked(path, 0)[:5] == first
    assert soaked(path, 1) == []


def test_a_run_of_some_categories_has_the_same_samples(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    run_of(path, 3, names=("drawer",))
    at = NAMES.index("drawer")
    assert [each["sample"] for each in soaked(path, 0)] == [at, at + len(NAMES), at + 2 * len(NAMES)]


def test_samples_are_begun_until_the_time_is_over(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    start = time.monotonic()
    soak(path, run=0, names=NAMES[:1], seconds=1.0, task=counted)
    assert 1.0 <= time.monotonic() - start < 60.0
    numbers = [each["sample"] for each in soaked(path, 0)]
    assert numbers  # one that has begun is finished, however long its process took to start
    assert numbers == [turn * len(NAMES) for turn in range(len(numbers))]


def test_a_sample_that_hangs_is_an_anomaly_and_leaves_no_files(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("surveys.folder._MEMORY", tmp_path)
    path = tmp_path / "soak.jsonl"
    run_of(path, 2, task=slow, limit=1.0)
    record = soaked(path, 0)[1]
    assert record["state"] == "timed out"
    assert record["anomalies"] == [{"kind": "timed out", "message": "it took more than 1 s"}]
    assert again(record, "timed out") == "python scripts/soak.py --seed 0 --sample 1"
    assert {each.name for each in tmp_path.iterdir()} == {path.name, f".{path.name}.lock"}


def test_a_killed_worker_is_replaced_and_its_sample_listed(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    done: list[Any] = []

    def kill(record: Any) -> None:
        done.append(record)
        if len(done) == 3:
            os.kill(record["process"], signal.SIGKILL)
        if len(done) == 8:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        soak(path, run=0, names=NAMES, seconds=60.0, jobs=2, progress=kill, task=brief)
    records = soaked(path, 0)
    assert sorted(each["sample"] for each in done) == [each["sample"] for each in records]
    (ended,) = [each for each in records if each["state"] != "sound"]
    assert ended["anomalies"] == [{"kind": "crashed", "message": "its process ended with code -9"}]
    (found,) = anomalies(records)
    assert found.command == f"python scripts/soak.py --seed 0 --sample {ended['sample']}"
    killed = done[2]["process"]
    assert killed not in {each.get("process") for each in done[3:]}


def test_a_killed_run_continues_without_loss(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    program = (
        "from pathlib import Path\n"
        "from test_soak import NAMES, brief, soak\n"
        f"soak(Path({str(path)!r}), run=0, names=NAMES, seconds=60.0, jobs=2, task=brief)"
    )
    paths = os.pathsep.join(
        [str(Path(__file__).parent), str(ROOT / "scripts"), os.environ.get("PYTHONPATH", "")]
    )
    run = subprocess.Popen([sys.executable, "-c", program], env={**os.environ, "PYTHONPATH": paths})
    while not path.exists() or path.read_text().count("\n") < 5:
        assert run.poll() is None
        time.sleep(0.01)
    run.kill()
    run.wait()
    before = soaked(path, 0)  # which cuts off a line that is half written
    workers = {each["process"] for each in before}
    end = time.monotonic() + 10.0
    while any(_lives(process) for process in workers):
        assert time.monotonic() < end, "a worker outlives its run"
        time.sleep(0.01)
    run_of(path, 4, task=brief)
    after = soaked(path, 0)
    assert [each for each in after if each in before] == before
    # those that were being measured when the run was killed are measured first
    assert [each["sample"] for each in after] == list(range(len(before) + 4))


def _lives(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def test_two_runs_do_not_write_to_one_file(tmp_path: Path) -> None:
    path = tmp_path / "soak.jsonl"
    run_of(path, 1, task=brief)
    before = path.read_text()
    told = (
        rf"another run \(process {os.getpid()}\) writes to .*soak\.jsonl; wait until it is done, or choose "
    )
    for fresh in (False, True):
        with locked(path), pytest.raises(ExportError, match=told + "another file"):
            soak(path, run=0, names=NAMES, seconds=60.0, fresh=fresh, task=brief)
        assert path.read_text() == before
    with locked(path):
        run_of(tmp_path / "other.jsonl", 1, task=brief)
    soak(path, run=0, names=NAMES, seconds=0.0, fresh=True, task=brief)
    assert path.read_text() == ""


@pytest.mark.parametrize("text", ["{}\n", '{"seed": 1, "category": "door", "state": "done"}\n'])
def test_another_file_is_an_error(tmp_path: Path, text: str) -> None:
    path = tmp_path / "survey.jsonl"
    path.write_text(text)
    with pytest.raises(ExportError, match=r"line 1 is no record of a soak; give another --out"):
        soak(path, run=0, names=NAMES, seconds=1.0, task=counted)
    assert path.read_text() == text


@pytest.fixture(scope="module")
def record() -> dict[str, Any]:
    return measure_extreme(TestSample.NUMBER, run=0)


class TestSample:
    NUMBER = NAMES.index("drawer") + 2 * len(NAMES)

    def test_a_record_names_its_sample(self, record) -> None:
        assert json.loads(json.dumps(record, allow_nan=False)) == record
        drawn = draw_extreme(0, self.NUMBER)
        assert (record["category"], record["seed"]) == ("drawer", drawn.seed)
        assert record["overrides"] == drawn.overrides
        assert record["state"] in ("sound", "odd", "ruled out")
        assert extreme_sample.of_record(record) == drawn

    def test_a_requirement_rules_a_sample_out(self, monkeypatch) -> None:
        given = {"grip": "knob", "handle": "bar_pull"}
        changed = replace(draw_extreme(0, self.NUMBER), overrides=given)
        monkeypatch.setattr(extreme_sample, "draw_extreme", lambda run, number: changed)
        found = measure_extreme(self.NUMBER, run=0)
        assert (found["state"], found["anomalies"]) == ("ruled out", [])
        assert "handle=bar_pull belongs to grip=bar, not to grip=knob: set grip as well" in found["message"]

    def test_other_exceptions_are_anomalies(self, monkeypatch) -> None:
        changed = replace(draw_extreme(0, self.NUMBER), overrides={"width": 99.0})
        monkeypatch.setattr(extreme_sample, "draw_extreme", lambda run, number: changed)
        found = measure_extreme(self.NUMBER, run=0)
        assert found["state"] == "odd"
        assert [each["kind"] for each in found["anomalies"]] == ["error"]
        assert found["anomalies"][0]["message"].startswith("ParameterError: width = 99.0 is out of range")

    def test_a_collision_is_an_anomaly_and_is_not_simulated(self) -> None:
        asset = find("drawer").generate(3)
        base, first = asset.links[0], asset.links[1]
        broken = replace(asset, links=(replace(base, pieces=(*base.pieces, *first.pieces)), *asset.links[1:]))
        broken.certify()
        kinds = {kind for kind, _ in extreme_sample._wrong(broken, None)}
        assert "not proven" in kinds
        assert not kinds & {"settling", "energy", "speed", "limits", "warning"}


class TestRest:
    def test_an_asset_at_rest_has_no_anomaly(self, tmp_path) -> None:
        assert odd(made(slide(friction=200.0)), tmp_path) == {}

    def test_a_long_fall_is_too_fast(self, tmp_path) -> None:
        found = odd(made(slide()), tmp_path)
        assert set(found) == {"speed"}  # it falls as far as it should, and no energy comes of it
        assert found["speed"].startswith("joint slide: moves at 9.")

    def test_a_small_part_on_a_spring_may_be_quick_and_a_long_one_not(self, tmp_path) -> None:
        def sprung(long: float, stiffness: float) -> Asset:
            turn = Revolute(
                "turn", axis=Z, limits=(0.0, 4.1), stiffness=stiffness, rest=2.0, friction=1e-4, armature=1e-4
            )
            base = part(box(0.1, 0.1, 0.1).at(0.0, 0.0, 0.05), "base", OAK)
            arm = part(box(long, 0.01, 0.01).at(long / 2, 0.0, 0.12), "arm", OAK)
            return made(base.attach(arm, turn))

        # both turn at 40 rad/s at most
        assert "speed" not in odd(sprung(0.03, 0.04), tmp_path / "small")
        assert "speed" in odd(sprung(0.60, 2.2), tmp_path / "long")

    def test_parts_in_each_other_gain_energy(self, tmp_path) -> None:
        base = part(box(0.3, 0.3, 0.1).at(0.0, 0.0, 0.05), "base", OAK)
        block = part(box(0.1, 0.1, 0.1).at(0.0, 0.0, 0.13), "block", STEEL)
        body = base.attach(
            part(box(0.1, 0.1, 0.1).at(0.0, 0.0, 0.5), "arm", STEEL).attach(
                block, Prismatic("lift", axis=Z, limits=(0.0, 0.2))
            ),
            Revolute("turn", axis=X, limits=(0.0, 0.1)),
        )
        found = odd(made(body), tmp_path)
        assert found["energy"].startswith("the energy grows by ")
        assert found["settling"]

    def test_limits_that_give_are_odd(self, tmp_path, monkeypatch) -> None:
        monkeypatch.setitem(rest.BEYOND, "prismatic", -10.0)
        monkeypatch.setattr(rest, "_give", lambda stop, speed: -10.0)
        found = odd(made(slide(friction=200.0)), tmp_path)
        assert found["limits"].startswith("joint slide: goes ")

    def test_a_spring_drives_a_part_into_its_stop(self, tmp_path, monkeypatch) -> None:
        turn = Revolute(
            "turn", axis=Z, limits=(0.0, 0.5), stiffness=0.8, rest=0.9, friction=1e-3, armature=2e-5
        )
        base = part(box(0.1, 0.1, 0.1).at(0.0, 0.0, 0.05), "base", OAK)
        asset = made(base.attach(part(box(0.1, 0.01, 0.01).at(0.05, 0.0, 0.12), "arm", OAK), turn))
        assert "limits" not in odd(asset, tmp_path / "sprung")
        monkeypatch.setattr(rest, "_give", lambda stop, speed: 0.0)
        assert "rad beyond its limits" in odd(asset, tmp_path / "hard")["limits"]


class TestCommands:
    def record(self, kind: str, number: int = NAMES.index("plier")) -> dict[str, Any]:
        drawn = draw_extreme(0, number)
        return {
            "run": 0,
            "sample": number,
            "category": drawn.category,
            "state": "odd",
            "seed": drawn.seed,
            "overrides": dict(drawn.overrides),
            "anomalies": [{"kind": kind, "message": "bad"}],
        }

    def test_a_command_reproduces_each_kind(self) -> None:
        number = NAMES.index("plier")
        for kind in ("error", "not proven"):
            words = shlex.split(again(self.record(kind), kind))
            assert words[:3] == ["artgen", "generate", "plier"]
            assert words[words.index("--on-collision") + 1] == "fail"
        checked = again(self.record("tree"), "tree")
        assert "--on-collision keep" in checked
        assert checked.endswith(f" && artgen validate out/again/plier_0_{number}")
        assert again(self.record("speed"), "speed") == f"python scripts/soak.py --seed 0 --sample {number}"

    def test_a_command_makes_the_same_sample(self, tmp_path, monkeypatch) -> None:
        monkeypatch.chdir(tmp_path)
        record = self.record("tree")
        made_, _ = again(record, "tree").split(" && ")
        done = CliRunner().invoke(command_line(), shlex.split(made_)[1:])
        assert done.exit_code == 0, done.output
        stored = json.loads(next(tmp_path.rglob("asset.json")).read_text())
        drawn = find("plier").sample(record["seed"], overrides=record["overrides"])
        assert set(drawn) - set(stored["parameters"]) <= set(record["overrides"])  # those that do not act
        for name in stored["parameters"]:
            value = drawn[name]
            close = (
                pytest.approx(value, rel=1e-9) if isinstance(value, float) else getattr(value, "name", value)
            )
            assert stored["parameters"][name] == close

    def test_anomalies_are_counted_by_sample_and_kind(self) -> None:
        twice = self.record("tree")
        twice["anomalies"] *= 2
        sound = {**self.record("tree"), "state": "sound", "anomalies": [], "sample": 400}
        out = {**sound, "state": "ruled out", "sample": 401}
        (tally,) = tallies([twice, sound, out])
        assert (tally.samples, tally.ruled_out, tally.odd, tally.kinds) == (3, 1, 1, {"tree": 1})
        assert [each.message for each in anomalies([twice, sound, out])] == ["bad", "bad"]


def script(*arguments: str) -> list[str]:
    # whoever runs the tests may have told its processes to ignore Ctrl-C
    program = (
        "import os, runpy, signal, sys\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"sys.argv[0] = {str(ROOT / 'scripts' / 'soak.py')!r}\n"
        "sys.path.append(os.path.dirname(sys.argv[0]))\n"
        "runpy.run_path(sys.argv[0], run_name='__main__')"
    )
    return [sys.executable, "-c", program, *arguments]


def test_ctrl_c_shows_the_results(tmp_path: Path) -> None:
    out = tmp_path / "deep" / "soak.jsonl"
    run = subprocess.Popen(
        script("plier", "--minutes", "10", "--out", str(out)),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while not out.exists() or not out.read_text():
        assert run.poll() is None
        time.sleep(0.05)
    os.killpg(run.pid, signal.SIGINT)
    shown, told = run.communicate(timeout=60)
    records = soaked(out, 0)
    found = [command for command in (each.command for each in anomalies(records)) if command in shown]
    assert told == ""
    assert f"plier     {len(records)} " in shown
    assert len(found) == len(anomalies(records))
    assert run.returncode == (1 if found else 130)


def test_a_sample_is_shown_again(tmp_path: Path) -> None:
    number = NAMES.index("plier")
    done = subprocess.run(
        script("--seed", "0", "--sample", str(number)),
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    record = measure_extreme(number, run=0)
    assert done.stdout.startswith(f"plier --seed {record['seed']}\n")
    assert all(f"  {name}=" in done.stdout for name in record["overrides"])
    assert done.returncode == (1 if record["anomalies"] else 0)
    assert f"\n{record['state']} " in done.stdout


def test_an_unknown_category_is_a_clear_error() -> None:
    done = subprocess.run(
        script("dor", "--minutes", "0"), capture_output=True, text=True, check=False, timeout=60
    )
    assert done.stderr == "error: there is no category 'dor'. Did you mean 'door'?\n"
    assert done.returncode == 2
