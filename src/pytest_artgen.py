"""What pytest loads of artgen in every run: the option; the rest, and artgen itself, only if it is given."""

from __future__ import annotations

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option `--artgen`."""
    parser.getgroup("artgen").addoption(
        "--artgen",
        action="append",
        metavar="DIRECTORY",
        default=[],
        help="run artgen's checks on the exported assets in a directory, one test for each check; repeatable",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Load what collects the assets, if there are any to collect."""
    if config.getoption("artgen"):
        from artgen.testing import pytest_plugin

        config.pluginmanager.register(pytest_plugin, "artgen.testing.pytest_plugin")
