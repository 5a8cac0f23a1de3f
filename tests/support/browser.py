"""A real browser for tests: headless Chromium, driven by Playwright, which downloads none of its own."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

_FLAGS = (
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)


def chromium() -> str:
    """Where Chromium is, the one that ARTGEN_CHROMIUM names first; skips the test where there is none."""
    pytest.importorskip("playwright", reason="Playwright is not installed: pip install playwright")
    names = (os.environ.get("ARTGEN_CHROMIUM"), "chromium", "chromium-browser", "google-chrome")
    found = next((path for name in names if name and (path := shutil.which(name))), None)
    if found is None:
        pytest.skip("chromium is not installed: apt-get install chromium, or set ARTGEN_CHROMIUM to it")
    return found


@dataclass
class Tab:
    """A page of the browser.

    Attributes:
        page: Playwright's page.
        problems: What went wrong: errors of the page, errors and warnings of its console, and offline what it
            asked of the network.
    """

    page: Any
    problems: list[str] = field(default_factory=list)

    def open(self, place: str | Path) -> "Tab":
        """Open a file or an address, once its scripts have run."""
        self.page.goto(place.resolve().as_uri() if isinstance(place, Path) else place, wait_until="load")
        return self

    def picture(self, selector: str | None = None) -> np.ndarray:
        """What is seen of the page, or of one element, shape (h, w, 3)."""
        target = self.page if selector is None else self.page.locator(selector).first
        return np.asarray(Image.open(BytesIO(target.screenshot())).convert("RGB"))

    def save(self, path: Path) -> None:
        """Save what is seen, for a person to look at."""
        self.page.screenshot(path=str(path))


class Browser:
    """A started Chromium."""

    def __init__(self, started: Any) -> None:
        self._started = started

    @contextmanager
    def tab(self, width: int = 1000, height: int = 700, *, offline: bool = False) -> Iterator[Tab]:
        """Open a page of its own, with a profile of its own.

        Args:
            width: Of the page [pixels].
            height: The same.
            offline: Whether requests to anywhere but files and data are problems, and fail.
        """
        context = self._started.new_context(viewport={"width": width, "height": height}, offline=offline)
        page = context.new_page()
        tab = Tab(page)
        page.on("console", lambda message: _keep(tab, message))
        page.on("pageerror", lambda error: tab.problems.append(f"error: {error}"))
        if offline:
            page.on("request", lambda request: _allow(tab, request.url))
        try:
            yield tab
        finally:
            context.close()


def _keep(tab: Tab, message: Any) -> None:
    # what software renderers say of their own speed says nothing of the page
    if message.type in ("error", "warning") and "GL Driver Message" not in message.text:
        tab.problems.append(f"{message.type}: {message.text}")


def _allow(tab: Tab, url: str) -> None:
    if not url.startswith(("file:", "data:", "blob:", "about:")):
        tab.problems.append(f"request: {url}")


@contextmanager
def started() -> Iterator[Browser]:
    """Start Chromium; skips the test where it cannot be had. A fixture of a module shares one start."""
    path = chromium()
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        running = play.chromium.launch(executable_path=path, headless=True, args=list(_FLAGS))
        try:
            yield Browser(running)
        finally:
            running.close()
