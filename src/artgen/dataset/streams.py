"""Endless assets for training, generated on demand."""

from __future__ import annotations

import logging
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from artgen.asset import Asset
from artgen.catalog import maker
from artgen.errors import EvaluationError, InfeasibleError, ParameterError
from artgen.generator.generator import checked_count
from artgen.generator.signature import RESERVED

_log = logging.getLogger("artgen")


class Stream(Iterable[Asset]):
    """Endless assets of several categories in turn, from consecutive seeds; see `stream`.

    Attributes:
        categories: Names of the categories.
        seed: The first seed.
        options: Options of `generate`, overrides included.
    """

    def __init__(self, categories: tuple[str, ...], seed: int, options: dict[str, Any]) -> None:
        self.categories, self.seed, self.options = categories, seed, options

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the stream for a worker, which creates the class again."""
        return _stream_of, (self.categories, self.seed, self.options)

    def __iter__(self) -> Iterator[Asset]:
        """Yield assets endlessly; a worker of a PyTorch DataLoader yields its share."""
        number, step = 0, 1
        if "torch" in sys.modules:
            from torch.utils.data import get_worker_info

            worker = get_worker_info()
            if worker is not None:
                number, step = worker.id, worker.num_workers
        while True:
            category = self.categories[number % len(self.categories)]
            seed = self.seed + number // len(self.categories)
            number += step
            try:
                yield maker(category).generate(seed, **self.options)
            except (InfeasibleError, EvaluationError) as error:
                _log.warning("%s %d is left out: %s", category, seed, " ".join(str(error).split()))


def stream(categories: str | Iterable[str], *, seed: int = 0, **options: Any) -> Stream:
    """Return an endless stream of assets, generated on access.

    Each iteration begins with the first seed. In a PyTorch DataLoader, each worker, forked or spawned,
    generates its share; pass `batch_size=None` or a `collate_fn`, because assets are not tensors. The stream
    is an `IterableDataset` if torch was imported before.

        loader = torch.utils.data.DataLoader(artgen.stream("door"), batch_size=None, num_workers=4)

    Args:
        categories: Name of a category or kind of room, or several names in turn.
        seed: The first seed.
        **options: Options of `artgen.generate`: values and distributions of parameters, `certify=False`, ...

    Raises:
        ParameterError: A category, the seed, an option or an override is unknown or not allowed.
    """
    names = (categories,) if isinstance(categories, str) else tuple(categories)
    if not names:
        raise ParameterError("a stream needs at least one category")
    first = checked_count("seed", seed)
    drawn = {name: value for name, value in options.items() if name not in RESERVED}
    for name in names:
        maker(name).sample(first, overrides=drawn)
    return _stream_of(names, first, options)


@cache
def _torch_stream() -> type[Stream]:
    """Return the stream class for the DataLoader of PyTorch."""
    from torch.utils.data import IterableDataset

    return type("TorchStream", (Stream, IterableDataset), {"__doc__": Stream.__doc__})


def _stream_of(*fields: Any) -> Stream:
    """Return a stream, for the DataLoader of PyTorch if torch was imported."""
    return (_torch_stream() if "torch" in sys.modules else Stream)(*fields)
