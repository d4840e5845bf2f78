"""Where one sentence of a text ends and the next begins: at marks, and where a command begins without one."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from grounding.language.tokens import Token

_COMMANDS = frozenset("take move put place pick set stack slide shift position grab lift push get select choose "
                      "remove".split())  # fmt: skip
_VERBS_ONLY = frozenset("take move put pick grab".split())
_JOINING = frozenset("and then or to".split())
_CLAUSES = frozenset("if when while after before once as".split())
_LEADING = frozenset("and then or to you i we can should will must please the a of on in not now".split())
_PREPOSITIONS = frozenset("in on at of from near to with by for".split())
_BEING = frozenset("is are there 's".split())
_DASHES = frozenset("-–—―")
_CLAUSE = 3  # words on either side of a dash that ends a sentence
_LONG = 5  # words, after which a command that follows a comma is a sentence of its own
_THERE = 4  # words that "there are two blocks" has


def split_sentences(tokens: Sequence[Token]) -> tuple[tuple[Token, ...], ...]:
    """The words of each sentence, without punctuation; sentences without words are left out.

    A dash by itself ends one where enough words stand on either side: "there are two on the left - take the near one".
    """
    return _split(tokens, at_commands=False)


def part_commands(
    tokens: Sequence[Token], is_verb: Callable[[str], bool] = lambda word: True
) -> tuple[tuple[Token, ...], ...]:
    """The same, parted before commands as well that run into what was said before.

    For example "there are two blocks on the left take the lower one", "... on the left Take the lower one" and "the box
    is the highest, place it on the tower". A text without verbs is parted at its commas: "the far row, middle block".

    Args:
        tokens: of a text.
        is_verb: tells whether a word is mostly one.
    """
    parted = not any(is_verb(token.text) for token in tokens)
    return _split(tokens, at_commands=True, at_commas=parted)


def _split(tokens: Sequence[Token], *, at_commands: bool, at_commas: bool = False) -> tuple[tuple[Token, ...], ...]:
    sentences: list[list[Token]] = [[]]
    parted = False
    for place, token in enumerate(tokens):
        if at_commands and sentences[-1] and _begins(token, sentences[-1], parted):
            sentences.append([])
        parted = token.text == ","
        ends = token.ends_sentence or token.text == ":" or (at_commas and token.text == ",")
        if ends or (token.text in _DASHES and _sets_apart(tokens, place)):
            sentences.append([])
        elif token.is_word:
            sentences[-1].append(token)
    return tuple(tuple(sentence) for sentence in sentences if sentence)


def _sets_apart(tokens: Sequence[Token], dash: int) -> bool:
    before, after = tokens[max(0, dash - _CLAUSE) : dash], tokens[dash + 1 : dash + 1 + _CLAUSE]
    return all(len(side) == _CLAUSE and all(token.is_word for token in side) for side in (before, after))


def _begins(token: Token, before: Sequence[Token], parted: bool) -> bool:
    """Whether a command begins though no mark ends the sentence before it.

    Args:
        token: the next word.
        before: the words of the sentence so far, at least one.
        parted: whether a comma stands between.
    """
    if token.text not in _COMMANDS:
        return False
    if token.original.istitle() and before[-1].original.islower():
        return True
    first, last = before[0].text, before[-1].text
    if parted and (first not in _PREPOSITIONS or _BEING & {word.text for word in before}):
        return last not in _JOINING and (first not in _COMMANDS | _CLAUSES or len(before) > _LONG)
    there = first in ("there", "here") and len(before) > _THERE
    return there and token.text in _VERBS_ONLY and last not in _LEADING
