"""Relations between two things, each a file of its own that is found by its name.

A module here has two functions of the places that are asked for and of the scene, each of shape (m, n) for m places and
n objects, in [0, 1]: `truth(where, scene)` tells how well a place stands in the relation to an object, and
`preference(where, scene)` which of the places that it is true of would be meant. The words that say it stand in the
section [relation] of the table of words, under the module's name. Where a module has words to say it before what it is
related to, as `SAID`, things are described by it as well.
"""

from __future__ import annotations

import importlib
from functools import lru_cache
from types import ModuleType

from grounding.errors import LexiconError
from grounding.lexicon.vocabulary import vocabulary


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


def said() -> tuple[str, ...]:
    """The words by which relations are said before what they relate to: "diagonal from"."""
    families = vocabulary().families["relation"]
    names = sorted({value for values in families.values() for value in values})
    found = (getattr(relation(name), "SAID", None) for name in names)
    return tuple(text for text in found if text)
