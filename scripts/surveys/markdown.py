"""Text in tables of Markdown."""


def escaped(text: str) -> str:
    """Return text for a cell of a table: on one line, its bars and what looks like a link escaped."""
    return text.replace("|", r"\|").replace("[", r"\[").replace("\n", " ")
