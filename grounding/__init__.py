"""Words and a world become symbolic goals.

Example:
    >>> from grounding import Grounder, load_world
    >>> world = load_world("models/scenes/default.json")
    >>> result = Grounder.load().ground("pick up the nearest block", world)
    >>> result.actions[0].objects

The modules behind these names are imported when a name is first asked for, so that a command or a program that needs
one of them does not wait for all.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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

_ERRORS = ("CorpusError", "GroundingError", "LanguageError", "ModelError", "SymbolError", "TreeError", "WorldError")
_RESULTS = ("Destination", "GroundedAction", "Grounding", "PhraseGrounding")
_WORLDS = ("Viewpoint", "World", "WorldObject", "load_world", "load_worlds", "make_object", "save_world")
_MODULES = {
    **dict.fromkeys(_ERRORS, "errors"),
    **dict.fromkeys(_RESULTS, "result"),
    **dict.fromkeys(_WORLDS, "world"),
    "Grounder": "grounder",
}


def __getattr__(name: str) -> Any:
    """What one of the names stands for."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = globals()[name] = getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
