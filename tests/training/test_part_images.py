"""Images become examples of parts, and masks become average precision."""

import sys
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "examples" / "training"
pytest.importorskip("pycocotools", reason="pip install 'artgen[images]'")
sys.path.insert(0, str(FOLDER))
import part_images  # noqa: E402
from part_images import PartImages  # noqa: E402

from support.flat_doors import drawn  # noqa: E402

# pycocotools does not know NumPy 2's way to ask for no copy
pytestmark = pytest.mark.filterwarnings("ignore:__array__ implementation:DeprecationWarning")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("images")
    drawn(place, "train", 24, 1)
    drawn(place, "test", 6, 2)
    return place


def test_labels_of_one_link_become_one_part(folder):
    images = PartImages(folder, "test")
    assert images.classes == ("door/frame", "door/body", "door/handle")
    for index in range(len(images)):
        found = {images.classes[number - 1]: mask for number, mask in images.masks(index)}
        assert set(found) == set(images.classes)
        rows, columns = np.nonzero(found["door/body"])
        leaf = (rows.max() - rows.min() + 1) * (columns.max() - columns.min() + 1)
        hidden = found["door/handle"].sum() + 3 * 5  # the latch, of no part, covers 3 x 5 pixels
        assert found["door/body"].sum() == leaf - hidden  # the pane is filled


def test_a_lamp_is_switched_by_what_moves():
    assert part_images.part_of("lamp", "rocker", {"rocker"}) == "lamp/switch"
    assert part_images.part_of("lamp", "switch", {"base", "switch"}) == "lamp/base"  # holds the rocker


def test_an_image_tells_its_asset_and_what_that_can_have(folder):
    images = PartImages(folder, "test", ["handle"])
    rows, columns = np.nonzero(images.silhouette(0))
    assert images.asset_box(0) == (columns.min(), rows.min(), columns.max() + 1, rows.max() + 1)
    assert images.possible(0).tolist() == [True]
    parts = PartImages(folder, "test").parts(0)
    areas = [(right - left) * (bottom - top) for _, _, (left, top, right, bottom) in parts]
    assert areas == sorted(areas, reverse=True)


def test_a_box_in_the_corner_stays_within_the_image():
    assert part_images.square((90, 0, 96, 3), (96, 96), 0.5) == (87, 0, 96, 9)
    assert part_images.square((0, 10, 96, 20), (96, 96), 0.5) == (0, 0, 96, 96)


def test_truth_as_answer_has_full_precision_and_a_shifted_one_has_less(folder):
    images = PartImages(folder, "test")

    def measured(change):
        results = []
        for index, image in enumerate(images.images):
            whole = images.whole(index)
            found = [(number, 0.9, change(mask), whole) for number, mask in images.masks(index)]
            results += part_images.as_results(image, found)
        return part_images.average_precisions(images.truth, results)

    assert set(measured(lambda mask: mask).values()) == {(1.0, 1.0)}
    for ap, ap50 in measured(lambda mask: np.roll(mask, 2, axis=1)).values():
        assert ap < 0.95
        assert ap50 == 1.0
    assert set(part_images.average_precisions(images.truth, []).values()) == {(0.0, 0.0)}


def test_what_is_likely_in_a_box_is_laid_there_as_far_as_the_image_reaches():
    likely = np.zeros((8, 8))
    likely[:, 4:] = 1.0  # the right half
    mask = part_images.laid(likely, (10.0, 20.0, 26.0, 36.0), (40, 50))
    assert mask.shape == (50, 40)
    rows, columns = np.nonzero(mask)
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (20, 35, 18, 25)
    assert part_images.laid(likely, (30.0, -8.0, 46.0, 8.0), (40, 50)).sum() == 2 * 8
    assert not part_images.laid(likely, (60.0, 0.0, 70.0, 10.0), (40, 50)).any()


def test_of_two_masks_of_one_part_the_likelier_is_the_result():
    image = {"id": 7, "width": 40, "height": 40}
    full = np.ones((4, 4))
    found = [
        (1, 0.4, full, (10.0, 10.0, 21.0, 20.0)),
        (1, 0.8, full, (10.0, 10.0, 20.0, 20.0)),
        (2, 0.3, full, (10.0, 10.0, 20.0, 20.0)),  # of another class
        (1, 0.2, full, (25.0, 25.0, 30.0, 30.0)),  # elsewhere
        (1, 0.9, 0.4 * full, (0.0, 0.0, 5.0, 5.0)),  # nothing is likely
    ]
    results = part_images.as_results(image, found)
    assert [(each["category_id"], each["score"]) for each in results] == [(1, 0.8), (2, 0.3), (1, 0.2)]
    assert all(each["image_id"] == 7 for each in results)


def test_a_wrong_part_or_an_empty_folder_is_one_clear_error(folder, tmp_path):
    with pytest.raises(
        SystemExit, match=r"error: no part 'door/handel' in these images; did you mean 'door/handle'\?"
    ):
        PartImages(folder, "train", ["door/handel"])
    handles = PartImages(folder, "train", ["handle"])
    assert handles.classes == ("door/handle",)
    assert [number for number, _ in handles.masks(0)] == [1]
    with pytest.raises(SystemExit, match=r"error: there is no .*train\.json; make it with: artgen images"):
        PartImages(tmp_path, "train")
