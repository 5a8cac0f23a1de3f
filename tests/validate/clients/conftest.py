"""An exported drawer, and drivers that answer as they should or not."""

import shutil
import textwrap

import pytest

from artgen.validate.clients import run
from artgen.validate.clients.exported import read_exported
from artgen.validate.clients.registry import Client
from support.exports import stand


@pytest.fixture(scope="session")
def drawer(tmp_path_factory):
    """The directory of an export in all formats."""
    directory = tmp_path_factory.mktemp("drawer") / "stand_0"
    return stand.generate(0, stiffness=15.0, certify=False).export(directory, textures=0)


@pytest.fixture
def directory(drawer, tmp_path):
    """A copy of the export, to be changed."""
    return shutil.copytree(drawer, tmp_path / "stand_0")


@pytest.fixture
def exported(drawer):
    """The export as clients see it."""
    return read_exported(drawer)


@pytest.fixture
def fake(tmp_path, monkeypatch):
    """Return a function that makes a client of the code of its driver."""
    monkeypatch.setattr(run, "DRIVERS", tmp_path)

    def make(code, name="fake", **fields):
        (tmp_path / f"{name}.py").write_text(textwrap.dedent(code), encoding="utf-8")
        chosen = {"seconds": 20.0, "distribution": "", "environment": "", "format": "urdf", **fields}
        return Client(name, driver=name, **chosen)

    return make
