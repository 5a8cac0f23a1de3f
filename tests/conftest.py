"""Settings of all tests: the same examples every time, no deadline on a busy machine; shared fixtures."""

from collections.abc import Iterator

import pytest
from hypothesis import settings

settings.register_profile("artgen", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("artgen")


@pytest.fixture(scope="module")
def coacd_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep what CoACD finds away from the user's own cache, but through all tests of a module."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ARTGEN_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield
