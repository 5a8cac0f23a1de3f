"""What lies below a directory, to be compared."""

import hashlib
from pathlib import Path


def digests(directory: Path) -> dict[str, str]:
    """Return the digest of every file below a directory."""
    return {
        str(path.relative_to(directory)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(directory.rglob("*"))
        if path.is_file()
    }
