"""An object store for tests and their processes."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def bucket(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Yield a folder whose URL is `bucket://` and its path, in this process and in started ones."""
    fsspec = pytest.importorskip("fsspec")
    from support import bucket

    known = tmp_path_factory.mktemp("known")
    bucket.register(known)
    fsspec.register_implementation(bucket.PROTOCOL, bucket.BucketFileSystem, clobber=True)
    paths = [str(known), str(Path(bucket.__file__).parent.parent), os.environ.get("PYTHONPATH", "")]
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", os.pathsep.join(filter(None, paths)))
        for path in paths[:2]:
            patch.syspath_prepend(path)
        yield tmp_path_factory.mktemp("bucket")
