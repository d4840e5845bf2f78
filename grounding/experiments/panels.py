"""What the figures show: for an instruction, its most telling phrases, each with what it was grounded to."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from grounding.inference import Hypothesis
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.pictures import Mark, Row, meaning_of
from grounding.pictures.marks import EXPRESSED, listed
from grounding.pictures.palette import FAINT, MARKS
from grounding.result import PhraseGrounding
from grounding.symbols import Action, Container, ObjectSymbol, Region, Symbol, symbol_key
from grounding.world import World

_ACTED, _CONTAINED, _MEANT, _BESIDE = MARKS[0], MARKS[1], MARKS[2], MARKS[3]


@dataclass(frozen=True)
class Panel:
    """One phrase.

    Attributes:
        text: its words.
        tag: NP, PP, VP, ...
        marks: what it means among the objects.
        rows: the legend: every kind of symbol with its probability.
        unsaid: kinds of arrangements that it means and none of its words names.
    """

    text: str
    tag: str
    marks: tuple[Mark, ...]
    rows: tuple[Row, ...]
    unsaid: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Figure:
    """One instruction.

    Attributes:
        name: of its file, without ending.
        title: the instruction.
        world: it was given in.
        panels: phrases, the inner before the outer: the order in which they were grounded.
        note: where instruction, world and factors come from.
    """

    name: str
    title: str
    world: World
    panels: tuple[Panel, ...]
    note: str


def phrases_of(tree: Phrase, hypothesis: Hypothesis, depth: int = 0) -> list[PhraseGrounding]:
    """Every phrase with the symbols of a hypothesis and their probabilities, parents before children."""
    symbols = [(symbol, hypothesis.probabilities.get(symbol, 1.0)) for symbol in hypothesis.symbols]
    symbols.sort(key=lambda pair: (-pair[1], symbol_key(pair[0])))
    span = (tree.leaves[0].index, tree.leaves[-1].index)
    found = [PhraseGrounding(tree.text, tree.tag, span, depth, tuple(symbols))]
    for child, part in zip(tree.phrases, hypothesis.children, strict=True):
        found += phrases_of(child, part, depth + 1)
    return found


def telling_panels(phrases: Sequence[PhraseGrounding], world: World, most: int = 4) -> tuple[Panel, ...]:
    """The phrases that mean something among the objects.

    Of those that mean the same, one stands for all: one that means an arrangement which none of its words names if
    there is one, otherwise the outermost noun phrase.

    Args:
        phrases: of one tree, parents before children.
        world: whose objects they mean; phrases that mean the robot or the furniture only are left out.
        most: so many at most; the outermost phrase is always among them, then those of most words.

    Returns:
        panels in the order in which phrases are grounded: the inner before the outer, the left before the right.
    """
    things = {item.id for item in world.things}
    chosen: dict[object, tuple[int, PhraseGrounding, tuple[Mark, ...]]] = {}
    for place, phrase in enumerate(phrases):
        marks = tuple(mark for mark in marks_of_phrase(phrase) if things.intersection(mark.objects))
        key = frozenset((mark.role, frozenset(mark.objects)) for mark in marks)
        known = chosen.get(key)
        if marks and (known is None or known[0] > 0 and _worth(phrase) > _worth(known[1])):
            chosen[key] = (place, phrase, marks)
    kept = sorted(chosen.values(), key=lambda item: (item[1].depth > 0, -len(item[1].text.split())))[:most]
    kept.sort(key=lambda item: (item[1].words[1], -item[1].words[0], -item[1].depth))
    return tuple(
        Panel(phrase.text, phrase.tag, marks, _rows(phrase, marks), unsaid_kinds(phrase.text, _meant(phrase)))
        for _, phrase, marks in kept
    )


def unsaid_kinds(text: str, symbols: Iterable[Symbol]) -> tuple[str, ...]:
    """The kinds of the containers among some symbols that no word of a phrase names, groups last."""
    said = {s.kind for word in text.split() for s in meanings(word) if isinstance(s, Container)}
    kinds = {s.kind for s in symbols if isinstance(s, Container) and s.objects and s.kind != "robot"}
    return tuple(sorted(kinds, key=lambda kind: (kind == "group", kind))) if not said & kinds else ()


def _worth(phrase: PhraseGrounding) -> tuple[bool, bool]:
    """Which of two phrases that mean the same is shown."""
    return phrase.tag != "PP" and bool(unsaid_kinds(phrase.text, _meant(phrase))), phrase.tag != "PP"


def _meant(phrase: PhraseGrounding) -> list[Symbol]:
    return [symbol for symbol, p in phrase.groundings if p >= EXPRESSED]


def marks_of_phrase(phrase: PhraseGrounding) -> tuple[Mark, ...]:
    """Everything that one phrase means among the objects: actions, containers, regions and objects."""
    found = [(symbol, p) for symbol, p in phrase.groundings if p >= EXPRESSED]
    marks = []
    for symbol, p in found:
        match symbol:
            case Action(_, objects, _) if objects:
                marks.append(Mark(phrase.text, "object", objects, p, _ACTED, None, meaning_of(symbol)))
            case Container(kind, objects) if objects and kind != "robot":
                marks.append(Mark(phrase.text, "container", objects, p, _CONTAINED, None, meaning_of(symbol)))
            case Region(_, _, objects) if objects:
                marks.append(Mark(phrase.text, "region", objects, p, _BESIDE, None, meaning_of(symbol)))
    acted = {name for mark in marks if mark.role == "object" for name in mark.objects}
    single = {symbol.id: p for symbol, p in found if isinstance(symbol, ObjectSymbol) and symbol.id not in acted}
    if single:
        names = tuple(single)
        marks.append(Mark(phrase.text, "object", names, min(single.values()), _MEANT, None, listed(names)))
    return tuple(marks)


def _rows(phrase: PhraseGrounding, marks: Sequence[Mark]) -> tuple[Row, ...]:
    """The legend of a phrase: what is marked, then what its words say."""
    rows = [Row(mark.role, _kind(mark), mark.meaning, f"{mark.probability:.2f}", mark.color) for mark in marks]
    shown = {mark.meaning for mark in marks}
    said = [s for s, p in phrase.groundings if p >= EXPRESSED and not _is_marked(s) and meaning_of(s) not in shown]
    texts = list(dict.fromkeys(meaning_of(symbol) for symbol in said))
    whole = [text for text in texts if not any(set(text.split()) < set(other.split()) for other in texts)]
    unsaid = unsaid_kinds(phrase.text, _meant(phrase))
    if unsaid:
        rows.append(Row("passed", f"none of these words says “{unsaid[0]}”"))
    if whole:
        rows.append(Row("", "says", ", ".join(whole), "", FAINT))
    return tuple(rows)


def _is_marked(symbol: Symbol) -> bool:
    grouped = isinstance(symbol, Container | Region | Action) and bool(symbol.objects)
    return grouped or isinstance(symbol, ObjectSymbol)


def _kind(mark: Mark) -> str:
    if mark.role != "object":
        return mark.role
    if mark.color == _ACTED:
        return "action"
    return "object" if len(mark.objects) == 1 else "objects"
