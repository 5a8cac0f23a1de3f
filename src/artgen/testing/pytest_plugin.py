"""Pytest plugin: `pytest --artgen DIRECTORY` makes a test of each check of each exported asset.

The directory holds one exported asset or several; the option may be repeated. Without paths, only these tests
run; with paths, both run. The tests have names such as `door_7::certificate`, so `-k certificate` or `-k "not
behavior"` select among them.

Every run of pytest loads `pytest_artgen`, which defines the option and loads this module if the option is
given.
"""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from artgen.asset.files import exports_in
from artgen.errors import ExportError
from artgen.validate import Examination

_DIRECTORIES = pytest.StashKey[list[Path]]()


def pytest_configure(config: pytest.Config) -> None:
    """Find the assets.

    Raises:
        UsageError: A directory holds no exported asset.
    """
    start = config.invocation_params.dir
    given = [Path(os.path.normpath(start / each)) for each in config.getoption("artgen")]
    try:
        config.stash[_DIRECTORIES] = exports_in(given)
    except ExportError as error:
        raise pytest.UsageError(f"--artgen: {error}") from error
    if given and config.args_source is not pytest.Config.ArgsSource.ARGS:
        config.args = []


def pytest_collection_modifyitems(
    session: pytest.Session, config: pytest.Config, items: list[pytest.Item]
) -> None:
    """Add a test for each asset and check."""
    for directory in config.stash[_DIRECTORIES]:
        inside = directory.is_relative_to(config.rootpath) and directory != config.rootpath
        name = (directory.relative_to(config.rootpath) if inside else directory).as_posix()
        collector = AssetDirectory.from_parent(session, name=name, nodeid=name, path=directory)
        items.extend(session.genitems(collector))


class AssetDirectory(pytest.Collector):
    """An exported asset with its checks as tests."""

    def collect(self) -> Iterator[pytest.Item]:
        """Make a test of each check that applies to the export."""
        examination = Examination(self.path)
        for check in examination.checks:
            yield CheckItem.from_parent(self, name=check, examination=examination)


class FaultsFoundError(Exception):
    """A check found faults; the text lists all of them."""


class CheckItem(pytest.Item):
    """One check of one exported asset."""

    def __init__(self, *, examination: Examination, **fields: Any) -> None:
        super().__init__(**fields)
        self._examination = examination

    def runtest(self) -> None:
        """Run the check.

        Raises:
            FaultsFoundError: The check found faults.
        """
        result = self._examination.result(self.name)
        if result.skipped:
            pytest.skip(result.skipped)
        notes = [str(finding) for finding in result.findings if finding.severity == "note"]
        if notes:
            self.add_report_section("call", "notes", "\n".join(notes))
        if result.faults:
            count = f"{len(result.faults)} fault{'' if len(result.faults) == 1 else 's'}"
            lines = [f"{self._examination.name} fails the check {result.check!r}: {count}"]
            raise FaultsFoundError("\n".join([*lines, *(f"  {fault}" for fault in result.faults)]))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Show only the faults; for an unexpected exception, also its traceback."""
        if isinstance(excinfo.value, FaultsFoundError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[os.PathLike[str], int | None, str]:
        """Return the headline of a failure."""
        return self.path, None, f"{self._examination.name}: {self.name}"
