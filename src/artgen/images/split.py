"""Which assets are for training, which for validation and which for the test."""

from collections.abc import Mapping, Sequence

PARTS = ("train", "val", "test")
"""Names of the parts, and of the files that list their pictures."""


def split_of(first: int, count: int, shares: Sequence[float]) -> Mapping[int, str]:
    """Return the part of each seed: each seed in one part, the same for all categories.

    Assets of one seed share draws, such as materials, even across categories: so seeds are divided. More of
    them move none from one part to another, and of any number of them each part has its share.
    """
    taken = [0] * len(PARTS)
    found = {}
    for number in range(count):
        behind = [share * (number + 1) - had for share, had in zip(shares, taken, strict=True)]
        part = max(range(len(PARTS)), key=lambda each: round(behind[each], 9))
        taken[part] += 1
        found[first + number] = PARTS[part]
    return found
