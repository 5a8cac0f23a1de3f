"""What the validators of OpenUSD say of a USD, in each of its variants."""

from collections.abc import Iterator
from typing import Any

from driver_protocol import serve


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    from pxr import Usd, UsdValidation

    registry = UsdValidation.ValidationRegistry()
    validators = registry.GetOrLoadAllValidators()
    context = UsdValidation.ValidationContext(validators)
    stage = Usd.Stage.Open(request["file"])
    said: dict[str, None] = {}
    for label in _variants(stage):
        for error in context.Validate(stage):
            places = ", ".join(str(_path(site)) for site in error.GetSites())
            said[f"{error.GetName()}: {error.GetMessage()} ({places}{label})"] = None
    return {
        "version": ".".join(str(number) for number in Usd.GetVersion()[1:]),
        "said": list(said),
        "note": f"{len(validators)} validators",
    }


def _path(site: Any) -> Any:
    if site.IsProperty():
        return site.GetProperty().GetPath()
    return site.GetPrim().GetPath() if site.IsPrim() else "the stage"


def _variants(stage: Any) -> Iterator[str]:
    """Select each variant of the asset in turn, the authored choice first; tell which by a label."""
    yield ""
    prim = stage.GetDefaultPrim()
    if not prim:
        return
    from pxr import Usd

    with Usd.EditContext(stage, stage.GetSessionLayer()):
        for name in prim.GetVariantSets().GetNames():
            chosen = prim.GetVariantSet(name)
            for variant in chosen.GetVariantNames():
                chosen.SetVariantSelection(variant)
                yield f", {name}={variant}"
            chosen.ClearVariantSelection()


if __name__ == "__main__":
    serve(read, "pxr")
