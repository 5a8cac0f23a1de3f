"""Settings of all tests: the same examples every time, and no deadline on a busy machine."""

from hypothesis import settings

settings.register_profile("artgen", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("artgen")
