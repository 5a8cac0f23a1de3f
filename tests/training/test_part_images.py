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


def test_random_views_point_to_the_same_centres_and_repeat_with_the_seed(folder):
    images = PartImages(folder, "train")
    for seed in range(24):
        box, around = images.view(seed, np.random.default_rng(seed))
        assert images.view(seed, np.random.default_rng(seed)) == (box, around)
        assert around[0] <= box[0] < box[2] <= around[2] or box[2] - box[0] < around[2] - around[0]
        _, classes, offsets = images.example(seed, 64, box)
        side = box[2] - box[0]
        for number, mask in images.masks(seed):
            y, x = np.nonzero(classes == number)
            pointed = np.stack((y, x)) + 0.5 + 64 * offsets[:, y, x]
            found = np.array([[box[1]], [box[0]]]) + side / 64 * pointed
            centre = np.mean(np.nonzero(mask), 1, keepdims=True) + 0.5
            np.testing.assert_allclose(found, np.broadcast_to(centre, found.shape), atol=1e-3)


def test_a_view_of_most_of_an_image_shows_all_parts(folder):
    images = PartImages(folder, "train")
    whole = 0
    for seed in range(60):
        box, around = images.view(seed % len(images), np.random.default_rng(seed))
        if box == around:
            whole += 1
            assert set(np.unique(images.example(seed % len(images), 64, box)[1])) >= {1, 2, 3}
    assert whole


def test_views_are_mostly_of_parts_and_some_of_the_whole(folder):
    images = PartImages(folder, "train", ["handle"])
    shown = []
    for seed in range(200):
        box, around = images.view(seed % len(images), np.random.default_rng(seed))
        shown.append((box == around, (images.example(seed % len(images), 32, box)[1] == 1).any()))
    whole, handle = np.mean(shown, axis=0)
    assert 0.08 < whole < 0.25
    assert handle > 0.75


def test_a_mirrored_example_points_to_mirrored_centres(folder):
    images = PartImages(folder, "train")
    image, classes, offsets = images.example(0, 64)
    place = part_images.within((30.0, 10.0, 50.0, 30.0), (10.0, 0.0, 90.0, 80.0))
    np.testing.assert_allclose(place, [0.25, 0.125, 0.5, 0.375])
    made = [
        part_images.changed((image,), classes, offsets, place, np.random.default_rng(seed))
        for seed in range(8)
    ]
    again = part_images.changed((image,), classes, offsets, place, np.random.default_rng(3))
    assert np.array_equal(again[0][0], made[3][0][0])
    assert np.array_equal(again[1], made[3][1])
    mirrored = [not np.array_equal(each[1], classes) for each in made]
    assert 0 < sum(mirrored) < len(made)
    for is_mirrored, (pictures, said, ways, lies) in zip(mirrored, made, strict=True):
        np.testing.assert_allclose(lies, [0.5, 0.125, 0.75, 0.375] if is_mirrored else place)
        assert pictures[0].shape == image.shape
        if is_mirrored:
            np.testing.assert_array_equal(said, classes[:, ::-1])
            np.testing.assert_array_equal(ways[1], -offsets[1, :, ::-1])
            np.testing.assert_array_equal(ways[0], offsets[0, :, ::-1])


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
