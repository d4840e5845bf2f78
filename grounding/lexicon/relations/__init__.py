"""Relations between two things, each a file of its own that is found by its name.

A module here has two functions of the places that are asked for and of the scene, each of shape (m, n) for m places and
n objects, in [0, 1]: `truth(where, scene)` tells how well a place stands in the relation to an object, and
`preference(where, scene)` which of the places that it is true of would be meant. The words that say it stand in the
section [relation] of the table of words, under the module's name.
"""

from __future__ import annotations

import importlib
from functools import lru_cache
from types import ModuleType

from grounding.errors import LexiconError


@lru_cache(maxsize=64)
def relation(name: str) -> ModuleType:
    """The module of a relation.

    Raises:
        LexiconError: the table of words names a relation that has no module, or one without its two functions.
    """
    where = f"{__name__}.{name}"
    try:
        module = importlib.import_module(where)
    except ModuleNotFoundError as error:
        raise LexiconError(f"the table of words has a relation {name!r}, and there is no module {where}") from error
    for function in ("truth", "preference"):
        if not callable(getattr(module, function, None)):
            raise LexiconError(f"expected {where} to have a function {function}(where, scene)")
    return module
