"""Files that others made: names of further files, XML and numbers, with one clear error for each fault."""

import math
import stat
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, NoReturn, cast
from urllib.parse import unquote
from xml.parsers import expat

from artgen.dataset.workers import run_tasks
from artgen.errors import AssetError, nearest
from artgen.referee.model import MOST_BYTES

MOST_ELEMENTS = 1_000_000  # of an XML file
MOST_DEPTH = 200  # of nested elements
MOST_LENGTH = 1e6  # largest coordinate or length; larger ones lose their decimals [m]

_MOST_SECONDS = 120.0  # time for a library that reads a file [s]
_MOST_MEMORY = 16 << 30  # memory for it [bytes]
_MOST_SHOWN = 80  # characters of a text in a message


class Element(ET.Element):
    """An XML element that knows its place."""

    line = 0
    offset = 0  # of its start tag in the file [bytes]


def line_of(element: ET.Element) -> int:
    """Return the line of an element from `parse_xml`."""
    return cast("Element", element).line


def offset_of(element: ET.Element) -> int:
    """Return the offset of an element's start tag in its file [bytes]."""
    return cast("Element", element).offset


def shown(text: str) -> str:
    """Return a text of the file for a message: quoted, in one line, shortened."""
    return repr(text if len(text) <= _MOST_SHOWN else f"{text[: _MOST_SHOWN - 3]}...")


def similar(name: str, allowed: Iterable[str]) -> str:
    """Return `nearest` for names of the file, without those that are long or would break the line."""
    short = [each for each in allowed if len(each) <= _MOST_SHOWN and each.isprintable()]
    return nearest(name[:_MOST_SHOWN], short)


def safe_path(name: str, folder: Path, root: Path, where: str) -> Path:
    """Return the file that a file names.

    `package://NAME/...` and `model://NAME/...` mean a folder NAME among the folders from `folder` up to
    `root` and those in them; without such a folder, the rest of the path is relative to one of them. A file
    in a package, however deep, may read all of that package.

    Args:
        name: The name in the file: a path relative to `folder`, or a URI file://, package:// or model://.
        folder: Folder of the file.
        root: Folder that contains all files that may be read.
        where: The place of the name, for messages, such as `the mesh of link 'door' (line 7)`.

    Raises:
        AssetError: The file does not exist, is outside `root` (after symbolic links), is no regular file, or
            is larger than MOST_BYTES.
    """
    what = f"{where} is {shown(name)}, which"
    try:
        path = _found(name.strip(), folder.resolve(), root.resolve(), what)
    except AssetError:
        raise
    except (OSError, RuntimeError, ValueError):  # too long, a circle of symbolic links, NUL
        raise AssetError(f"{what} is no path of a file; give one") from None
    check_file(path, what)
    return path


def _found(name: str, folder: Path, root: Path, what: str) -> Path:
    """Return a path below `root`; `what` begins the message."""
    scheme, mark, rest = name.partition("://")
    own: list[Path] = []  # folders of the package in which the file lies: it may read all of them
    if not mark:
        candidates = [folder / name]
    elif scheme == "file":
        candidates = [folder / unquote(rest)]
    elif scheme in ("package", "model"):
        package, _, rest = rest.partition("/")
        above = [each for each in (folder, *folder.parents) if each.is_relative_to(root)] or [folder]
        own = [each for each in folder.parents if each.name == package]
        named = own + [each for each in above if each.name == package]
        named += [each / package for each in above if package.strip(".")]
        candidates = [each / rest for each in named + above]
        if not any(each.exists() for each in candidates):
            advice = "give --root DIR, a folder that contains the package and the file"
            raise AssetError(f"{what} is in no folder from {folder} up to {root}; {advice}")
    else:
        raise AssetError(f"{what} cannot be read; give a path, or a URI file://, package:// or model://")
    for path in [each.resolve() for each in candidates if each.exists()] or [candidates[0].resolve()]:
        if any(path.is_relative_to(each) for each in (root, *own)):
            return path
    raise AssetError(f"{what} is outside {root}, from which files may be read; give --root DIR to allow it")


def read_apart(task: Callable[[Any], Any], item: Any, fault: str) -> Any:
    """Run a task of a library that may crash on bad files, in a process with limits of time and memory.

    Args:
        task: A function of a module.
        item: Its argument.
        fault: Begins the message of the error.

    Raises:
        AssetError: The task raised an exception, ended its process, or took too long.
    """
    ending = next(iter(run_tasks(partial(_limited, task), [item], jobs=1, limit=_MOST_SECONDS)))
    if ending.state != "done":
        raise AssetError(f"{fault}: {ending.reason or ending.state}")
    return ending.value


def _limited(task: Callable[[Any], Any], item: Any) -> Any:
    with suppress(ImportError, ValueError, OSError):  # not on every platform
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (_MOST_MEMORY, _MOST_MEMORY))
    return task(item)


def check_file(path: Path, what: str) -> None:
    """Raise AssetError unless a path is a regular file of at most MOST_BYTES; `what` begins the message."""
    try:
        state = path.stat()
    except OSError:
        raise AssetError(f"{what} does not exist or cannot be read; put the file there") from None
    if not stat.S_ISREG(state.st_mode):
        raise AssetError(f"{what} is no regular file; name a file")
    if state.st_size > MOST_BYTES:
        raise AssetError(f"{what} has {state.st_size} bytes; at most {MOST_BYTES} are read: reduce it")


def parse_xml(path: Path) -> Element:
    """Return the root of an XML file, whose elements know their places; prefixes of names stay.

    Raises:
        AssetError: The file cannot be read, is malformed, too large or nested too deep, or declares a
            document type or entities, which are refused before anything expands.
    """
    check_file(path, path.name)
    parser, builder = expat.ParserCreate(), ET.TreeBuilder(element_factory=cast("Any", Element))
    count = depth = 0

    def refuse(fault: str) -> NoReturn:
        raise AssetError(f"{path.name}, line {parser.CurrentLineNumber}: {fault}")

    def declaration(*_: object) -> NoReturn:
        refuse("it declares a document type or an entity, which is not read; remove <!DOCTYPE ...>")

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count, depth
        count, depth = count + 1, depth + 1
        if depth > MOST_DEPTH:
            refuse(f"more than {MOST_DEPTH} elements are nested; nest fewer")
        if count > MOST_ELEMENTS:
            refuse(f"it has more than {MOST_ELEMENTS} elements; split the file")
        element = cast("Element", builder.start(tag, attributes))
        element.line, element.offset = parser.CurrentLineNumber, parser.CurrentByteIndex

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag)

    parser.buffer_text = True
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = builder.data
    parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = declaration
    try:
        parser.Parse(path.read_bytes(), True)
        return cast("Element", builder.close())
    except AssetError:
        raise
    except expat.ExpatError as error:
        refuse(f"it is not well-formed XML ({expat.ErrorString(error.code)}); correct it")
    except (OSError, LookupError, ValueError) as error:  # an encoding that expat does not know
        refuse(f"it cannot be read ({' '.join(str(error).split())}); save it as UTF-8")


def numbers(text: str, count: int, where: str, most: float = math.inf) -> tuple[float, ...]:
    """Return the numbers in a text; `where` begins the message, such as `xyz of joint 'a' (line 3)`.

    Raises:
        AssetError: Their count is another, or one is not finite or exceeds `most`.
    """
    words = text.split()
    try:
        values = tuple(map(float, words)) if len(words) == count and "_" not in text else ()
    except ValueError:
        values = ()
    if len(values) != count or not all(math.isfinite(value) and abs(value) <= most for value in values):
        limit = "" if most == math.inf else f" from {-most:g} to {most:g}"
        kind = "1 finite number" if count == 1 else f"{count} finite numbers"
        raise AssetError(f"{where} is {shown(text)}; give {kind}{limit}")
    return values
