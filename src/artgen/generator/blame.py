"""Calls of an author's function, whose errors name the author's line."""

from collections.abc import Callable, Mapping
from typing import Any

from artgen.errors import ArtgenError, BuildError, ParameterError
from artgen.graph.node import line_in


def call_author(name: str, function: Callable[..., Any], arguments: Mapping[str, Any]) -> Any:
    """Call the function of a generator and return what it returns."""
    file = function.__code__.co_filename
    try:
        return function(**arguments)
    except ArtgenError as error:
        if isinstance(error, BuildError | ParameterError) and "\n  at " not in str(error):
            error.args = (f"{error}\n  at {line_in(file, error)}",)
        raise
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
        raise BuildError(f"{name} cannot be built: {reason}\n  at {line_in(file, error)}") from error
