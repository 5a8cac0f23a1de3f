"""Driver of NVIDIA's validators of USD: the Omniverse Asset Validator, and simready-validate."""

import ast
import logging
from functools import cache
from typing import Any

from driver_protocol import require, serve

_SEVERE = ("ERROR", "FAILURE", "WARNING")
_PROFILE, _VERSION = "Robotics-Prop", "4.0.0"  # NVIDIA's profile of props for robotics


def _read(request: dict[str, Any]) -> dict[str, Any]:
    drivers = {"omniverse_asset_validator": _read_by_omniverse, "simready_validate": _read_by_simready}
    return drivers[request["client"]](request)


def _read_by_omniverse(request: dict[str, Any]) -> dict[str, Any]:
    require("omni.asset_validator")
    # its command line logs progress to stdout at import; only findings are requested
    logging.basicConfig(level=logging.WARNING)
    from omni.asset_validator import ValidationEngine

    engine = ValidationEngine(init_rules=True)
    issues = engine.validate(request["file"]).issues()
    return {
        "said": [
            f"{issue.severity.name.lower()}: {_rule(issue)}: {issue.message} ({_place(issue)})"
            for issue in issues
            if issue.severity.name in _SEVERE
        ],
        "note": f"{len(engine.rules)} rules",
    }


def _read_by_simready(request: dict[str, Any]) -> dict[str, Any]:
    """Check a USD by a profile; unmet optional requirements go to the note."""
    require("simready.validate", "simready.foundation.tier_core")
    validate = _simready()
    config = validate.AssetValidationConfig(request["file"], _PROFILE, _VERSION)
    result = validate.validate_asset(config)
    if result is None:
        raise RuntimeError(
            f"simready-validate cannot read the asset, or has no profile {_PROFILE} {_VERSION}"
        )
    features = result.features_summary
    met = sum(bool(feature["passed"]) for feature in features.values())
    optional = sorted({code for feature in features.values() for code in _optional(feature)})
    said = [f"{_code(issue)}: {issue.message} ({_place(issue)})" for issue in result.issues]
    said += [
        f"the feature {name} is required, and fails"
        for name, feature in features.items()
        if validate.is_blocking_failure(feature)
    ]
    unmet = f"; optional and unmet: {', '.join(optional)}" if optional else ""
    return {
        "said": list(dict.fromkeys(said)),
        "optional": sorted({f"{_code(issue)}: {issue.message}" for issue in result.soft_issues}),
        "note": f"{met} of {len(features)} features{unmet}",
    }


@cache
def _simready() -> Any:
    """Return the package with the installed profiles."""
    from simready import validate

    validate.initialize(rules_and_requirements_paths=[], features_paths=[], profiles_paths=[])
    return validate


def _optional(feature: dict[str, Any]) -> list[str]:
    """Return the unmet requirements of a feature that are optional in its profile."""
    codes = ast.literal_eval(feature.get("optional requirements", "[]"))
    return [code.removeprefix("com.nvidia.simready.") for code in codes]


def _code(issue: Any) -> str:
    code = issue.requirement.code if issue.requirement is not None else _rule(issue)
    return str(code).removeprefix("com.nvidia.simready.")


def _rule(issue: Any) -> str:
    return getattr(issue.rule, "__name__", "")


def _place(issue: Any) -> str:
    """Return the prim of an issue, or the stage as a whole."""
    path = getattr(issue.at, "path", None)
    return str(path) if path is not None else "the stage"


if __name__ == "__main__":
    serve(_read)
