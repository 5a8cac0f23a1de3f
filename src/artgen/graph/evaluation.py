"""Evaluation: each distinct subgraph is computed once and cached by its content."""

import hashlib
import math
from collections import Counter, OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from threading import Lock
from time import perf_counter
from typing import Any

import numpy as np

from artgen.errors import EvaluationError, InfeasibleError
from artgen.graph.handle import Handle, handle_of, handle_type, resolved
from artgen.graph.kernel import _LEVEL, FULL, Detail, Operation, operation
from artgen.graph.node import PARAMETER, Node, nodes_in, topological

_ABSENT = object()


class Cache:
    """Values of subgraphs by content; the least recently used values are dropped first.

    Args:
        capacity: Largest number of values.
    """

    def __init__(self, capacity: int = 4096) -> None:
        self.capacity = capacity
        self._values: OrderedDict[str, Any] = OrderedDict()
        self._lock = Lock()  # held while the order changes, never while a value is computed

    def __contains__(self, key: str) -> bool:
        return key in self._values

    def __len__(self) -> int:
        return len(self._values)

    def get(self, key: str, default: Any = None) -> Any:
        """Return the value of a key, or the default."""
        with self._lock:
            if key in self._values:
                self._values.move_to_end(key)
            return self._values.get(key, default)

    def put(self, key: str, value: Any) -> None:
        """Store a value."""
        with self._lock:
            self._values[key] = value
            self._values.move_to_end(key)
            if len(self._values) > self.capacity:
                self._values.popitem(last=False)

    def clear(self) -> None:
        """Remove all values."""
        self._values.clear()


@dataclass
class Evaluation:
    """The value of an evaluation and its cost.

    Attributes:
        value: The value of the root.
        runs: Number of runs of each operation's kernel.
        hits: Number of values from the cache.
        seconds: Time spent in each operation's kernel [s].
        keys: The content key of each node, by the node's own key.
        node_seconds: Time spent in the kernel of each node that ran, by the node's own key [s].
    """

    value: Any = None
    runs: Counter[str] = field(default_factory=Counter)
    hits: int = 0
    seconds: dict[str, float] = field(default_factory=dict)
    keys: dict[str, str] = field(default_factory=dict)
    node_seconds: dict[str, float] = field(default_factory=dict)


def evaluate(
    handle: Handle,
    parameters: Mapping[str, Any] | None = None,
    cache: Cache | None = None,
    detail: Detail = FULL,
) -> Evaluation:
    """Compute the value of a handle.

    Numbers, points and frames are measured on solids of full detail at every level, so that they are the
    same.

    Args:
        handle: Root of the graph.
        parameters: The value of each parameter that the graph reaches.
        cache: Values from earlier evaluations; new values are added.
        detail: Level of detail of the solids.

    Raises:
        EvaluationError: A kernel failed, or a parameter has no value or a value of the wrong type; the
            message names the operation, the reason, and the author's line.
        InfeasibleError: A requirement is violated.
    """
    order = topological(handle.node)
    given: dict[str, Any] = {}
    result = Evaluation(keys=_content_keys(order, parameters or {}, given))
    run = _Run(
        Cache() if cache is None else cache, given, result, set() if detail is FULL else _checked(order)
    )
    result.value = run.value(handle.node, detail)
    return result


def _checked(order: list[Node]) -> set[str]:
    """Return the keys of the nodes that may violate a requirement."""
    found: set[str] = set()
    for node in order:
        if node.op.startswith("require") or any(child.key in found for child in node.children):
            found.add(node.key)
    return found


class _Run:
    """Computes values of the nodes of a graph, those that can wait on first use."""

    def __init__(self, cache: Cache, given: Mapping[str, Any], result: Evaluation, checked: set[str]) -> None:
        self._cache, self._given, self._result = cache, given, result
        self._checked = checked  # keys of the nodes that cannot wait
        self._values: dict[Detail, dict[str, Any]] = {FULL: dict(given)}

    def value(self, root: Node, detail: Detail) -> Any:
        """Return the value of a node at a level of detail."""
        values = self._values
        values.setdefault(detail, dict(self._given))
        stack = [(root, detail)]
        while stack:
            node, level = stack[-1]
            if node.key in values[level]:
                stack.pop()
                continue
            known = operation(node.op)
            within = FULL if known.measures else level  # the level of its inputs
            content = self._result.keys[node.key] + ("" if within is FULL else f" {level.name} {level.chord}")
            value = self._cache.get(content, _ABSENT)
            if value is not _ABSENT:
                self._result.hits += 1
            else:
                value = known.bare(node.inputs) if level.thin and known.bare else NotImplemented
                if value is NotImplemented:
                    waiting = self._waiting(node, known, within)
                    inputs = values[within] | waiting if waiting else values[within]
                    missing = [child for child in _needed(node, known, inputs) if child.key not in inputs]
                    if missing:
                        stack.extend((each, within) for each in reversed(missing))
                        continue
                    value = self._run(node, known, inputs, within)
                self._cache.put(content, value)
            for each in list(values) if known.measures else (level,):
                values[each][node.key] = value
        return values[detail][root.key]

    def _run(self, node: Node, known: Operation, inputs: Mapping[str, Any], level: Detail) -> Any:
        result, start = self._result, perf_counter()
        value = _run(node, known, inputs, level)
        result.node_seconds[node.key] = elapsed = perf_counter() - start
        result.seconds[node.op] = result.seconds.get(node.op, 0.0) + elapsed
        result.runs[node.op] += 1
        return value

    def _waiting(self, node: Node, known: Operation, level: Detail) -> dict[str, Any]:
        """Return values in place of the inputs that can wait, by their keys."""
        if level is FULL:
            return {}
        return {
            child.key: make(partial(self._late, child, level))
            for name, make in known.later.items()
            for child in nodes_in(node.inputs[name])
            if child.key not in self._values[level] and child.key not in self._checked
        }

    def _late(self, node: Node, level: Detail) -> Any:
        """Return the value of a node that waited; if it fails, at the next level that does not."""
        while True:
            try:
                return self.value(node, level)
            except EvaluationError:
                if level is FULL:
                    raise
                level = level.finer


def reached(handle: Handle, parameters: Mapping[str, Any], cache: Cache | None = None) -> set[str]:
    """Return the names of the parameters that a value depends on; of a switch, only the chosen branch counts.

    Raises:
        EvaluationError: The condition of a switch cannot be evaluated.
    """
    cache = Cache() if cache is None else cache
    found: set[str] = set()
    seen: set[str] = set()
    stack = [handle.node]
    while stack:
        node = stack.pop()
        if node.key in seen:
            continue
        seen.add(node.key)
        condition = node.inputs.get("condition")
        if node.op == PARAMETER:
            found.add(node.inputs["name"])
        elif operation(node.op).lazy and isinstance(condition, Node):
            chosen = evaluate(handle_of(condition), parameters, cache).value
            stack += [condition, *nodes_in(node.inputs["a" if chosen else "b"])]
        else:
            stack += node.children
    return found


def _content_keys(order: list[Node], given: Mapping[str, Any], values: dict[str, Any]) -> dict[str, str]:
    """Hash every node with the values of its parameters inserted, and store those values."""
    keys: dict[str, str] = {}
    for node in order:
        if node.op == PARAMETER:
            literal, values[node.key] = _parameter_value(node, given)
            text = f"{PARAMETER}\0{literal!r}"
            keys[node.key] = hashlib.blake2b(text.encode(), digest_size=12).hexdigest()
        elif node.varies:
            keys[node.key] = node.digest(keys)
        else:
            keys[node.key] = node.key
    return keys


def _parameter_value(node: Node, given: Mapping[str, Any]) -> tuple[Any, Any]:
    """Return the value of a parameter as a literal, and in the form for kernels."""
    name, kind = node.inputs["name"], handle_type(node.inputs["kind"])
    if name not in given:
        raise EvaluationError(f"parameter {name!r} has no value\n  at {node.where}")
    literal = NotImplemented if isinstance(given[name], Handle) else kind.lift(given[name])
    if literal is NotImplemented:
        raise EvaluationError(
            f"parameter {name!r} needs the value of a {kind.__name__}, got {given[name]!r}\n  at {node.where}"
        )
    return literal, kind.decode(literal)


def _needed(node: Node, known: Operation, values: Mapping[str, Any]) -> Sequence[Node]:
    """Return the inputs that must be computed next: all of them, or for a switch only the chosen branch."""
    if not known.lazy:
        return node.children
    condition = node.inputs["condition"]
    if isinstance(condition, Node):
        if condition.key not in values:
            return [condition]
        condition = values[condition.key]
    chosen = node.inputs["a" if condition else "b"]
    return [chosen] if isinstance(chosen, Node) else []


def _run(node: Node, known: Operation, values: Mapping[str, Any], level: Detail) -> Any:
    if known.lazy:  # a branch that is not chosen has no value
        values = {child.key: values.get(child.key) for child in node.children}
    inputs = resolved(known, node.inputs, values)
    before = _LEVEL.set(level)
    try:
        value = known.kernel(*inputs)
    except InfeasibleError as error:
        raise InfeasibleError(f"{error}\n  at {node.where}") from None
    except Exception as error:
        reason = str(error) or type(error).__name__
        raise EvaluationError(f"{node.op} failed: {reason}\n  at {node.where}") from error
    finally:
        _LEVEL.reset(before)
    if isinstance(value, float) and not math.isfinite(value):
        raise EvaluationError(f"{node.op} gives {value}, which is not a finite number\n  at {node.where}")
    if isinstance(value, np.ndarray):
        if not np.isfinite(value).all():
            raise EvaluationError(f"{node.op} gives {value}, which is not finite\n  at {node.where}")
        value.setflags(write=False)  # every node that uses it shares it
    return value
