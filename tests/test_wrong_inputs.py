"""Wrong inputs end in one line that names the value and the fix: calls, drafts of categories, commands."""

import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from math import inf, nan
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

import artgen as ag
from artgen import catalog
from artgen.dataset import Plan, generate_many
from artgen.errors import ArtgenError
from artgen.generator.source import check_source
from support.exports import stand

OAK = ag.material("oak")


@pytest.fixture(scope="module")
def asset():
    """Return an asset with a drawer, whose joint is `slide`."""
    return stand.generate(certify=False)


def made(category, **overrides):
    return ag.generate(category, certify=False, **overrides)


CALLS = [
    # names
    (lambda: made("dor"), "there is no category 'dor'. Did you mean 'door'?"),
    (lambda: made("Door"), "Did you mean 'door'?"),
    (lambda: made(None), "generate takes the name of a category or a generator, got None"),
    (
        lambda: made("."),
        "'.'. . is a file or folder: give the Python file of the category, such as stapler.py",
    ),
    (lambda: made("nowhere.py"), "there is no Python file 'nowhere.py'; give the path of one"),
    (lambda: made(Path("nowhere.py")), "there is no Python file 'nowhere.py'"),
    (lambda: made("a" * 300 + ".py"), "there is no Python file 'aaa"),
    (lambda: catalog.find(3), "a category is found by its name, such as 'door', or its file, not by 3"),
    (lambda: made("door", widht=0.9), "door has no parameter 'widht'. Did you mean 'width'?"),
    (lambda: made("refrigerator", dispenser=True), "Did you mean 'water' (whether a door has a water"),
    (lambda: ag.material("grain"), "Did you mean 'leather_grain_abs'?"),
    (lambda: ag.material(None), "there is no material None. Allowed: "),
    (lambda: made("refrigerator", finish="stainles"), "Did you mean 'stainless'?"),
    (lambda: made("door", name="a b"), "name = 'a b' is no identifier; use letters, digits and _"),
    # types
    (lambda: made("door", width="0.9"), "it must be a number. Write the number alone, in m: 0.9"),
    (lambda: made("door", width=None), "width = None is not allowed: it must be a number"),
    (lambda: made("door", width=(0.85, 0.92)), "For a range, write uniform(0.85, 0.92)"),
    (lambda: made("door", width=np.array([0.9, 0.8])), "it must be a number"),
    (lambda: made("door", hand=1), "hand = 1 is not allowed: it must be one of 'left', 'right'"),
    (lambda: made("refrigerator", shelves=2.0), "shelves = 2.0 is not allowed: it must be a whole number"),
    (lambda: made("door", seed="1"), "seed must be a whole number that is not negative, got '1'"),
    (lambda: made("door", seed=True), "seed must be a whole number that is not negative, got True"),
    (lambda: made("door", seed=np.float64(1.0)), "seed must be a whole number that is not negative"),
    (lambda: made("door", attempts="3"), "attempts must be a whole number that is not negative, got '3'"),
    (lambda: made("door", cache="x"), "cache = 'x' is not allowed: it must be an artgen.graph.Cache"),
    (lambda: made("door", base="loose"), "base = 'loose' is not allowed: it must be 'fixed' or 'free'"),
    (lambda: ag.generate("door", certify="no"), "certify = 'no' is not allowed: it must be True, False or"),
    (lambda: made("door", on_collision="ignore"), "it must be one of 'redraw', 'fail', 'keep'"),
    (lambda: Plan(7, 2), "a dataset needs the names of its categories, such as ('door', 'drawer'), not 7"),
    (lambda: Plan("drawer", "2"), "count is a whole number from 1 to 1000000000, not '2'"),
    (lambda: Plan(("drawer", "drawer"), 2), "the category 'drawer' is named twice; leave one of them out"),
    (lambda: generate_many("handle", "x"), "takes a plan such as Plan('door', 100), not 'handle'"),
    (lambda: ag.box("1", 1, 1), "box(..., x=...) needs a Float, got '1'"),
    (lambda: ag.box(1, 1, 1).at([1, 2]), "translate(..., offset=...) needs a Vector, got [1, 2]"),
    (lambda: ag.box(1, 1, 1).rotate(90, ag.X), "rotate(..., axis=...) needs a Vector, got 90"),
    (lambda: ag.part(ag.box(1, 1, 1), "a", "oakk"), "part(..., material=...) needs a Material, got 'oakk'"),
    # ranges and units
    (lambda: made("door", seed=-1), "seed must be a whole number that is not negative, got -1"),
    (lambda: made("door", width=900), "0.6 to 1.25 m is allowed; 900 mm are 0.9 m"),
    (lambda: made("door", width=90), "0.6 to 1.25 m is allowed; 90 cm are 0.9 m"),
    (lambda: made("door", width=3), "width = 3 is out of range: 0.6 to 1.25 m is allowed"),
    (lambda: made("door", width=nan), "width = nan is not allowed: it must be a number"),
    (lambda: made("door", width=ag.uniform(0.92, 0.85)), "low exceeds high; swap them"),
    (lambda: made("door", width=ag.uniform(0.1, 5)), "width = uniform(0.1, 5) is out of range"),
    (lambda: ag.uniform(100, 300, "mm"), "lengths are in m, angles in rad and masses in kg; 1 mm is 0.001 m"),
    (lambda: ag.count(1, 3, unit=5), "unit = 5 is not allowed: it is text, such as 'm' or 'rad'"),
    (lambda: made("door", attempts=0), "attempts must be at least 1, got 0"),
    (lambda: ag.generate("door", tolerance=1.0), "a number of metres (not mm) that is not negative and at"),
    (lambda: made("door", limits="fulll"), "limits = 'fulll' is not allowed: it must be 'full' or 'indep"),
    (lambda: ag.prove_range("handle", 1.5), "samples must be a whole number that is not negative, got 1.5"),
]
"""Calls, with words that their messages hold."""

OF_ASSET = [
    (lambda asset, _: asset.show(textures=0).save(None), "path = None is not allowed: give a path"),
    (lambda asset, _: asset.pose({"slid": 0.1}), "has no joint 'slid'. Did you mean 'slide'?"),
    (lambda asset, _: asset.pose({"slide": 100}), "joint 'slide' cannot be at 100; its limits are 0 to 0.2"),
    (lambda asset, _: asset.pose({"slide": "open"}), "cannot be at 'open'; give a number [rad or m]"),
    (lambda asset, _: asset.pose([0.1]), "positions are a mapping such as {'slide': 0.1}, not [0.1]"),
    (lambda asset, _: asset.joints["slid"], "Did you mean 'slide'?"),
    (lambda asset, _: asset.certify(5), "tolerance must be a length of 0 to 0.1 m (metres, not mm), got 5"),
    (
        lambda asset, _: asset.certify(seconds="5"),
        "seconds must be a time limit that is not negative, got '5'",
    ),
    (lambda asset, _: asset.certify(seconds=-1), "seconds must be a time limit that is not negative, got -1"),
    (lambda asset, _: asset.with_limits("free"), "limits = 'free' is not allowed: it must be 'full' or"),
    (lambda asset, _: asset.sample_states(1.5), "must be a whole number of at least 0, got 1.5"),
    (lambda asset, _: asset.render(size="big"), "size 'big' must be one or two whole numbers in 16..4096"),
    (
        lambda asset, to: asset.export(to / "x", formats=("obj",)),
        "there is no format 'obj'. Allowed: glb, mjcf",
    ),
    (
        lambda asset, to: asset.export(to / "x", formats=3),
        "formats = 3 is not allowed: it must be a tuple of",
    ),
    (lambda asset, to: asset.export(to / "x", layout=None), "there is no layout None. Allowed: flat"),
    (lambda asset, to: asset.export(to / "x", layout=[]), "there is no layout []. Allowed: flat"),
    (lambda asset, to: asset.export(to / "x", layout="simredy"), "Did you mean 'simready'?"),
    (
        lambda asset, to: asset.export(to / "x", textures="512"),
        "textures have 256, 512, 1024, 2048 texels on",
    ),
    (lambda asset, to: asset.export(to / "x", mesh_precision="fine"), "to 0.005 m, not 'fine'"),
    (lambda asset, to: asset.export(to / "x", states=-1), "must be a whole number of at least 0, got -1"),
    (lambda asset, _: asset.export(None), "directory = None is not allowed: give a path, such as 'out/door'"),
    (lambda asset, _: asset.export("a\0b"), "is not allowed: give a path"),
    (lambda asset, to: asset.export(to / ("a" * 300)), "File name too long"),
    (lambda asset, to: asset.export(to / "file" / "x"), "file is a file; nothing was changed"),
    (lambda asset, to: asset.export(to / "file"), "it is a file; choose another directory"),
    (
        lambda asset, to: asset.export(to),
        "it holds 'file' and is no earlier export of artgen; choose another",
    ),
    (lambda _, to: ag.load(to), "asset.json: No such file or directory; is this a directory that artgen exp"),
    (
        lambda _, to: ag.load("x" * 300),
        "asset.json: File name too long; give a directory that artgen exported",
    ),
    (lambda _, to: ag.load(None), "directory = None is not allowed: give a path"),
    (lambda _, to: ag.Dataset(to), "holds no dataset; `artgen generate CATEGORY -n 100` makes one"),
    (lambda _, to: ag.Dataset(7), "directory = 7 is not allowed: give a path"),
    (lambda _, to: generate_many(Plan("handle", 1), "s3:/bucket/x"), "no URL: write s3://bucket/x, with two"),
]
"""Calls with an asset and a folder that holds a file, with words that their messages hold."""


def cube(label: str = "a") -> ag.Body:
    return ag.part(ag.box(0.1, 0.1, 0.1), label, OAK)


def hinged(**options: object) -> ag.Body:
    joint = {"pivot": (0, 0, 0.15), "axis": ag.Z, "limits": (0, 1), **options}
    return cube().attach(ag.part(ag.box(0.1, 0.1, 0.1).at(z=0.2), "b", OAK), ag.Revolute("turn", **joint))


DRAFTS: list[tuple[Callable[[], object], str]] = [
    (lambda: cube() | cube(), "weld(a, b) joins bodies rigidly to one link, a.attach(b, joint) by a joint"),
    (lambda: cube() - ag.box(1, 1, 1), "cut a solid before part(...) makes a body of it"),
    (lambda: ag.box(1, 1, 1) + ag.box(1, 1, 1), "solids have no +; a | b unites them"),
    (lambda: np.sin(ag.box(1, 1, 1).size().x), "use artgen's sin, sqrt, min_, ... instead of numpy's"),
    (lambda: cube() if ag.box(1, 1, 1).size().x > 1 else None, "Use switch(condition, a, b) instead of if"),
    (lambda: ag.bx(1, 1, 1), "module 'artgen' has no attribute 'bx'. Did you mean 'box'?"),
    (lambda: sys.exit("bye"), "cannot be built: SystemExit: bye"),
    (lambda: None, "returned None; it must return a handle such as a Body"),
    (lambda: ag.part(ag.box(1, 0, 1), "a", OAK), "size y must be positive, got 0 m"),
    (lambda: ag.part(ag.box(1, 1, 1, bevel=0.6), "a", OAK), "bevel must be within 0 and 0.5 m, got 0.6 m"),
    (lambda: ag.part(ag.box(1, 1, 1) - ag.box(2, 2, 2), "a", OAK), "the second solid contains the first"),
    (
        lambda: ag.part(ag.extrude(ag.polygon([(0, 0), (1, 1), (1, 0), (0, 1)]), 1), "a", OAK),
        "the polygon crosses itself; give its points in order around it",
    ),
    (lambda: cube("a b"), "label 'a b' is no identifier; use letters, digits and _, at most 100"),
    (lambda: hinged(limits=(1, 0)), "joint 'turn' has limits 1 to 0: the lower one comes first"),
    (
        lambda: hinged(limits=1),
        "joint(..., limits=...) needs 2 values of Float or None, got 1; write the lower",
    ),
    (
        lambda: hinged(axis="z"),
        "joint(..., axis=...) needs a Vector, got 'z'; write X, Y, Z or three numbers",
    ),
    (lambda: ag.Revolute("turn", ag.Z), "give the others by name, as in axis=Z"),  # type: ignore[misc]
    (lambda: ag.part(ag.box(1, 1, 1), "a", "oak"), "needs a Material, got 'oak'; write material('oak')"),
    (lambda: ag.part(ag.box(1, 1, 1), OAK, "a"), "part(..., label=...) needs a str, got a Material"),
    (lambda: hinged(spring=3), "joint(..., spring=...) needs a Spring, got 3"),
    (lambda: hinged(feel="heavy"), "joint(..., feel=...) needs a Feel, got 'heavy'"),
    (lambda: cube().install(3), "install(...) needs a Fitting or a Body, got 3"),
    (lambda: cube().repeat("knob", at=[(0, 0, 0)]), "repeat(...) needs a Fitting or a Body, got 'knob'"),
    (
        lambda: ag.Region(1, (0, 1), (0, 1)),  # type: ignore[arg-type]
        "Region(..., x=...) needs the lowest and the highest coordinate, got 1",
    ),
    (lambda: hinged(axis=(0, 0, 0)), "a vector of length zero has no direction"),
    (lambda: hinged(effort=0), "joint 'turn': effort 0 must be positive"),
]
"""Bodies of categories, with words that the messages about them hold."""

COMMANDS = """
generate dor ~ there is no category 'dor'. Did you mean 'door'?
generate DOOR ~ Did you mean 'door'?
generate file ~ file is a file or folder: give the Python file of the category, such as stapler.py
generate pair ~ there is no category 'pair'. Did you mean the file pair.py?
check package ~ package is a folder without an exported asset; did you mean the file package/src/package.py?
view page.html ~ page.html is a page: open it in a browser.
view nowhere ~ there is no category 'nowhere'
view nofolder ~ and no folder of that name; give a folder that artgen exported, the Python file of a category
view dor ~ `artgen list` shows. Did you mean 'door'?
certify - ~ artgen reads no pipe or device: write its content to a file, such as stapler.py or robot.urdf.
certify /dev/null ~ artgen reads no pipe or device: write its content to a file
check - ~ artgen reads no pipe or device: write its content to a file
validate - ~ there is no directory '-'
generate nowhere.py ~ there is no Python file 'nowhere.py'; give the path of one
generate broken.py ~ SyntaxError: invalid syntax at
generate fails.py ~ ZeroDivisionError: division by zero at
generate exits.py ~ SystemExit: 3 at
generate nothing.py ~ defines no category; put @artgen.category(labels=(...)) before the function
generate pair.py ~ defines 2 categories; pick one: pair.py:one or pair.py:two
generate pair.py:three ~ pair.py defines no category 'three'. Allowed: one, two.
generate quits.py ~ quits cannot be built: SystemExit: bye at
generate door drawer ~ one asset is of one category, not door, drawer; give a number of assets with -n
generate door --set widht=0.9 ~ door has no parameter 'widht'. Did you mean 'width'?
generate door --set width=90 ~ 0.6 to 1.25 m is allowed; 90 cm are 0.9 m
generate door --set width=90cm ~ it must be a number. Write the number alone, in m
generate door --set 'width=36 in' ~ Write the number alone, in m: 0.9144
generate door --set 'width=3 ft' ~ Write the number alone, in m
generate door --set width=wide ~ width = 'wide' is not allowed: it must be a number
generate door --set 'hand=uniform(0, 1)' ~ hand = uniform(0, 1) is not allowed
generate door --set hand=middle ~ hand = 'middle' is not allowed: it must be one of 'left'
generate door --set 'width=uniform(0.85 0.92)' ~ a comma is missing; write for example uniform(0.8,
generate door --set 'width=uniform(0.85,' ~ it is not complete; write for example uniform(0.8, 0.9)
generate door --set 'width=unifrom(1, 2)' ~ Did you mean 'uniform'?
generate door --set handle_height 1.05 ~ 'handle_height' is no override; write NAME=VALUE
generate door --format urdf --format obj ~ there is no format 'obj'
generate door --set width ~ 'width' is no override; write NAME=VALUE
generate refrigerator --set dispenser=true ~ Did you mean 'water' (whether a door has a water dispenser)?
generate door --format obj ~ there is no format 'obj'
generate door --format , ~ ',' names no format
generate door --seed -1 ~ seed must be a whole number that is not negative, got -1
generate door --seed many ~ '--seed'
generate door --base loose ~ '--base'
generate door --name a/b ~ name = 'a/b' is no identifier
generate door --tolerance -0.001 ~ tolerance = -0.001 is not allowed: it is the clearance
generate door --tolerance 1mm ~ '--tolerance'
generate door --on-collision ignore ~ '--on-collision'
generate door --no-certify --on-collision fail ~ --on-collision does nothing for assets without a proof (--no
generate door --no-certify --tolerance 0.001 ~ --tolerance does nothing for assets without a proof
generate door --openings 0.1 ~ --openings does nothing for assets without --colliders; leave it out
generate door --jobs 2 ~ --jobs does nothing for one asset; leave it out
generate door --sed 1 ~ --sed
generate ~ Missing argument
generate door -n 2 ~ -n makes a dataset: give its folder with --out DIRECTORY
generate door -n 2 --out x --name x ~ --name is for one asset; those of a dataset are
generate door -n 0 --out x ~ Input should be greater than or equal to 1
generate dor -n 2 --out x ~ there is no category 'dor'. Did you mean 'door'?
generate door -n 2 --out folder ~ it holds 'notes' and no dataset; choose another folder
generate door -n 2 --out s3:/bucket ~ s3:/bucket is no URL: write s3://bucket, with two slashes
check stand --out nowhere ~ cannot write to nowhere: give a directory that exists
check stand --set width=9 ~ width = 9 is out of range: 0.2 to 0.5 m is allowed; 9 in are 0.2286 m
check stand --seconds -1 ~ '--seconds'
check broken.py ~ SyntaxError: invalid syntax at
certify nowhere.urdf ~ there is no file nowhere.urdf
certify door --total 5 ~ --total does nothing for a category; leave it out
certify robot.sdf --total 40 ~ cannot certify robot.sdf: its name must end in .urdf, .xml
certify robot.urdf --root nowhere ~ there is no directory nowhere; give the one with the files as --root
certify robot.urdf --samples 5 ~ --samples does nothing for a file; leave it out
certify robot.urdf --set w=3 ~ --set does nothing for a file; leave it out
certify door --samples -1 ~ samples must be a whole number that is not negative, got -1
certify broken.py --json broken.py ~ --json broken.py is not allowed: the name of the file must end in .json
certify door --json nowhere/x ~ cannot write nowhere/x: give a file in a directory that exists
validate nowhere ~ there is no directory 'nowhere'; give one that holds an exported asset
validate folder ~ 'folder' holds no exported asset; `artgen generate CATEGORY -n 10 --out folder` makes some
render stand --joint slide=1 ~ joint 'slide' cannot be at 1; its limits are 0 to 0.2
render stand --joint slide ~ --joint 'slide' must be JOINT=NUMBER, such as door_hinge=0.8
render stand --open 2 ~ open 2.0 must be in 0..1
render stand --out nowhere/x.png ~ cannot write nowhere/x.png: give a file in a directory that exists
render stand --samples 3 ~ --samples 3 must be an even number from 2 on, such as 8
render stand --samples 0 ~ --samples 0 must be an even number from 2 on, such as 8
render stand --out x.txt ~ a picture's name ends in .png, .jpg, .jpeg
render {long} ~ it is too long
view folder ~ cannot read folder/asset.json: No such file or directory; is this a directory that artgen
gallery folder ~ holds no exported asset; `artgen generate CATEGORY -n 10 --out
export folder ~ cannot read folder/asset.json: No such file or directory; is this a directory that artgen
info dor ~ there is no category 'dor'. Did you mean 'door'?
info {long}.py ~ there is no Python file
info door zzz ~ door has no parameter with 'zzz' in its name or description. Allowed:
info door width --picture a.png ~ leave the WORD out
generate door --set lamp:width=1 ~ is for 'lamp', which is not in the plan; its categories are door
images dor --out x ~ there is no category 'dor'. Did you mean 'door'?
images door --out x --labels handel ~ door: there is no label 'handel'. Did you mean 'handle'?
images door --out x --labels lamp:base ~ is for 'lamp', which is not in the plan; its categories are door
images door --out x --labels handle,grip=handle ~ the label 'handle' of door is named twice; leave one
images door --out x --random flor ~ no part of a picture is called 'flor'. Did you mean 'floor'?
images door --out x --size 8 ~ size 8 must be one or two whole numbers in 16..4096
images door --out x --split 0.8,0.1,0.2 ~ must be the shares of train, val, test with the sum 1
images door --out x --elevation 60,30 ~ within 0..1.5708 rad (60, 30 of 0 to 90 degrees), the lower
images door --out x --margin a,b ~ --margin 'a,b' must be 2 numbers with commas between them
images door --out x --assets 0 ~ Input should be greater than or equal to 1
studio door --port 99999 ~ --port 99999 is not allowed: it must be in 0..65535; 0 selects a free port
new door ~ there is a category 'door'; choose another name
paint ~ there is no command 'paint'.
valdate ~ there is no command 'valdate'. Did you mean 'validate'?
export door ~ there is no directory door; `artgen generate CATEGORY --out door` makes one
generate door --handle-height 1 ~ a parameter is given as --set handle_height=VALUE
--versio ~ No such option: --versio (Possible options: --version)
"""
"""Commands, with words that their messages hold; the folder of the files has FILES."""

CATEGORY = '@ag.category(labels=("a",))\ndef {}() -> ag.Body:\n    {}\n\n'
FILES = {
    "file": "",
    "folder/notes": "mine",
    "broken.py": "def f(:\n",
    "fails.py": "1 / 0\n",
    "exits.py": "raise SystemExit(3)\n",
    "nothing.py": "x = 1\n",
    "page.html": "<html>",
    "package/src/package.py": "",
    "pair.py": "import artgen as ag\n" + CATEGORY.format("one", "...") + CATEGORY.format("two", "..."),
    "quits.py": "import artgen as ag\n" + CATEGORY.format("quits", "raise SystemExit('bye')"),
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Return the current folder, which holds FILES."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def files_below(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize(("call", "words"), CALLS)
def test_a_call_names_the_fix(call, words, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ArtgenError, match=re.escape(words)):
        call()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("call", "words"), OF_ASSET)
def test_a_call_of_an_asset_names_the_fix_and_writes_nothing(call, words, asset, tmp_path):
    (tmp_path / "file").write_text("mine")
    with pytest.raises(ArtgenError, match=re.escape(words)):
        call(asset, tmp_path)
    assert files_below(tmp_path) == {"file"}


@pytest.mark.parametrize(("body", "words"), DRAFTS)
def test_a_draft_of_a_category_names_line_and_fix(body, words):
    def draft() -> ag.Body:
        return body()

    category = ag.generator(draft)
    with pytest.raises(ArtgenError, match=re.escape(words)) as caught:
        category.generate(certify=False)
    assert Path(__file__).name in str(caught.value)


HINGE = ag.Revolute("turn", axis=ag.Z, pivot=(0, 0, 0.1), limits=(0, 1))


def lid() -> ag.Body:
    return ag.part(ag.box(0.1, 0.1, 0.1).at(z=0.101), "b", OAK)


def attached() -> ag.Body:
    body = cube()
    body.attach(lid(), HINGE)
    return body


def cut() -> ag.Body:
    body = cube()
    body.cut(ag.box(0.01, 0.01, 1))
    return body


def made_only() -> ag.Body:
    lid()
    ag.weld(cube(), lid().at(z=0.2))
    return cube()


def moved() -> ag.Body:
    solid = ag.box(0.1, 0.1, 0.1)
    solid.at(z=0.05)
    return ag.part(solid, "a", OAK)


@pytest.mark.parametrize(
    ("function", "statement"),
    [(attached, "body.attach("), (cut, "body.cut("), (made_only, "ag.weld("), (moved, "solid.at(")],
)
def test_a_statement_that_drops_its_body_is_named(function, statement):
    with pytest.raises(ag.BuildError, match=r"Keep the result, as in body = body\.attach") as caught:
        ag.generator(function).generate(certify=False)
    file, line = re.search(r"at (\S+):(\d+)\n", str(caught.value)).groups()
    assert statement in Path(file).read_text().splitlines()[int(line) - 1]


def test_bodies_that_are_made_for_a_choice_may_be_left_out():
    def chosen(*, kind: str = ag.choice("plain", "lidded"), wide: ag.Float = ag.uniform(0.1, 0.2)) -> ag.Body:
        body, copies = cube(), []
        for place in (0.0, 0.5):
            copies.append(lid().at(x=place))  # noqa: PERF401 - a statement that keeps its body
        kinds = {"plain": body, "lidded": body.attach(copies[0], HINGE)}
        heavy = body.attach(copies[1], HINGE)
        measured = cube("c").mass() + ag.box(1, 1, 1).volume()
        return ag.switch((wide > 0.05) & (measured > 0), kinds[kind], heavy)

    category = ag.generator(chosen)
    links = {kind: len(category.generate(certify=False, kind=kind).links) for kind in ("plain", "lidded")}
    assert links == {"plain": 1, "lidded": 2}
    plain = category.generate(certify=False, kind="plain")
    notes = check_source(category, category, plain, overrides={"kind": "plain"}).findings
    assert [note.severity for note in notes] == ["note"]
    assert re.fullmatch(r"the body of attach at \S+ is not in the asset; return, .*", str(notes[0]))


def test_a_parameter_that_is_never_used_is_told():
    def tray(
        *,
        kind: str = ag.choice("flat", "deep"),
        wide: ag.Float = ag.by("kind", flat=0.2, deep=0.1),
        walls: int = ag.count(2, 4),
        lip: ag.Float = 0.01,
        spare: ag.Float = ag.uniform(0.1, 0.2),
    ) -> ag.Body:
        def wall(number: int) -> ag.Solid:
            return ag.box(wide, 0.1, lip).at(z=0.1 * number)

        return ag.part([wall(number) for number in range(walls)], "tray", OAK)

    category = ag.generator(tray)
    notes = check_source(category, category, category.generate(certify=False)).findings
    assert [note.severity for note in notes] == ["note"]
    assert re.fullmatch(
        r"the parameter 'spare' at \S+ is never used; use it in the function, or remove it", str(notes[0])
    )


COUNTED = [0]


def test_likely_mistakes_of_a_function_are_told():
    @ag.category(labels="base", joints=(1, 2))
    def stand(*, style: Literal["round", "square"] = ag.choice("round", "square")) -> ag.Body:
        """Make a base."""
        COUNTED[0] += 1
        solid = ag.cylinder(0.1, 0.1) if style == "rond" else ag.box(0.2, 0.2, 0.1 + 0.001 * COUNTED[0])
        for height in {0.01, 0.02}:  # noqa: PLC0208 - the mistake
            solid = solid | ag.box(0.01, 0.01, height).at(z=0.05)
        if style in ("square", "other"):
            solid = solid.rotate(ag.Z, 90) - ag.box(0.1, 0.1, 0.1).at(z=5)
        return ag.part(solid, "base", OAK)

    asset = stand.generate(certify=False, style="square")
    found = {
        str(each): each.severity
        for each in check_source(stand, stand, asset, overrides=asset.parameters).findings
    }
    assert list(found.values()) == ["note"] * 5 + ["fault"] * 2
    here = re.escape(__file__)
    patterns = (
        rf"style is compared with 'rond' at {here}:\d+; it never has that value. Did you mean 'round'\?",
        rf"a loop takes its values from a set at {here}:\d+; its order differs from process to process: .*",
        rf"style is compared with 'other' at {here}:\d+; it never has that value. Allowed: round, square\.",
        rf"rotate at {here}:\d+ turns by 90 rad, 14.3 turns; angles are in radians: math.radians\(90\)",
        rf"the cut at {here}:\d+ removes nothing; move the second solid into the first",
        rf"the asset has 0 joints, but @category\(joints=\(1, 2\)\) is declared; correct .* at {here}:\d+",
        rf"the same seed gives another asset .*; box at {here}:\d+ differs: z was 0\.\d+, then 0\.\d+; .*",
    )
    for text, pattern in zip(found, patterns, strict=True):
        assert re.fullmatch(pattern, text), text


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (lambda a, b, w: ag.Revolute("h", axis=ag.X, limit=(0, 1)), r"'limit'\. Did you mean 'limits'\?"),
        (lambda a, b, w: ag.box(w, w, w, bevl=0.1), r"'bevl'\. Did you mean 'bevel'\?"),
        (lambda a, b, w: ag.box(w, w, w).translate(x=1), r"'translate'\. Did you mean 'at'\?"),
        (lambda a, b, w: a.attach(a, HINGE), "a body cannot be attached to itself"),
        (
            lambda a, b, w: ag.Revolute("h", axis=ag.X, needs=w > 0.1),
            "a comparison of a joint, as in hinge > 0.6",
        ),
        (lambda a, b, w: ag.Revolute("h", axis=(1, 0)), "write X, Y, Z or three numbers"),
        (
            lambda a, b, w: ag.Revolute("h", axis=ag.X, feel="HINGE"),
            "write a preset, as feel=artgen.feel.HINGE",
        ),
        (lambda a, b, w: ag.Revolute("h", axis=ag.X, spring=5), r"write spring=artgen.Spring\(\.\.\.\)"),
        (lambda a, b, w: f"{w:.2f}", r"a handle used as a plain number.*\s.*\s.*\s.*make the parameter"),
    ],
)
def test_a_mistake_in_a_call_names_the_remedy_and_the_line(mistake, message):
    def thing(*, wide: ag.Float = ag.uniform(0.1, 0.2)) -> ag.Body:
        mistake(cube("a"), cube("b"), wide)
        return cube()

    with pytest.raises(ag.BuildError, match=message) as caught:
        ag.generator(thing).generate(certify=False)
    assert f"at {__file__}:" in str(caught.value)


def test_a_folder_of_assets_is_no_asset(asset, tmp_path):
    made = asset.export(tmp_path / "stand", textures=0)
    with pytest.raises(ag.ArtgenError, match=f"{tmp_path} holds several assets; give one, such as {made}"):
        ag.load(tmp_path)


@pytest.mark.parametrize("command", ["info", "generate", "certify"])
def test_an_exported_asset_is_no_category(command, asset, artgen_command, tmp_path):
    made = asset.export(tmp_path / "stand", textures=0)
    done = artgen_command(command, str(made))
    assert (done.code, done.out) == (2, "")
    assert (
        f"{made} is an exported asset: `artgen view {made}` and `artgen validate {made}` take it" in done.err
    )


@pytest.mark.parametrize("content", ["", "{", "[]", "null", "\0", '{"format": "artgen-asset-0"}'])
@pytest.mark.parametrize("command", ["view", "render", "export"])
def test_a_damaged_asset_is_exported_again(command, content, asset, artgen_command, tmp_path):
    made = asset.export(tmp_path / "stand", textures=0)
    (made / "asset.json").write_text(content)
    done = artgen_command(command, str(made))
    assert (done.code, done.out, done.err.count("\n")) == (2, "", 1)
    assert "export the asset again" in done.err


def test_formats_add_up(artgen_command, tmp_path, monkeypatch):
    monkeypatch.setitem(catalog.CATEGORIES, "stand", stand)
    made = artgen_command(
        *("generate", "stand", "--format", "urdf", "--format", "mjcf", "--texture-size", "0"),
        *("--out", str(tmp_path / "out")),
    )
    assert made.code == 0, made.err
    assert [Path(line).suffix for line in made.out.splitlines()] == [".urdf", ".xml"]


def test_links_and_pictures_are_shown_in_a_line(asset):
    assert repr(asset.links[0]) == "<link body: body>"
    assert all("\n" not in repr(link) and len(repr(link)) < 80 for link in asset.links)
    assert repr(asset.render(size=32, textures=0)) == "<picture, 32 x 32 pixels; save(path) writes it>"
    assert sum(link.mass for link in asset.links) == pytest.approx(asset.mass)


def whole(*, number: int = ag.uniform(1, 4)) -> ag.Body:
    return cube()


def listed(*, kind: str = ["x", "y"]) -> ag.Body:  # type: ignore[assignment]
    return cube()


def ranged(*, width: ag.Float = (0.1, 0.2)) -> ag.Body:  # type: ignore[assignment]
    return cube()


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (whole, "annotate it Float, or draw whole numbers, as count(1, 4) does"),
        (listed, "to draw one, write choice('x', 'y')"),
        (ranged, "to draw one, write uniform(0.1, 0.2)"),
    ],
)
def test_a_signature_names_the_distribution(function, words):
    with pytest.raises(ag.BuildError, match=re.escape(words)):
        ag.generator(function)


def test_a_decorator_without_labels_names_them():
    for decorate in (lambda: ag.category(cube), ag.category):
        with pytest.raises(ag.BuildError, match='write @category\\(labels="base arm"\\)') as caught:
            decorate()
        assert Path(__file__).name in str(caught.value)


def test_numpy_in_a_category_is_refused_at_the_line_of_the_author():
    @ag.generator
    def spaced(*, width: ag.Float = ag.uniform(1, 2)) -> ag.Body:
        return ag.part([ag.box(1, 1, 1).at(x=x) for x in np.linspace(0, width, 3)], "a", OAK)  # type: ignore[call-overload]

    with pytest.raises(ag.BuildError) as caught:
        spaced.generate()
    assert Path(__file__).name in str(caught.value)
    assert "numpy/" not in str(caught.value)


@pytest.mark.parametrize("line", COMMANDS.strip().splitlines())
def test_a_command_prints_one_line_and_writes_nothing(line, artgen_command, folder, monkeypatch):
    monkeypatch.setitem(catalog.CATEGORIES, "stand", stand)
    command, words = line.format(long="a" * 300).split(" ~ ")
    done = artgen_command(*shlex.split(command))
    assert (done.code, done.out, done.err.count("\n")) == (2, "", 1), done.err
    assert done.err.startswith("error: ")
    assert words in done.err
    assert files_below(folder) == set(FILES)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"task": "OpenDrawr"}, "there is no task 'OpenDrawr'. Did you mean 'OpenDrawer'?"),
        ({"count": 0}, "count is a whole number from 1 to 10000000, not 0"),
        ({"count": "1"}, "count is a whole number from 1 to 10000000, not '1'"),
        ({"seed": -1}, "seed is a whole number from 0 to"),
        ({"noise": -0.1}, "noise is a number from 0 to 1, not -0.1"),
        ({"image": 5000}, "image is a whole number from 0 to 4096, not 5000"),
        ({"jobs": 0}, "jobs is a whole number from 1 to 1000000, not 0"),
        ({"out": None}, "out = None is not allowed: give a path"),
    ],
)
def test_demonstrations_are_refused_before_the_first_attempt(wrong, words, tmp_path):
    for package in ("h5py", "gymnasium", "robosuite"):
        pytest.importorskip(package, reason="pip install 'artgen[demos,envs]'")
    from artgen.demos import make_demos

    with pytest.raises(ArtgenError, match=re.escape(words)):
        make_demos(**{"task": "OpenDrawer", "count": 1, "out": tmp_path / "new", **wrong})
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("value", [np.int64(3), np.uint8(3), np.array(3)])
def test_whole_numbers_of_numpy_are_numbers(value):
    assert stand.generate(value, certify=False).name == "stand_3"
    assert Plan("handle", 3, seed=3) == Plan("handle", value[()], seed=value)
    assert type(Plan("handle", value[()], seed=value).seed) is int


def test_numbers_of_numpy_and_infinite_time_are_allowed(asset):
    assert stand.generate(width=np.float32(0.25), certify=False).parameters["width"] == 0.25
    assert asset.certify(seconds=np.float32(inf)).proven


@pytest.mark.parametrize("command", ["generate quits.py", "validate nowhere"])
def test_a_process_prints_no_traceback(command, folder):
    done = subprocess.run(
        [sys.executable, "-W", "error", "-m", "artgen", *shlex.split(command)],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        timeout=120,
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith("error: ")
