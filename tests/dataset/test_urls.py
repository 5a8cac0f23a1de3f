"""Datasets at URLs: the same bytes as in a folder, with the operations of object stores only."""

import pickle
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from artgen.dataset import Dataset, Plan, generate_many, places
from artgen.dataset.places import LOCK_FILE, Store, place_of
from artgen.dataset.run import MANIFEST_FILE, Folder
from artgen.errors import ExportError
from support.digests import digests

pytest.importorskip("fsspec")

CATEGORIES = ("drawer", "cabinet")
PLAN = Plan(CATEGORIES, 4, formats=("mjcf",), texture_size=256, certify=False)
OPTIONS = ("--format", "mjcf", "--texture-size", "256", "--no-certify")


def command(url: str) -> list[str]:
    return [
        *(sys.executable, "-m", "artgen", "generate", *CATEGORIES, *OPTIONS),
        *("-n", str(PLAN.count), "--jobs", "1", "--out", url),
    ]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Digests of a folder with embedded maps, without the lock, which remains on disks."""
    folder = tmp_path_factory.mktemp("dataset")
    generate_many(replace(PLAN, textures="embedded"), folder, jobs=1)
    found = digests(folder)
    assert found.pop(LOCK_FILE)
    return found


@pytest.fixture(scope="module")
def filled(bucket: Path) -> Path:
    """Make the dataset at a URL with several processes."""
    assert generate_many(PLAN, f"bucket://{bucket}/filled", jobs=2).made == 4
    return bucket / "filled"


def test_the_same_bytes_as_in_a_folder(undisturbed: dict[str, str], filled: Path) -> None:
    assert digests(filled) == undisturbed
    assert generate_many(PLAN, f"bucket://{filled}").existing == 4


@pytest.mark.long
def test_a_killed_run_continues(undisturbed: dict[str, str], bucket: Path) -> None:
    folder = bucket / "killed"
    run = subprocess.Popen(
        command(f"bucket://{folder}"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    deadline = time.monotonic() + 120.0
    while not list(folder.rglob("asset.json")):
        assert run.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    run.send_signal(signal.SIGKILL)
    run.wait()
    again = subprocess.run(command(f"bucket://{folder}"), check=False, capture_output=True, text=True)
    message = (
        f"; wait until it is done, or choose another place; if it was killed, remove bucket://{folder}/.lock "
        "and run the same command again\n"
    )
    assert again.returncode == 2
    assert again.stderr.startswith(f"error: another run (process {run.pid} on ")
    assert again.stderr.endswith(message)
    (folder / LOCK_FILE).unlink()
    done = subprocess.run(command(f"bucket://{folder}"), check=True, capture_output=True, text=True)
    assert " were there: bucket://" in done.stdout
    assert digests(folder) == undisturbed


def test_a_directory_without_its_record_is_absent(
    undisturbed: dict[str, str], filled: Path, bucket: Path
) -> None:
    folder = shutil.copytree(filled, bucket / "torn")
    (folder / "drawer/drawer_1/asset.json").unlink()
    (folder / "drawer/drawer_1/drawer_1.xml").write_text("<muj")
    first, *_ = (folder / MANIFEST_FILE).read_text().splitlines(keepends=True)
    (folder / MANIFEST_FILE).write_text(first)  # it is written from time to time only
    summary = generate_many(PLAN, f"bucket://{folder}", jobs=1)
    assert (summary.made, summary.existing) == (1, 3)
    assert digests(folder) == undisturbed


def test_a_damaged_record_is_named(filled: Path, bucket: Path) -> None:
    folder = shutil.copytree(filled, bucket / "damaged")
    (folder / MANIFEST_FILE).unlink()
    (folder / "drawer/drawer_1/asset.json").write_text('{"name": "dra')
    message = r"drawer_1/asset\.json is damaged: .*; remove bucket://.*/drawer/drawer_1, and the same command"
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, f"bucket://{folder}")
    assert not (folder / LOCK_FILE).exists()


@pytest.mark.long
def test_folders_are_created_in_stores_with_folders(undisturbed: dict[str, str], tmp_path: Path) -> None:
    generate_many(PLAN, f"local://{tmp_path}/set", jobs=1)
    assert digests(tmp_path / "set") == undisturbed


def test_the_manifest_is_written_at_intervals(bucket: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(places, "_INTERVAL", 0.05)
    store = Store(f"bucket://{bucket}/lines")
    store.write("lines", b"first\n")
    with store.opened():
        store.append("lines", "second\n")
        assert store.read("lines") == b"first\n"
        time.sleep(0.06)
        store.append("lines", "third\n")
        assert store.read("lines") == b"first\nsecond\nthird\n"
        store.append("lines", "fourth\n")
    assert store.read("lines") == b"first\nsecond\nthird\nfourth\n"


def test_two_runs_do_not_write_to_one_url(bucket: Path) -> None:
    url = f"bucket://{bucket}/held"
    with (
        Folder.opened(place_of(url), PLAN),
        pytest.raises(ExportError, match=r"another run \(process \d+ on .*, since 20.*\) writes to bucket:"),
    ):
        generate_many(PLAN, url)
    assert not (bucket / "held" / LOCK_FILE).exists()


def test_the_first_of_two_runs_fails_in_a_store_that_overwrites(
    bucket: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without exclusive creation, the last owner to write is the owner."""
    store = Store(f"bucket://{bucket}/raced")

    def race(path: str, owner: bytes) -> None:
        for each in (owner, b"process 7 on other, since now"):
            store.write(path, each)

    monkeypatch.setattr(store, "_create", race)
    with pytest.raises(ExportError, match="process 7 on other, since now"), store.opened():
        pass
    assert (bucket / "raced" / LOCK_FILE).exists()


def test_unsuitable_urls_are_errors(bucket: Path) -> None:
    with pytest.raises(
        ExportError, match=r"by links, and bucket:.* has no links; choose the textures 'embedd"
    ):
        generate_many(replace(PLAN, textures="shared"), f"bucket://{bucket}/shared")
    (bucket / "letters").mkdir()
    (bucket / "letters/to.txt").write_text("Dear")
    with pytest.raises(ExportError, match=r"it holds 'to\.txt' and no dataset; choose another folder"):
        generate_many(PLAN, f"bucket://{bucket}/letters")
    with pytest.raises(ExportError, match="it is a file; choose another place"):
        generate_many(PLAN, f"bucket://{bucket}/letters/to.txt")
    assert not (bucket / "shared").exists()


def test_a_store_of_one_process_is_refused() -> None:
    message = r"process \d+ on .* does not see memory://set; choose a folder or URL that all processes share"
    with pytest.raises(ExportError, match=message):
        generate_many(replace(PLAN, count=1, textures="none"), "memory://set", jobs=1)


@pytest.mark.parametrize(
    ("url", "message"),
    [
        ("what://set", "what://set cannot be opened: Protocol not known: what"),
        (
            "file://host/set",
            r"names a folder of another machine \('host'\): a folder of this one is file:///",
        ),
    ],
)
def test_unknown_urls_are_errors(url: str, message: str) -> None:
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, url)


def test_the_url_of_a_file_is_a_folder(tmp_path: Path) -> None:
    folder = tmp_path / "a set"
    assert str(place_of(folder.as_uri())) == str(folder)
    assert place_of(folder.as_uri()).links


def test_missing_fsspec_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "fsspec.core", None)
    with pytest.raises(ExportError, match=r"s3://x needs fsspec: pip install 'artgen\[url\]'"):
        place_of("s3://x")


def test_datasets_are_read_from_urls(filled: Path) -> None:
    there, here = Dataset(f"bucket://{filled}"), Dataset(filled)
    assert repr(there) == f"<4 assets of cabinet, drawer in bucket://{filled}>"
    assert there.records == here.records
    part = pickle.loads(pickle.dumps(there.filter("drawer")))  # noqa: S301 - as for the workers of a loader
    assert [asset.name for asset in part] == ["drawer_0", "drawer_1"]
    [first, *_] = there.files("mjcf")
    assert not first.is_relative_to(filled)
    assert digests(first.parent) == digests(filled / "drawer/drawer_0")
    surface = there[0].links[0].surfaces[0].mesh
    assert surface.vertices.tobytes() == here[0].links[0].surfaces[0].mesh.vertices.tobytes()


def test_a_removed_asset_is_an_error(filled: Path, bucket: Path) -> None:
    found = Dataset(f"bucket://{shutil.copytree(filled, bucket / 'gone')}")
    shutil.rmtree(bucket / "gone/cabinet/cabinet_0")
    with pytest.raises(
        ExportError, match=r"/gone/cabinet/cabinet_0 holds no asset\.json; generate the datas"
    ):
        found[1]


def test_what_is_no_dataset_is_refused(bucket: Path) -> None:
    with pytest.raises(ExportError, match=r"bucket:.*/nothing holds no dataset; `artgen generate"):
        Dataset(f"bucket://{bucket}/nothing")


def test_a_single_asset_needs_a_disk(artgen_command) -> None:  # type: ignore[no-untyped-def]
    done = artgen_command("generate", "drawer", "--out", "s3://bucket/drawer")
    assert done.code == 2
    assert (
        "one asset is written to a directory, not to s3://bucket/drawer; give a number of assets with -n"
        in done.err
    )
