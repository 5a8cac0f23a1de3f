"""The error classes of artgen.

    ArtgenError
    ├── BuildError(ValueError)          a category is written wrongly (known while building)
    │   └── GraphError                  a graph or graph file is malformed
    ├── ParameterError(ValueError)      an unknown or impossible parameter, distribution or override
    ├── EvaluationError(RuntimeError)   a kernel failed; names the author's file and line
    ├── InfeasibleError(RuntimeError)   a sample that `require` ruled out, or no sample is feasible
    ├── AssetError(ValueError)          an asset is inconsistent, or was asked for what it has not
    ├── CheckError(RuntimeError)        a check found a fault
    ├── ExportError(OSError)            files could not be written or read
    ├── ClientError(RuntimeError)       the environment of a client could not be made
    ├── EnvError(RuntimeError)          a task cannot be set up, or a package that it needs is not there
    └── RenderError(RuntimeError)       a renderer, or a library that it needs, is not there

Each also derives from a suitable builtin, so `except ValueError` works. A message has the fault, its place
(the author's file and line), the value, the allowed values or the nearest name, and the remedy.
"""

import difflib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager


class ArtgenError(Exception):
    """Base of all errors that artgen raises intentionally."""


class BuildError(ArtgenError, ValueError):
    """A category or generator has an error."""


class GraphError(BuildError):
    """A graph or its file is malformed."""


class ParameterError(ArtgenError, ValueError):
    """A parameter, distribution or override is unknown or impossible."""


class EvaluationError(ArtgenError, RuntimeError):
    """A kernel failed on its values."""


class InfeasibleError(ArtgenError, RuntimeError):
    """A sample violates a requirement of its category, or is not proven free of collisions.

    Attributes:
        pair: Names and labels of the pair that is not proven; empty for a requirement.
    """

    def __init__(self, message: str, *, pair: str = "") -> None:
        super().__init__(message)
        self.pair = pair

    @property
    def cause(self) -> str:
        """The requirement, or the first pair of links that is not proven, in one line."""
        lines = str(self).splitlines()
        return lines[1 if self.pair and len(lines) > 1 else 0].strip()


class AssetError(ArtgenError, ValueError):
    """An asset is inconsistent, or does not have a requested part.

    Attributes:
        joint: Name of the faulty joint, if any; a generator uses it to find the author's line.
        link: Name of the faulty link, if any.
    """

    def __init__(self, message: str, *, joint: str = "", link: str = "") -> None:
        super().__init__(message)
        self.joint = joint
        self.link = link


class CheckError(ArtgenError, RuntimeError):
    """A check found a fault in an asset."""


class ExportError(ArtgenError, OSError):
    """Files could not be written or read."""


class ClientError(ArtgenError, RuntimeError):
    """The environment of a client could not be created."""


class EnvError(ArtgenError, RuntimeError):
    """A manipulation task cannot be set up: the asset lacks a part, or a package is missing."""


class RenderError(ArtgenError, RuntimeError):
    """A picture could not be rendered: a renderer or one of its libraries is missing."""


_LIKE = 0.5  # likeness from which on a name is proposed


def nearest(name: object, allowed: Iterable[str]) -> str:
    """Return the allowed names, the likeliest first: ` Did you mean 'width'?` or ` Allowed: a, b.`.

    A name is also compared with each word of an option: `leather` is near to `leather_grain_abs`. Among
    equally near ones, a whole name wins: `bax` is near to `box`, not to `max_`.
    """
    options = sorted(allowed)
    words = {word.casefold(): each for each in reversed(options) for word in each.split("_")}
    words |= {each.casefold(): each for each in reversed(options)}
    near = name.casefold() if isinstance(name, str) else ""
    likeness = {
        word: difflib.SequenceMatcher(None, word, near).ratio() for word in sorted(words, reverse=True)
    }
    best = max(likeness, key=lambda word: (likeness[word], words[word].casefold() == word), default="")
    if likeness.get(best, 0.0) >= _LIKE:
        return f" Did you mean {words[best]!r}?"
    shown = ", ".join(options[:12]) + (", ..." if len(options) > 12 else "")
    return f" Allowed: {shown}." if options else ""


@contextmanager
def needed(text: str, kind: type[ArtgenError] = ExportError) -> Iterator[None]:
    """Give imports of an optional package an error that says how to install it.

    Args:
        text: The message; `{error}` in it is the error of the import.
        kind: Class of the error.
    """
    try:
        yield
    except ImportError as error:
        raise kind(text.format(error=error)) from error
