"""Sentences whose subject gives or gets what is moved: "the tower loses its top", "the row gains a block from X"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from grounding.graded.discourse.parts import Parts
from grounding.graded.discourse.verbs import GAINING, LOSING, MAKING
from grounding.graded.nouns import Noun, read_noun
from grounding.language.tree import Phrase, Word

_BRINGING = frozenset("from using moving taking placing stacking putting adding by".split())
_THINGS = ("block", "container", "place")


def given(verbs: list[str], parts: Parts, subjects: Sequence[Noun]) -> Noun | None:
    """What is moved where the subject only gives or gets it; None where it does neither.

    Args:
        verbs: of the clause.
        parts: of the clause.
        subjects: its subjects that name something, read.
    """
    if any(v in MAKING for v in verbs) and not any(s.head == "block" for s in subjects):
        return _brought(*parts.objects, *parts.rest)
    if not subjects:
        return None
    subject = subjects[0]
    if any(v in LOSING for v in verbs):
        of_it = Phrase("PP", (Word("of", "IN", 0), parts.named[0]))
        return replace(subject, head="block", kinds=(), directions=("up",), number=None, ordinals=(), distance=None,
                       size=0, middle=False, colors=(), modifiers=(of_it,))  # fmt: skip
    if any(v in GAINING for v in verbs) and subject.head in ("block", "container"):
        return _brought(*parts.objects, *parts.rest)
    return None


def gained(verbs: list[str], parts: Parts) -> list[Phrase]:
    """Where to, where somebody gives or receives: onto what gains it, or as a further clause tells."""
    clauses = [p for phrase in (*parts.objects, *parts.rest) for p in phrase.preorder() if p.tag == "SBAR"][:1]
    subjects = parts.named
    if any(v in LOSING for v in verbs) or not subjects or not any(v in GAINING for v in verbs):
        return clauses
    where = [p for p in parts.rest if p.tag == "PP" and p.leaves[0].text not in ("from", "using", "by", "with")]
    return [Phrase("PP", (Word("on", "IN", 0), subjects[0])), *where, *clauses]


def _brought(*phrases: Phrase) -> Noun | None:
    """What "by moving X", "using X", "coming from X" name."""
    for phrase in phrases:
        for part in phrase.preorder():
            if part.tag in ("PP", "VP", "S") and any(word.text in _BRINGING for word in part.words):
                inner = next((p for p in part.preorder() if p.tag == "NP" and read_noun(p).head in _THINGS), None)
                if inner is not None:
                    noun = read_noun(inner)
                    return replace(noun, head="block") if noun.head == "place" else noun
    return None
