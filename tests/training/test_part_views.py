"""What a network looks at: squares of assets and parts from near, with what it is to say of them."""

import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pycocotools", reason="pip install 'artgen[images]'")
sys.path.insert(0, str(Path(__file__).parents[2] / "examples" / "training"))
import part_views
from part_images import PartImages

from support.flat_doors import SIZE, drawn

pytestmark = pytest.mark.filterwarnings("ignore:__array__ implementation:DeprecationWarning")


@pytest.fixture(scope="module")
def images(tmp_path_factory):
    place = tmp_path_factory.mktemp("images")
    drawn(place, "train", 24, 1)
    return PartImages(place, "train")


def boxes_in(shown, number):
    """Return the boxes that cells at the peaks of a class tell [cells]."""
    rows, columns = np.nonzero(shown.peaks[number - 1] > 0.99)
    left, top, right, bottom = shown.sides[number - 1][:, rows, columns]
    x, y = columns + 0.5, rows + 0.5
    return np.stack((x - left, y - top, x + right, y + bottom), 1)


def test_peaks_are_in_the_middle_of_parts_and_tell_their_boxes(images):
    box = (6.0, 4.0, 90.0, 88.0)
    shown = part_views.wide(images, 0, images.image(0), box, 128)
    mirrored = shown.mirrored()
    n = 128 // part_views.CELL
    for number, _, part in images.parts(0):
        there = n * (np.array(part) - np.tile(box[:2], 2)) / 84.0
        np.testing.assert_allclose(boxes_in(shown, number), [there], atol=1e-5)
        other = n - there[2], there[1], n - there[0], there[3]
        np.testing.assert_allclose(boxes_in(mirrored, number), [other], atol=1e-5)
    assert shown.weights.sum((1, 2)) == pytest.approx([1.0, 1.0, 1.0])
    assert set(np.unique(shown.asset)) == {False, True}


def test_a_part_whose_middle_is_outside_is_not_asked_for(images):
    *_, right, bottom = next(box for number, _, box in images.parts(0) if number == 3)
    far = part_views.wide(images, 0, images.image(0), (right, bottom, right + 20.0, bottom + 20.0), 64)
    assert not far.peaks[2].any()


def test_boxes_repeat_with_the_seed_and_stay_within_the_image(images):
    whole = 0
    for seed in range(80):
        box = part_views.wide_box(images, seed % 24, np.random.default_rng(seed))
        assert box == part_views.wide_box(images, seed % 24, np.random.default_rng(seed))
        assert min(box) >= -1e-9
        assert max(box) <= SIZE + 1e-9
        assert box[2] - box[0] == pytest.approx(box[3] - box[1])
        whole += box[2] - box[0] == SIZE
    assert 2 <= whole < 30


def test_a_look_from_near_shows_the_part_where_its_mask_is(images):
    handles = PartImages(images.folder, "train", ["handle"])
    rng = np.random.default_rng(0)
    looks, masks = part_views.close_ups(handles, 0, handles.image(0), 5, 64, rng)
    assert len(looks) == len(masks) == 5
    for look, mask in zip(looks, masks, strict=True):
        assert look.shape == (64, 64, 4)
        inner = mask & np.roll(mask, 3, 0) & np.roll(mask, -3, 0) & np.roll(mask, 3, 1) & np.roll(mask, -3, 1)
        assert np.median(look[..., :3][inner], axis=0) == pytest.approx((40, 40, 45), abs=12)
        box = look[..., 3] == 255
        assert (mask & box).sum() / (mask | box).sum() > 0.5  # the box is a little off
        turned_look, turned_mask = part_views.turned(look, mask, rng)
        assert np.array_equal(np.sort(turned_look[turned_mask], 0), np.sort(look[mask], 0))


def test_what_lies_beyond_the_image_is_black_and_of_no_part(images):
    look, region = part_views.near(images.image(0), (-10.0, -10.0, 10.0, 10.0), 32)
    assert region == (-17.0, -17.0, 17.0, 17.0)
    assert not look[:14, :14, :3].any()
    assert look[20:, 20:, :3].all()
    mask = part_views.sampled(np.ones((SIZE, SIZE), bool), region, 32)
    assert mask.sum() == 16 * 16


def test_light_changes_colors_alone_and_the_same_in_all_looks():
    rng = np.random.default_rng(0)
    picture = rng.integers(0, 255, (8, 8, 4)).astype(np.uint8)
    for seed in range(8):
        wide, near = part_views.relit([picture[..., :3], picture], np.random.default_rng(seed))
        assert not np.array_equal(wide, picture[..., :3])
        assert np.array_equal(near[..., :3], wide)
        assert np.array_equal(near[..., 3], picture[..., 3])
