"""Pytest plugin that defines the option `--artgen`, and loads artgen only if the option is given."""

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
    """Load the plugin that collects exported assets, if the option is given."""
    if config.getoption("artgen"):
        from artgen.testing import pytest_plugin

        config.pluginmanager.register(pytest_plugin, "artgen.testing.pytest_plugin")
