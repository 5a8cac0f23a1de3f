"""Checks for the test suites of category authors.

    from artgen.testing import check_category

    def test_nightstand():
        check_category("nightstand", seeds=range(20))

`artgen.testing.strategies` has hypothesis strategies for the parameters of any generator. With `pytest
--artgen DIRECTORY`, each check of each exported asset becomes a test.
"""

from artgen.testing.category import check_category

__all__ = ["check_category"]
