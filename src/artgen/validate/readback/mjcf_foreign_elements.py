"""MJCF elements that an exported asset must not contain: they move or hold links."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from artgen.asset.report import AGAIN, Finding

_CHECK = "mjcf"
_SCENE = "put it into the scene that attaches the asset"
_ACTING = ("actuator", "tendon", "deformable", "extension", "include")  # they move, hold, or bring what does
_SOFTEST, _LEAST_IMPEDANCE = 0.02, 0.9  # MuJoCo's own time constant [s] and impedance
_SHOWN = 2  # colliders of a link
_FREE, _BALL = 0, 1  # of mjtJoint
_PLAIN = {"contype": 1.0, "conaffinity": 1.0, "condim": 3.0, "margin": 0.0, "gap": 0.0}


def strange_words(root: Any, file: str) -> Iterator[Finding]:
    """Yield elements that move links, hold them, or let them touch otherwise than `asset.json` says."""
    for tag in _ACTING:
        if root.find(f".//{tag}") is not None:
            yield Finding(_CHECK, f"{file} has <{tag}>, which is no part of an asset", hint=_SCENE)
    for pair in root.iterfind("contact/pair"):
        names = f"{pair.get('geom1')}, {pair.get('geom2')}"
        message = f"{file} makes a contact of its own between the geoms {names}"
        yield Finding(_CHECK, message, hint="remove <pair>")
    for equality in root.iterfind("equality/*"):
        name = equality.get("joint1", "")
        if equality.tag != "joint":
            message = f"{file} has the equality <{equality.tag}>, which holds links together"
            yield Finding(_CHECK, message, hint=_SCENE)
        elif isinstance(equality.tag, str) and not equality.get("joint2"):
            yield Finding(_CHECK, f"an equality of {file} holds it where it is", joint=name, hint=_SCENE)


def model_findings(model: Any, links: list[str], base: str, file: str) -> Iterator[Finding]:
    """Yield what a compiled model has beyond the links of an asset, and contacts that are not plain."""
    import mujoco

    for body in range(model.nbody):
        name = model.body(body).name
        link = name if name in links else ""
        found = list(_geom_findings(model, body, link, file))
        yield from found[:_SHOWN]
        if len(found) > _SHOWN:
            message = f"{len(found) - _SHOWN} more of its colliders are not plain in {file}"
            yield Finding(_CHECK, message, link, value=float(len(found)), hint=AGAIN)
        yield from _joint_findings(model, body, link, base, file)
    for number in range(model.neq):
        terms = model.eq_data[number, 2:5]
        coupling = model.eq_type[number] == mujoco.mjtEq.mjEQ_JOINT and model.eq_obj2id[number] >= 0
        if coupling and np.abs(terms).max() > 0.0:
            message = f"its coupling has terms of higher order, {terms}, in {file}"
            name = model.joint(int(model.eq_obj1id[number])).name
            yield Finding(_CHECK, message, joint=name, value=float(np.abs(terms).max()), hint=AGAIN)


def _geom_findings(model: Any, body: int, link: str, file: str) -> Iterator[Finding]:
    first = model.body_geomadr[body]
    for geom in range(first, first + model.body_geomnum[body]):
        if not (model.geom_contype[geom] or model.geom_conaffinity[geom]):
            continue
        name = model.geom(geom).name or f"number {geom}"
        if not link:
            where = model.body(body).name
            message = f"its body {where!r} is no link of the asset and collides, by the geom {name!r}"
            yield Finding(_CHECK, message, hint=_SCENE)
            continue
        strange = [
            key for key, wanted in _PLAIN.items() if float(getattr(model, f"geom_{key}")[geom]) != wanted
        ]
        if strange:
            text = ", ".join(f"{key} {float(getattr(model, f'geom_{key}')[geom]):.4g}" for key in strange)
            usual = ", ".join(f"{_PLAIN[key]:g}" for key in strange)
            yield Finding(_CHECK, f"its collider {name} has {text} in {file}, not {usual}", link, hint=AGAIN)
        if _is_soft(model.geom_solref[geom], model.geom_solimp[geom]):
            yield Finding(
                _CHECK, f"its collider {name} is softer than MuJoCo's own in {file}", link, hint=AGAIN
            )


def _joint_findings(model: Any, body: int, link: str, base: str, file: str) -> Iterator[Finding]:
    first = model.body_jntadr[body]
    for joint in range(first, first + model.body_jntnum[body]):
        name, kind = model.joint(joint).name, int(model.jnt_type[joint])
        if kind == _BALL or (kind == _FREE and not _holds(model, body, base)):
            what = "as a ball" if kind == _BALL else "freely"
            message = f"the body {model.body(body).name!r} moves {what} in {file}"
            yield Finding(_CHECK, message, link, hint=AGAIN)
        elif kind != _FREE and _is_soft(model.jnt_solref[joint], model.jnt_solimp[joint]):
            message = f"its limits are softer than MuJoCo's own in {file}"
            yield Finding(_CHECK, message, joint=name, hint=AGAIN)


def _holds(model: Any, body: int, base: str) -> bool:
    """Tell whether a body is the base or has it below."""
    below = model.body(base).id if base in {model.body(number).name for number in range(model.nbody)} else 0
    while below and below != body:
        below = model.body_parentid[below]
    return bool(below)


def _is_soft(reference: Any, impedance: Any) -> bool:
    """Tell whether a constraint gives way more than MuJoCo's default; negative numbers are stiffnesses."""
    return bool(reference[0] > _SOFTEST + 1e-9 or impedance[0] < _LEAST_IMPEDANCE - 1e-9)
