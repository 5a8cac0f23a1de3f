"""Streams: reproducible assets, divided among the workers of a loader."""

import pickle
import sys
from itertools import islice
from types import ModuleType, SimpleNamespace

import pytest

import artgen
from artgen.dataset import Stream
from artgen.errors import InfeasibleError, ParameterError


def names(stream: Stream, count: int) -> list[str]:
    return [asset.name for asset in islice(stream, count)]


def test_categories_alternate_and_each_iteration_begins_again() -> None:
    stream = artgen.stream(["drawer", "cabinet"], seed=3, certify=False)
    assert names(stream, 3) == ["drawer_3", "cabinet_3", "drawer_4"]
    again = pickle.loads(pickle.dumps(stream))  # noqa: S301 - our own
    assert names(again, 2) == ["drawer_3", "cabinet_3"]


def test_distributions_are_drawn_from() -> None:
    wide = artgen.stream("drawer", certify=False, width=artgen.uniform(1.2, 1.3))
    assert all(1.2 <= float(str(asset.parameters["width"])) <= 1.3 for asset in islice(wide, 2))


def test_options_of_generate_are_no_overrides() -> None:
    stream = artgen.stream("switch", certify=False, topology="fixed")
    assert all(asset.originals for asset in islice(stream, 2))


def test_workers_of_a_loader_share_the_seeds(monkeypatch: pytest.MonkeyPatch) -> None:
    """As in each worker of PyTorch, which the tests do not need."""
    torch = {name: ModuleType(name) for name in ("torch", "torch.utils", "torch.utils.data")}
    for name, module in torch.items():
        monkeypatch.setitem(sys.modules, name, module)
    stream = Stream(("drawer",), 0, {"certify": False})
    found = []
    for number in range(2):
        worker = SimpleNamespace(id=number, num_workers=2)
        torch["torch.utils.data"].get_worker_info = lambda worker=worker: worker  # type: ignore[attr-defined]
        found.append(names(stream, 2))
    assert found == [["drawer_0", "drawer_2"], ["drawer_1", "drawer_3"]]


def test_infeasible_assets_are_omitted(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    drawer = artgen.catalog.find("drawer")
    real = type(drawer).generate

    def generate(self: object, seed: int, **options: object) -> artgen.Asset:
        if seed == 1:
            raise InfeasibleError("no draw is feasible")
        return real(drawer, seed, certify=False)

    monkeypatch.setattr(type(drawer), "generate", generate)
    assert names(artgen.stream("drawer"), 2) == ["drawer_0", "drawer_2"]
    assert caplog.messages == ["drawer 1 is left out: no draw is feasible"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"categories": "drawr"}, "there is no category 'drawr'"),
        ({"categories": ()}, "a stream needs at least one category"),
        ({"categories": "drawer", "seed": -1}, "seed"),
        ({"categories": "drawer", "widht": 1.0}, "Did you mean 'width'"),
    ],
)
def test_mistakes_are_errors_before_the_first_asset(options: dict[str, object], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        artgen.stream(**options)  # type: ignore[arg-type]
