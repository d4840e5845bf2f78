"""What is said when no reading names anything: was it the words, or the world?"""

from __future__ import annotations

from dataclasses import dataclass

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import kind
from grounding.lexicon import words as w
from grounding.meaning.discourse.verbs import HANDLING
from grounding.meaning.nouns import read_noun
from grounding.meaning.recall import is_surely_recalled
from grounding.missing import targets, unknown_things, whats_missing
from grounding.world.scene import Scene

_OPEN_CLASSES = ("NN", "VB", "JJ")
_AUXILIARIES = frozenset("is are was were be been being am 's 're do does did has have had will would can could "
                         "should please".split())  # fmt: skip
_PRONOUNS = frozenset("it them that this those these they".split())
_HANDLED = frozenset(word for words in HANDLING.values() for word in words)


@dataclass(frozen=True)
class Unanswered:
    """Why there is no answer.

    Attributes:
        outcome: "no_referent" or "not_understood".
        explanation: one sentence, for people.
        words: that were not understood.
    """

    outcome: str
    explanation: str
    words: tuple[str, ...] = ()


def unanswered(tree: Phrase, scene: Scene, unknown: tuple[str, ...]) -> Unanswered:
    """Find out why a text names nothing.

    Args:
        tree: its likeliest parse.
        scene: the world.
        unknown: words that the grammar does not know.
    """
    asks = _asks(tree)
    things = _names_things(tree)
    strange = unknown_things(tree, scene.layout) if asks else ()
    heard = tuple(dict.fromkeys((*unknown, *strange)))
    if asks and (things or strange):
        if _recalls(tree):
            return Unanswered("no_referent", "nothing was handled before; say which block", heard)
        missing = whats_missing(tree, scene)
        hollow = next((p.text for p in tree.preorder() if p.tag == "NP"), tree.text)
        return Unanswered("no_referent", missing or f"nothing here is {hollow!r}", heard)
    pronouns = [leaf.text for leaf in tree.leaves if leaf.text in _PRONOUNS]
    if asks and pronouns:
        return _points_nowhere(pronouns[0], heard)
    if asks:
        return Unanswered("not_understood", "say what to handle: which block, row or tower", heard)
    heard = tuple(dict.fromkeys((*unknown, *_strange_words(tree))))
    if heard:
        return Unanswered("not_understood", f"I do not understand {', '.join(repr(word) for word in heard)}", heard)
    return Unanswered("not_understood", "this asks for no pick, place or clear")


def _points_nowhere(pronoun: str, heard: tuple[str, ...] = ()) -> Unanswered:
    why = f"I do not know what {pronoun!r} is, as nothing was spoken of before; say which block"
    return Unanswered("not_understood", why, heard)


def nothing_before(tree: Phrase) -> Unanswered | None:
    """What to say of a command for "it" before which the text names nothing; None for other texts."""
    first = next((p for p in tree.preorder() if p.tag == "NP"), None)
    if first is None or len(first.leaves) != 1 or first.leaves[0].text not in _PRONOUNS:
        return None
    return _points_nowhere(first.leaves[0].text) if _asks(tree) else None


def open_options(tree: Phrase, scene: Scene) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """All that the bare noun of what is asked for may mean, as (action, ids); none where it is not there.

    Args:
        tree: the likeliest parse.
        scene: the world.
    """
    if not _asks(tree) or _recalls(tree) or whats_missing(tree, scene) is not None:
        return ()
    doing = next((k for k, verbs in HANDLING.items() for leaf in tree.leaves if leaf.text in verbs), "pick")
    for target in targets(tree):
        noun = read_noun(target)
        if noun.head == "block" and not noun.strange:
            fits = kind.fitting(scene, noun.types, noun.colors)
            return tuple((doing, (scene.layout.ids[i],)) for i in range(scene.n) if fits[i] > 0)
    return ()


def _recalls(tree: Phrase) -> bool:
    """Whether a text speaks of what was handled before."""
    return any(is_surely_recalled(read_noun(phrase)) for phrase in tree.preorder() if phrase.tag == "NP")


def _asks(tree: Phrase) -> bool:
    """Whether something is asked for: a verb of handling, or a thing that is named with an article."""
    if any(leaf.text in _HANDLED for leaf in tree.leaves):
        return True
    return _names_things(tree) or (tree.tag == "NP" and tree.leaves[0].tag == "DT")


def _names_things(tree: Phrase) -> bool:
    return any(p.tag == "NP" and read_noun(p).head in ("block", "container") and not read_noun(p).strange
               for p in tree.preorder())  # fmt: skip


def _strange_words(tree: Phrase) -> list[str]:
    return [
        leaf.text
        for leaf in tree.leaves
        if leaf.tag[:2] in _OPEN_CLASSES and not meanings(leaf.text) and not _known(leaf.text)
    ]


def _known(text: str) -> bool:
    """Whether a word means something to the lexicon, or is one that only joins others."""
    return bool(text in _AUXILIARIES or text in _HANDLED or w.directions(text) or w.distance(text) or w.place(text)
                or w.containers(text) or w.is_block(text) or w.is_table(text) or w.is_measure(text) or w.agent(text)
                or w.is_middle(text) or w.is_lone(text) or w.is_other(text) or w.is_touching(text)
                or w.is_beside(text) or w.is_between(text) or w.is_surrounded(text))  # fmt: skip
