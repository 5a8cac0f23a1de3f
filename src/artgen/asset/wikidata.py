"""Wikidata's Q-codes of the categories, by which datasets of many makers know the same thing."""

THING = "Q223557"
"""A physical object: what every asset is whose category has no code here."""

CATEGORY_CODES = {
    "box": "Q188075",
    "dishwasher": "Q186263",
    "door": "Q36794",
    "lamp": "Q1138737",
    "microwave": "Q127956",
    "oven": "Q36539",
    "refrigerator": "Q37828",
    "toaster": "Q14890",
    "trashcan": "Q216530",  # Wikidata says waste container
    "window": "Q35473",
}
"""Codes by name of the category; a code stands here only if somebody has looked it up."""


def category_code(category: str) -> str:
    """Return the Q-code of a category; that of a physical object if it has none of its own."""
    return CATEGORY_CODES.get(category, THING)
