"""The facts of the context that roles are crossed with: words, tags, what the children are and grounded to."""

from __future__ import annotations

from grounding.features.scope import Scope
from grounding.features.sources import Source, child_roles
from grounding.language.lexicon import alike, is_superlative, is_universal, meanings, size_order
from grounding.language.tree import Phrase
from grounding.symbols import Symbol, sided

_CLOSED_TAGS = ("DT", "PDT", "IN", "TO", "PRP", "PRP$", "CC", "CD")


def word_facts(scope: Scope) -> list[str]:
    """What the phrase's own words and its make-up tell."""
    phrase = scope.phrase
    roles = child_roles(phrase)
    facts = ["bias", f"tag={phrase.tag}", f"shape={phrase.tag}:{'+'.join(roles)}"]
    if scope.plural:
        facts.append("plural")
    for word in phrase.words:
        facts.append(f"word={alike(word.text)}")
        if alike(word.text) == "<ordinal>":
            facts.append(f"rank={word.text}")
        facts.append(f"pos={word.tag}")
        if is_superlative(word.text) or word.tag in ("JJS", "RBS"):
            facts.append("superlative")
        if is_universal(word.text):
            facts.append("universal")
        if size_order(word.text):
            facts.append(f"size={size_order(word.text)}")
        if not meanings(word.text) and word.tag not in _CLOSED_TAGS:
            facts.append("unnamed word")
    facts += [f"says {kind}" for kind in sorted({type(symbol).__name__ for symbol in scope.named})]
    for role, child in zip(roles, phrase.phrases, strict=True):
        facts.append(f"{role}={child.tag}")
        preposition = _preposition(child)
        if preposition:
            facts.append(f"{role}:{preposition}")
        if any(word.text in ("a", "an", "another", "any", "one", "some") for word in child.words[:1]):
            facts.append(f"{role}:indefinite")
    return list(dict.fromkeys(facts))


def child_facts(scope: Scope) -> list[str]:
    """What the children have grounded to, by kinds of symbols."""
    facts = []
    for role, source in scope.child_sources.items():
        for name in ("types", "colors", "relations", "indices", "numbers", "kinds", "furniture", "containers",
                     "regions", "attributes", "collections", "actions"):  # fmt: skip
            if getattr(source, name):
                facts.append(f"{role} has {name}")
        if source.objects:
            facts.append(f"{role} has {'object' if source.objects & (source.objects - 1) == 0 else 'objects'}")
        if source.robot:
            facts.append(f"{role} has robot")
        if not source.symbols:
            facts.append(f"{role} has nothing")
        for attribute in source.attributes[:1]:
            facts.append(f"{role} ranks {_rank(attribute.index)}|{'along' if attribute.relation else '-'}")
        facts += [f"{role}.relation={sided(relation)}" for relation in source.relations]
        facts += [f"{role}.container={kind}" for kind, _ in source.containers]
        facts += [f"{role}.region={sided(region.relation)}" for region in source.regions]
        facts += [f"{role}.region of={region.kind}" for region in source.regions]
    if scope.child_sources:
        told = "+".join(f"{role}({_told(source)})" for role, source in scope.child_sources.items())
        joined = ",".join(filter(None, map(_preposition, scope.phrase.phrases)))
        facts += [f"composed {told}", f"composed {told} by {joined}"]
    head, mod = scope.source("head"), scope.source("mod")
    if head.relations and mod.relations:
        prepositions = [_preposition(c) for c in scope.phrase.phrases if c.tag == "PP"]
        facts.append(f"two relations:{sided(head.relations[0])}:{prepositions[0] if prepositions else ''}")
    return facts


def own_facts(scope: Scope) -> list[str]:
    """What the settled concrete symbols tell, and which sets exist."""
    own = scope.own
    facts = []
    for name in ("types", "colors", "relations", "indices", "numbers", "kinds"):
        if getattr(own, name):
            facts.append(f"own {name}")
    facts += [f"own.relation={sided(relation)}" for relation in own.relations]
    facts += [f"own.index={_rank(index)}" for index in own.indices]
    facts += [f"own.kind={kind}" for kind in own.kinds]
    if scope.phrase.words:
        number = "several" if scope.plural else "one"
        every = "all " if scope.universal else ""
        article = "the " if any(word.text in ("the", "these", "those") for word in scope.phrase.words) else ""
        facts.append(f"base {every}{article}{number} {_told(own)}")
    sets = scope.sets
    base = sets.base
    facts.append("nothing matches" if not base else "one matches" if base & (base - 1) == 0 else "many match")
    facts.append("stacked" if scope.layout.stacked(base) else "level")
    facts += [f"have {name}" for name in sets.named]
    for name, mask in sets.references.items():
        if not mask:
            facts.append(f"empty {name}")
    lists = scope.fitting.lists
    for name, arrangements in lists.items():
        facts.append(f"{min(len(arrangements), 2)} {name}")
    return facts


def abstract_facts(scope: Scope) -> list[str]:
    """What the settled abstract symbols tell."""
    source = scope.own_abstract
    facts = [f"own {name}" for name in ("containers", "regions", "attributes", "collections") if getattr(source, name)]
    facts += [f"own.container={kind}" for kind, _ in source.containers]
    for attribute in source.attributes[:1]:
        facts.append(f"own ranks {_rank(attribute.index)}|{'along' if attribute.relation else '-'}")
        facts.append(f"own ranks {_rank(attribute.index)}|{sided(attribute.relation or '-')}")
    return facts


def context_facts(scope: Scope) -> list[str]:
    """All facts of a phrase's context at the stage it is in, in a fixed order."""
    spoken = scope.__dict__.get("spoken_facts")
    if spoken is None:
        spoken = scope.__dict__["spoken_facts"] = [*word_facts(scope), *child_facts(scope)]
    if scope.stage == 0:
        return spoken
    settled = scope.__dict__.get("settled_facts")
    if settled is None:
        settled = scope.__dict__["settled_facts"] = [*spoken, *own_facts(scope)]
    return settled if scope.stage == 1 else [*settled, *abstract_facts(scope)]


def _told(source: Source) -> str:
    """In short what kinds of things a part speaks of."""
    kinds = {
        "d": source.relations, "i": source.indices, "n": source.numbers, "k": source.kinds, "C": source.containers,
        "R": source.regions, "A": source.attributes, "P": source.collections, "!": source.actions,
        "F": source.furniture, "B": source.robot,
    }  # fmt: skip
    objects = "" if not source.objects else "o" if source.objects & (source.objects - 1) == 0 else "O"
    return "".join(letter for letter, values in kinds.items() if values) + objects


def _rank(index: int | None) -> str:
    """Which rank, in short."""
    return "-" if index is None else "first" if index == 1 else "last" if index < 0 else "later"


def _preposition(phrase: Phrase) -> str:
    """The words of a prepositional phrase, without adverbs before them; "" for other phrases."""
    if phrase.tag != "PP":
        return ""
    return " ".join(alike(word.text) for word in phrase.words if word.tag not in ("RB", "RBR"))


def named_how(scope: Scope, symbol: Symbol) -> list[str]:
    """Roles that tell how the phrase's own words name a symbol."""
    how = scope.named.get(symbol)
    if how is None:
        return ["not named"]
    return [*(f"named by {way}" for way in how), "named"]
