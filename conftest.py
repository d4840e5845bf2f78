"""Settings of all tests: hypothesis never judges by the clock, and draws the same examples every time."""

from hypothesis import settings

settings.register_profile("steady", deadline=None, derandomize=True)
settings.load_profile("steady")
