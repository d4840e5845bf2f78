"""What reading a phrase needs to know of a scene: whether sizes tell things apart, and what its types are called."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.lexicon.size import vary
from grounding.meaning.reading import Context
from grounding.meaning.referents import Referent
from grounding.world.scene import Scene


def context_in(
    scene: Scene, history: Sequence[int] = (), mentioned: Referent | None = None, *, several: bool = False
) -> Context:
    """What phrases are read with.

    Args:
        scene: the world.
        history: indices of the objects handled before.
        mentioned: what was spoken of last, or None.
        several: whether that were several.
    """
    return Context(mentioned, several, bool(history), vary(scene), scene.layout.kinds)
