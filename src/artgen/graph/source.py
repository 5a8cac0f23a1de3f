"""Graphs as Python source, as an author would write it."""

import inspect
import keyword
import re
import sys
from collections import Counter
from collections.abc import Mapping
from typing import Any

from artgen.errors import GraphError
from artgen.graph.handle import LITERAL_TYPES, Handle, handle_of, lift
from artgen.graph.kernel import Operation, operation
from artgen.graph.node import PARAMETER, Node, topological

_LONGEST_LINE = 100


def to_python(handle: Handle, name: str = "build") -> str:
    """Return Python source of a function that builds the graph which a handle reaches.

    Executing the source and calling the function returns a handle whose node has the same key.
    """
    if not name.isidentifier() or keyword.iskeyword(name):
        raise GraphError(f"{name!r} is not a name for a Python function")
    writer = _Writer(handle)
    result = writer.expression(handle.node)
    kind = type(handle_of(handle.node)).__name__
    imports = "".join(
        f"from {module} import {', '.join(sorted(names))}\n"
        for module, names in sorted(writer.imports.items())
    )
    body = "".join(f"    {line}\n" for line in writer.lines)
    return f"{imports}\n\ndef {name}() -> {kind}:\n{body}    return {result}\n"


class _Writer:
    """Writes shared nodes as variables and other nodes in place."""

    def __init__(self, handle: Handle) -> None:
        order = topological(handle.node)
        uses = Counter(child.key for node in order for child in node.children)
        self.lines: list[str] = []
        self.imports: dict[str, set[str]] = {}
        self._spelled: dict[str, str] = {}
        self._taken: Counter[str] = Counter()
        self._import(type(handle_of(handle.node)))
        for node in order:
            text = self._spell(node)
            if uses[node.key] > 1 or len(text) > _LONGEST_LINE:
                variable = self._variable(node)
                self.lines.append(f"{variable} = {text}")
                text = variable
            self._spelled[node.key] = text

    def expression(self, node: Node) -> str:
        """Return the source of a node."""
        return self._spelled[node.key]

    def _import(self, made: Any) -> str:
        name: str = made.__name__
        self.imports.setdefault(made.__module__, set()).add(name)
        return name

    def _variable(self, node: Node) -> str:
        wanted = str(node.inputs.get("label") or node.inputs.get("name") or node.op)
        wanted = re.sub(r"\W", "_", wanted)
        if not wanted.isidentifier() or keyword.iskeyword(wanted):
            wanted = f"_{wanted}"
        # the suffix distinguishes variables from imported functions
        self._taken[wanted] += 1
        return f"{wanted}_{self._taken[wanted]}"

    def _spell(self, node: Node) -> str:
        if node.op == PARAMETER:
            kind = self._import(type(handle_of(node)))
            return f"{kind}.parameter({node.inputs['name']!r})"
        known = operation(node.op)
        if _is_infix(known, node):
            written = {name: self._value(value) for name, value in node.inputs.items()}
            if known.spelling.startswith("("):  # an operator
                # a negative number stands in parentheses: `-2.0 ** a` means `-(2.0 ** a)`
                written = {name: f"({text})" if text[:1] == "-" else text for name, text in written.items()}
            return known.spelling.format(**written)
        return self._call(known, node)

    def _call(self, known: Operation, node: Node) -> str:
        constructor = getattr(sys.modules[known.module], known.constructor, None)
        if constructor is None:
            handle = self._import(type(handle_of(node)))
            return f"{handle}.record({', '.join([repr(known.name), *self._keywords(node.inputs)])})"
        self.imports.setdefault(known.module, set()).add(known.constructor)
        remaining = dict(node.inputs)
        arguments: list[str] = []
        positional = True
        for name, parameter in inspect.signature(constructor).parameters.items():
            if name not in remaining:  # determined by the kind of value, as in `switch`
                positional = False
            elif parameter.kind is parameter.VAR_POSITIONAL:
                arguments += [self._value(item) for item in remaining.pop(name)]
            elif _is_default(remaining[name], parameter.default, known.inputs[name]):
                del remaining[name]
                positional = False
            elif parameter.kind is parameter.KEYWORD_ONLY:
                positional = False
            elif positional:
                arguments.append(self._value(remaining.pop(name)))
        return f"{known.constructor}({', '.join([*arguments, *self._keywords(remaining)])})"

    def _keywords(self, inputs: Mapping[str, Any]) -> list[str]:
        return [f"{name}={self._value(value)}" for name, value in inputs.items()]

    def _value(self, value: Any) -> str:
        if isinstance(value, Node):
            return self._spelled[value.key]
        if isinstance(value, tuple):
            items = [self._value(item) for item in value]
            return f"({', '.join(items)}{',' if len(items) == 1 else ''})"
        if isinstance(value, dict):
            for kind, literal in LITERAL_TYPES.items():
                if "$" + literal.tag in value:
                    self._import(kind)
                    return repr(literal.decode(value["$" + literal.tag]))
        return repr(value)


def _is_infix(known: Operation, node: Node) -> bool:
    """Tell whether the operation's spelling reproduces this node."""
    # Python needs a handle among the operands, and evaluates `2 < a` with a handle `a` as `a > 2`
    values = list(node.inputs.values())
    if not known.spelling or not any(isinstance(value, Node) for value in values):
        return False
    return isinstance(values[0], Node) or known.result is float


def _is_default(value: Any, default: Any, hint: Any) -> bool:
    """Tell whether omitting an argument gives the same literal."""
    if default is inspect.Parameter.empty or isinstance(default, Handle) or isinstance(value, Node):
        return False
    try:
        return repr(lift(default, hint, "")) == repr(value)
    except ValueError:
        return False
