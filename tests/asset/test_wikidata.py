"""Wikidata's codes of the categories."""

import re

from artgen.export.usd.layer import CATEGORY_CODES, THING, category_code


def test_categories_have_their_codes_and_others_that_of_a_thing():
    assert category_code("door") == "Q36794"
    assert category_code("trashcan") == "Q216530"
    assert category_code("a_category_of_somebody") == THING
    assert all(re.fullmatch(r"Q[1-9][0-9]*", code) for code in (THING, *CATEGORY_CODES.values()))
    assert len(set(CATEGORY_CODES.values())) == len(CATEGORY_CODES)
