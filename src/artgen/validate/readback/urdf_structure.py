"""Faults of a URDF that do not depend on the asset; readers silently ignore most of them."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from artgen.asset.report import AGAIN, Finding
from artgen.errors import nearest

_CHECK = "urdf"
_OF_GAZEBO = ("springStiffness", "springReference")


def urdf_findings(path: Path) -> Iterator[Finding]:
    """Yield names that are there twice or not at all, and limits that cannot be."""
    from lxml import etree

    robot = etree.parse(path).getroot()
    links, joints = (_names(robot, tag) for tag in ("link", "joint"))
    yield from _repeated(robot)
    yield from _tree_findings(robot, links)
    for joint in robot.iterfind("joint"):
        yield from _joint_findings(joint, joints)
    yield from _strange_words(robot)
    known = {element.get("name") for element in robot.iterfind("material")}
    for link in robot.iterfind("link"):
        count = len(link.findall("inertial"))
        if count > 1:
            message = f"it has {count} inertials in {path.name}; readers take any of them"
            yield Finding(_CHECK, message, link.get("name"), value=float(count), hint=AGAIN)
        for material in link.iterfind("visual/material"):
            if not len(material) and material.get("name") not in known:
                name = str(material.get("name"))
                message = (
                    f"it is of the material {name!r}, which the file does not define.{nearest(name, known)}"
                )
                yield Finding(_CHECK, message, link.get("name"), hint=AGAIN)


def _names(robot: Any, tag: str) -> list[str]:
    return [element.get("name", "") for element in robot.iterfind(tag)]


def _repeated(robot: Any) -> Iterator[Finding]:
    kinds = {"link": "link", "joint": "joint", "collision": "link/collision"}
    for kind, place in kinds.items():
        for name, count in Counter(_names(robot, place)).items():
            if count > 1 and name:
                link, joint = name if kind == "link" else "", name if kind == "joint" else ""
                message = f"{count} {kind}s are named {name!r}; readers keep one of them"
                yield Finding(_CHECK, message, link, joint, float(count), hint=AGAIN)


def _strange_words(robot: Any) -> Iterator[Finding]:
    """Yield what makes single readers take links and joints for others than the file says."""
    for tag in ("safety_controller", "calibration"):
        for element in robot.iterfind(f"joint/{tag}"):
            name = element.getparent().get("name", "")
            message = f"its <{tag}> narrows or shifts its limits for some readers"
            yield Finding(_CHECK, message, joint=name, hint=f"remove <{tag}>")
    for element in robot.iterfind("gazebo"):
        said = [word.tag for word in element if isinstance(word.tag, str) and word.tag not in _OF_GAZEBO]
        if said:
            message = f"Gazebo is told {', '.join(said)} of {element.get('reference', 'the model')!r}"
            hint = "put it into the scene; an asset says springs only"
            yield Finding(_CHECK, message, hint=hint)
    for tag in ("transmission", "mujoco"):
        if robot.find(tag) is not None:
            message = f"it has <{tag}>, which is no part of an asset"
            yield Finding(_CHECK, message, hint="put it into the scene")


def _tree_findings(robot: Any, links: list[str]) -> Iterator[Finding]:
    above: dict[str, str] = {}
    for joint in robot.iterfind("joint"):
        name = joint.get("name", "")
        for tag in ("parent", "child"):
            element = joint.find(tag)
            end = "" if element is None else element.get("link", "")
            if end not in links:
                message = f"its {tag} {end!r} is no link of the file.{nearest(end, links)}"
                yield Finding(_CHECK, message, joint=name, hint=AGAIN)
            elif tag == "child" and end in above:
                message = f"two joints hold it: {above[end]!r} and {name!r}"
                yield Finding(_CHECK, message, end, name, hint=AGAIN)
            elif tag == "child":
                above[end] = name
    roots = [name for name in links if name not in above]
    if len(roots) != 1:
        message = f"it has {len(roots)} links that hang on no joint ({', '.join(roots)}); 1 is right"
        yield Finding(_CHECK, message, value=float(len(roots)), hint=AGAIN)


def _joint_findings(joint: Any, joints: list[str]) -> Iterator[Finding]:
    name, limit, mimic = joint.get("name", ""), joint.find("limit"), joint.find("mimic")
    if limit is not None and joint.get("type") != "fixed":
        for what in ("effort", "velocity"):
            value = _number(limit.get(what))
            if not value > 0.0:
                message = f"its {what} limit is {value:.4g}; simulators take it for a joint that cannot move"
                yield Finding(_CHECK, message, joint=name, value=value, hint=AGAIN)
        low, high = _number(limit.get("lower")), _number(limit.get("upper"))
        if joint.get("type") != "continuous" and not low < high:
            message = f"its limits are inverted or empty: from {low:.7g} to {high:.7g}"
            yield Finding(_CHECK, message, joint=name, value=high - low, hint=AGAIN)
    if mimic is not None and mimic.get("joint") not in joints:
        leader = str(mimic.get("joint"))
        message = f"it follows {leader!r}, which is no joint of the file.{nearest(leader, joints)}"
        yield Finding(_CHECK, message, joint=name, hint=AGAIN)


def _number(text: str | None) -> float:
    try:
        return float(text or 0.0)
    except ValueError:
        return float("nan")
