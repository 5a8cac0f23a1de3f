"""Overrides as text, such as `handle_height=1.05` or `width=uniform(0.8, 0.9)`.

The text is data and is never executed.
"""

import ast
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from artgen.errors import ParameterError, nearest
from artgen.sampling import choice, count, loguniform, truncated_normal, uniform

DISTRIBUTIONS: Mapping[str, Callable[..., Any]] = {
    "choice": choice,
    "count": count,
    "loguniform": loguniform,
    "truncated_normal": truncated_normal,
    "uniform": uniform,
}
"""Distributions that text may use, by name."""

_EXAMPLES = {
    "choice": "choice(left, right)",
    "count": "count(2, 5)",
    "loguniform": "loguniform(0.1, 1.0)",
    "truncated_normal": "truncated_normal(0.9, 0.05, 0.8, 1.0)",
    "uniform": "uniform(0.8, 0.9)",
}
_WORDS = {"true": True, "false": False}


def parse_overrides(texts: Iterable[str]) -> dict[str, Any]:
    """Parse overrides of the form `NAME=VALUE`."""
    result: dict[str, Any] = {}
    for text in texts:
        name, equals, value = (piece.strip() for piece in text.partition("="))
        if not (name and equals and value):
            raise ParameterError(f"{text!r} is no override; write NAME=VALUE, such as width=0.9")
        name = name.replace("__", ".")
        if name in result:
            raise ParameterError(f"{name} is set twice; leave one of them out")
        result[name] = parse_value(value, name)
    return result


def overrides_of(category: str, texts: Iterable[str], categories: Sequence[str]) -> dict[str, Any]:
    """Parse the overrides for one of several categories: `NAME=VALUE`, or its own `CATEGORY:NAME=VALUE`."""
    common, own = [], []
    for text in texts:
        before, colon, after = text.partition(":")
        if not colon or "=" in before:
            common.append(text)
        elif before.strip() == category:
            own.append(after)
        elif before.strip() not in categories:
            raise ParameterError(
                f"the override {text!r} is for {before.strip()!r}, which is not in the plan; its "
                f"categories are {', '.join(categories)}"
            )
    return parse_overrides(common) | parse_overrides(own)


def parse_value(text: str, name: str = "value") -> Any:
    """Parse a number, True or False, a string (quoted or not), or a distribution."""
    try:
        tree = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        made = text.partition("(")[0].strip()
        if made not in DISTRIBUTIONS or made == text:
            return text
        comma = "a comma is missing" if "comma" in str(error) else "it is not complete"
        raise ParameterError(
            f"{name} = {text} cannot be read: {comma}; write for example {_EXAMPLES[made]}"
        ) from None
    if isinstance(tree, ast.Call):
        return _distribution(tree, text, name)
    try:
        return _literal(tree)
    except ValueError:
        return text


def spelled(overrides: Mapping[str, Any]) -> list[str]:
    """Format values as `NAME=VALUE`, so that `parse_overrides` returns the same values."""
    return [f"{name}={_spelled(value)}" for name, value in overrides.items()]


def _spelled(value: Any) -> str:
    """Format a value; a string needs no quotes if it is read as the same string without them."""
    if not isinstance(value, str) or not value or value != value.strip():
        return repr(value)
    try:
        return value if parse_value(value) == value else repr(value)
    except ParameterError:  # it looks like a distribution
        return repr(value)


def _literal(tree: ast.expr) -> Any:
    """Return the value of a literal; a bare word is a string."""
    if isinstance(tree, ast.Name):
        return _WORDS.get(tree.id, tree.id)
    try:
        return ast.literal_eval(tree)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        raise ValueError(f"{ast.unparse(tree)} is neither a number nor a word") from None


def _distribution(call: ast.Call, text: str, name: str) -> Any:
    made = call.func.id if isinstance(call.func, ast.Name) else ast.unparse(call.func)
    if made not in DISTRIBUTIONS:
        raise ParameterError(f"{name}: there is no distribution {made!r}.{nearest(made, DISTRIBUTIONS)}")
    try:
        arguments = [_literal(argument) for argument in call.args]
        keywords = {keyword.arg or "**": _literal(keyword.value) for keyword in call.keywords}
        return DISTRIBUTIONS[made](*arguments, **keywords)
    except ParameterError as error:
        raise ParameterError(f"{name}: {error}") from None
    except (TypeError, ValueError) as error:
        raise ParameterError(f"{name} = {text} cannot be read: {error}") from None
