"""Contacts by design: pieces that may touch or press into each other, such as a gasket and its frame."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from artgen.asset.joint import AssetCondition
from artgen.asset.record import Record


@dataclass(frozen=True)
class AllowedContact(Record):
    """Two kinds of pieces on two links that may touch.

    Attributes:
        links: Names of the two links, the declared order kept.
        labels: Label of the pieces on the first and on the second link.
        depth: How far the pieces may press into each other [m].
        reason: Why they do, as the author says.
        when: The region of joint space in which they may; everywhere if None.
    """

    links: tuple[str, str]
    labels: tuple[str, str]
    depth: float
    reason: str
    when: AssetCondition | None = None

    def renamed(self, links: Mapping[str, str], joints: Mapping[str, str]) -> "AllowedContact":
        """Return the contact with links and joints renamed; names not in the mappings stay."""
        first, second = (links.get(name, name) for name in self.links)
        when = None if self.when is None else self.when.renamed(joints)
        return replace(self, links=(first, second), when=when)

    def __str__(self) -> str:
        """Tell which pieces may touch, how deep, where and why."""
        (a, b), (first, second) = self.links, self.labels
        where = "" if self.when is None else f" where {self.when}"
        return f"{a}/{first} may press {1e3 * self.depth:.3g} mm into {b}/{second}{where}: {self.reason}"

    def to_data(self) -> dict[str, Any]:
        """Return the contact as JSON data, the reason last."""
        return dict.fromkeys(("links", "labels", "depth", "when")) | super().to_data()
