"""Modifiers, read literally: what they do to the things of a noun."""

from __future__ import annotations

from dataclasses import replace

from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.literal.choosing import alone, along, toward
from grounding.literal.places import NAMES
from grounding.literal.prepositions import ADVERBS, STRICT, at_place, by_distance, counted, related
from grounding.literal.reading import ReadsLiterally
from grounding.literal.relations import region_of
from grounding.literal.values import Effect, Narrow, Order, Sided, Unread
from grounding.meaning.nouns import Noun, read_noun
from grounding.symbols import Cardinal, ObjectColor, Ordinal, Region
from grounding.world.scene import SPEAKER

_REFUSED = frozenset("aligned level flush line parallel facing opposite diagonal separated than forming making across "
                     "around until not n't isn't without except surrounded same other".split())  # fmt: skip
_APART = frozenset("away apart outside opposite beyond".split())
_CLAUSE = frozenset("is are 's was were that which who also still now completely located situated positioned placed "
                    "sitting standing lying sits lies stands sit lie stand see can and but both you i it just".split())
_VIEWS = frozenset("perspective view viewpoint standpoint vantage position point".split())


def modify(reader: ReadsLiterally, phrase: Phrase, noun: Noun, pool: int) -> list[Effect]:
    """What a modifier does.

    Args:
        reader: of the noun phrases within.
        phrase: the modifier.
        noun: what it modifies.
        pool: what the noun may be by its own words.

    Raises:
        Unread: it is beyond what is read literally.
        Missing: it speaks of something that is not there.
    """
    words = [word for word in phrase.words if word.tag not in ("UH", "CC") and word.text != "please"]
    texts = [word.text for word in words]
    if phrase.tag in ("WHNP", "INTJ"):
        return []
    if phrase.tag == "NP":
        return _predicate(reader, read_noun(phrase), pool)
    ranked = any(w.is_ranking(text) for text in texts)
    if texts in (["outside"], ["outside", "of"]) and len(phrase.phrases) == 1:
        return [_outside(reader, phrase)]
    if _REFUSED & set(texts) or (_APART & set(texts) and not ranked):
        raise Unread(phrase.text)
    if phrase.tag in ("SBAR", "S", "VP"):
        return _clause(reader, phrase, texts, noun, pool)
    if phrase.tag in ("PP", "ADVP", "ADJP"):
        return _relation(reader, phrase, words, noun, pool)
    raise Unread(phrase.text)


def _outside(reader: ReadsLiterally, phrase: Phrase) -> Effect:
    """What is no part of an arrangement: "outside the row"; a ring may have something within it that is neither."""
    meant = reader.mean(phrase.phrases[0])
    if meant.sort != "things" or not meant.chosen or meant.kind in ("object", "circle"):
        raise Unread(phrase.text)
    return Narrow(reader.layout.everything & ~meant.chosen)


def _clause(reader: ReadsLiterally, phrase: Phrase, texts: list[str], noun: Noun, pool: int) -> list[Effect]:
    leaves = [leaf.text for leaf in phrase.leaves]
    if {"moved", "placed", "put", "picked"} & set(leaves) and {"you", "i"} & set(leaves):
        if not reader.history:
            raise Unread(phrase.text)
        return [Narrow(1 << reader.history[-1])]
    if {"touches", "touching"} & set(texts) and len(phrase.phrases) == 1:
        return [region_of(reader, reader.mean(phrase.phrases[0]), "touching", phrase)]
    if not set(texts) <= _CLAUSE:
        raise Unread(phrase.text)
    found: list[Effect] = []
    for child in phrase.phrases:
        if child.tag == "NP" and phrase.tag == "S" and read_noun(child).head in ("pronoun", "agent"):
            continue
        found += modify(reader, child, noun, pool)
    return found


def _predicate(reader: ReadsLiterally, noun: Noun, pool: int) -> list[Effect]:
    """A noun phrase that says more of the same thing: "that is the closest one to you"."""
    if noun.head not in ("block", "other", "place") or noun.plural or noun.conjoined:
        raise Unread(noun.text)
    if noun.head == "place":
        meant = reader.meant(noun) if noun.place else None
        if meant is not None:
            return at_place(reader, meant, "", noun, None)
        noun = replace(noun, head="block")
    meant = reader.meant(replace(noun, head="block"), pool)
    return [Narrow(meant.chosen or meant.pool, chosen=bool(meant.chosen))]


def _relation(reader: ReadsLiterally, phrase: Phrase, words: list[Word], noun: Noun, pool: int) -> list[Effect]:
    texts = [word.text for word in words]
    kids = [child for child in phrase.phrases if child.tag not in ("INTJ", "PRT")]
    if phrase.tag == "PP" and _is_view(phrase):
        if any(leaf.text == "my" for leaf in phrase.leaves) and reader.person(SPEAKER) == SPEAKER:
            raise Unread(phrase.text)
        return []
    if len(kids) > 1:
        return _joined(reader, phrase, texts, kids, noun, pool)
    strict = bool(STRICT & set(texts)) and not (texts[:1] == ["right"] and "of" in texts)
    if not kids:
        return _bare(reader, phrase, texts, noun, pool)
    child = kids[0]
    if child.tag != "NP":
        if not set(texts) <= ADVERBS:
            raise Unread(phrase.text)
        found = modify(reader, child, noun, pool)
        if strict:
            found = [Narrow(e.mask, e.region, True, e.vague) if isinstance(e, Narrow) else e for e in found]
        return found
    inner = read_noun(child)
    if (inner.lone or inner.text in ("itself", "its own")) and not inner.colors and not inner.modifiers:
        return [Narrow(alone(reader.scene, pool))]
    if inner.head == "measure" or (texts and texts[0] == "" ):
        raise Unread(phrase.text)
    index = next((s.value for text in texts for s in meanings(text) if isinstance(s, Ordinal)), None)
    if any(isinstance(s, Cardinal) for text in texts for s in meanings(text)):
        raise Unread(phrase.text)
    ranking = [text for text in texts if w.is_ranking(text) or text == "farthest"]
    if not ranking and texts[:1] == ["most"] and {"close", "near"} & set(texts):
        ranking = ["closest"]
    meant = reader.meant(inner)
    if ranking:
        return [by_distance(reader, meant, w.distance(ranking[-1]) == "far", index, texts, phrase)]
    if index is not None:
        if meant.sort != "place" or (meant.parts and meant.parts[0].sort != "table") or texts[-1] not in ("from", "in"):
            raise Unread(phrase.text)
        return counted(reader, meant, index)
    return related(reader, phrase, texts, meant, noun, pool, strict=strict)


def _is_view(phrase: Phrase) -> bool:
    """Whether a modifier only tells whose view is taken: "from your perspective", "from my side"."""
    texts = [leaf.text for leaf in phrase.leaves]
    if texts[0] != "from" or len(texts) > 6:
        return False
    return bool(_VIEWS & set(texts)) or texts in (["from", "your", "side"], ["from", "my", "side"])


def _joined(
    reader: ReadsLiterally, phrase: Phrase, texts: list[str], kids: list[Phrase], noun: Noun, pool: int
) -> list[Effect]:
    """What is joined: "on the left and next to it", "above and to the left of it"."""
    if any(child.tag == "NP" for child in kids) or not set(texts) <= ADVERBS | {"and", "but", "then"}:
        raise Unread(phrase.text)
    if len(kids) == 2 and not any(p.tag == "NP" and read_noun(p).head in ("block", "container")
                                  for p in kids[0].preorder()):  # fmt: skip
        names = [NAMES.get(n, n) for leaf in kids[0].leaves for n in w.directions(leaf.text)]
        if "behind" in [leaf.text for leaf in kids[0].leaves]:
            names = ["back"]
        bare = not any(p.tag == "NP" for p in kids[0].preorder()) or kids[0].leaves[-1].text == "front"
        if names and bare and len(kids[0].leaves) <= 2:
            second = modify(reader, kids[1], noun, pool)
            if len(second) != 1 or not isinstance(second[0], Narrow) or second[0].region is None:
                raise Unread(phrase.text)
            name = {"top": "back", "bottom": "front"}.get(names[0], names[0])
            region = second[0].region
            also = reader.layout.within(Region(name, region.kind, region.objects))
            return [Narrow(second[0].mask & also, vague=True)]
    return [effect for child in kids for effect in modify(reader, child, noun, pool)]


def _bare(reader: ReadsLiterally, phrase: Phrase, texts: list[str], noun: Noun, pool: int) -> list[Effect]:
    """A modifier without a noun phrase: "farthest away", "leftmost", "alone", "red"."""
    told = [text for text in texts if text not in ADVERBS or text in ("far",)]
    if not told or told == ["way"]:
        raise Unread(phrase.text)
    if all(w.is_lone(text) for text in told):
        return [Narrow(alone(reader.scene, pool))]
    index = None
    effects: list[Effect] = []
    for text in told:
        symbols = meanings(text)
        ordinal = next((s.value for s in symbols if isinstance(s, Ordinal)), None)
        color = next((s.name for s in symbols if isinstance(s, ObjectColor)), None)
        names = [NAMES.get(name, name) for name in w.directions(text)]
        if ordinal is not None:
            index = ordinal
        elif color is not None:
            effects.append(Narrow(reader.layout.matching(None, color)))
        elif w.is_ranking(text):
            name = str(w.distance(text))
            effects.append(Order(along(reader.layout, name), index, name))
        elif len(names) == 1 and phrase.tag == "ADJP" and len(told) == 1:
            effects.append(Sided(names[0]))
        elif 0 < len(names) <= 2 and text == told[-1] and w.is_extreme(text):
            effects.append(Order(toward(reader.scene, names), index, "", 0.03) if len(names) > 1 else Sided(names[0]))
        else:
            raise Unread(phrase.text)
    if not effects:
        raise Unread(phrase.text)
    return effects
