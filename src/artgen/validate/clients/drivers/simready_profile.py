"""simready-validate driver: checks a USD by NVIDIA's profile of props for robotics."""

import ast
from functools import cache
from typing import Any

from driver_protocol import serve
from validator_words import place

_PROFILE, _VERSION = "Robotics-Prop", "4.0.0"


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request: unmet optional requirements go to the note."""
    from importlib.metadata import version

    validate = _validator()
    config = validate.AssetValidationConfig(request["file"], _PROFILE, _VERSION)
    result = validate.validate_asset(config)
    if result is None:
        raise RuntimeError(
            f"simready-validate cannot read the asset, or has no profile {_PROFILE} {_VERSION}"
        )
    features = result.features_summary
    met = [name for name, feature in features.items() if feature["passed"]]
    optional = sorted({code for feature in features.values() for code in _codes(feature)})
    said = {f"{_code(issue)}: {issue.message} ({place(issue.at)})": None for issue in result.issues}
    blocked = [name for name, feature in features.items() if validate.is_blocking_failure(feature)]
    said |= {f"the feature {name} is required, and fails": None for name in blocked}
    return {
        "version": version("simready-validate"),
        "said": list(said),
        "optional": sorted({f"{_code(issue)}: {issue.message}" for issue in result.soft_issues}),
        "note": _note(len(met), len(features), optional),
    }


@cache
def _validator() -> Any:
    """Return the package with the installed profiles."""
    from simready import validate

    validate.initialize(rules_and_requirements_paths=[], features_paths=[], profiles_paths=[])
    return validate


def _codes(feature: dict[str, Any]) -> list[str]:
    """Return the unmet requirements of a feature that are optional in its profile."""
    codes = ast.literal_eval(feature.get("optional requirements", "[]"))
    return [code.removeprefix("com.nvidia.simready.") for code in codes]


def _note(met: int, every: int, optional: list[str]) -> str:
    note = f"{met} of {every} features"
    return f"{note}; optional and unmet: {', '.join(optional)}" if optional else note


def _code(issue: Any) -> str:
    code = issue.requirement.code if issue.requirement is not None else getattr(issue.rule, "__name__", "")
    return str(code).removeprefix("com.nvidia.simready.")


if __name__ == "__main__":
    serve(read, "simready.validate", "simready.foundation.tier_core")
