"""Promises of every category: sound files, the same bytes for the same seed, no collisions."""

from artgen.testing import check_category

from my_category import my_category


def test_the_first_seeds_are_sound() -> None:
    """Run every check of `artgen validate`, including MuJoCo; a failure has its seed and parameters."""
    check_category(my_category, seeds=range(4), behavior=True)


def test_a_hand_can_open_the_lid() -> None:
    """Check a promise of this category only."""
    asset = my_category.generate(seed=0)
    (grasp,) = asset.affordances
    assert (grasp.link, grasp.joints) == ("lid", ("lid_hinge",))
    assert asset.clearance({"lid_hinge": 1.5})["box", "lid"] > 0.0
