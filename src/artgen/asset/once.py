"""What several checks ask of a link, worked out once."""

from collections.abc import Callable
from functools import wraps
from typing import TypeVar
from weakref import WeakKeyDictionary

from artgen.asset import Link

Value = TypeVar("Value")


def once_per_link(make: Callable[[Link], Value]) -> Callable[[Link], Value]:
    """Keep what a function says of a link as long as the link is there; what it raises is not kept."""
    known: WeakKeyDictionary[Link, Value] = WeakKeyDictionary()

    @wraps(make)
    def kept(link: Link) -> Value:
        if link not in known:
            known[link] = make(link)
        return known[link]

    return kept
