"""The small network learns to tell parts in images that it has not seen."""

import sys
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch", reason="pip install 'artgen[train]'")
pytest.importorskip("pycocotools", reason="pip install 'artgen[images]'")
sys.path.insert(0, str(Path(__file__).parents[2] / "examples" / "training"))
import segmentation  # noqa: E402
from part_images import PartImages  # noqa: E402

from support.flat_doors import drawn  # noqa: E402

# pycocotools does not know NumPy 2's way to ask for no copy
pytestmark = pytest.mark.filterwarnings("ignore:__array__ implementation:DeprecationWarning")


@pytest.fixture(scope="module")
def splits(tmp_path_factory):
    folder = tmp_path_factory.mktemp("doors")
    drawn(folder, "train", 24, 1)
    drawn(folder, "test", 6, 2)
    return PartImages(folder, "train"), PartImages(folder, "test")


def learnt(seen, steps):
    torch.manual_seed(0)
    torch.set_num_threads(1)
    network = segmentation.SmallNetwork(seen, 64)
    segmentation.train(network, seen, steps, 4, 1e-2, 0)
    return network


def test_it_separates_parts_that_it_has_not_seen(splits):
    seen, unseen = splits
    before = segmentation.evaluate(learnt(seen, 1), unseen)
    after = segmentation.evaluate(learnt(seen, 300), unseen)
    assert all(ap50 < 0.2 for _, ap50 in before.values())
    assert all(ap50 > 0.6 for _, ap50 in after.values()), after


def test_the_table_ends_with_the_mean_of_handles_and_of_all():
    lines = segmentation.table(
        {"door/body": (0.8, 0.9), "door/handle": (0.2, 0.5), "lamp/switch": (0.4, 0.6)}
    )
    assert lines[-2].split() == ["handle-like", "0.300", "0.550"]
    assert lines[-1].split() == ["all", "0.467", "0.667"]


def test_learning_repeats_with_its_seed(splits):
    first, again = (learnt(splits[0], 3).model.state_dict() for _ in range(2))
    assert all(torch.equal(first[key], again[key]) for key in first)


@pytest.mark.filterwarnings("ignore::DeprecationWarning:torch", "ignore::UserWarning:torch")
def test_mask_rcnn_learns_from_the_same_images(splits):
    try:
        from torchvision.ops import nms

        nms(torch.zeros(1, 4), torch.zeros(1), 0.5)
    except (ImportError, RuntimeError):
        pytest.skip("pip install torchvision, of torch's own index")
    seen, unseen = splits
    torch.manual_seed(0)
    network = segmentation.MaskRCNN(seen, 96)
    for proposals in (network.model.rpn._pre_nms_top_n, network.model.rpn._post_nms_top_n):
        proposals.update(training=32, testing=32)  # enough for boxes of plain colors
    batch = network.together([network.item(seen, index, np.random.default_rng(index)) for index in range(2)])
    optimizer = torch.optim.SGD(network.model.parameters(), 1e-3)
    losses = []
    network.model.train()
    for _ in range(4):
        losses.append(network.loss(batch))
        optimizer.zero_grad()
        losses[-1].backward()
        optimizer.step()
    assert losses[-1] < 0.5 * losses[0]
    assert set(segmentation.evaluate(network, unseen)) == {"door/frame", "door/body", "door/handle"}
    network.model.roi_heads.score_thresh = 0.0
    assert network.results(unseen, 0)  # that early it is sure of nothing, but has masks of something
