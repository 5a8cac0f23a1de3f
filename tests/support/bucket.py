"""An object store below a folder, for tests, without renaming and links."""

from pathlib import Path
from typing import Any, NoReturn

from fsspec.implementations.local import LocalFileSystem

PROTOCOL = "bucket"


class BucketFileSystem(LocalFileSystem):
    """Stores `bucket:///tmp/x` in `/tmp/x`."""

    protocol = PROTOCOL

    def __init__(self, **options: Any) -> None:
        super().__init__(**{**options, "auto_mkdir": True})

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise NotImplementedError("an object store has no such operation")

    mv = mv_file = move = rename = link = symlink = _refuse


def register(folder: Path) -> None:
    """Write the entry point of this store into a folder, for each process with the folder on its path."""
    about = folder / "bucket_of_tests-1.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: bucket-of-tests\nVersion: 1\n")
    (about / "entry_points.txt").write_text(
        f"[fsspec.specs]\n{PROTOCOL} = {__name__}:{BucketFileSystem.__name__}\n"
    )
