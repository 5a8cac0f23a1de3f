"""Handles: typed references to nodes while a graph is built. A handle has a type and a node, but no value.

In the graph of a single sample, a handle of a number, truth value, vector or list of points holds a literal
instead of a node where all inputs of its operation are literals.
"""

import inspect
import math
import typing
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache, lru_cache, partial, wraps
from types import NoneType
from typing import Any, ClassVar, NoReturn, Self, TypeVar

import numpy as np

from artgen.errors import BuildError, nearest
from artgen.graph.kernel import OPERATIONS, Operation, alternatives, operation, register, types_of
from artgen.graph.node import PARAMETER, Data, Node, authors_line

C = TypeVar("C", bound=Callable[..., Any])

_FOLDING = ContextVar("folding", default=False)
_RECORDED: ContextVar[list[Node] | None] = ContextVar("recorded", default=None)


@contextmanager
def recording() -> Iterator[list[Node]]:
    """Collect the nodes of all operations, also of those that no result uses."""
    nodes: list[Node] = []
    token = _RECORDED.set(nodes)
    try:
        yield nodes
    finally:
        _RECORDED.reset(token)


@contextmanager
def folding() -> Iterator[None]:
    """Compute the results of operations at once where their inputs are known and the result has a literal."""
    token = _FOLDING.set(True)
    try:
        yield
    finally:
        _FOLDING.reset(token)


def of_numbers(name: str, a: Any, b: Any) -> float | None:
    """Return the result of an operation on two numbers at once, None where it has to be recorded.

    Most operations of a sample are sums and products, for which `record` takes several times as long.
    """
    if not (_FOLDING.get() and type(a) in _NUMBERS and type(b) in _NUMBERS):
        return None
    try:
        value = operation(name).kernel(float(a), float(b))
    except (ArithmeticError, ValueError):
        return None
    return value if math.isfinite(a) and math.isfinite(b) and math.isfinite(value) else None


_NUMBERS = (float, int)


class Handle:
    """A value that is known when the graph is evaluated.

    Subclasses name the type of that value in `value_type`; their `lift` accepts Python values that may
    replace a handle. Operations that need the value while building raise an error with the remedies.
    """

    __slots__ = ("node",)
    __array_ufunc__ = None  # numpy's numbers leave arithmetic with handles to the handle
    value_type: ClassVar[Any] = None
    folds: ClassVar[bool] = False  # whether values are numbers or arrays, which have literals
    HANDLES: ClassVar[dict[Any, type["Handle"]]] = {}

    def __init__(self, node: Any) -> None:
        """Wrap a node with a result of this handle's type, or a literal of this type."""
        self.node: Node = node

    def __init_subclass__(cls) -> None:
        """Register the handle class for its value type, unless it is that of its base."""
        if vars(cls).get("value_type") is not None:
            Handle.HANDLES[cls.value_type] = cls

    @classmethod
    def record(cls, kernel: Callable[..., Any] | str, /, **inputs: Any) -> Self:
        """Record an operation in a new node and return the handle of its result.

        Args:
            kernel: The kernel, or the name of its operation.
            **inputs: Handles, or Python values that may replace them.

        Raises:
            BuildError: An input is unknown, missing, or has another type than the kernel's.
        """
        known = operation(kernel if isinstance(kernel, str) else kernel.__name__.lstrip("_"))
        return cls(_result(cls, known, lift_all(known, inputs)))

    @classmethod
    def socket(cls, name: str, where: str, value: Any) -> Self:
        """Return the handle of a parameter; of its value where results are computed at once."""
        return cls(cls.lift(value)) if _FOLDING.get() else cls.parameter(name, where)

    @classmethod
    def parameter(cls, name: str, where: str = "") -> Self:
        """Return the handle of a parameter, which is drawn at generation.

        Args:
            name: Name of the value at evaluation.
            where: File and line of the author; by default the caller's.
        """
        return cls(Node(PARAMETER, {"name": name, "kind": cls.__name__}, where or authors_line()))

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Return the node or literal of a Python value, or NotImplemented."""
        return value.node if isinstance(value, cls) else NotImplemented

    @classmethod
    def decode(cls, literal: Any) -> Any:
        """Return the value of a literal of this type for kernels."""
        return literal

    def require(self, condition: "Handle | bool", message: str) -> Self:
        """Return this value under a condition: a sample that violates the condition is drawn again.

        Raises:
            BuildError: Values of this type cannot have requirements.
        """
        name = f"require_{type(self).__name__.lower()}"
        if name not in OPERATIONS:
            raise BuildError(
                f"a {type(self).__name__} cannot carry a requirement\n  at {authors_line()}\n"
                "  Attach it to a number, a solid or the body: body.require(condition, message)"
            )
        return type(self).record(name, value=self, condition=condition, message=message)

    def _refuse(self, what: str, remedy: str) -> NoReturn:
        raise BuildError(
            f"{what}: a {type(self).__name__} has no value while the graph is being built\n"
            f"  at {authors_line()}, made at {getattr(self.node, 'where', self.node)}\n"
            f"  {remedy}\n"
            "  Or make the parameter that it comes from structural (annotate it int, str, bool or Literal): "
            "then it is known while building, and plain if, for and == work."
        )

    def __bool__(self) -> bool:
        """Raise BuildError: a handle is neither true nor false."""
        self._refuse(
            "a handle used as a condition",
            "Use switch(condition, a, b) instead of if; a & b, a | b, ~a instead of and, or, not; "
            "(a < b) & (b < c) instead of a < b < c; min_ and max_ instead of min and max.",
        )

    def __eq__(self, other: object) -> bool:
        """Raise BuildError: comparing handles does not compare their values."""
        self._refuse(
            "== or != on a handle",
            "Use switch(abs(a - b) < tolerance, ...) for numbers; a.node.key == b.node.key tells whether two "
            "handles stand for equal graphs.",
        )

    def __ne__(self, other: object) -> bool:
        """Raise BuildError: comparing handles does not compare their values."""
        return not self.__eq__(other)

    def __hash__(self) -> int:
        """Raise BuildError: a handle cannot be compared, so it cannot be a key."""
        self._refuse(
            "a handle as a key of a dict or a member of a set",
            "Use switch(condition, a, b) instead of a look-up, or handle.node.key as the key.",
        )

    def __len__(self) -> int:
        """Raise BuildError: the length is not known."""
        self._refuse(
            "len() of a handle",
            "Use body.repeat(child, joint, at=points) for copies, switch(condition, points, others) where "
            "their number varies.",
        )

    def __iter__(self) -> Iterator[Any]:
        """Raise BuildError: the members are not known."""
        self._refuse(
            "iteration over a handle",
            "Use .x, .y and .z of a Vector, body.repeat(child, joint, at=points) for copies, or "
            "switch(condition, a, b).",
        )

    def __float__(self) -> Any:
        """Raise BuildError: the number is not known."""
        self._refuse(
            "a handle used as a plain number, as float() or the functions of math do",
            "Keep it a handle: arithmetic, switch(condition, a, b) and artgen's sin, sqrt, min_, ... "
            "take handles.",
        )

    def __round__(self, digits: int | None = None) -> Any:
        """Raise BuildError: the number is not known."""
        return self.__float__()

    __int__ = __index__ = __floor__ = __ceil__ = __float__

    def __format__(self, specification: str) -> str:
        """Raise BuildError for the format of a number, as in `f"{width:.2f}"`; else return the repr."""
        return self.__float__() if specification else repr(self)

    def __repr__(self) -> str:
        """Return the type, the operation and its place."""
        shown = f"{self.node.op} at {self.node.where}" if type(self.node) is Node else self.node
        return f"<{type(self).__name__} {shown}>"


def records(
    kernel: Callable[..., Any],
    of: Any = None,
    *,
    spelling: str = "",
    bare: Callable[[Mapping[str, Any]], Any] | None = None,
    later: Mapping[str, Callable[[Callable[[], Any]], Any]] | None = None,
) -> Callable[[C], C]:
    """Make a function without a body the constructor of an operation: a call of it records the operation.

    The name of the function is that of the operation, and its parameters are the inputs.

    Args:
        kernel: Function that computes the result from the values of the inputs; its annotations are their
            types.
        of: The type of all inputs and of the result, for a kernel without annotations such as `math.sin`.
        spelling: Python source of the operation, e.g. `({a} & {b})`; by default a call of the function.
        bare: Its value at levels of detail without print; see `Operation`.
        later: Inputs that are computed on first use at levels of detail other than `FULL`; see `Operation`.
    """

    def decorate(constructor: C) -> C:
        parameters = inspect.signature(constructor).parameters
        name = constructor.__name__
        inputs, result = types_of(kernel, name) if of is None else (dict.fromkeys(parameters, of), of)
        module = constructor.__module__
        known = Operation(
            name, kernel, inputs, result, module, spelling, constructor=name, bare=bare, later=later or {}
        )
        register(known)
        kind = Handle.HANDLES[result]
        defaults = {key: item.default for key, item in parameters.items() if item.default is not item.empty}
        several = {
            key: i for i, (key, item) in enumerate(parameters.items()) if item.kind is item.VAR_POSITIONAL
        }

        @wraps(constructor)
        def record(*arguments: Any, **keywords: Any) -> Any:
            constructor(*arguments, **keywords)  # checks the arguments like any call
            rest = {key: arguments[start:] for key, start in several.items()}
            given = dict(zip(parameters, arguments, strict=False)) | rest
            return kind(_result(kind, known, lift_all(known, {**defaults, **given, **keywords})))

        return typing.cast("C", record)

    return decorate


def _result(kind: type[Handle], known: Operation, inputs: Mapping[str, Any]) -> Any:
    """Return the node of an operation, or its result if it is computed at once."""
    found = _folded(kind, known, inputs) if _FOLDING.get() else NotImplemented
    made = Node(known.name, inputs, authors_line()) if found is NotImplemented else found
    recorded = _RECORDED.get()
    if recorded is not None and type(made) is Node:
        # a switch that is computed at once uses its other branch as well
        recorded.append(made if found is NotImplemented else Node(known.name, inputs))
    return made


def _folded(kind: type[Handle], known: Operation, inputs: Mapping[str, Any]) -> Any:
    """Return the literal of a result, or the chosen node; NotImplemented to leave it to the evaluation."""
    if known.lazy and not isinstance(inputs["condition"], Node):
        return inputs["a" if inputs["condition"] else "b"]
    if not kind.folds or not all(map(_is_literal, inputs.values())):
        return NotImplemented
    try:
        return _encoded(known.kernel(*resolved(known, inputs, {})))
    except Exception:  # noqa: BLE001 - the evaluation reports it, if it needs the result
        return NotImplemented


def _encoded(value: Any) -> Any:
    """Return the literal of a number or an array, or NotImplemented: the evaluation refuses infinite ones."""
    if isinstance(value, np.ndarray):
        rows = value.tolist()
        literal = tuple(rows) if value.ndim == 1 else tuple(map(tuple, rows))
        return literal if np.isfinite(value).all() else NotImplemented
    return value if type(value) is bool or (type(value) is float and math.isfinite(value)) else NotImplemented


def _is_literal(value: Any) -> bool:
    kind = type(value)
    return kind is not Node and (kind is not tuple or all(map(_is_literal, value)))


@dataclass(frozen=True)
class LiteralType:
    """A Python class whose instances are literals of nodes.

    Attributes:
        tag: Key of the data, as in `{"$material": {...}}`.
        encode: Function from an instance to its data.
        decode: Function from data to the instance.
    """

    tag: str
    encode: Callable[[Any], Any]
    decode: Callable[[Any], Any]


LITERAL_TYPES: dict[type, LiteralType] = {}
"""Literal classes in addition to numbers and strings; instances are hashable."""


@lru_cache(maxsize=4096)
def _literal(kind: type, value: Any) -> Data:
    """Return the data of an instance of a literal type: the same object for equal instances."""
    known = LITERAL_TYPES[kind]
    return Data({"$" + known.tag: known.encode(value)}, value)


def lift_all(known: Operation, inputs: Mapping[str, Any]) -> dict[str, Any]:
    """Convert an author's values to the inputs of a node of an operation."""
    lifted = {}
    for name, hint, lifters in _lifters_of(known):
        if name not in inputs:
            _refuse_inputs(known, inputs)
        lifted[name] = _lifted(inputs[name], lifters, hint, known.name, name)
    if len(lifted) != len(inputs):
        _refuse_inputs(known, inputs)
    return lifted


def lift(value: Any, hint: Any, what: str) -> Any:
    """Convert an author's value to a node or literal of the type that a kernel expects."""
    return _lifted(value, _lifters(hint), hint, "", what)


def check_options(function: Callable[..., Any], arguments: Mapping[str, Any]) -> None:
    """Check the arguments of a function whose types are literals, as operations do.

    Raises:
        BuildError: An argument is not one of the literals.
    """
    for name, hint in _options(function).items():
        if name in arguments:
            lift(arguments[name], hint, f"{function.__name__}(..., {name}=...)")


@cache
def _options(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the types of the parameters that take literals."""
    hints = typing.get_type_hints(function)
    return {
        name: hint
        for name, hint in hints.items()
        if any(typing.get_origin(option) is typing.Literal for option in alternatives(hint))
    }


_LONGEST = 100  # characters of a value in a message
_REMEDIES = {  # by the expected type
    "a Vector": "; write X, Y, Z or three numbers",
    "a Points": "; write at least one point of three numbers, as in [(0, 0, 0)]",
    "a Dependency or None": "; write a comparison of a joint, as in hinge > 0.6",
}

Lifter = Callable[[Any, str], Any]


def _lifted(value: Any, lifters: tuple[Lifter, ...], hint: Any, operation: str, what: str) -> Any:
    for lifter in lifters:
        found = lifter(value, what)
        if found is not NotImplemented:
            return found
    return _refuse_value(value, hint, f"{operation}(..., {what}=...)" if operation else what)


@cache
def _lifters_of(known: Operation) -> tuple[tuple[str, Any, tuple[Lifter, ...]], ...]:
    """Return name, type and lifters of the inputs of an operation, in order."""
    return tuple((name, hint, _lifters(hint, known.name)) for name, hint in known.inputs.items())


@cache
def _lifters(hint: Any, operation: str = "") -> tuple[Lifter, ...]:
    return tuple(_lifter(option, operation) for option in alternatives(hint))


def _lifter(hint: Any, operation: str) -> Lifter:
    """Return a function that lifts an author's value to a node or literal of a type, or to NotImplemented."""
    # its arguments are the value and the name of the input; errors about members of tuples name that input
    if hint is NoneType:
        return lambda value, what: None if value is None else NotImplemented
    if hint in Handle.HANDLES:
        lifted = Handle.HANDLES[hint].lift
        return lambda value, what: lifted(value)
    origin, members = typing.get_origin(hint), typing.get_args(hint)
    if origin is tuple:
        several = len(members) == 2 and members[1] is Ellipsis
        members = members[:1] if several else members
        each = [(_lifters(member, operation), member, operation) for member in members]
        return lambda value, what: _lift_tuple(value, each, what, several=several)
    if origin is typing.Literal:
        return lambda value, what: _option(value, members)
    return lambda value, what: _lift_literal(value, hint)


def _refuse_inputs(known: Operation, inputs: Mapping[str, Any]) -> NoReturn:
    for name in inputs:
        if name not in known.inputs:
            raise BuildError(
                f"{known.name} has no input {name!r}.{nearest(name, known.inputs)}\n  at {authors_line()}"
            )
    missing = next(name for name in known.inputs if name not in inputs)
    raise BuildError(f"{known.name} needs the input {missing!r}\n  at {authors_line()}")


def _refuse_value(value: Any, hint: Any, what: str) -> NoReturn:
    infinite = _not_finite(value)
    if infinite is not None:
        raise BuildError(
            f"{what}: {infinite} is not a finite number; give a finite one\n  at {authors_line()}"
        )
    expected = " or ".join(_name(option) for option in alternatives(hint))
    shown = f"a {type(value).__name__} handle" if isinstance(value, Handle) else repr(value)
    if len(shown) > _LONGEST:
        shown = f"a {type(value).__name__}"
    remedy = _remedy(value, hint, expected)
    raise BuildError(f"{what} needs {expected}, got {shown}{remedy}\n  at {authors_line()}")


def _not_finite(value: Any) -> float | None:
    """Return the first number in a value that is infinite or not a number."""
    if is_sequence(value):
        return next((found for item in value if (found := _not_finite(item)) is not None), None)
    return float(value) if isinstance(value, float | np.floating) and not np.isfinite(value) else None


def _remedy(value: Any, hint: Any, expected: str) -> str:
    """Return what to write in place of a value that is often given for that type; empty for others."""
    if isinstance(value, Handle):
        if hint in (int, str, bool):
            return "; it must be known while building: annotate the parameter int, str, bool or Literal"
        return _REMEDIES.get(expected, "") if expected.startswith("a Dependency") else ""
    if isinstance(value, str) and expected == "a Material":
        return f"; write material({value!r})"
    if expected.startswith("2 values") and isinstance(value, float | int):
        return f"; write the lower and the upper one: (0, {value})"
    return _REMEDIES.get(expected, "")


def _option(value: Any, options: tuple[Any, ...]) -> Any:
    matching = (item for item in options if type(item) is type(value) and item == value)
    return next(matching, NotImplemented)


def _lift_literal(value: Any, hint: Any) -> Any:
    if isinstance(value, Handle):
        return NotImplemented
    if hint in LITERAL_TYPES and isinstance(value, hint):
        return _literal(hint, value)
    if hint is int and isinstance(value, (int, np.integer)) and not isinstance(value, bool):
        return int(value)
    if hint is str and isinstance(value, str):
        return str(value)
    return NotImplemented


def is_sequence(value: Any) -> bool:
    """Tell whether a value is a sequence of values; strings and handles are single values."""
    kind = type(value)
    if kind is tuple or kind is list:
        return True
    return isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, (Handle, str))


def _lift_tuple(
    value: Any, members: list[tuple[tuple[Lifter, ...], Any, str]], what: str, *, several: bool
) -> Any:
    if several and isinstance(value, Handle):
        value = (value,)
    if not is_sequence(value):
        return NotImplemented
    if several:
        return tuple([_lifted(item, *members[0], what) for item in value])
    if len(value) != len(members):
        return NotImplemented
    return tuple([_lifted(item, *member, what) for item, member in zip(value, members, strict=True)])


def _name(hint: Any) -> str:
    """Format a kernel's type in the terms of authors."""
    if hint is NoneType:
        return "None"
    if hint in Handle.HANDLES:
        return f"a {Handle.HANDLES[hint].__name__}"
    origin = typing.get_origin(hint)
    if origin is tuple:
        members = typing.get_args(hint)
        if len(members) == 2 and members[1] is Ellipsis:
            return f"a sequence of {_name(members[0]).removeprefix('a ')}"
        return f"{len(members)} values of {_name(members[0]).removeprefix('a ')}"
    if origin is typing.Literal:
        return "one of " + ", ".join(map(repr, typing.get_args(hint)))
    return f"an {hint.__name__}" if hint is int else f"a {hint.__name__}"


Resolver = Callable[[Any, Mapping[str, Any]], Any]


def resolved(known: Operation, inputs: Mapping[str, Any], values: Mapping[str, Any]) -> list[Any]:
    """Return the inputs of an operation with values in place of nodes, and with decoded literals."""
    return [resolver(inputs[name], values) for name, resolver in _resolvers_of(known)]


@cache
def _resolvers_of(known: Operation) -> tuple[tuple[str, Resolver], ...]:
    return tuple((name, _resolver(hint)) for name, hint in known.inputs.items())


@cache
def _resolver(hint: Any) -> Resolver:
    """Return a function that replaces nodes in a value of a type by their values, and decodes literals."""
    tuples = [typing.get_args(each) for each in alternatives(hint) if typing.get_origin(each) is tuple]
    members = [_resolver(member) for member in (tuples[0] if tuples else ()) if member is not Ellipsis]
    several = bool(tuples) and tuples[0][-1] is Ellipsis
    decoders = _decoders(hint)

    def resolve(value: Any, values: Mapping[str, Any]) -> Any:
        kind = type(value)
        if kind is Node:
            return values[value.key]
        if kind is float and hint is float:
            return value  # literals of numbers are their own values
        if kind is tuple and tuples:
            if several:
                return tuple([members[0](item, values) for item in value])
            return tuple([member(item, values) for member, item in zip(members, value, strict=True)])
        return _decoded(value, decoders)

    return resolve


Decoders = tuple[tuple[Callable[[Any], bool], Callable[[Any], Any]], ...]


def decode(value: Any, hint: Any) -> Any:
    """Convert the literal of a node's input to the value for its kernel."""
    return _decoded(value, _decoders(hint))


def _decoded(value: Any, decoders: Decoders) -> Any:
    if type(value) is Data:
        return value.value
    for applies, decoded in decoders:
        if applies(value):
            return decoded(value)
    return value


@cache
def _decoders(hint: Any) -> Decoders:
    """Return for a type the predicates of literals that need decoding, with their decoders."""
    found: list[tuple[Callable[[Any], bool], Callable[[Any], Any]]] = []
    for option in alternatives(hint):
        if option in Handle.HANDLES:
            found.append((lambda value: value is not None, Handle.HANDLES[option].decode))
        elif typing.get_origin(option) is tuple:
            members = typing.get_args(option)
            found.append((lambda value: isinstance(value, tuple), partial(_decode_tuple, members)))
        elif option in LITERAL_TYPES:
            found.append((lambda value: isinstance(value, dict), partial(_decode_literal, option)))
    return tuple(found)


def _decode_tuple(members: tuple[Any, ...], value: tuple[Any, ...]) -> tuple[Any, ...]:
    if len(members) == 2 and members[1] is Ellipsis:
        return tuple(decode(item, members[0]) for item in value)
    return tuple(decode(item, member) for item, member in zip(value, members, strict=True))


def _decode_literal(kind: type, value: Mapping[str, Any]) -> Any:
    known = LITERAL_TYPES[kind]
    return known.decode(value["$" + known.tag])


def handle_type(name: str) -> type[Handle]:
    """Return the handle class of an existing name."""
    return next(handle for handle in Handle.HANDLES.values() if handle.__name__ == name)


def handle_of(node: Node) -> Handle:
    """Return a node as a handle of its result's type."""
    if node.op == PARAMETER:
        return handle_type(node.inputs["kind"])(node)
    known: Operation = operation(node.op)
    return Handle.HANDLES[known.result](node)
