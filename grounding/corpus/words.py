"""What words mean to annotation, beyond the closed classes of the lexicon: compass points, places, loneness."""

from __future__ import annotations

from grounding.language.lexicon import meanings
from grounding.symbols import SpatialReference

_POINTS: dict[str, tuple[str, ...]] = {"north": ("back",), "south": ("front",), "east": ("right",), "west": ("left",)}
_POINTS |= {ns + ew: _POINTS[ns] + _POINTS[ew] for ns in ("north", "south") for ew in ("east", "west")}
COMPASS = {name + ending: where for name, where in _POINTS.items() for ending in ("", "ern", "ernmost", "most", "ward")}
"""Compass points as the robot sees them from the south, by word; two directions for those in between."""

_MORE_DIRECTIONS = {
    "lowermost": "bottom", "undermost": "bottom", "rearward": "back", "up": "back", "down": "front", "upward": "back",
    "downward": "front", "upwards": "back", "downwards": "front", "forward": "front", "forwards": "front",
    "backward": "back", "backwards": "back", "rightward": "right", "rightwards": "right", "leftwards": "left",
    "centremost": "center",
}  # fmt: skip

EDGES = frozenset("side sides end ends edge edges border hand".split())
PARTS = frozenset("half part section area portion region quadrant zone".split())
CORNERS = frozenset("corner corners".split())
PLACE_NOUNS = EDGES | PARTS | CORNERS

LONE = frozenset(
    "lone single solitary isolated loose alone separate freestanding free-standing standalone lonely unstacked solo "
    "stray".split()
)
OTHER = frozenset(("other", "another"))
INDEFINITE = frozenset(("a", "an", "some", "any", "another"))
BLOCKS = frozenset("square squares piece pieces object objects thing things item items tile tiles unit units".split())
TABLES = frozenset("board grid screen surface desk tabletop desktop playing field page image picture display".split())
IGNORED = frozenset(
    "of very only whole entire most absolute extreme same hand nearby little um uh er exact actual immediate "
    "particular specific away story stories high".split()
)
SUPERLATIVE_NEAR = frozenset(("closest", "nearest", "closer", "nearer"))
SUPERLATIVE_FAR = frozenset(("farthest", "furthest", "farther", "further"))
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "near": "far", "far": "near",
            "top": "bottom", "bottom": "top"}  # fmt: skip
MEASURING = frozenset("half about approximately almost roughly around nearly quarter bit little few couple".split())
LENGTHS = frozenset(
    "length lengths space spaces spot spots step steps width widths square squares place places distance distances "
    "unit units tile tiles".split()
)


def directions(text: str) -> tuple[str, ...]:
    """The spatial references that a word names: two for "northeast", none for most words; "top" rather than "back"."""
    if text in COMPASS:
        return COMPASS[text]
    if text in _MORE_DIRECTIONS:
        return (_MORE_DIRECTIONS[text],)
    names = sorted(s.name for s in meanings(text) if isinstance(s, SpatialReference))
    if not names:
        return ()
    return ("top",) if "top" in names else ("bottom",) if "bottom" in names else (names[0],)
