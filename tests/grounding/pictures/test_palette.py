"""The colours of things in pictures and in the simulation."""

import pytest

from grounding.pictures.palette import OBJECT_COLORS, color_of


@pytest.mark.parametrize(("name", "seen"), [
    ("#08306b", (8, 48, 107)), ("rgb(214, 39, 40)", (214, 39, 40)), ("Red", OBJECT_COLORS["red"]),
    ("wug", OBJECT_COLORS["unknown"]), ("turquoise", (6, 194, 172)),
])  # fmt: skip
def test_a_colour_looks_as_its_name_or_its_shade_says(name, seen):
    assert color_of(name) == seen
