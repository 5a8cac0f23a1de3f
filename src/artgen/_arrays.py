"""Array types, read-only arrays, caches that are safe for threads, and pauses of the garbage collector."""

import _imp
import gc
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import lru_cache, wraps
from importlib import import_module
from threading import Lock, RLock
from types import MappingProxyType
from typing import Annotated, Any, Generic, Self, TypeVar, overload
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray


class _OpenUSD:
    """A lock that imports OpenUSD when it is taken for the first time."""

    def __init__(self) -> None:
        self._lock, self._imported = Lock(), False

    def __enter__(self) -> None:
        self._lock.acquire()
        if not self._imported:
            with suppress(ImportError):  # the import that follows names what is missing
                _import_openusd()
            self._imported = True

    def __exit__(self, *_: object) -> None:
        self._lock.release()


def _import_openusd() -> None:
    """Import OpenUSD while no other thread opens a library."""
    # it gives up the interpreter's lock with the system's held: a thread that imports too would wait forever
    create, one_at_a_time = _imp.create_dynamic, RLock()

    def create_alone(*arguments: Any) -> Any:
        with one_at_a_time:
            return create(*arguments)

    _imp.create_dynamic = create_alone
    try:
        time.sleep(_SWITCHES)  # a thread that has just read the old function has called it then
        import_module("pxr.Usd")
    finally:
        _imp.create_dynamic = create


OPENUSD = _OpenUSD()
"""Lock around imports and calls of OpenUSD: two threads that load its plugins wait for each other forever."""

_SWITCHES = 0.05  # time in which each thread has run [s]
_MAPPINGS = (dict, MappingProxyType)
_CONTAINERS = frozenset((*_MAPPINGS, tuple, list))
_PLAIN = (str, float, int)  # first items of sequences without arrays

Value = TypeVar("Value")
Key = TypeVar("Key")


def frozen(value: Value) -> Value:
    """Return the value, with its arrays read-only, also those in tuples, lists and mappings."""
    _freeze((value,))
    return value


def _freeze(values: Iterable[Any]) -> None:
    """Make arrays read-only, also those in containers; types are compared because most values are plain."""
    for value in values:
        kind = type(value)
        if kind is np.ndarray:
            value.setflags(write=False)
        elif kind in _CONTAINERS and value:
            if kind in _MAPPINGS:
                _freeze(value.values())
            elif type(value[0]) not in _PLAIN:
                _freeze(value)


class FrozenArrays:
    """Base of dataclasses whose arrays are read-only: a caller copies an array before changing it."""

    def __post_init__(self) -> None:
        """Make the arrays of all fields read-only."""
        _freeze(vars(self).values())


class cached_property(Generic[Value]):  # noqa: N801 - the name of the field
    """A property that is computed once; threads that compute it at the same time get one value.

    It holds no lock. On Python 3.11, `functools.cached_property` locks all instances of a class while it
    computes, and threads that compute properties of each other's objects wait for each other forever.
    """

    def __init__(self, compute: Callable[[Any], Value]) -> None:
        self._compute = compute
        self.__doc__ = compute.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        """Learn the name under which an instance keeps the value."""
        self._name = name

    @overload
    def __get__(self, instance: None, owner: type | None = None) -> Self: ...

    @overload
    def __get__(self, instance: object, owner: type | None = None) -> Value: ...

    def __get__(self, instance: object | None, owner: type | None = None) -> Self | Value:
        """Return the value; after the first access it is in the instance's dictionary."""
        if instance is None:
            return self
        value: Value = vars(instance).setdefault(self._name, frozen(self._compute(instance)))
        return value


def cached(maxsize: int | None) -> Callable[[Callable[..., Value]], Callable[..., Value]]:
    """Return a decorator like `functools.lru_cache`, for functions that return arrays."""

    def decorate(compute: Callable[..., Value]) -> Callable[..., Value]:
        @lru_cache(maxsize)
        @wraps(compute)
        def remembered(*arguments: Any, **options: Any) -> Value:
            return frozen(compute(*arguments, **options))

        return remembered

    return decorate


def cached_per_object(compute: Callable[[Key], Value]) -> Callable[[Key], Value]:
    """Cache the value of a function for each argument while that object lives; exceptions are not cached."""
    known: WeakKeyDictionary[Key, Value] = WeakKeyDictionary()

    @wraps(compute)
    def remembered(key: Key) -> Value:
        try:
            return known[key]
        except KeyError:
            return known.setdefault(key, frozen(compute(key)))

    return remembered


@contextmanager
def without_collector() -> Iterator[None]:
    """Pause the search for cyclic garbage: evaluations and exports make many objects and hardly any cycles.

    A thread turns the collector on again only if it turned it off, so it never stays off after all have left.
    """
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


Array = NDArray[np.float64]
Triple = Annotated[Array, (3,)]
Matrix = Annotated[Array, (3, 3)]
Pose = Annotated[Array, (4, 4)]
Indices = NDArray[np.int64]
Mask = NDArray[np.bool_]

Kind = TypeVar("Kind", bound=np.generic)
Number = TypeVar("Number", np.float64, np.int64)


_STILL = np.eye(4)  # a call of it takes as long as three copies


def affine(linear: Array, origin: Any = (0.0, 0.0, 0.0)) -> Array:
    """Return the affine matrix, shape (4, 4), of a linear part (3, 3) and an origin (3,)."""
    matrix = _STILL.copy()
    matrix[:3, :3] = linear
    matrix[:3, 3] = origin
    return matrix


def boxes_of(groups: Sequence[Array]) -> tuple[Array, Array]:
    """Return the lowest and highest coordinates of each group of points, each shape (groups, d)."""
    starts = np.cumsum([0, *(len(points) for points in groups[:-1])])
    points = np.concatenate(groups)
    return np.minimum.reduceat(points, starts), np.maximum.reduceat(points, starts)


def successors(ring: NDArray[Kind]) -> NDArray[Kind]:
    """Return the next row for each row, cyclically, five times as fast as `np.roll`."""
    return np.concatenate((ring[1:], ring[:1]))


def predecessors(ring: NDArray[Kind]) -> NDArray[Kind]:
    """Return the previous row for each row, cyclically."""
    return np.concatenate((ring[-1:], ring[:-1]))


def distinct_rows(rows: NDArray[Number]) -> tuple[NDArray[Number], Indices, Indices]:
    """Return the distinct rows in order, like `numpy.unique` but five times as fast."""
    order = np.lexsort(rows.T[::-1])
    ordered = rows[order]
    new = np.ones(len(rows), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    number = np.empty(len(rows), np.int64)
    number[order] = np.cumsum(new) - 1
    return ordered[new], order[new], number
