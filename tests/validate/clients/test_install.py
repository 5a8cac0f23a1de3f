"""Environments of clients: made once, whole or not at all."""

import re
import sys
import zipfile
from pathlib import Path

import pytest

from artgen.errors import ClientError
from artgen.validate.clients import install as module
from artgen.validate.clients.install import (
    UNFINISHED,
    environments_directory,
    install,
    installed,
    interpreters,
    python_of,
)
from artgen.validate.clients.registry import CLIENTS, REQUIREMENTS


@pytest.fixture
def calls(monkeypatch):
    """Let no venv be made and nothing be installed, but remember what would be."""
    made = []

    def run(command, target):
        made.append(command)
        if command[1:3] == ["-m", "venv"]:
            program = target / "bin" / "python"
            program.parent.mkdir()
            program.symlink_to(sys.executable)

    monkeypatch.setattr(module, "_run", run)
    return made


def test_an_environment_is_made_once(calls, tmp_path):
    assert install("drake", tmp_path / "new") == "made"
    assert [command[1:3] for command in calls] == [["-m", "venv"], ["-m", "pip"]]
    assert calls[0][0] == sys.executable
    assert calls[1][-1:] == list(REQUIREMENTS["drake"])
    assert python_of(tmp_path / "new" / "drake") == tmp_path / "new/drake/bin/python"
    assert install("drake", tmp_path / "new") == "there already"
    assert len(calls) == 2


def test_an_environment_that_artgen_does_not_know_is_made_of_given_requirements(calls, tmp_path):
    assert install("peer", tmp_path, requirements={"peer": ("peer>=1", "numpy")}) == "made"
    assert calls[1][-2:] == ["peer>=1", "numpy"]
    with pytest.raises(ClientError, match=r"there is no environment 'pear'. Did you mean 'peer'\?"):
        install("pear", tmp_path, requirements={"peer": ()})


def test_other_requirements_make_it_anew(calls, tmp_path, monkeypatch):
    install("drake", tmp_path)
    monkeypatch.setitem(REQUIREMENTS, "drake", ("drake>=9",))
    assert install("drake", tmp_path, python="/usr/bin/other") == "made"
    assert calls[2][0] == "/usr/bin/other"
    assert calls[3][-1] == "drake>=9"


def test_what_was_interrupted_counts_as_nothing_and_is_begun_anew(calls, tmp_path, monkeypatch):
    record = module._run

    def interrupted(command, target):
        record(command, target)
        if "pip" in command:
            raise KeyboardInterrupt

    monkeypatch.setattr(module, "_run", interrupted)
    with pytest.raises(KeyboardInterrupt):
        install("drake", tmp_path)
    assert (tmp_path / "drake/bin/python").exists()
    assert (tmp_path / "drake" / UNFINISHED).exists()
    assert python_of(tmp_path / "drake") is None
    (tmp_path / "drake/left").touch()
    monkeypatch.setattr(module, "_run", record)
    assert install("drake", tmp_path) == "made"
    assert not (tmp_path / "drake/left").exists()
    assert python_of(tmp_path / "drake") is not None


def test_an_environment_made_by_hand_is_left_alone(calls, tmp_path):
    program = tmp_path / "drake/bin/python"
    program.parent.mkdir(parents=True)
    program.symlink_to(sys.executable)
    assert install("drake", tmp_path) == "made by hand"
    assert not calls


def test_two_processes_do_not_make_one_environment(calls, tmp_path):
    with (
        module._only_one(tmp_path / ".drake.lock", "drake"),
        pytest.raises(ClientError, match="another process is making the environment 'drake'; wait"),
    ):
        install("drake", tmp_path)


def test_an_unknown_environment_has_the_nearest_name(tmp_path):
    with pytest.raises(ClientError, match=r"there is no environment 'darke'\. Did you mean 'drake'\?"):
        install("darke", tmp_path)


def test_pip_s_complaint_is_told_in_one_line(tmp_path):
    code = (
        "import sys; print('Collecting x'); print('ERROR: no x'); print('hint', file=sys.stderr); sys.exit(1)"
    )
    with pytest.raises(ClientError, match="cannot make the environment 'drake': ERROR: no x ") as caught:
        module._run([sys.executable, "-c", code], tmp_path / "drake")
    assert "\n" not in str(caught.value)
    with pytest.raises(ClientError, match="drake': exit code 3 "):
        module._run([sys.executable, "-c", "raise SystemExit(3)"], tmp_path / "drake")


def test_a_disk_that_refuses_is_one_error(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(ClientError, match=r"cannot make the environment 'drake' in .*: "):
        install("drake", tmp_path / "file")


@pytest.mark.long
def test_a_package_is_really_installed(tmp_path, monkeypatch):
    wheel = tmp_path / "quux-1.5-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("quux.py", "")
        archive.writestr("quux-1.5.dist-info/METADATA", "Metadata-Version: 2.1\nName: quux\nVersion: 1.5\n")
        archive.writestr(
            "quux-1.5.dist-info/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        )
        archive.writestr("quux-1.5.dist-info/RECORD", "")
    monkeypatch.setitem(REQUIREMENTS, "drake", (str(wheel),))
    monkeypatch.setenv("ARTGEN_CLIENTS", str(tmp_path))
    assert install("drake", environments_directory()) == "made"
    from dataclasses import replace

    client = replace(CLIENTS["drake_urdf"], distribution="quux")
    assert installed(client) == ("1.5", str(tmp_path / "drake"))
    assert interpreters(client) == [tmp_path / "drake/bin/python"]


def test_light_clients_are_artgen_s_own():
    assert interpreters(CLIENTS["pinocchio"])[0] == Path(sys.executable)
    version, where = installed(CLIENTS["pinocchio"])
    assert re.fullmatch(r"\d+\.\d+.*", version)
    assert where == "artgen's own"


def test_without_a_folder_there_is_no_environment(monkeypatch):
    monkeypatch.delenv("ARTGEN_CLIENTS", raising=False)
    monkeypatch.setenv("ARTGEN_CACHE", "off")
    with pytest.raises(ClientError, match="the cache is off; name one in ARTGEN_CLIENTS"):
        environments_directory()
    assert interpreters(CLIENTS["drake_urdf"]) == []


def test_every_client_can_be_got_and_has_its_driver():
    drivers = Path(module.__file__).parent / "drivers"
    for client in CLIENTS.values():
        assert client.environment in REQUIREMENTS or client.obtain, client.name
        assert (drivers / f"{client.driver}.py").is_file(), client.name
        for pattern, reason in client.unavoidable:
            assert reason
            re.compile(pattern)
