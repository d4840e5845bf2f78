"""Noun phrases as trees, built of words as the parser would have read them."""

from __future__ import annotations

from grounding.language.tree import Phrase, Word

_TAGS = {"the": "DT", "a": "DT", "of": "IN", "to": "TO", "on": "IN", "in": "IN", "at": "IN", "next": "JJ",
         "behind": "IN", "from": "IN", "under": "IN", "me": "PRP", "you": "PRP", "my": "PRP$",
         "your": "PRP$"}  # fmt: skip
_NOUNS = frozenset("left right front back top bottom middle table row column tower circle group corner side".split())


def _word(text: str, place: int) -> Word:
    return Word(text, _TAGS.get(text, "NN" if text in _NOUNS else "JJ"), place)


def noun_phrase(text: str) -> Phrase:
    """A noun phrase of words only; the last one is its noun."""
    *before, noun = text.split()
    return Phrase("NP", (*(_word(word, i) for i, word in enumerate(before)), Word(noun, "NN", len(before))))


def modifier(words: str, reference: Phrase | None = None) -> Phrase:
    """A modifier: words before a reference, or before the noun phrase that its own last words are."""
    texts = words.split()
    if reference is None:
        start = next((i for i, text in enumerate(texts) if text in ("the", "my", "your", "me", "you")), len(texts))
        if texts[-3:-2] == ["of"] or "of" in texts[start:]:
            place = texts.index("of", start)
            inner = modifier("of", noun_phrase(" ".join(texts[place + 1 :])))
            reference = modified(noun_phrase(" ".join(texts[start:place])), inner)
        else:
            reference = noun_phrase(" ".join(texts[start:]))
        texts = texts[:start]
    elif texts[-1] == "of" and len(texts) > 2:
        inner = noun_phrase(" ".join(texts[1:-1]))
        reference, texts = modified(inner, modifier("of", reference)), texts[:1]
    return Phrase("PP", (*(_word(text, i) for i, text in enumerate(texts)), reference))


def modified(noun: Phrase, following: Phrase) -> Phrase:
    """A noun phrase with a modifier behind it."""
    return Phrase("NP", (noun, following))
