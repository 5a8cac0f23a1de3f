"""Where a category comes from, and whether its file was saved since."""

from pathlib import Path

from artgen.catalog import find, is_file, load_file
from artgen.generator import Generator

_Stamp = tuple[int, int]  # time and size of a file


class CategorySource:
    """A category by name or file.

    Attributes:
        text: Name of the category, or its file, as the user gave it.
        path: The file that defines it.
        generator: The category as it was loaded last.
        revision: How often it was loaded again.
    """

    def __init__(self, text: str) -> None:
        """Load the category.

        Raises:
            ParameterError: There is no such category or file.
            BuildError: The file is faulty, or defines no category.
        """
        self.text = text
        self.generator: Generator = find(text)
        self.path = Path(self.generator.function.__code__.co_filename)
        self.revision = 0
        self._stamp = self._look()

    @property
    def reference(self) -> str:
        """What `artgen.catalog.find` finds the category by as it is now."""
        if is_file(self.text) or self.revision == 0:
            return self.text
        return f"{self.path}:{self.generator.name}"

    def saved(self) -> bool:
        """Tell, once for each time, whether the file was saved since it was looked at last."""
        stamp = self._look()
        if stamp is None or stamp == self._stamp:  # editors replace a file: for a moment there is none
            return False
        self._stamp = stamp
        return True

    def reload(self) -> None:
        """Load the category again; the one before stays where that fails.

        Raises:
            ParameterError: The file no longer defines the category.
            BuildError: The file is faulty; the message has the author's line.
        """
        text = self.text if is_file(self.text) else f"{self.path}:{self.generator.name}"
        self.generator = load_file(text)
        self.revision += 1

    def _look(self) -> _Stamp | None:
        try:
            found = self.path.stat()
        except OSError:
            return None
        return found.st_mtime_ns, found.st_size
