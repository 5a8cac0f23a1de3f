"""The card of a dataset: rows with the digests of the certificates, as the package `datasets` reads them."""

import hashlib
import json

import pytest

from artgen.cli import main
from artgen.dataset import Plan, generate_many, write_card
from artgen.errors import ExportError, ParameterError


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("HF_HOME", str(tmp_path / "hub"))
    plan = Plan(("drawer", "faucet"), 2, formats=("mjcf",), textures="none")
    generate_many(plan, tmp_path / "set", jobs=1, progress=False)
    return tmp_path / "set"


def test_the_rows_have_the_digests_of_the_certificates(folder, tmp_path, capsys) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["card", str(folder), "--licence", "cc-by-4.0", "--title", "Drawers: a test"])
    assert ended.value.code in (0, None)
    assert str(folder / "README.md") in capsys.readouterr().out
    rows = [json.loads(line) for line in (folder / "assets.jsonl").read_text().splitlines()]
    assert [row["name"] for row in rows] == ["drawer_0", "faucet_0"]
    for row in rows:
        certificate = (folder / row["path"] / "certificate.json").read_bytes()
        assert row["certificate_sha256"] == hashlib.sha256(certificate).hexdigest()
        assert row["proven"]
        assert (folder / json.loads(row["files"])["mjcf"]).is_file()
    card = (folder / "README.md").read_text()
    assert card.startswith('---\npretty_name: "Drawers: a test"\nlicense: "cc-by-4.0"\n')
    assert "2 articulated assets" in card
    assert "2 have a proof" in card
    datasets = pytest.importorskip("datasets", reason="pip install datasets")
    loaded = datasets.load_dataset(str(folder), split="train", cache_dir=str(tmp_path / "cache"))
    assert loaded.to_list() == rows


def test_a_card_replaces_only_itself(folder) -> None:
    write_card(folder, "cc-by-4.0")
    assert "cc0-1.0" in write_card(folder, "cc0-1.0").read_text()
    (folder / "README.md").write_text("my own words")
    with pytest.raises(ExportError, match="was not written by artgen; move it away first"):
        write_card(folder, "cc0-1.0")
    assert (folder / "README.md").read_text() == "my own words"


def test_wrong_inputs_are_told(folder, tmp_path) -> None:
    with pytest.raises(ParameterError, match=r"licence = 'CC BY 4.0' is not allowed: .*such as cc-by-4.0"):
        write_card(folder, "CC BY 4.0")
    with pytest.raises(ExportError, match="holds no dataset"):
        write_card(tmp_path, "cc-by-4.0")
