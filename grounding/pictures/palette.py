"""The colours of pictures: of blocks by their names, of markings, of paper and ink."""

from __future__ import annotations

from types import MappingProxyType

from grounding.lexicon.shades import shade

Rgb = tuple[int, int, int]

PAPER: Rgb = (255, 255, 255)
GROUND: Rgb = (238, 240, 243)
TABLE: Rgb = (252, 252, 250)
EDGE: Rgb = (190, 195, 202)
INK: Rgb = (28, 32, 38)
FAINT: Rgb = (112, 120, 130)
ROBOT: Rgb = (120, 128, 138)
PASSED: Rgb = (22, 128, 60)
FAILED: Rgb = (196, 30, 40)

OBJECT_COLORS = MappingProxyType(
    {
        "red": (201, 46, 44),
        "green": (58, 148, 74),
        "blue": (52, 101, 184),
        "yellow": (236, 190, 48),
        "orange": (232, 127, 36),
        "purple": (128, 76, 160),
        "violet": (128, 76, 160),
        "pink": (226, 130, 166),
        "brown": (124, 82, 52),
        "black": (52, 54, 58),
        "gray": (142, 147, 153),
        "grey": (142, 147, 153),
        "white": (240, 240, 238),
        "cyan": (62, 176, 190),
        "unknown": (176, 170, 160),
    }
)
"""Red, green, blue by the name that a world gives; others as `grounding.lexicon.shades` sees them."""

MARKS: tuple[Rgb, ...] = ((0, 130, 54), (22, 86, 200), (176, 84, 0), (118, 56, 184), (0, 120, 128), (150, 32, 96))
"""Colours of markings, dark enough to be read as text on paper; the first is for what is acted on."""


def color_of(name: str) -> Rgb:
    """The colour of objects that a world calls `name`, by a name or as a shade such as "#1f77b4"."""
    known = OBJECT_COLORS.get(name.lower())
    if known is not None:
        return known
    seen = shade(name)
    if seen is None:
        return OBJECT_COLORS["unknown"]
    red, green, blue = (round(255 * value) for value in seen.convert("srgb").fit().coords())
    return red, green, blue


def legible_on(color: Rgb) -> Rgb:
    """Ink or paper, whichever is easier to read on `color`."""
    red, green, blue = color
    return INK if 0.299 * red + 0.587 * green + 0.114 * blue > 140 else PAPER


def mixed(color: Rgb, other: Rgb, share: float) -> Rgb:
    """`color` with a share of `other` between 0 and 1."""
    mixture = [round(a + (b - a) * share) for a, b in zip(color, other, strict=True)]
    return mixture[0], mixture[1], mixture[2]
