"""Heads of phrases, after Collins: the child that a phrase is about, and the word that this comes down to.

The rules are those of M. Collins, "Head-driven statistical models for natural language parsing" (Computational
Linguistics 29(4), 2003), shortened to the phrases of instructions. As there, a noun phrase without phrases of its own
is set apart from one that has some.
"""

from __future__ import annotations

from collections.abc import Sequence

from grounding.language.tree import Phrase, Word

BASE_NP = "NPB"
_NOUNS = ("NN", "NNS", "NNP", "NNPS")
_NESTED = ("NP", "PP", "VP", "S", "SBAR")
# Phrase tag -> the tags looked for, in order of preference; the first child from the left with the tag is the head.
_FIRST = {
    "PP": (("IN", "TO", "JJ", "JJR", "JJS"),),
    "VP": (("VB", "VBZ", "VBP", "VBD", "VBG", "VBN"), ("VP",), ("MD",)),
    "S": (("VP",), ("S",), ("NP",)),
    "SQ": (("VP",), ("MD",)),
    "SBAR": (("S", "SQ"), ("VP",)),
    "PRT": (("RP",),),
    "ADJP": (("JJ", "JJR", "JJS"), ("VBN",), ("ADJP",)),
    "ADVP": (("RB", "RBR", "RBS"), ("ADVP",)),
}


def refined_tag(phrase: Phrase) -> str:
    """The tag of a phrase in the grammar: `BASE_NP` for a noun phrase without phrases of its own, else its own tag."""
    if phrase.tag == "NP" and not any(child.tag in _NESTED for child in phrase.phrases):
        return BASE_NP
    return phrase.tag


def plain_tag(tag: str) -> str:
    """The tag in the tree of a tag in the grammar."""
    return "NP" if tag == BASE_NP else tag


def head_index(tag: str, children: Sequence[Phrase | Word]) -> int:
    """Which child of a phrase is its head.

    Args:
        tag: the phrase's tag.
        children: at least one.
    """
    tags = [child.tag for child in children]
    if tag == "NP":
        return _head_of_noun_phrase(tags, [isinstance(child, Word) for child in children])
    for wanted in _FIRST.get(tag, ()):
        for index, child_tag in enumerate(tags):
            if child_tag in wanted:
                return index
    words = [index for index, child in enumerate(children) if isinstance(child, Word)]
    return words[-1] if words else 0


def _head_of_noun_phrase(tags: list[str], are_words: list[bool]) -> int:
    """The last noun; else the first noun phrase; else the last word."""
    nouns = [index for index, tag in enumerate(tags) if tag in _NOUNS]
    if nouns:
        return nouns[-1]
    if "NP" in tags:
        return tags.index("NP")
    words = [index for index, is_word in enumerate(are_words) if is_word]
    return words[-1] if words else 0
