"""Source of a category, and detection of saved changes."""

from pathlib import Path

from artgen.catalog import find, is_file, load_file
from artgen.generator import Generator

_Stamp = tuple[int, int]  # time and size of a file


class CategorySource:
    """A category by name or file.

    Attributes:
        text: Name of the category, or its file, as given by the user.
        path: The file that defines it.
        generator: The category at its last load.
        revision: Number of reloads.
    """

    def __init__(self, text: str) -> None:
        """Load the category.

        Raises:
            ParameterError: There is no such category or file.
            BuildError: The file has an error, or defines no category.
        """
        self.text = text
        self.generator: Generator = find(text)
        self.path = Path(self.generator.function.__code__.co_filename)
        self.revision = 0
        self._stamp = self._look()

    @property
    def reference(self) -> str:
        """The argument for `artgen.catalog.find` that finds the current category."""
        if is_file(self.text) or self.revision == 0:
            return self.text
        return f"{self.path}:{self.generator.name}"

    def saved(self) -> bool:
        """Tell whether the file was saved since the last call."""
        stamp = self._look()
        if stamp is None or stamp == self._stamp:  # editors replace a file: for a moment there is none
            return False
        self._stamp = stamp
        return True

    def reload(self) -> None:
        """Load the category again; on an error the previous one stays.

        Raises:
            ParameterError: The file no longer defines the category.
            BuildError: The file has an error; the message has the author's line.
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
