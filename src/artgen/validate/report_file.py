"""The report of an exported asset, written beside it."""

import os
from contextlib import suppress
from pathlib import Path

from artgen.asset.report import Report
from artgen.errors import ExportError
from artgen.export.files import REPORT_FILE


def write_report(report: Report, path: str | Path) -> Path:
    """Write a report as JSON, all of it or nothing."""
    target = Path(path)
    target = target / REPORT_FILE if target.is_dir() else target
    partial = target.with_name(f".{target.name}.{os.getpid()}.partial")
    try:
        try:
            partial.write_text(report.to_json(), encoding="utf-8", newline="\n")
            partial.replace(target)
        except BaseException:
            with suppress(OSError):
                partial.unlink(missing_ok=True)
            raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise ExportError(
            f"cannot write the report of {report.asset!r} to {target}: {reason}; check that its directory "
            "exists and may be written to"
        ) from error
    return target
