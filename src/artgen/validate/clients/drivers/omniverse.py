"""Driver of the Omniverse Asset Validator: failures and warnings of a USD."""

from typing import Any

from driver_protocol import serve
from validator_words import place


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import logging

    # its command line logs progress to stdout at import; only findings are requested
    logging.basicConfig(level=logging.WARNING)
    from importlib.metadata import version

    from omni.asset_validator import ValidationEngine

    engine = ValidationEngine(init_rules=True)
    issues = engine.validate(request["file"]).issues()
    return {
        "version": version("omniverse-asset-validator"),
        "said": [_text(issue) for issue in issues if issue.severity.name in _SEVERE],
        "note": f"{len(engine.rules)} rules",
    }


_SEVERE = ("ERROR", "FAILURE", "WARNING")


def _text(issue: Any) -> str:
    rule = getattr(issue.rule, "__name__", "")
    return f"{issue.severity.name.lower()}: {rule}: {issue.message} ({place(issue.at)})"


if __name__ == "__main__":
    serve(read, "omni.asset_validator")
