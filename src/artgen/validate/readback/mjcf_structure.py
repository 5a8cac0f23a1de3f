"""Faults of an MJCF file that do not depend on the asset: MuJoCo refuses them or silently accepts them."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from artgen.asset.report import AGAIN, Finding
from artgen.validate.readback.mjcf_foreign_elements import strange_words

_CHECK = "mjcf"
_NAMED = ("body", "joint", "geom", "site", "mesh", "material", "texture")
_ROUNDING = 1e-6  # relative, of moments of inertia


def mjcf_findings(path: Path) -> Iterator[Finding]:
    """Yield what hides contacts or changes gravity, and names and numbers that MuJoCo refuses."""
    from lxml import etree

    root = etree.parse(path).getroot()
    file = path.name
    for exclude in root.iterfind("contact/exclude"):
        pair = f"{exclude.get('body1')}, {exclude.get('body2')}"
        message = f"{file} excludes their contacts, which hides parts that go through each other"
        yield Finding(_CHECK, message, pair, hint="remove <exclude>")
    for option in root.iterfind("option"):
        for what in [name for name in ("gravity", "density", "wind") if option.get(name)]:
            message = f"{file} sets {what} to {option.get(what)}, which is up to the scene"
            yield Finding(_CHECK, message, hint="remove it from <option>")
        for flag in option.iterfind("flag"):
            text = ", ".join(f"{name}={value}" for name, value in flag.items())
            yield Finding(
                _CHECK, f"{file} sets the flags {text}, which are up to the scene", hint="remove <flag>"
            )
    bodies = list(root.iterfind("worldbody//body"))
    yield from _repeated(root, file)
    for body in bodies:
        yield from _body_findings(body, file)
    for joint in root.iterfind("worldbody//joint"):
        yield from _range_findings(joint, file)
    yield from _unknown(root, file)
    yield from strange_words(root, file)


def _repeated(root: Any, file: str) -> Iterator[Finding]:
    for kind in _NAMED:
        scope = "asset" if kind in ("mesh", "material", "texture") else "worldbody"
        names = [element.get("name") for element in root.iterfind(f"{scope}//{kind}")]
        for name, count in Counter(filter(None, names)).items():
            if count > 1:
                link, joint = name if kind == "body" else "", name if kind == "joint" else ""
                message = f"{count} {kind} elements are named {name!r} in {file}"
                yield Finding(_CHECK, message, link, joint, float(count), hint=AGAIN)


def _body_findings(body: Any, file: str) -> Iterator[Finding]:
    name = body.get("name", "")
    if _numbers(body.get("gravcomp", "0"))[:1] != [0.0]:
        message = f"{file} takes the share {body.get('gravcomp')} of its weight away (gravcomp)"
        yield Finding(_CHECK, message, name, hint="remove gravcomp")
    for inertial in body.iterfind("inertial"):
        mass = _numbers(inertial.get("mass", "0"))[0]
        if not mass > 0.0:
            yield Finding(
                _CHECK, f"its mass is {mass:.4g} kg in {file}", name, value=mass, unit="kg", hint=AGAIN
            )
        six, three = (_numbers(inertial.get(key, "")) for key in ("fullinertia", "diaginertia"))
        if len(six) == 6:
            xx, yy, zz, xy, xz, yz = six
            three = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).tolist()
        text = moments_fault(three)
        if text:
            yield Finding(_CHECK, f"{text} in {file}", name, value=min(three), unit="kg m^2", hint=AGAIN)


def moments_fault(moments: Any) -> str:
    """Say why principal moments, shape (3,) [kg m^2], are not those of a body; nothing if they are."""
    if len(moments) != 3:
        return ""
    low, middle, high = sorted(moments)
    shown = ", ".join(f"{moment:.4g}" for moment in (low, middle, high))
    if not low > 0.0:
        return f"its principal moments {shown} kg m^2 are not all positive"
    if low + middle < high * (1.0 - _ROUNDING):
        return f"its principal moments {shown} kg m^2 violate the triangle inequality"
    return ""


def _range_findings(joint: Any, file: str) -> Iterator[Finding]:
    low, high = ([*_numbers(joint.get("range", "0 1")), 0.0, 0.0])[:2]
    if not low < high:
        message = f"its limits are inverted or empty in {file}: from {low:.7g} to {high:.7g}"
        yield Finding(_CHECK, message, joint=joint.get("name", ""), value=high - low, hint=AGAIN)


def _unknown(root: Any, file: str) -> Iterator[Finding]:
    """Yield what is named and not there."""
    for kind in ("mesh", "material"):
        known = {element.get("name") for element in root.iterfind(f"asset/{kind}")}
        known |= {Path(element.get("file", "")).stem for element in root.iterfind(f"asset/{kind}[@file]")}
        for geom in root.iterfind("worldbody//geom"):
            name = geom.get(kind)
            if name and name not in known:
                message = (
                    f"its geom {geom.get('name')!r} names the {kind} {name!r}, which {file} does not have"
                )
                yield Finding(_CHECK, message, geom.getparent().get("name", ""), hint=AGAIN)
    joints = {element.get("name") for element in root.iterfind("worldbody//joint")}
    for equality in root.iterfind("equality/joint"):
        for key in ("joint1", "joint2"):
            name = equality.get(key)
            if name and name not in joints:
                message = f"its coupling names the joint {name!r}, which {file} does not have"
                yield Finding(_CHECK, message, joint=equality.get("joint1", ""), hint=AGAIN)


def _numbers(text: str) -> list[float]:
    try:
        return [float(word) for word in text.split()]
    except ValueError:
        return [float("nan")]
