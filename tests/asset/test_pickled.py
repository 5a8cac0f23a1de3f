"""Assets travel between processes: what comes out is what went in, without its solids."""

import copy
import pickle

import pytest

import artgen
from artgen.asset import Asset
from artgen.errors import AssetError
from artgen.export.files import encode


@pytest.fixture(scope="module")
def asset() -> Asset:
    return artgen.generate("cabinet", seed=1)


def test_files_are_the_same(asset: Asset) -> None:
    back = pickle.loads(pickle.dumps(asset))  # noqa: S301 - our own
    assert back.to_json() == asset.to_json()
    assert encode(back, textures=0) == encode(asset, textures=0)
    assert encode(pickle.loads(pickle.dumps(back)), textures=0) == encode(asset, textures=0)  # noqa: S301


def test_the_certificate_travels(asset: Asset) -> None:
    back = pickle.loads(pickle.dumps(asset))  # noqa: S301 - our own
    assert back.certificate is not None
    assert back.certificate.proven
    bare = artgen.generate("cabinet", seed=1, certify=False)
    assert pickle.loads(pickle.dumps(bare)).certificate is None  # noqa: S301 - our own


def test_solids_stay_behind(asset: Asset) -> None:
    back = pickle.loads(pickle.dumps(asset))  # noqa: S301 - our own
    with pytest.raises(AssetError, match=r"keep no solids|was read from files"):
        encode(back, collision="hull")


def test_a_copy_is_the_asset(asset: Asset) -> None:
    assert copy.copy(asset) is asset
    assert copy.deepcopy({"it": asset})["it"] is asset
