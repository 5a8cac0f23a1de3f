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

from support.flat_doors import SIZE, drawn  # noqa: E402

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


def test_offsets_point_to_the_middle_of_each_part(folder):
    images = PartImages(folder, "test")
    _, classes, offsets = images.example(0, SIZE)
    assert (classes == images.other).sum() == 15
    number = 1 + images.classes.index("door/handle")
    y, x = np.nonzero(classes == number)
    pointed = np.stack((y, x)) + SIZE * offsets[:, y, x]
    np.testing.assert_allclose(pointed, [[y.mean()] * len(y), [x.mean()] * len(x)], atol=1e-3)
    assert np.isnan(offsets[:, classes == 0]).all()


def test_random_views_keep_centres_true_and_repeat_with_the_seed(folder):
    images = PartImages(folder, "train")

    def drawn_view(seed):
        rng = np.random.default_rng(seed)
        return part_images.changed(images.example(seed, 64, images.view(seed, rng)), rng)

    for seed in range(8):
        _, classes, offsets = drawn_view(seed)
        assert all(map(np.array_equal, drawn_view(seed)[:2], drawn_view(seed)[:2]))
        assert set(np.unique(classes)) >= {1, 2, 3}
        for number in range(1, 4):
            y, x = np.nonzero(classes == number)
            np.testing.assert_allclose(y + 64 * offsets[0, y, x], y.mean(), atol=1e-2)
            np.testing.assert_allclose(x + 64 * offsets[1, y, x], x.mean(), atol=1e-2)


def test_a_box_in_the_corner_stays_within_the_image():
    assert part_images.square((90, 0, 96, 3), (96, 96), 0.5) == (87, 0, 96, 9)
    assert part_images.square((0, 10, 96, 20), (96, 96), 0.5) == (0, 0, 96, 96)


def test_truth_as_answer_has_full_precision_and_a_shifted_one_has_less(folder):
    images = PartImages(folder, "test")

    def measured(change):
        results = []
        for index, image in enumerate(images.images):
            found = [(number, 0.9, change(mask)) for number, mask in images.masks(index)]
            results += part_images.as_results(image, found)
        return part_images.average_precisions(images.truth, results)

    assert set(measured(lambda mask: mask).values()) == {(1.0, 1.0)}
    for ap, ap50 in measured(lambda mask: np.roll(mask, 2, axis=1)).values():
        assert ap < 0.95
        assert ap50 == 1.0
    assert set(part_images.average_precisions(images.truth, []).values()) == {(0.0, 0.0)}


def test_votes_part_neighbours_and_join_what_something_hides():
    probabilities = np.zeros((3, 60, 60))  # background, a part, and what is of no part
    probabilities[2, :5] = 1.0
    probabilities[0] = 0.5
    probabilities[1, 10:30, 10:30] = probabilities[1, 10:30, 30:50] = 0.9  # two that touch
    probabilities[1, 40:44, 10:50] = probabilities[1, 50:54, 10:50] = 0.9  # one with something before it
    offsets = np.zeros((2, 60, 60))
    rows, columns = np.mgrid[:60, :60]
    for area, centre in (
        (np.s_[10:30, 10:30], (19.5, 19.5)),
        (np.s_[10:30, 30:50], (19.5, 39.5)),
        (np.s_[40:54, 10:50], (46.5, 29.5)),
    ):
        offsets[0][area] = (centre[0] - rows[area]) / 60
        offsets[1][area] = (centre[1] - columns[area]) / 60
    found = part_images.instances(probabilities, offsets)
    assert sorted(mask.sum() for _, _, mask in found) == [320, 400, 400]
    assert all(number == 1 and score == pytest.approx(0.9) for number, score, _ in found)


def test_a_wrong_part_or_an_empty_folder_is_one_clear_error(folder, tmp_path):
    with pytest.raises(
        SystemExit, match=r"error: no part 'door/handel' in these images; did you mean 'door/handle'\?"
    ):
        PartImages(folder, "train", ["door/handel"])
    handles = PartImages(folder, "train", ["handle"])
    assert handles.classes == ("door/handle",)
    assert [number for number, _ in handles.masks(0)] == [1]
    assert set(np.unique(handles.example(0, SIZE)[1])) == {0, 1, handles.other}
    with pytest.raises(SystemExit, match=r"error: there is no .*train\.json; make it with: artgen images"):
        PartImages(tmp_path, "train")
