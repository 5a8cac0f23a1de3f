"""Driver of the validators of OpenUSD: errors of a USD in each of its variants."""

from collections.abc import Iterator
from typing import Any

from driver_protocol import require, serve

require("pxr")
from pxr import Usd, UsdValidation


def _read(request: dict[str, Any]) -> dict[str, Any]:
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    context = UsdValidation.ValidationContext(validators)
    stage = Usd.Stage.Open(request["file"])
    said: dict[str, None] = {}
    for label in _variants(stage):
        for error in context.Validate(stage):
            places = ", ".join(str(_path(site)) for site in error.GetSites())
            said[f"{error.GetName()}: {error.GetMessage()} ({places}{label})"] = None
    return {"said": list(said), "note": f"{len(validators)} validators"}


def _path(site: Any) -> Any:
    if site.IsProperty():
        return site.GetProperty().GetPath()
    return site.GetPrim().GetPath() if site.IsPrim() else "the stage"


def _variants(stage: Any) -> Iterator[str]:
    """Select each variant of the asset in turn, the authored choice first, and yield its label."""
    yield ""
    prim = stage.GetDefaultPrim()
    if not prim:
        return
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        for name in prim.GetVariantSets().GetNames():
            chosen = prim.GetVariantSet(name)
            for variant in chosen.GetVariantNames():
                chosen.SetVariantSelection(variant)
                yield f", {name}={variant}"
            chosen.ClearVariantSelection()


if __name__ == "__main__":
    serve(_read)
