"""Words that speak against acting: what is forbidden, or told of the past, must not be done."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from grounding.language.tree import Phrase
from grounding.meaning.discourse.verbs import BEING, HANDLING, HAVING, LOOKING, MAKING

_NEGATIONS = frozenset(("not", "n't", "never", "don't", "dont"))
_NONE = frozenset(("0", "zero", "no"))
_ASKING = frozenset("what which how where who whose why when is are does did was were".split())
_OTHER_DEEDS = frozenset("let show".split())  # whatever follows
_POLITE = frozenset("please robot baxter hey hi hello ok okay now so then and you can could would will kindly just "
                    "well no yes yeah nope nah not oh ah uh um hm hmm alright right fine sure".split())  # fmt: skip
_PLACING = frozenset(HANDLING["place"])
_BESIDE = frozenset("on onto atop upon to beside behind under below above near".split())
_STATING = frozenset(("is", "are", "'s", "does", "was", "were", "am", "be", "will", "would", "should", "has", "have"))
_HANDLED = frozenset(word for verbs in HANDLING.values() for word in verbs)
_CLAUSES = ("VP", "S")


def forbidden(tree: Phrase) -> str | None:
    """The reason why a text must not be acted upon, as a sentence for people; None where nothing speaks against it.

    A negation forbids where it stands with the verb of a command ("do not touch the tower"); in what describes things
    ("the one that is not blue", "it is not near the tower") it tells which is meant.

    Args:
        tree: the parse.
    """
    texts = [leaf.text for leaf in tree.leaves]
    if not _HANDLED & set(texts):
        if texts[0] in _ASKING:
            return "that is a question; I pick up, place and clear: say what to handle"
        verb = _other_deed(tree)
        if verb is not None:
            return f"I cannot {verb!r} things; I pick up, place and clear"
    verb = next((leaf.text for leaf in tree.leaves if leaf.text not in _POLITE), "")
    if verb in _OTHER_DEEDS:
        return f"I cannot {verb!r} things; I pick up, place and clear"
    nowhere = _nowhere(texts)
    if nowhere is not None:
        return nowhere
    clauses = _commands(tree)
    named = (phrase for clause in clauses for phrase in _objects(clause))
    nothing = next((phrase for phrase in named if phrase.leaves[0].text in _NONE), None)
    if nothing is not None:
        return f"{nothing.text!r} is nothing to handle; say which block"
    denied = [clause for clause in clauses if _denies(clause)]
    if denied and len(denied) == len(clauses):
        text = denied[0].text.replace(" n't", "n't")
        return f"{text!r} tells me what not to do; say what to do"
    return None


def _other_deed(tree: Phrase) -> str | None:
    """The verb of a text that commands nothing that can be done, and does not only say where to look or how things are.

    Told by its place and its tag, so that no verb needs to be known: "tap the block".
    """
    first = next((leaf for leaf in tree.leaves if leaf.text not in _POLITE), None)
    if first is None or first.text in LOOKING | BEING | MAKING | HAVING:
        return None
    commands = first.tag in ("VB", "VBP") and any(phrase.tag in ("NP", "PP") for phrase in tree.preorder())
    return first.text if commands or first.text in _OTHER_DEEDS else None


def _nowhere(texts: Sequence[str]) -> str | None:
    """The reason why a place that is named cannot be one."""
    if not _PLACING & set(texts):
        return None
    for before, text in pairwise(texts):
        if text == "itself" and before in _BESIDE:
            return "nothing can be put on or beside itself; say where else"
        if text == "floor" and before in ("the", "on", "onto"):
            return "I cannot reach the floor; say a place on the table"
    return None


def without_forbidden(tree: Phrase) -> Phrase:
    """The tree without the sentences that forbid, where others tell what to do."""
    if tree.tag != "FRAG" or not any(_denies(clause) for clause in tree.phrases):
        return tree
    kept = tuple(child for child in tree.children if not (isinstance(child, Phrase) and _denies(child)))
    return Phrase(tree.tag, kept) if any(isinstance(child, Phrase) for child in kept) else tree


def _commands(tree: Phrase) -> list[Phrase]:
    return [clause for child in tree.phrases for clause in _commands(child)] if tree.tag == "FRAG" else [tree]


def _denies(clause: Phrase) -> bool:
    """Tells whether the verb of a clause is denied, not what the clause says of things."""
    for phrase in _verbal(clause):
        texts = [leaf.text for word in phrase.children for leaf in ([word] if not isinstance(word, Phrase) else
                 word.leaves if word.tag in ("PP", "ADVP", "PRT") and len(word.leaves) <= 2 else [])]  # fmt: skip
        place = next((i for i, text in enumerate(texts) if text in _NEGATIONS), None)
        if place is not None and not _STATING & set(texts) and not _HANDLED & set(texts[:place]):
            return True
    return False


def _objects(clause: Phrase) -> list[Phrase]:
    """The things that the verbs of a clause handle, or the clause itself where it is a noun phrase."""
    if clause.tag == "NP":
        return [clause]
    return [child for phrase in _verbal(clause) if phrase.tag == "VP" for child in phrase.phrases if child.tag == "NP"]


def _verbal(clause: Phrase) -> list[Phrase]:
    """The clause and the verb phrases it is made of, outside of what modifies things."""
    if clause.tag not in _CLAUSES:
        return []
    return [clause, *(deeper for child in clause.phrases for deeper in _verbal(child))]
