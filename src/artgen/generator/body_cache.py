"""Bodies that were built lately, for who changes one value of a category after another."""

from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from artgen.generator.parameter import Parameter, Variant

_MOST = 4  # bodies that are kept


class Built:
    """Builds the graphs of a generator, and keeps the last few: no value of a socket matters to them."""

    def __init__(self, own: Mapping[str, Parameter], build: Callable[[Mapping[str, Any]], Any]) -> None:
        self._own = own
        self._build = build
        self._bodies: OrderedDict[tuple[Any, ...], Any] = OrderedDict()

    def of(self, values: Mapping[str, Any]) -> Any:
        """Return the handle of the result; raises what building raises."""
        key = tuple(_structural(self._own, values, ""))
        body = self._bodies.get(key)
        if body is None:
            self._bodies[key] = body = self._build(values)
            if len(self._bodies) > _MOST:
                self._bodies.popitem(last=False)
        return body


def _structural(
    own: Mapping[str, Parameter], values: Mapping[str, Any], prefix: str
) -> Iterator[tuple[str, Any]]:
    """Yield the structural values by name, those of the chosen sub-generators included."""
    for name, parameter in own.items():
        value = values[prefix + name]
        if parameter.structural:
            yield prefix + name, value
        if isinstance(value, Variant):
            yield from _structural(value.own, values, f"{prefix}{name}.")
