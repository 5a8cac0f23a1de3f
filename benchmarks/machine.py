"""The machine and the versions of packages of a measurement."""

import os
import platform
import sys
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path

from artgen.dataset.workers import cores
from artgen.version import __version__

_PACKAGES = ("numpy", "scipy", "manifold3d", "python-fcl", "mujoco", "coacd")


def machine(others: Mapping[str, str]) -> str:
    """Return processor, cores, memory, system, Python and packages as text.

    Args:
        others: Versions of packages of another environment, by name.
    """
    versions = {"artgen": __version__, **{name: _version(name) for name in _PACKAGES}, **others}
    return ", ".join(
        [
            _processor(),
            f"{cores()} cores",
            *_memory(),
            platform.system(),
            f"Python {sys.version.split()[0]}",
            *(f"{name} {version}" for name, version in versions.items() if version),
        ]
    )


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text(encoding="utf-8").splitlines():
            name, _, value = line.partition(":")
            if name.strip() == "model name":
                return " ".join(value.split())
    return platform.processor() or platform.machine()


def _memory() -> list[str]:
    """Return the memory as text; empty if the system does not report it."""
    try:
        size = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return []
    return [f"{size / 2**30:.0f} GiB of memory"]


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return ""
