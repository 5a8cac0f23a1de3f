"""Files that a foreign file names, XML and numbers: what is found, and what is refused."""

import os

import pytest

from artgen.errors import AssetError
from artgen.referee import files
from artgen.referee.files import line_of, numbers, offset_of, parse_xml, safe_path, shown, similar


@pytest.fixture
def package(tmp_path):
    """A package with a mesh, and the folder of its URDF."""
    for place in ("robot/meshes", "robot/urdf", "other/meshes"):
        (tmp_path / place).mkdir(parents=True)
        (tmp_path / place / "a.stl").write_bytes(b"solid")
    return tmp_path, tmp_path / "robot" / "urdf"


def test_a_path_is_relative_to_the_folder(package):
    root, folder = package
    mesh = (root / "robot/meshes/a.stl").resolve()
    assert safe_path("../meshes/a.stl", folder, root, "x") == mesh
    assert safe_path(" a.stl ", folder, root, "x") == folder.resolve() / "a.stl"
    assert safe_path(f"file://{mesh}", folder, root, "x") == mesh
    assert safe_path("file://../meshes/a%2Estl", folder, root, "x") == mesh


def test_a_package_is_a_folder_above_or_beside(package):
    root, folder = package
    mesh = (root / "robot/meshes/a.stl").resolve()
    assert safe_path("package://robot/meshes/a.stl", folder, root, "x") == mesh
    assert safe_path("model://other/meshes/a.stl", folder, root, "x") == root.resolve() / "other/meshes/a.stl"
    # without its folder, the rest of the path counts
    assert safe_path("package://renamed/meshes/a.stl", folder, root / "robot", "x") == mesh
    with pytest.raises(AssetError, match=r"in no folder from .* up to .*; give --root DIR"):
        safe_path("package://other/b.stl", folder, root, "x")


@pytest.mark.parametrize(
    "name",
    [
        "../../other/meshes/a.stl",
        "/etc/passwd",
        "file:///etc/passwd",
        "package://robot//etc/passwd",
        "package://robot/../../../../../../../../etc/passwd",
        "link.stl",
        "up/other/meshes/a.stl",
    ],
)
def test_a_file_outside_the_root_is_refused(package, name):
    root, folder = package
    (folder / "link.stl").symlink_to("/etc/passwd")
    (folder / "up").symlink_to(root)
    with pytest.raises(AssetError, match=r"the mesh is '.*', which is outside .*give --root DIR to allow it"):
        safe_path(name, folder, root / "robot", "the mesh")


def test_what_is_no_regular_file_is_refused(package, monkeypatch):
    root, folder = package
    os.mkfifo(folder / "pipe.stl")
    (folder / "circle").symlink_to("circle")
    for name, fault in (
        ("pipe.stl", "is no regular file"),
        ("..", "is no regular file"),
        ("none.stl", "does not exist"),
        ("a\0.stl", "no path of a file"),
        ("x" * 5000, r"'x+\.\.\.', which is no path"),
        ("circle/a.stl", "no path of a file|does not exist"),
        ("http://example.org/a.stl", "give a path, or a URI file://"),
    ):
        with pytest.raises(AssetError, match=fault) as caught:
            safe_path(name, folder, root, "x")
        assert "\n" not in str(caught.value)
        assert "\0" not in str(caught.value)
    monkeypatch.setattr(files, "MOST_BYTES", 4)
    with pytest.raises(AssetError, match="has 5 bytes; at most 4 are read"):
        safe_path("a.stl", folder, root, "x")


def test_elements_know_their_places(tmp_path):
    path = tmp_path / "a.xml"
    path.write_bytes(b"<a>\n <!-- <b/> -->\n  <x:b c='1'>text</x:b></a>")
    root = parse_xml(path)
    (child,) = root
    assert (child.tag, child.get("c"), child.text) == ("x:b", "1", "text")
    assert (line_of(root), line_of(child)) == (1, 3)
    assert path.read_bytes()[offset_of(child) :].startswith(b"<x:b c")


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (b"<!DOCTYPE a><a/>", "line 1: it declares a document type"),
        (b"<!DOCTYPE a SYSTEM 'file:///etc/passwd'><a/>", "remove <!DOCTYPE"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>".encode("utf-16"), "it declares a document type"),
        (b"<a>\n<b></a>", "line 2: it is not well-formed XML .mismatched tag"),
        (b"<a>&b;</a>", "undefined entity"),
        (b"", "no element found"),
        (b"\0\1\2", "not well-formed"),
        (b"<?xml version='1.0' encoding='rot13'?><a/>", "save it as UTF-8|not well-formed"),
        (b"<a>" * 201, "more than 200 elements are nested"),
    ],
)
def test_harmful_xml_is_refused(tmp_path, data, fault):
    path = tmp_path / "a.xml"
    path.write_bytes(data)
    with pytest.raises(AssetError, match=fault) as caught:
        parse_xml(path)
    assert str(caught.value).startswith("a.xml, line ")


def test_too_many_elements_are_refused(tmp_path, monkeypatch):
    path = tmp_path / "a.xml"
    path.write_bytes(b"<a>" + b"<b/>" * 10 + b"</a>")
    monkeypatch.setattr(files, "MOST_ELEMENTS", 10)
    with pytest.raises(AssetError, match="more than 10 elements"):
        parse_xml(path)


def test_numbers():
    assert numbers(" 1\n-2e3 ", 2, "x") == (1.0, -2000.0)
    for text in ("1 2 3", "1", "1 a", "1 nan", "1 inf", "1 1_0", ""):
        with pytest.raises(AssetError, match=r"xyz of 'a' is '.*'; give 2 finite numbers"):
            numbers(text, 2, "xyz of 'a'")
    with pytest.raises(AssetError, match="give 1 finite number from -5 to 5"):
        numbers("-6", 1, "x", 5)


def test_texts_in_messages_are_short_and_in_one_line():
    assert shown("a\nb") == r"'a\nb'"
    assert len(shown("x" * 1000)) == 82
    assert similar("arn", ["arm", "a\nrn", "x" * 1000]) == " Did you mean 'arm'?"


def test_a_file_deep_in_a_package_may_read_its_package_only(tmp_path):
    package = tmp_path / "robots" / "arm"
    folder = package / "a" / "b" / "c"
    folder.mkdir(parents=True)
    mesh = package / "link.stl"
    mesh.write_text("solid")
    (tmp_path / "robots" / "other.stl").write_text("solid")
    assert safe_path("package://arm/link.stl", folder, folder, "the mesh") == mesh.resolve()
    with pytest.raises(AssetError, match="outside"):
        safe_path("package://arm/../other.stl", folder, folder, "the mesh")
