"""A store of objects below a folder, for tests: it knows no renaming and no links."""

from pathlib import Path
from typing import Any, NoReturn

from fsspec.implementations.local import LocalFileSystem

PROTOCOL = "bucket"


class BucketFileSystem(LocalFileSystem):
    """What lies at `bucket:///tmp/x` is kept in `/tmp/x`."""

    protocol = PROTOCOL

    def __init__(self, **options: Any) -> None:
        super().__init__(**{**options, "auto_mkdir": True})

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise NotImplementedError("a store of objects has no such thing")

    mv = mv_file = move = rename = link = symlink = _refuse


def register(folder: Path) -> None:
    """Write into a folder what makes fsspec know such stores, in each process that has it on its path."""
    about = folder / "bucket_of_tests-1.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: bucket-of-tests\nVersion: 1\n")
    (about / "entry_points.txt").write_text(
        f"[fsspec.specs]\n{PROTOCOL} = {__name__}:{BucketFileSystem.__name__}\n"
    )
