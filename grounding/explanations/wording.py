"""Meanings of facts and roles in the words of the phrase at hand: "the head phrase" becomes what it reads."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from grounding.features.blanks import PARTS, WHO
from grounding.features.explained import explain_fact, explain_role
from grounding.features.scope import Scope
from grounding.features.sources import child_roles
from grounding.symbols import LAST

_RANKED = re.compile(r"^(?:it is (?:among: )?)?of (.+), the one at (.+?)(?: rank)? along (.+)$")
_OF = re.compile(r"^(?:it is (?:among: )?)?of (.+?), (the .+|as many .+)$")
_ALL = "all things of the type and colour that are said"
_ORDINALS = {1: "the first", 2: "the second", 3: "the third", LAST: "the last"}
_NEGATED = (
    ("it is not ", "it is "), ("it is, ", "it is not, "), ("it is ", "it is not "),
    ("no own word may name it", "an own word may name it"), ("an own word may name it", "no own word may name it"),
    ("a word with ", "no word with "), ("the head word may ", "the head word may not "), ("of ", "not of "),
    ("acts on ", "does not act on "),
)  # fmt: skip


def role_in_words(role: str, family: str, scope: Scope) -> str:
    """What a role means here."""
    meaning = _role(role, family)
    return in_words(role if meaning is None else meaning, scope)


def fact_in_words(fact: str, family: str, scope: Scope) -> str:
    """What a fact of the context means here."""
    meaning = _fact(fact, family)
    return in_words(fact if meaning is None else meaning, scope)


@lru_cache(maxsize=8192)
def _role(role: str, family: str) -> str | None:
    found = explain_role(role, family)
    return None if found is None else found.meaning


@lru_cache(maxsize=8192)
def _fact(fact: str, family: str) -> str | None:
    found = explain_fact(fact, family)
    return None if found is None else found.meaning


def in_words(meaning: str, scope: Scope) -> str:
    """A meaning with directions, ranks and phrases filled in from a scope."""
    for who, words in WHO.items():
        source = scope.own_abstract if who == "own" and scope.own_abstract.attributes else scope.sources.get(who)
        if source is None:
            continue
        if len(source.relations) == 1:
            meaning = meaning.replace(f"the direction that {words} says", f'"{source.relations[0]}"')
        if len(source.indices) == 1:
            meaning = meaning.replace(f"the rank that {words} says", _ordinal(source.indices[0]))
        for attribute in source.attributes[:1]:
            ranked = "those" if attribute.index is None else _ordinal(attribute.index)
            ranked += f' along "{attribute.relation}"' if attribute.relation else ""
            if ranked != "those":
                meaning = meaning.replace(f"the one that the attribute of {words} ranks", ranked)
    meaning = meaning.replace(_ALL, _every(scope))
    for role, words in _texts(scope).items():
        meaning = re.sub(rf"\b{re.escape(PARTS[role])}\b", words.replace("\\", r"\\"), meaning)
    return _OF.sub(r"it is, of \1, \2", _RANKED.sub(r"it is \2 along \3 of \1", meaning))


def _ordinal(rank: int) -> str:
    return _ORDINALS.get(rank, f"number {rank}")


def _every(scope: Scope) -> str:
    sources = [scope.own, *scope.child_sources.values()]
    colors = {color for source in sources for color in source.colors}
    types = {name for source in sources for name in source.types}
    kind = types.pop() + "s" if len(types) == 1 else "things"
    return f"all {colors.pop()} {kind}" if len(colors) == 1 else f"all {kind}"


def _texts(scope: Scope) -> Mapping[str, str]:
    """The words of every child, by its role."""
    found: dict[str, list[str]] = {}
    for role, child in zip(child_roles(scope.phrase), scope.phrase.phrases, strict=True):
        found.setdefault(role, []).append(f'"{child.text}"')
    return {role: " and ".join(texts) for role, texts in found.items() if role != "prt"}


def negated(meaning: str) -> str:
    """That a meaning does not hold."""
    for start, other in _NEGATED:
        if meaning.startswith(start):
            return other + meaning[len(start) :]
    for verb in (" is ", " are ", " has ", " have "):
        if verb in meaning:
            subject, rest = meaning.split(verb, 1)
            if len(subject.split()) <= 4:
                return f"{subject}{verb}not {rest}"
    return f"not so: {meaning}"
