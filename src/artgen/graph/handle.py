"""Handles: what authors hold while a graph is built. A handle has a type and a node, but no value."""

import typing
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import NoneType
from typing import Any, ClassVar, NoReturn, Self

import numpy as np

from artgen.errors import BuildError
from artgen.graph.kernel import Operation, alternatives, operation
from artgen.graph.node import PARAMETER, Node, authors_line


class Handle:
    """A value that will be known when the graph is evaluated.

    Subclasses name the type of that value in `value_type` and say in `lift` which Python values may stand
    for it. Anything that would need the value now is refused with the two remedies.
    """

    __slots__ = ("node",)
    __array_ufunc__ = None  # numpy's numbers leave arithmetic with a handle to the handle
    value_type: ClassVar[Any] = None
    HANDLES: ClassVar[dict[Any, type["Handle"]]] = {}

    def __init__(self, node: Node) -> None:
        """Wrap a node whose operation gives this handle's type."""
        self.node = node

    def __init_subclass__(cls) -> None:
        """Make the handle known as the one for its value type."""
        if cls.value_type is not None:
            Handle.HANDLES[cls.value_type] = cls

    @classmethod
    def record(cls, kernel: Callable[..., Any] | str, **inputs: Any) -> Self:
        """Record an operation in a new node and return the handle of its result.

        Args:
            kernel: The kernel, or the name of its operation.
            **inputs: Handles, or Python values that may stand for them.

        Raises:
            BuildError: An input is of another type than the kernel's.
        """
        name = kernel if isinstance(kernel, str) else kernel.__name__.lstrip("_")
        known = operation(name)
        where = authors_line()
        lifted = {}
        for parameter, hint in known.inputs.items():
            lifted[parameter] = lift(inputs.pop(parameter), hint, f"{name}(..., {parameter}=...)", where)
        if inputs:
            raise BuildError(f"{name} has no input {next(iter(inputs))!r}\n  at {where}")
        return cls(Node(name, lifted, where))

    @classmethod
    def parameter(cls, name: str) -> Self:
        """Return the handle of a value that is drawn when an asset is generated."""
        return cls(Node(PARAMETER, {"name": name, "kind": cls.__name__}, authors_line()))

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Return the node or literal that a Python value stands for, or NotImplemented."""
        return value.node if isinstance(value, cls) else NotImplemented

    @classmethod
    def decode(cls, literal: Any) -> Any:
        """Return the value that a literal of this type stands for when kernels run."""
        return literal

    def require(self, condition: "Handle | bool", message: str) -> Self:
        """Return this value, on condition: a sample that violates the condition is drawn again."""
        return type(self).record(
            f"require_{type(self).__name__.lower()}", value=self, condition=condition, message=message
        )

    def _refuse(self, what: str, remedies: str) -> NoReturn:
        raise BuildError(
            f"{what}: a {type(self).__name__} has no value while the graph is being built\n"
            f"  at {authors_line()}, made at {self.node.where}\n  {remedies}"
        )

    def __bool__(self) -> bool:
        """Refuse: a handle is neither true nor false."""
        self._refuse(
            "a handle used as a condition",
            "Use switch(condition, a, b), or make the parameter structural (annotate it bool, int, str or "
            "Literal) so that Python's own if and for may look at it.",
        )

    def __eq__(self, other: object) -> bool:
        """Refuse: comparing handles does not compare their values."""
        self._refuse(
            "== between handles",
            "Use abs(a - b) < tolerance inside switch(...), or make the parameter structural "
            "(annotate it bool, int, str or Literal).",
        )

    def __ne__(self, other: object) -> bool:
        """Refuse: comparing handles does not compare their values."""
        return not self.__eq__(other)

    def __hash__(self) -> int:
        """Refuse: what cannot be compared is no key."""
        self._refuse("a handle as a key of a dict or member of a set", "Use its node's key: handle.node.key.")

    def __len__(self) -> int:
        """Refuse: the length is not known."""
        self._refuse(
            "len() of a handle",
            "Make the count structural (annotate it int, with count(low, high)), or use repeat and array.",
        )

    def __iter__(self) -> Any:
        """Refuse: the members are not known."""
        self._refuse(
            "iteration over a handle",
            "Use .x, .y and .z, repeat or array, or make the parameter structural (annotate it int).",
        )

    def __float__(self) -> float:
        """Refuse: the number is not known."""
        self._refuse(
            "float() of a handle",
            "Keep it a handle: arithmetic, min_, max_ and switch work on it; or make the parameter "
            "structural (annotate it int, or Literal).",
        )

    def __int__(self) -> int:
        """Refuse: the number is not known."""
        return int(self.__float__())

    def __index__(self) -> int:
        """Refuse: the number is not known."""
        return int(self.__float__())

    def __repr__(self) -> str:
        """Name the type, the operation and its place."""
        return f"<{type(self).__name__} {self.node.op} at {self.node.where}>"


@dataclass(frozen=True)
class LiteralType:
    """A Python class whose instances nodes hold as data.

    Attributes:
        tag: Marks the data, as in `{"$material": {...}}`.
        encode: Gives the data of an instance.
        decode: Gives the instance of the data.
        spell: Gives Python source of the instance.
    """

    tag: str
    encode: Callable[[Any], Any]
    decode: Callable[[Any], Any]


LITERAL_TYPES: dict[type, LiteralType] = {}
"""Classes beside numbers and strings that nodes may hold, by class."""


def lift(value: Any, hint: Any, what: str, where: str) -> Any:
    """Turn an author's value into a node or literal of the type that a kernel expects.

    Raises:
        BuildError: It is of another type; names the input and the author's line.
    """
    for option in alternatives(hint):
        lifted = _lift_one(value, option, what, where)
        if lifted is not NotImplemented:
            return lifted
    expected = " or ".join(_name(option) for option in alternatives(hint))
    shown = f"a {type(value).__name__} handle" if isinstance(value, Handle) else repr(value)
    remedy = ""
    if isinstance(value, Handle) and hint in (int, str, bool):
        remedy = "; it must be known while building: annotate the parameter int, str, bool or Literal"
    raise BuildError(f"{what} needs {expected}, got {shown}{remedy}\n  at {where}")


def _lift_one(value: Any, hint: Any, what: str, where: str) -> Any:
    if hint is NoneType:
        return None if value is None else NotImplemented
    if hint in Handle.HANDLES:
        return Handle.HANDLES[hint].lift(value)
    origin = typing.get_origin(hint)
    if origin is tuple:
        return _lift_tuple(value, typing.get_args(hint), what, where)
    if origin is typing.Literal:
        options = typing.get_args(hint)
        if isinstance(value, str | int) and value in options:
            return value
        return NotImplemented
    if isinstance(value, Handle):
        return NotImplemented
    if hint in LITERAL_TYPES and isinstance(value, hint):
        return {"$" + LITERAL_TYPES[hint].tag: LITERAL_TYPES[hint].encode(value)}
    if hint is int and isinstance(value, int | np.integer) and not isinstance(value, bool):
        return int(value)
    if hint is str and isinstance(value, str):
        return str(value)
    return NotImplemented


def _lift_tuple(value: Any, members: tuple[Any, ...], what: str, where: str) -> Any:
    if isinstance(value, Handle | str) or not isinstance(value, Sequence | np.ndarray):
        return NotImplemented
    if len(members) == 2 and members[1] is Ellipsis:
        return [lift(item, members[0], what, where) for item in value]
    if len(value) != len(members):
        return NotImplemented
    return [lift(item, member, what, where) for item, member in zip(value, members, strict=True)]


def _name(hint: Any) -> str:
    """Spell a kernel's type as authors know it."""
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


def decode(value: Any, hint: Any) -> Any:
    """Turn the literal of a node's input into the value that its kernel takes."""
    for option in alternatives(hint):
        if option in Handle.HANDLES and value is not None:
            return Handle.HANDLES[option].decode(value)
        if typing.get_origin(option) is tuple and isinstance(value, list):
            members = typing.get_args(option)
            if len(members) == 2 and members[1] is Ellipsis:
                return tuple(decode(item, members[0]) for item in value)
            return tuple(decode(item, member) for item, member in zip(value, members, strict=True))
        if option in LITERAL_TYPES and isinstance(value, dict):
            return LITERAL_TYPES[option].decode(value["$" + LITERAL_TYPES[option].tag])
    return value


def handle_of(node: Node) -> Handle:
    """Wrap a node in the handle of its result's type."""
    if node.op == PARAMETER:
        kinds = {handle.__name__: handle for handle in Handle.HANDLES.values()}
        return kinds[node.inputs["kind"]](node)
    known: Operation = operation(node.op)
    return Handle.HANDLES[known.result](node)
