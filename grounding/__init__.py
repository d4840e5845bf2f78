"""Words and a world become symbolic goals.

Example:
    >>> from grounding import Grounder, load_world
    >>> world = load_world("models/scenes/default.json")
    >>> result = Grounder.load().ground("pick up the nearest block", world)
    >>> result.actions[0].objects
"""

from grounding.errors import (
    CorpusError,
    GroundingError,
    LanguageError,
    ModelError,
    SymbolError,
    TreeError,
    WorldError,
)
from grounding.grounder import Grounder
from grounding.result import Destination, GroundedAction, Grounding, PhraseGrounding
from grounding.world import Viewpoint, World, WorldObject, load_world, load_worlds, make_object, save_world

__all__ = [
    "CorpusError",
    "Destination",
    "GroundedAction",
    "Grounder",
    "Grounding",
    "GroundingError",
    "LanguageError",
    "ModelError",
    "PhraseGrounding",
    "SymbolError",
    "TreeError",
    "Viewpoint",
    "World",
    "WorldError",
    "WorldObject",
    "load_world",
    "load_worlds",
    "make_object",
    "save_world",
]
