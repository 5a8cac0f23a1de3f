"""Which of the labels of categories have masks, and what they are called."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from artgen.catalog import find
from artgen.errors import ParameterError, nearest


@dataclass(frozen=True)
class Vocabulary:
    """The parts that have masks."""

    # what each label of each category is called; those without a mask are not in it
    names: Mapping[str, Mapping[str, str]]

    @staticmethod
    def of(categories: Sequence[str], texts: Sequence[str]) -> "Vocabulary":
        """Read which labels have masks; all of them if no text says otherwise."""
        known = {name: find(name).labels for name in categories}
        if not texts:
            return Vocabulary({name: {label: label for label in labels} for name, labels in known.items()})
        found: dict[str, dict[str, str]] = {name: {} for name in categories}
        for text in texts:
            owner, colon, rest = text.partition(":")
            if colon and owner.strip() not in known:
                raise ParameterError(f"the label {text!r} is of {owner!r}, of which there are no images")
            owners = [owner.strip()] if colon else list(categories)
            new, equals, old = (rest if colon else text).partition("=")
            for label in (old if equals else new).split("+"):
                _add(found, known, owners, label.strip(), new.strip())
        return Vocabulary(found)

    def categories(self) -> list[dict[str, Any]]:
        """Return the categories of COCO: one for each part of each category, numbered from 1."""
        parts = [
            (owner, name) for owner, names in self.names.items() for name in dict.fromkeys(names.values())
        ]
        return [
            {"id": number, "name": name, "supercategory": owner}
            for number, (owner, name) in enumerate(parts, start=1)
        ]

    def ids(self) -> dict[tuple[str, str], int]:
        """Return the number of each part: the key is the category and what the part is called."""
        return {(each["supercategory"], each["name"]): each["id"] for each in self.categories()}


def _add(
    found: dict[str, dict[str, str]],
    known: Mapping[str, Sequence[str]],
    owners: Sequence[str],
    label: str,
    name: str,
) -> None:
    """Note what a label is called in the categories that have it."""
    having = [owner for owner in owners if label in known[owner]]
    if not having or not name:
        allowed = [each for owner in owners for each in known[owner]]
        raise ParameterError(f"{', '.join(owners)}: there is no label {label!r}.{nearest(label, allowed)}")
    for owner in having:
        if label in found[owner]:
            raise ParameterError(f"the label {label!r} of {owner} is named twice; leave one of them out")
        found[owner][label] = name
