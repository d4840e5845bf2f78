"""What a phrase's features look at: its words, its children's groundings, the world, and the sets it may mean."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from grounding.features.fitting import Fitting
from grounding.features.sets import NamedSets
from grounding.features.sources import NOTHING, Source, child_roles, digest, merge
from grounding.geometry.layout import Layout
from grounding.geometry.masks import single
from grounding.language.lexicon import is_plural, is_universal, meanings
from grounding.language.tree import Phrase
from grounding.lazy import lazy
from grounding.symbols import Cardinal, Ordinal, SpatialReference, Symbol

_HEAD_TAGS = ("NN", "NNS", "NNP", "NNPS", "CD", "PRP")


class Scope:
    """One phrase λ with the groundings Φ of its children in the world Υ.

    Args:
        phrase: λ.
        children: the symbols that each child phrase is grounded to, in the order of `phrase.phrases`.
        layout: Υ, measured.
        concrete: the concrete symbols that λ itself is taken to express; empty while those are inferred.
        abstract: the abstract symbols that λ itself is taken to mean; empty while those are inferred.
    """

    def __init__(
        self,
        phrase: Phrase,
        children: Sequence[frozenset[Symbol]],
        layout: Layout,
        concrete: frozenset[Symbol] = frozenset(),
        abstract: frozenset[Symbol] = frozenset(),
    ) -> None:
        self.phrase = phrase
        self.layout = layout
        self.children = tuple(children)
        self.concrete = concrete
        self.abstract = abstract

    @property
    def stage(self) -> int:
        """What is to be judged next: 0 the concrete symbols, 1 the abstract ones, 2 objects and actions."""
        return self._stage

    _stage = 0
    _shared = ("child_sources", "spoken_facts", "below", "named", "plural", "universal")
    _settled = ("own", "sources", "sets", "fitting", "settled_facts")

    def with_concrete(self, concrete: frozenset[Symbol]) -> Scope:
        """The same phrase, its concrete symbols settled."""
        return self._next(1, Scope(self.phrase, self.children, self.layout, concrete), self._shared)

    def with_abstract(self, abstract: frozenset[Symbol]) -> Scope:
        """The same phrase, its abstract symbols settled too."""
        scope = Scope(self.phrase, self.children, self.layout, self.concrete, abstract)
        return self._next(2, scope, (*self._shared, *self._settled))

    def _next(self, stage: int, scope: Scope, kept: Sequence[str]) -> Scope:
        scope.__dict__.update({name: value for name, value in self.__dict__.items() if name in kept})
        scope._stage = stage
        return scope

    @lazy
    def own_abstract(self) -> Source:
        """What the abstract symbols of the phrase itself say."""
        return digest(self.abstract, self.layout)

    @lazy
    def child_sources(self) -> dict[str, Source]:
        """What the children say, by their roles."""
        found: dict[str, list[Source]] = {}
        for role, symbols in zip(child_roles(self.phrase), self.children, strict=True):
            found.setdefault(role, []).append(digest(symbols, self.layout))
        return {role: s[0] if len(s) == 1 else merge(s, self.layout) for role, s in found.items()}

    @lazy
    def told_objects(self) -> tuple[tuple[int, tuple[str, ...]], ...]:
        """The objects that each child has grounded to, if any, with the roles that its members have."""
        left_out = "head" if self.sets.ranked_again else None
        return tuple(
            (source.objects, (f"in {role}", f"is {role}") if single(source.objects) else (f"in {role}",))
            for role, source in self.child_sources.items()
            if source.objects and role != left_out
        )

    @lazy
    def below(self) -> Source:
        """What words within the head name and its grounding no longer tells: "the two nearest", once found, are two."""
        head = self.source_of_head
        if head is None or head[1].relations or head[1].numbers:
            return NOTHING
        named = frozenset(symbol for text in _spoken(head[0]) for symbol in meanings(text))
        return digest(frozenset(s for s in named if isinstance(s, SpatialReference | Cardinal | Ordinal)), self.layout)

    @lazy
    def source_of_head(self) -> tuple[Phrase, Source] | None:
        """The head child with what it says, if there is one."""
        for role, child in zip(child_roles(self.phrase), self.phrase.phrases, strict=True):
            if role == "head":
                return child, self.child_sources["head"]
        return None

    @lazy
    def own(self) -> Source:
        """What the concrete symbols of the phrase itself say."""
        return digest(self.concrete, self.layout)

    @lazy
    def sources(self) -> dict[str, Source]:
        """What the phrase and its children say, by role; "own" first."""
        return {"own": self.own, **self.child_sources, "below": self.below}

    def source(self, role: str) -> Source:
        """What a part says; nothing where there is no such part."""
        return self.sources.get(role, NOTHING)

    @lazy
    def named(self) -> dict[Symbol, tuple[str, ...]]:
        """Symbols that the phrase's own words may name, with how they are named: as its head or by a tag."""
        heads = [word for word in self.phrase.words if word.tag in _HEAD_TAGS]
        head = heads[-1] if heads else None
        found: dict[Symbol, list[str]] = {}
        for word in self.phrase.words:
            how = "head" if word is head else word.tag
            for symbol in meanings(word.text):
                found.setdefault(symbol, []).append(how)
        return {symbol: tuple(how) for symbol, how in found.items()}

    @lazy
    def plural(self) -> bool:
        """Whether the phrase's own head noun is plural."""
        return any(is_plural(word.tag) for word in self.phrase.words)

    @lazy
    def universal(self) -> bool:
        """Whether the phrase's own words mean all of a set."""
        return any(is_universal(word.text) for word in self.phrase.words)

    @lazy
    def sets(self) -> NamedSets:
        """The sets of objects that the phrase may mean."""
        return NamedSets(self.sources, self.layout)

    @lazy
    def fitting(self) -> Fitting:
        """The arrangements that the phrase may mean."""
        return Fitting(self.sources, self.sets, self.layout)


def _spoken(phrase: Phrase) -> Iterator[str]:
    """The words of a phrase, of its head, and of its prepositional phrases themselves."""
    for word in phrase.words:
        yield word.text
    for role, child in zip(child_roles(phrase), phrase.phrases, strict=True):
        if role == "head":
            yield from _spoken(child)
        elif child.tag == "PP":
            yield from (word.text for word in child.words)
