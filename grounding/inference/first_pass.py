"""The first pass over a tree: from its leaves up, which kinds of symbols every phrase needs."""

from __future__ import annotations

from grounding.factors.first_pass import FirstPass, Needs
from grounding.features import FAMILIES
from grounding.features.needs import need_facts
from grounding.geometry.layout import Layout
from grounding.inference.engine import Kept, Memory, Tally, context_key
from grounding.language.tree import Phrase

_NEEDS = ("needs",)  # stands for the children in the keys of what is remembered


def infer_needs(first_pass: FirstPass, tree: Phrase, layout: Layout, memory: Memory | None = None) -> dict[int, Needs]:
    """What every phrase needs, by the identity of the phrase.

    Args:
        first_pass: the factors.
        tree: the parse.
        layout: the world, measured.
        memory: what was said of phrases before, by this first pass in this world.
    """
    found: dict[int, Needs] = {}
    for phrase in tree.postorder():
        key = None if memory is None else (_NEEDS, context_key(phrase, ()))
        needs = None if memory is None else memory.get(key)
        if needs is None:
            likely = [found[id(child)].likely for child in phrase.phrases]
            needs = first_pass.needs(need_facts(phrase, likely, layout))
            if memory is not None:
                memory[key] = needs
        found[id(phrase)] = needs
    return found


def kept_families(
    first_pass: FirstPass | None, tree: Phrase, layout: Layout, tally: Tally, memory: Memory | None = None
) -> Kept | None:
    """The families that the second pass looks at; None where there is no first pass, and it looks at all of them.

    A family that the first pass has no factor for is kept: nothing speaks against it.

    Args:
        first_pass: the factors, if any.
        tree: the parse.
        layout: the world, measured.
        tally: told how many factors were evaluated: one a phrase and kind, but for phrases that are remembered.
        memory: what was said of phrases before, by this first pass in this world.
    """
    if first_pass is None:
        return None
    unknown = frozenset(family.name for family in FAMILIES).difference(first_pass.kinds)
    before = 0 if memory is None else len(memory)
    needs = infer_needs(first_pass, tree, layout, memory)
    judged = len(needs) if memory is None else len(memory) - before
    tally.evaluations += judged * len(first_pass.kinds)
    return {phrase: found.kept | unknown for phrase, found in needs.items()}
