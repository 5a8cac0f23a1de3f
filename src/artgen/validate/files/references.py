"""The files that exported files name: relative, within the export, of the same letters, and listed."""

import posixpath
import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath
from typing import Any

from artgen.asset.files import ASSET_FILE
from artgen.asset.report import Finding
from artgen.errors import nearest

_HINT = "name files by their path relative to the file that names them; or export the asset again"
_FOLDERS = {
    "mesh": "meshdir", "hfield": "meshdir", "skin": "meshdir", "texture": "texturedir", "layer": "texturedir"
}  # fmt: skip


def reference_findings(
    contents: Mapping[str, bytes], formats: Mapping[str, tuple[str, ...]]
) -> Iterator[Finding]:
    """Yield the paths in exported files that clients do not find, or find only on this machine.

    Args:
        contents: The content of each file that can be read.
        formats: The files of each format.
    """
    listed = {path for files in formats.values() for path in files}
    for path, content in contents.items():
        readers = {".urdf": _urdf, ".xml": _mjcf, ".usda": _usd, ".mtl": _library, ".obj": _mesh}
        read = readers.get(PurePosixPath(path).suffix.lower())
        if read is None:
            continue
        folder = posixpath.dirname(path)
        for word, name, found in dict.fromkeys(read(folder, content)):
            if found not in listed:
                yield _finding(path, word, name, listed)
    yield from _material_findings(contents)


def _finding(path: str, word: str, name: str, listed: set[str]) -> Finding:
    if name.startswith("/") or re.match(r"[A-Za-z]:[\\/]|\w+://", name):
        message = f"{path} names the {word} {name}, a path that other machines do not have"
    elif ".." in name.split("/"):
        message = f"{path} names the {word} {name}, through a folder above, which some clients do not follow"
    else:
        near = nearest(posixpath.basename(name), {posixpath.basename(each) for each in listed})
        message = f"{path} names the {word} {name}, which is listed by no format of {ASSET_FILE}.{near}"
    return Finding("files", message, hint=_HINT)


def _urdf(folder: str, content: bytes) -> Iterator[tuple[str, str, str]]:
    for element in _xml(content, "mesh", "texture"):
        name = element.get("filename", "")
        yield element.tag, name, posixpath.join(folder, name)


def _mjcf(folder: str, content: bytes) -> Iterator[tuple[str, str, str]]:
    compilers = _xml(content, "compiler")
    folders = {key: value for element in compilers for key, value in element.items()}
    for element in _xml(content, *_FOLDERS, "include", "model"):
        if "file" in element.keys():  # noqa: SIM118 - an element of lxml contains its children
            inner = _FOLDERS.get(element.tag, "")
            inner = folders.get(inner, folders.get("assetdir", "")) if inner else ""
            name = element.get("file")
            yield element.tag, name, posixpath.join(folder, inner, name)


def _xml(content: bytes, *tags: str) -> list[Any]:
    from lxml import etree

    try:
        return list(etree.fromstring(content).iter(*tags))
    except etree.XMLSyntaxError:
        return []  # the check of the format tells


def _usd(folder: str, content: bytes) -> Iterator[tuple[str, str, str]]:
    for name in re.findall(r"@([^@\n]+)@", content.decode("utf-8", "replace")):
        if "/" not in name and name.endswith(".mdl"):
            continue  # a module that the renderer brings along
        yield "file", name, posixpath.normpath(posixpath.join(folder, name))


def _library(folder: str, content: bytes) -> Iterator[tuple[str, str, str]]:
    """Yield the maps of a library of materials; readers leave out silently what they do not find."""
    for line in content.decode("utf-8", "replace").splitlines():
        words = line.split(maxsplit=1)
        if len(words) == 2 and words[0].startswith(("map_", "norm")):
            yield "map", words[1], posixpath.join(folder, words[1])


def _mesh(folder: str, content: bytes) -> Iterator[tuple[str, str, str]]:
    for name in re.findall(rb"^mtllib (.+?)\s*$", content, re.MULTILINE):
        text = name.decode("utf-8", "replace")
        yield "library", text, posixpath.join(folder, text)


def _material_findings(contents: Mapping[str, bytes]) -> Iterator[Finding]:
    """Yield meshes of a material that their library does not have: they are drawn grey."""
    known: dict[str, set[bytes]] = {}
    for path, content in contents.items():
        if path.endswith(".mtl"):
            known[path] = set(re.findall(rb"^newmtl (.+?)\s*$", content, re.MULTILINE))
    for path, content in contents.items():
        if not path.endswith(".obj"):
            continue
        libraries = [posixpath.join(posixpath.dirname(path), name) for _, name, _ in _mesh("", content)]
        if not libraries or any(library not in known for library in libraries):
            continue
        there = set().union(*(known[library] for library in libraries))
        for name in sorted(set(re.findall(rb"^usemtl (.+?)\s*$", content, re.MULTILINE)) - there):
            message = (
                f"{path} is of the material {name.decode('utf-8', 'replace')}, which {libraries[0]} lacks"
            )
            yield Finding("files", message, hint="export the asset again")
