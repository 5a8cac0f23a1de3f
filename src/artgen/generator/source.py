"""The check of an author's function: graphs that differ when built again, and likely mistakes."""

from __future__ import annotations

import ast
import dis
import functools
import linecache
import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Literal, get_origin

from artgen.asset import Asset, AssetJoint, Tree
from artgen.asset.report import CheckResult, Finding
from artgen.errors import ArtgenError, nearest
from artgen.graph import OPERATIONS, Cache, Graph, Handle, operation
from artgen.graph.node import Node, topological
from artgen.nodes.handles import Solid

if TYPE_CHECKING:
    from artgen.generator.generator import Generator

_REMOVED = 1e-9  # least share of a solid that a cut removes
_ROTATIONS = ("rotate", "rotate_body", "profile_rotate")


def check_source(
    generator: Generator, again: Generator, asset: Asset, *, overrides: Mapping[str, Any] | None = None
) -> CheckResult:
    """Check that the function builds the same graph again, and that the asset has all that it makes.

    Args:
        generator: A generator.
        again: The same generator; one from a file is best loaded a second time.
        asset: An asset that it generated.
        overrides: Values or other distributions by name.

    Returns:
        The check `source`: a fault with the author's line if the two graphs differ, or if the number of
        joints is not the declared one, and a note for each likely mistake: a body or joint that is not in
        the asset, a parameter that is never used or compared with a word that it never has, a rotation
        in degrees, a cut that removes nothing, a loop over a set.
    """
    seed, attempt = asset.seed or 0, asset.attempt
    values = generator.sample(seed, attempt=attempt, overrides=overrides)
    first, made = generator.traced(values, {})
    # a module that is loaded again has new variables; in the same one, those that the function changes differ
    both = (again, generator) if again is not generator else (generator,)
    others = [each.build(each.sample(seed, attempt=attempt, overrides=overrides)) for each in both]
    kinds = {Tree: "body", AssetJoint: "joint"}
    left = [node for node in unused(first, made) if operation(node.op).result in kinds]
    findings = [
        Finding(
            "source",
            f"the {kinds[operation(node.op).result]} of {node.op} at {node.where} is not in the asset",
            hint="return, attach or weld it, or make it only where it is used",
            severity="note",
        )
        for node in left
    ]
    findings += [
        Finding(
            "source",
            f"the parameter {name!r} at {generator.where} is never used",
            hint="use it in the function, or remove it",
            severity="note",
        )
        for name in _unread(generator)
    ]
    findings += [*_misread(generator), *_turned_by_degrees(made), *_cut_by_nothing(made, values)]
    least, most = generator.joints or (0, math.inf)
    if not least <= (count := len(asset.joints)) <= most:
        message = f"the asset has {count} joints, but @category(joints=({least}, {most})) is declared"
        findings.append(Finding("source", message, hint=f"correct the numbers at {generator.where}"))
    differing = [_differing(first.node, each.node) for each in others if first.node.key != each.node.key]
    return CheckResult("source", (*findings, *differing[:1]), f"built twice, {len(made)} operations")


def _unread(generator: Generator) -> list[str]:
    """Return the parameters that neither the function nor a distribution reads."""
    code = generator.function.__code__
    read = {name for each in generator.own.values() for name in each.distribution.needs()}
    read.update(code.co_cellvars)
    for step in dis.get_instructions(code):
        if "LOAD" in step.opname:  # one step may load two variables
            read.update(step.argval if isinstance(step.argval, tuple) else (step.argval,))
    return [name for name in generator.own if name not in read]


def _misread(generator: Generator) -> Iterator[Finding]:
    """Yield a note for each comparison of a parameter with a word that it never has, and loop over a set."""
    code = generator.function.__code__
    file, first = code.co_filename, code.co_firstlineno
    last = max((line or 0 for _, _, line in code.co_lines()), default=first)
    kinds = {name: get_origin(each.kind) or each.kind for name, each in generator.own.items()}
    words = {name: generator.own[name].options for name, kind in kinds.items() if kind in (str, Literal)}
    for line, node in _expressions("".join(linecache.getlines(file))):
        if not first <= line <= last:
            continue
        at = f"at {file}:{line}"
        if _is_set(node):
            hint = "its order differs from process to process: write a tuple, or sorted(...)"
            yield Finding("source", f"a loop takes its values from a set {at}", hint=hint, severity="note")
        elif isinstance(node, ast.Compare) and isinstance(node.left, ast.Name):
            options = words.get(node.left.id, ())
            for each in ast.walk(node.comparators[0]):
                word = each.value if isinstance(each, ast.Constant) else None
                if options and isinstance(word, str) and word not in options:
                    message = f"{node.left.id} is compared with {word!r} {at}"
                    near = nearest(word, options).strip()
                    yield Finding("source", message, hint=f"it never has that value. {near}", severity="note")


def unused(result: Handle, made: Sequence[Node]) -> list[Node]:
    """Return the nodes that neither the result nor another operation uses, except those of switches."""
    used = {child.key for node in made for child in node.children}
    used.add(getattr(result.node, "key", ""))  # a number has no node
    return [node for node in made if node.key not in used and not operation(node.op).lazy]


@functools.lru_cache(maxsize=64)
def _expressions(text: str) -> tuple[tuple[int, ast.expr], ...]:
    """Return the comparisons in a file and the values of its loops, with their lines."""
    found: list[ast.expr] = []
    with suppress(SyntaxError):  # edited meanwhile
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.For | ast.comprehension):
                found.append(node.iter)
            elif isinstance(node, ast.Compare):
                found.append(node)
    return tuple(sorted(((node.lineno, node) for node in found), key=lambda pair: pair[0]))


def _is_set(node: ast.expr) -> bool:
    called = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
    return isinstance(node, ast.Set | ast.SetComp) or called in ("set", "frozenset")


def _turned_by_degrees(made: Sequence[Node]) -> Iterator[Finding]:
    """Yield a note for each rotation by a whole number of radians that is more than a turn."""
    for node in made:
        angle = node.inputs.get("angle")
        if (
            node.op in _ROTATIONS
            and isinstance(angle, float)
            and abs(angle) > math.tau
            and angle % 1.0 == 0.0
        ):
            message = f"{node.op} at {node.where} turns by {angle:g} rad, {abs(angle) / math.tau:.1f} turns"
            hint = f"angles are in radians: math.radians({angle:g})"
            yield Finding("source", message, hint=hint, severity="note")


def _cut_by_nothing(made: Sequence[Node], values: Mapping[str, Any]) -> Iterator[Finding]:
    """Yield a note for each difference that removes nothing."""
    cache = Cache()
    for node in made:
        if node.op != "difference":
            continue
        with suppress(ArtgenError):  # of an option that is not taken
            whole, rest = (
                Graph(Solid(each)).evaluate(values, cache).value.manifold.volume()
                for each in (node.inputs["a"], node)
            )
            if whole - rest < _REMOVED * whole:
                message = f"the cut at {node.where} removes nothing"
                yield Finding("source", message, hint="move the second solid into the first", severity="note")


def is_dropped(node: Node) -> bool:
    """Tell whether a node is of a statement that calls an operation or a method of a handle."""
    file, _, line = node.where.rpartition(":")
    linecache.checkcache(file)
    return int(line or 0) in _calls("".join(linecache.getlines(file)))


@functools.lru_cache(maxsize=64)
def _calls(text: str) -> frozenset[int]:
    """Return the lines of statements that only call an operation or a method of a handle."""
    try:
        parsed = ast.parse(text)
    except SyntaxError:  # edited meanwhile
        return frozenset()
    methods = {*OPERATIONS, *(name for kind in Handle.HANDLES.values() for name in dir(kind))}
    lines: set[int] = set()
    blocks: list[ast.AST] = [parsed]
    while blocks:  # statements without their expressions, which are many
        each = blocks.pop()
        for name in ("body", "orelse", "finalbody", "handlers", "cases"):
            blocks += getattr(each, name, ())
        if isinstance(each, ast.Expr) and isinstance(each.value, ast.Call):
            called = each.value.func
            if getattr(called, "attr", getattr(called, "id", "")) in methods:  # `body.attach`, or `part`
                lines.update(range(each.lineno, (each.end_lineno or each.lineno) + 1))
    return frozenset(lines)


def _differing(first: Node, second: Node) -> Finding:
    """Return the fault of a function that builds two graphs for the same values."""
    pairs = zip(topological(first), topological(second), strict=False)
    node, other = next((pair for pair in pairs if pair[0].key != pair[1].key), (first, second))
    changed = ""
    for name, value in node.inputs.items():
        if name in other.inputs and isinstance(value, float | int | str) and value != other.inputs[name]:
            changed = f": {name} was {value!r}, then {other.inputs[name]!r}"
            break
    return Finding(
        "source",
        "the same seed gives another asset when it is built again; "
        f"{node.op} at {node.where} differs{changed}",
        hint="draw numbers in the signature, such as width: Float = uniform(0.1, 0.2); use no random, time "
        "or order of a set",
    )
