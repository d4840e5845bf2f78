"""The facts that the first pass looks at: words, tags, what the children need, and the world in a few coarse words."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from grounding.features.context import word_facts
from grounding.features.scope import Scope
from grounding.features.sources import child_roles
from grounding.geometry.layout import Layout
from grounding.language.lexicon import alike
from grounding.language.tree import Phrase

_SIZES = (1, 2, 3, 4, 5, 6, 8, 12, 16, 24)  # bounds between which worlds count as equally full
Children = Sequence[tuple[str, ...]]


def need_facts(phrase: Phrase, children: Children, layout: Layout) -> list[str]:
    """All facts of a phrase, in a fixed order.

    Args:
        phrase: λ.
        children: the kinds of symbols that each child phrase needs, in the order of `phrase.phrases`.
        layout: Υ, of which only the number of things and colours and the stacks are asked.
    """
    facts = word_facts(Scope(phrase, (), layout))
    roles = child_roles(phrase)
    for role, child, needed in zip(roles, phrase.phrases, children, strict=True):
        facts += [f"{role} needs {kind}" for kind in needed]
        facts += [f"{role} word={alike(word.text)}" for word in child.words]
    if roles:
        told = "+".join(f"{role}({','.join(needed)})" for role, needed in zip(roles, children, strict=True))
        facts.append(f"needed {told}")
    return list(dict.fromkeys([*facts, *world_facts(layout)]))


def world_facts(layout: Layout) -> tuple[str, ...]:
    """The world in a few words."""
    size = sum(layout.size >= bound for bound in _SIZES)
    colors = min(len(layout.colors), 3)
    return f"world of {size}", f"{colors} colors", "world has stacks" if layout.has_stacks else "world is level"


def need_key(phrase: Phrase, children: Children) -> Hashable:
    """Phrases with the same key have the same facts in worlds with the same facts; cheaper than the facts are."""
    below = [(child.tag, [(word.text, word.tag) for word in child.words]) for child in phrase.phrases]
    words = tuple([(word.text, word.tag) for word in phrase.words])
    return phrase.tag, words, tuple([(tag, tuple(own)) for tag, own in below]), tuple(children)
