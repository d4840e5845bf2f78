"""Phrases that a parse tore apart, put together: "grid" "center", "the upper of" two, "it" "'s nearest neighbour"."""

from __future__ import annotations

from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.meaning.discourse.verbs import GAINING, LOOKING, LOSING, PARTING
from grounding.meaning.nouns import read_words

_PARTICLES = frozenset(("'s",))
_ONLY = frozenset("just only simply".split())
_SETTING = frozenset("put set lay place".split())
_DETERMINERS = frozenset("the a an this that these those its one two three".split())


def mended(phrase: Phrase) -> Phrase:
    """A phrase whose torn parts are put together; the same one where nothing is torn."""
    children = tuple(mended(child) if isinstance(child, Phrase) else child for child in phrase.children)
    children = _sided(children)
    children = _centred(_chosen(_owned(children, within=phrase.tag != "S")))
    if phrase.tag == "SBAR" and len(children) == 2 and isinstance(children[1], Phrase) and children[1].tag == "NP":
        return Phrase("PP", children)
    if phrase.tag == "VP":
        children = _set_down(children)
    only = [child for child in children if not (isinstance(child, Word) and child.text in _ONLY)]
    if phrase.tag == "PP" and len(only) == 1 < len(children) and isinstance(only[0], Phrase) and only[0].tag == "NP":
        return only[0]  # "just the middle one"
    if phrase.tag == "PP" and isinstance(children[0], Word) and children[0].text in LOOKING:
        return Phrase("VP", children)
    if phrase.tag == "PP":
        children = _ranking(children)
    if phrase.tag in ("NP", "VP"):
        children = _denied(children)
    if len(children) == len(phrase.children) and all(a is b for a, b in zip(children, phrase.children, strict=True)):
        return phrase
    return Phrase(phrase.tag, children)


def as_sentence(phrase: Phrase) -> Phrase:
    """A noun phrase with what was read as a relation, though its first word is a verb: "(the tower) (claims X)"."""
    if phrase.tag != "NP" or len(phrase.children) < 2:
        return phrase
    last = phrase.children[-1]
    if not isinstance(last, Phrase) or last.tag != "PP" or not isinstance(last.children[0], Word):
        return phrase
    verb = last.children[0].text
    if not (verb in GAINING or verb in LOSING or verb in PARTING):
        return phrase
    before = phrase.children[:-1]
    subject = before[0] if len(before) == 1 and isinstance(before[0], Phrase) else Phrase("NP", before)
    return Phrase("S", (subject, Phrase("VP", last.children)))


Children = tuple[Phrase | Word, ...]


def _sided(children: Children) -> Children:
    """For example "on (the right) (table)": one of several tables, named by its side."""
    found: list[Phrase | Word] = []
    for child in children:
        before = found[-1] if found else None
        bare = isinstance(child, Phrase) and child.tag == "NP" and len(child.children) == 1 and w.is_table(child.text)
        side = isinstance(before, Phrase) and before.tag == "NP" and not before.phrases and w.directions(
            before.leaves[-1].text)  # fmt: skip
        if bare and side and isinstance(before, Phrase) and isinstance(child, Phrase):
            found[-1] = Phrase("NP", (*before.children, *child.children))
        else:
            found.append(child)
    return tuple(found)


def _set_down(children: Children) -> Children:
    """For example "(put) (down the block)": a particle of the verb, no way to go."""
    if len(children) < 2 or not isinstance(children[0], Word) or children[0].text not in _SETTING:
        return children
    phrase = children[1]
    if not isinstance(phrase, Phrase) or phrase.tag != "PP" or [word.text for word in phrase.words] != ["down"]:
        return children
    down = Phrase("PRT", (Word("down", "RP", phrase.leaves[0].index),))
    return (children[0], down, *phrase.phrases, *children[2:])


def _centred(children: Children) -> Children:
    """For example "right of (grid)" "(center)": the middle of the table."""
    found: list[Phrase | Word] = []
    for child in children:
        before = found[-1] if found else None
        joined = None
        if isinstance(child, Phrase) and isinstance(before, Phrase) and w.is_middle(child.text):
            joined = _with_centre(before, child.leaves[0])
        if joined is None:
            found.append(child)
        else:
            found[-1] = joined
    return tuple(found)


def _with_centre(phrase: Phrase, centre: Word) -> Phrase | None:
    """A phrase that ends in a bare name of the table, with its middle instead; None where it does not."""
    last = phrase.children[-1] if phrase.children else None
    if isinstance(last, Phrase):
        deeper = _with_centre(last, centre)
        return None if deeper is None else Phrase(phrase.tag, (*phrase.children[:-1], deeper))
    if isinstance(last, Word) and phrase.tag == "NP" and w.is_table(last.text) and not phrase.phrases:
        return Phrase("NP", (*phrase.children, centre))
    return None


def _ranking(children: Children) -> Children:
    """For example "((the furthest) from (you))": a rank, which was read as a measure."""
    first = children[0]
    if not isinstance(first, Phrase) or first.tag != "NP" or first.phrases or len(children) < 2:
        return children
    rank = first.words[-1]
    plain = all(word.text in _DETERMINERS for word in first.words[:-1])
    if not (plain and w.is_ranking(rank.text) and w.distance(rank.text) and isinstance(children[1], Word)):
        return children
    return (rank, *children[1:])


def _denied(children: Children) -> Children:
    """For example "(the block that is (not red)) (or blue)": what is denied further, which was read as a relation."""
    found: list[Phrase | Word] = []
    for child in children:
        before = found[-1] if found else None
        whole = None
        if isinstance(child, Phrase) and isinstance(before, Phrase) and child.leaves[0].text == "or":
            rest = child.leaves[1:]
            if len(rest) == 1 and read_words(rest).colors:
                whole = _with_denied(before, child.leaves)
        if whole is None:
            found.append(child)
        else:
            found[-1] = whole
    return tuple(found)


def _with_denied(phrase: Phrase, further: tuple[Word, ...]) -> Phrase | None:
    """A phrase that ends in a denial, with more words in that; None where it does not."""
    last = phrase.children[-1] if phrase.children else None
    if isinstance(last, Phrase):
        deeper = _with_denied(last, further)
        return None if deeper is None else Phrase(phrase.tag, (*phrase.children[:-1], deeper))
    first = phrase.children[0] if phrase.children else None
    if phrase.phrases or not isinstance(first, Word) or not w.is_negation(first.text):
        return None
    return Phrase("PP", (first, Phrase("NP", (*phrase.words[1:], *further))))


def _chosen(children: Children) -> Children:
    """For example "(the upper of (the two))": a thing, which was read as a relation."""
    return tuple(_as_thing(child) if isinstance(child, Phrase) else child for child in children)


def _as_thing(phrase: Phrase) -> Phrase:
    words, rest = phrase.words, phrase.phrases
    if phrase.tag != "PP" or len(words) != 3 or [child.tag for child in rest] != ["NP"]:
        return phrase
    article, which, of = words
    if article.text != "the" or of.text != "of" or not w.directions(which.text):
        return phrase
    return Phrase("NP", (Phrase("NP", (article, which)), Phrase("PP", (of, rest[0]))))


def _owned(children: Children, *, within: bool) -> Children:
    """For example "takes (it ('s nearest box))": what is its own, which was read as what it is.

    Args:
        children: of a phrase.
        within: whether "it" and the rest may be children of the phrase itself.
    """
    found: list[Phrase | Word] = []
    for child in children:
        owner = found[-1] if found else None
        verbal = isinstance(child, Phrase) and child.tag in ("S", "VP")
        if within and verbal and isinstance(child, Phrase) and isinstance(owner, Phrase) and owner.text == "it":
            verb = child.phrases[0] if child.tag == "S" and len(child.children) == 1 and child.phrases else child
            together = Phrase("S", (owner, verb))
            own = _as_own(together)
            if own is not together:
                found[-1] = own
                continue
        found.append(_as_own(child) if isinstance(child, Phrase) else child)
    return tuple(found)


def _as_own(phrase: Phrase) -> Phrase:
    if phrase.tag != "S" or len(phrase.phrases) != 2 or phrase.words or phrase.phrases[0].text != "it":
        return phrase
    verb = phrase.phrases[1]
    first = verb.children[0] if verb.children else None
    if not isinstance(first, Word) or first.text not in _PARTICLES or len(verb.children) != 2 or not verb.phrases:
        return phrase
    thing = verb.phrases[0]
    if thing.tag == "S" and thing.phrases and thing.phrases[0].tag == "NP":
        thing = thing.phrases[0]  # "its nearest cube to grow by"
    if thing.tag != "NP" or thing.leaves[0].text in _DETERMINERS or not w.is_ranking(thing.leaves[0].text):
        return phrase
    its = Word("its", "PRP$", phrase.leaves[0].index)
    return _begun(thing, its)


def _begun(phrase: Phrase, word: Word) -> Phrase:
    """A noun phrase with a word before its first one."""
    first = phrase.children[0]
    start = (_begun(first, word),) if isinstance(first, Phrase) else (word, first)
    return Phrase(phrase.tag, (*start, *phrase.children[1:]))
