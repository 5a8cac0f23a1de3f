"""`artgen clients`: the list, and installing."""

import pytest

from artgen.commands import clients as module
from artgen.errors import ClientError
from artgen.validate.clients.registry import CLIENTS, REQUIREMENTS, Client


@pytest.fixture
def made(monkeypatch, tmp_path):
    """Let nothing be installed, and remember what would be."""
    monkeypatch.setenv("ARTGEN_CLIENTS", str(tmp_path / "clients"))
    names = []

    def install(environment, directory, *, python):
        if environment == "urchin":
            raise ClientError("no network")
        names.append((environment, directory, python))
        return "made"

    monkeypatch.setattr(module, "install_environment", install)
    return names


def test_the_list_says_where_each_client_is(artgen_command, made):
    lines = artgen_command("clients").out.splitlines()
    assert lines[0].split() == ["client", "reads", "layouts", "version", "where"]
    rows = {line.split()[0]: line for line in lines[1:]}
    assert list(rows) == list(CLIENTS)
    assert rows["yourdfpy"].rstrip().endswith("artgen's own")
    assert rows["drake_urdf"].rstrip().endswith("absent: artgen clients --install drake_urdf")
    assert "searched when the client runs" in rows["check_urdf"]


def test_named_clients_are_installed(artgen_command, made, tmp_path):
    done = artgen_command("clients", "--install", "drake_urdf,drake_mjcf,pybullet", "--python", "py")
    assert done.code == 0
    folder = tmp_path / "clients"
    assert made == [("drake", folder, str(tmp_path / "py")), ("bullet", folder, str(tmp_path / "py"))]
    assert done.out.splitlines() == [f"{folder / 'drake'}: made", f"{folder / 'bullet'}: made"]


def test_all_but_those_that_are_artgen_s_own_are_installed_though_one_fails(
    artgen_command, made, monkeypatch
):
    own = Client("own", "urdf", "yourdfpy", "light", "x")
    heavy = [Client("a", "urdf", "urchin", "urchin", "x"), Client("b", "urdf", "nothing", "drake", "x")]
    monkeypatch.setattr(module, "chosen_clients", lambda names: ([own, *heavy], False))
    done = artgen_command("clients", "--install", "all")
    assert done.code == 1
    assert [name for name, *_ in made] == ["drake"]
    assert "error: no network" in done.err
    assert ", ".join(REQUIREMENTS["drake"]) in done.err


def test_a_program_of_the_system_cannot_be_installed(artgen_command, made):
    done = artgen_command("clients", "--install", "check_urdf")
    assert done.code == 1
    assert "check_urdf: artgen cannot install it; install liburdfdom-tools" in done.err


def test_an_unknown_client_is_wrong_input(artgen_command, made):
    done = artgen_command("clients", "--install", "darke_urdf")
    assert done.code == 2
    assert done.err == "error: there is no client 'darke_urdf'. Did you mean 'drake_urdf'?\n"
