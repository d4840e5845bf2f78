"""Annotates clauses: commands, wishes, statements, relative clauses, and texts of several sentences."""

from __future__ import annotations

from dataclasses import replace

from grounding.corpus.destinations import Destinations, parts_of
from grounding.corpus.meaning import Meaning, NotAnnotatable, is_empty, passed
from grounding.corpus.noun_phrases import NounPhrases
from grounding.corpus.words import LONE, directions
from grounding.geometry.masks import indices_of
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.symbols import Action, ObjectAttribute, ObjectColor, Region, SpatialReference, Symbol

_BEING = frozenset(
    "is are was were 's be been become becomes sits lies stands sit lie stand located positioned "
    "situated sitting standing lying".split()
)
_AUXILIARY = frozenset("to would will can could should must 'd have do does needs need gets".split())
_WANTING = frozenset(("want", "need", "like", "choose"))
_LOOKING = frozenset(("look", "see"))
_VERBS = {"touch": "pick", "find": "pick", "locate": "pick", "identify": "pick", "moves": "place", "goes": "place",
          "shifts": "place", "slides": "place", "jumps": "place", "drops": "place", "leaps": "place", "falls": "place",
          "hops": "place", "travels": "place", "comes": "place", "shift": "place", "reposition": "place",
          "joins": "place", "loses": "pick", "takes": "place", "go": "place", "moved": "place", "placed": "place",
          "stacked": "place", "positioned": "place", "add": "place", "pull": "place", "lands": "place"}  # fmt: skip
_PLACES = ("direction", "region", "several", "predicate")
_HANDLED = ("one", "many", "container")


class Clauses:
    """Clauses in one world."""

    def __init__(self, noun_phrases: NounPhrases, history: tuple[str, ...] = ()) -> None:
        self.noun_phrases = noun_phrases
        self.select = noun_phrases.select
        self.layout = noun_phrases.layout
        self.destinations = Destinations(noun_phrases)
        self.history = history

    def adjectives(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """Predicates of one or two words: "alone", "red", "closest"."""
        texts = [word.text for word in phrase.words if word.text not in ("all", "away", "very", "most")]
        if len(texts) != 1 or children:
            raise NotAnnotatable(f"ADJP {phrase.text!r}: construction not covered")
        if texts[0] in LONE:
            return Meaning("lone")
        for symbol in meanings(texts[0]):
            if isinstance(symbol, ObjectColor):
                return Meaning("color", frozenset({symbol}), color=symbol.name)
        named = directions(texts[0])
        if len(named) != 1:
            raise NotAnnotatable(f"ADJP {phrase.text!r}: construction not covered")
        return Meaning("direction", frozenset({SpatialReference(named[0])}), relation=named[0], preposition="",
                       comparative=phrase.words[-1].tag == "JJR")  # fmt: skip

    def verb_phrase(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """A verb phrase from its children's meanings."""
        texts = [word.text for word in phrase.words if word.tag != "UH"]
        told = [child for child in children if child.sort != "empty"]
        if "not" in texts or "n't" in texts:
            raise NotAnnotatable(f"VP {phrase.text!r}: what is not is not covered")
        verbs = [word.text for word in phrase.words if word.tag.startswith("VB")]
        verb = verbs[-1] if verbs else ""
        if not verbs or verbs[0] in _AUXILIARY or texts[0] in _AUXILIARY:
            if len(verbs) > 1 and verbs[-1] in ("moved", "placed", "picked"):
                return self._moved(phrase)
            return self._together(phrase, texts, told)
        if verb in _BEING:
            return self._being(phrase, texts, told)
        if verb in ("has", "have", "made", "formed") and len(told) == 1 and told[0].sort == "many":
            return replace(told[0], symbols=passed(told[0]), preposition="of")
        commands = any(word.tag == "VB" for word in phrase.words)
        if verb in ("touches", "touch", "hits", "reaches") and not commands:
            if len(told) != 1:
                raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
            return self.destinations.prepositions.region(phrase, told[0], "touching", "touching")
        if verb in ("moved", "placed", "put", "picked") and phrase.words[-1].tag != "VBN" and not told:
            return self._moved(phrase)
        if verb in _WANTING and len(told) == 1 and told[0].sort == "action":
            return told[0]
        if verb in _LOOKING:
            if len(told) == 1 and told[0].sort in (*_HANDLED, "table"):
                return Meaning("empty") if told[0].sort == "table" else replace(told[0], symbols=passed(told[0]))
            raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
        return self._acting(phrase, verb, told)

    def _together(self, phrase: Phrase, texts: list[str], told: list[Meaning]) -> Meaning:
        """Auxiliaries and politeness around another verb phrase; two of them joined by "and"."""
        if len(told) == 1:
            return replace(told[0], symbols=passed(told[0]))
        if len(told) == 2 and set(texts) & {"and", "then"} and all(c.sort == "action" for c in told):
            return self.discourse(phrase, told)
        if len(told) == 2 and "and" in texts and not any(c.sort == "action" for c in told):
            return Meaning("several", told[0].symbols | told[1].symbols, parts=tuple(told))
        if len(told) == 2 and "and" in texts:
            return self.discourse(phrase, told)
        if len(told) == 2 and told[0].sort == "robot" and told[1].sort == "action":
            return told[1]
        raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")

    def _being(self, phrase: Phrase, texts: list[str], told: list[Meaning]) -> Meaning:
        if len(told) == 1:
            found = replace(told[0], symbols=passed(told[0]))
            nominal = found.sort in _HANDLED and phrase.phrases[-1].tag == "NP"
            return replace(found, preposition="") if nominal else found
        if len(told) == 2 and {"and", "but"} & set(texts):
            return Meaning("several", told[0].symbols | told[1].symbols, parts=tuple(told))
        raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")

    def _moved(self, phrase: Phrase) -> Meaning:
        if not self.history:
            raise NotAnnotatable(f"VP {phrase.text!r}: nothing was moved before")
        mask = self.layout.mask(self.history[-1:])
        return Meaning("moved", self.select.objects(mask), chosen=mask, pool=mask)

    def _acting(self, phrase: Phrase, verb: str, told: list[Meaning]) -> Meaning:
        kinds = sorted(s.kind for s in meanings(verb) if isinstance(s, Action))
        kind = _VERBS.get(verb) or (kinds[0] if kinds else "pick" if verb in _WANTING else "")
        before, told = self._framed(phrase, told)
        if not kind:
            if any(child.sort == "nothing" or is_empty(child) for child in told):
                return Meaning("action")
            raise NotAnnotatable(f"VP {phrase.text!r}: no action on objects")
        if any(word.text in ("away", "out") for child in phrase.phrases if child.tag == "PRT" for word in child.words):
            kind = "clear" if kind in ("pick", "place") and verb != "pick" else kind
        if verb == "bring" and len(told) > 1 and told[1].sort in _PLACES:
            kind = "place"  # "bring it next to the tower"
        if kind == "clear" and told and told[0].sort in ("table", "region", "direction"):
            told = [self._all_there(phrase, told[0]), *told[1:]]
        moves = verb in _VERBS and kind == "place" and phrase.words[0].tag in ("VBZ", "VBN") and verb != "takes"
        aside = bool(told) and kind == "place" and all(place.sort in _PLACES for place in told)
        subjectless = moves or aside or (verb == "go" and told and told[0].sort not in _HANDLED)
        if verb == "joins" and len(told) == 1:
            told = [self.destinations.prepositions.region(phrase, told[0], "near", "next to")]
        if not told and not moves:
            raise NotAnnotatable(f"VP {phrase.text!r}: no action on objects")
        if told and told[0].sort == "region" and told[0].region and told[0].region.kind == "tower" and not subjectless:
            told = [self._member(phrase, told[0]), *told[1:]]
        target = None if subjectless or told[0].sort == "pronoun" else told[0]
        places = told if subjectless else told[1:]
        if verb == "takes":
            raise NotAnnotatable(f"VP {phrase.text!r}: construction not covered")
        if target is not None:
            for frame in before:
                target = self._in_frame(phrase, target, frame)
        if kind == "pick" and any(place.sort == "region" for place in places) and len(places) == 1:
            target, places = self.noun_phrases.modified(phrase, target, places[0]) if target else None, []
        if kind == "clear" and len(places) == 1 and places[0].sort == "table":
            places = []
        places = [place for place in places if place.sort != "view"]
        if target is None and not subjectless and told[0].sort == "pronoun":
            pronoun = told[0]
            return self.act(phrase, kind, pronoun, tuple(places))
        done = self.act(phrase, kind, target, tuple(places))
        return replace(done, preposition="find") if verb in ("find", "locate", "identify") else done

    def _all_there(self, phrase: Phrase, place: Meaning) -> Meaning:
        """What is cleared where a place is: everything on it."""
        everything = Meaning("many", pool=self.layout.everything, chosen=self.layout.everything, definite=True)
        if place.sort == "table":
            return everything
        if place.sort == "direction" and place.place not in ("half", "side", "part", "section", "area"):
            raise NotAnnotatable(f"VP {phrase.text!r}: no action on objects")
        return self.noun_phrases.modified(phrase, everything, place)

    def _framed(self, phrase: Phrase, told: list[Meaning]) -> tuple[list[Meaning], list[Meaning]]:
        """What was said before the verb, to choose from, and the rest."""
        first = next((i for i, c in enumerate(phrase.children) if not isinstance(c, Phrase) and c.tag.startswith("VB")),
                     0)  # fmt: skip
        before = sum(1 for c in phrase.children[:first] if isinstance(c, Phrase) and c.tag == "PP")
        return told[:before], told[before:]

    def _in_frame(self, phrase: Phrase, target: Meaning, frame: Meaning) -> Meaning:
        if frame.sort == "view":
            return target
        if frame.sort == "direction" and target.ranks:
            raise NotAnnotatable(f"VP {phrase.text!r}: two directions")
        return self.choice(phrase, target, frame)

    def choice(self, phrase: Phrase, target: Meaning, frame: Meaning) -> Meaning:
        """What is chosen from a set or a place: "of the three on the left, the closest"."""
        if target.sort == "direction" and (target.relation or target.corner):
            target = Meaning("one", object_type=None, relation=target.relation, index=target.index,
                             corner=target.corner, pool=self.layout.everything, comparative=target.comparative,
                             definite=True, nearest_to=target.nearest_to, away=target.away)  # fmt: skip
        return self.noun_phrases.modified(phrase, target, frame)

    def act(self, phrase: Phrase, kind: str, target: Meaning | None, places: tuple[Meaning, ...]) -> Meaning:
        """An action on what a noun phrase means; without that, one that waits for what is acted on."""
        if (target is not None and (target.sort == "nothing" or is_empty(target))) or any(
            place.sort == "nothing" or is_empty(place) for place in places
        ):
            return Meaning("action", frozenset({Action(kind)}))
        if target is not None and target.unclear:  # fine while what was said before decides
            ranks = frozenset(s for s in target.symbols if isinstance(s, ObjectAttribute))
            return Meaning("action", ranks | {Action(kind)}, verb=kind, target=target, parts=places, unclear=True)
        said: frozenset[Symbol] = frozenset(s for p in places for s in p.symbols if isinstance(s, Region))
        if target is None or target.sort == "pronoun":
            said |= frozenset(s for p in places for s in p.symbols if isinstance(s, SpatialReference))
            return Meaning("action", frozenset({Action(kind)}) | said, verb=kind, target=target, parts=places)
        if target.sort not in _HANDLED:
            raise NotAnnotatable(f"{phrase.text!r}: no action on objects")
        if kind != "place" and places:
            raise NotAnnotatable(f"{phrase.text!r}: construction not covered")
        own = bool(places) and all(part.sort == "direction" for part in parts_of(places[0]))  # steps from where it is
        actions: set[Symbol] = set()
        extra: frozenset[Symbol] = frozenset()
        for mask in self._sets(target):
            names = self.layout.names(mask)
            if kind != "place":
                actions.add(Action(kind, names))
                continue
            alternatives, extra = self.destinations.regions(phrase, places, mask)
            actions |= {Action(kind, names, r) for r in alternatives if own or not self.layout.mask(r.objects) & mask}
        if len(actions) > 1 and extra:
            raise NotAnnotatable(f"{phrase.text!r}: the destination is not covered")
        return Meaning("action", frozenset(actions) | {Action(kind)} | extra, verb=kind, target=target, parts=places,
                       indefinite=bool(target.chosen)
                       and any(part.indefinite for place in places for part in parts_of(place)))  # fmt: skip

    def _sets(self, target: Meaning) -> list[int]:
        """What may be acted on."""
        if target.chosen:
            return [target.chosen]
        if target.sort == "one":
            return [1 << i for i in indices_of(target.pool)]
        if target.sort == "container":
            return [mask for _, mask in target.arrangements]
        if target.number is not None and target.pool.bit_count() > target.number:
            raise NotAnnotatable("which of them is open, in too many ways")
        return [target.pool] if target.number is None and target.pool else []

    def sentence(self, phrase: Phrase, children: list[Meaning]) -> Meaning:
        """A sentence or a relative clause from its parts."""
        told = [child for child in children if child.sort not in ("empty", "robot", "speaker")]
        viewers = [child for child in children if child.sort in ("robot", "speaker")]
        if any(child.sort == "moved" for child in told):
            return told[-1] if len(told) == 1 else self.noun_phrases.modified(phrase, told[0], told[-1])
        if len(told) == 1:
            if told[0].sort == "action" and told[0].target is None and told[0].verb and viewers:
                raise NotAnnotatable(f"{phrase.text!r}: people are not moved")
            return replace(told[0], symbols=passed(told[0]))
        if len(told) == 2 and all(child.sort == "action" for child in told):
            return self.discourse(phrase, told)
        if len(told) == 2 and phrase.tag == "S":
            return self._stated(phrase, *told)
        if len(told) == 3 and phrase.tag == "S" and told[2].sort == "action" and phrase.phrases[0].tag == "PP":
            return self._stated(phrase, self.choice(phrase, told[1], told[0]), told[2])
        raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")

    def _stated(self, phrase: Phrase, subject: Meaning, said: Meaning) -> Meaning:
        if said.sort == "action" and said.verb:
            return self._done_to(phrase, subject, said)
        if said.sort == "action":
            return said
        if phrase.phrases[0].tag == "PP" and said.sort in _HANDLED:
            return self.noun_phrases.modified(phrase, said, subject)
        if subject.sort == "pronoun" and said.sort in _HANDLED:
            return replace(said, preposition="")
        if subject.sort == "pronoun":
            return Meaning("predicate", said.symbols, parts=(said,))
        if subject.sort in _HANDLED and said.sort not in _HANDLED:
            return self.noun_phrases.modified(phrase, subject, said)
        if subject.sort == "one" and said.sort == "one":
            return self.noun_phrases.modified(phrase, subject, replace(said, preposition=""))
        raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")

    def _done_to(self, phrase: Phrase, subject: Meaning, said: Meaning) -> Meaning:
        """The box moves somewhere; the tower loses its top block."""
        if said.target is None:
            if subject.sort == "direction":
                subject = self.choice(phrase, subject, Meaning("view"))
            if subject.sort == "region":
                subject = self._member(phrase, subject)
            return self.act(phrase, said.verb, subject, said.parts)
        if said.verb == "pick" and subject.sort in ("one", "many", "container", "nothing"):
            if subject.sort == "nothing":
                return Meaning("action", frozenset({Action("pick")}))
            part = replace(subject, preposition="of", symbols=passed(subject))
            return self.act(phrase, "pick", self.noun_phrases.modified(phrase, said.target, part), said.parts)
        raise NotAnnotatable(f"{phrase.text!r}: construction not covered")

    def _member(self, phrase: Phrase, place: Meaning) -> Meaning:
        """The top of the stack, as a block."""
        anything = Meaning("one", pool=self.layout.everything)
        return self.noun_phrases.modified(phrase, anything, replace(place, preposition="at"))

    def discourse(self, phrase: Phrase, told: list[Meaning]) -> Meaning:
        """Sentences in their order: what is spoken of first may be meant by "it" and "one" later.

        Raises:
            NotAnnotatable: two commands that do not concern the same things, or nothing that "it" may be.
        """
        topic: Meaning | None = None
        done: Meaning | None = None
        for said in (child for child in told if child.sort != "empty"):
            if said.sort == "action":
                done, topic = self._after(phrase, said, done, topic), None
                topic = done.target
            elif said.sort in ("predicate", "several", "region", "direction") and topic is not None:
                parts = said.parts if said.sort == "predicate" else (said,)
                topic = self._described(phrase, topic, parts)
                done = done and self.act(phrase, done.verb, topic, done.parts)
            elif said.sort in _HANDLED:
                if done is not None and topic is not None:
                    topic = self._described(phrase, topic, (replace(said, preposition=""),))
                    done = self.act(phrase, done.verb, topic, done.parts)
                else:
                    topic = said if topic is None else self._described(phrase, topic, (replace(said, preposition=""),))
            elif said.sort == "nothing":
                topic = said
            else:
                raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")
        if done is not None:
            return done
        if topic is None:
            raise NotAnnotatable(f"{phrase.tag} {phrase.text!r}: construction not covered")
        return replace(topic, symbols=passed(topic))

    def _described(self, phrase: Phrase, topic: Meaning, parts: tuple[Meaning, ...]) -> Meaning:
        for part in parts:
            topic = self.noun_phrases.modified(phrase, topic, part)
        return topic

    def _after(self, phrase: Phrase, said: Meaning, done: Meaning | None, topic: Meaning | None) -> Meaning:
        """An action after what was said before it."""
        if done is not None and done.preposition == "find":
            done = None  # what was looked for is spoken of
        if topic is not None and topic.sort == "nothing":
            return Meaning("action", frozenset({Action(said.verb)} if said.verb else ()), verb=said.verb)
        if not said.verb or said.target is None:
            if said.verb and topic is not None and done is not None and done.verb == said.verb:
                return self._further(phrase, topic, done, said)
            if done is None or not said.verb:
                return said
            raise NotAnnotatable(f"{phrase.text!r}: construction not covered")
        target = said.target
        if target.sort == "pronoun":
            if topic is None or topic.sort not in _HANDLED:
                raise NotAnnotatable(f"{phrase.text!r}: nothing was spoken of before")
            if (target.index == 2) != (topic.sort in ("many", "container")):
                raise NotAnnotatable(f"{phrase.text!r}: one or several?")
            if done is not None and done.verb == "place" and said.verb == "place":
                return self._further(phrase, topic, done, said)
            return self.act(phrase, said.verb, topic, said.parts)
        if done is not None:
            raise NotAnnotatable(f"{phrase.text!r}: two commands")
        within = topic is not None and topic.sort == "one" and target.chosen and not target.chosen & ~topic.pool
        if topic is not None and not topic.chosen and not within:
            raise NotAnnotatable(f"{phrase.text!r}: what was said first is not true, or of several")
        if topic is not None and topic.chosen and topic.sort in ("many", "container"):
            frame = replace(topic, preposition="of", symbols=passed(topic))
            chosen = self.choice(phrase, target, frame) if target.sort == "one" else target
            return self.act(phrase, said.verb, chosen, said.parts)
        if topic is not None and topic.chosen and target.chosen and topic.chosen != target.chosen:
            raise NotAnnotatable(f"{phrase.text!r}: spoken of was something else")
        return said

    def _further(self, phrase: Phrase, topic: Meaning, done: Meaning, said: Meaning) -> Meaning:
        """Moved one way, and then another."""
        places = (*done.parts, *said.parts)
        if any(place.sort != "direction" for place in places):
            raise NotAnnotatable(f"{phrase.text!r}: moved twice")
        return self.act(phrase, "place", topic, places)
