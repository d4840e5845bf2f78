"""From the phrase trees of a text to what is handled: commands, statements, and what they speak of before."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from grounding.graded.destinations.items import peeled
from grounding.graded.nouns import Noun, read_noun
from grounding.graded.reader import Reader
from grounding.graded.values import Membership, Rank, Restriction
from grounding.language.tree import Phrase, Word
from grounding.world import Array

HANDLING = {
    "pick": "pick pickup grab take lift get select choose grasp fetch hold collect bring raise want need touch scoop "
            "reach retrieve obtain picking seize give pass hand lifts takes".split(),
    "place": "put place set move stack lay drop position slide push shift moves slides shifts bring transfer relocate "
             "moved placed stacked put puts places sits goes joins jumps stacks becomes leaps hops drag pull travels "
             "creates forms falls drops returns needs mover relocates swaps switch offset joined go sit join "
             "lands rests".split(),
    "clear": "clear remove".split(),
}  # fmt: skip
_SETTING_OFF = frozenset(
    (
        "move moves moving put place places position positions set shift shifts slide "
        "slides stack stacks join joins leap leaps hop hops jump jumps drop drops fall "
        "falls align aligns"
    ).split()
)
_LOOKING = frozenset("look find locate see focus consider notice search narrow identify imagine observe looking "
                     "there there's".split())  # fmt: skip
_BEING = frozenset("is are 's was were be being re".split())
_ORDERING = frozenset("should will must shall would needs ought".split())
_MOVED = frozenset("moved placed put stacked set shifted relocated positioned".split())
_WANTING = frozenset("want need reach like".split())
_LOSING = frozenset("loses lose lost drops".split())
_GAINING = frozenset("takes gains gets receives becomes grows adds acquires take gain become made formed".split())
_BRINGING = frozenset("from using moving taking placing stacking putting adding by".split())
_THINGS = ("block", "container", "place")
_MAKING = frozenset("create make form build creating making forming".split())
_BODY = frozenset("hand hands arm arms gripper fingers claw".split())


@dataclass
class Told:
    """What a text has told so far.

    Attributes:
        target: how well each object is what shall be handled, shape (n,), or None.
        sets: where several are.
        mentioned: what was spoken of last, shape (n,), or None.
        kind: of action.
        destination: phrases that tell where to, the words of their clauses as phrases of their own.
        doubt: pieces that were not used.
        whole: the text, in which a destination is looked for where no phrase was told apart.
    """

    target: Array | None = None
    sets: tuple[tuple[np.ndarray, float], ...] = ()
    mentioned: Array | None = None
    plural: bool = False
    kind: str = "pick"
    destination: list[Phrase] = field(default_factory=list)
    doubt: int = 0
    continued: bool = False
    whole: Phrase | None = None


def _resumes(clause: Phrase) -> bool:
    """Whether a clause says what shall be done with "it"."""
    words = [leaf.text for leaf in clause.leaves]
    verb = any(text in HANDLING["place"] for text in words)
    return verb and any(text in ("it", "that", "them", "one") for text in words[:6])


def read_text(tree: Phrase, reader: Reader) -> Told:
    """Follow a text clause by clause."""
    told = Told()
    clauses = clauses_of(tree)
    for place, clause in enumerate(clauses):
        told.continued = any(_resumes(further) for further in clauses[place + 1 :])
        _follow(clause, reader, told)
    if told.target is None and told.mentioned is not None:
        told.target = told.mentioned
    if told.target is None:
        _guess(tree, reader, told)
    told.whole = tree
    reader.context = told.mentioned
    if told.kind == "pick" and not told.destination and _only_moves(tree):
        told.kind = "place"
    return told


def clauses_of(tree: Phrase) -> list[Phrase]:
    """The clauses of a text, in order."""
    return [_possessed(clause) for clause in _clauses(tree)]


def _only_moves(tree: Phrase) -> bool:
    """Whether a text that was not understood clause by clause speaks of moving something, and not of picking it."""
    texts = {leaf.text for leaf in tree.leaves}
    moving = any(leaf.text in _SETTING_OFF and leaf.tag in ("VB", "VBZ", "VBP", "VBG") for leaf in tree.leaves)
    return moving and not texts & set(HANDLING["pick"])


def _guess(tree: Phrase, reader: Reader, told: Told) -> None:
    """Where no clause named anything: the first noun phrase that could."""
    for phrase in tree.preorder():
        if phrase.tag == "NP":
            noun = read_noun(phrase)
            if noun.head == "block" and _informative(noun) and not noun.strange:
                _take(noun, reader, told)
                if told.target is not None:
                    return


def _possessed(clause: Phrase) -> Phrase:
    """The sentence "the corner 's block moves" was read as one on the corner; it is one on the corner's block."""
    if clause.tag != "S" or len(clause.children) < 2:
        return clause
    owner, verb = clause.children[0], clause.children[1]
    if not (isinstance(owner, Phrase) and owner.tag == "NP" and isinstance(verb, Phrase) and verb.tag == "VP"):
        return clause
    if (
        not verb.children
        or not isinstance(verb.children[0], Word)
        or verb.children[0].text != "'s"
        or len(verb.children) < 2
    ):
        return clause
    rest = verb.children[1:]
    if isinstance(rest[0], Phrase) and rest[0].tag == "S":
        rest = (*rest[0].children, *rest[1:])
    thing = rest[0]
    if not (isinstance(thing, Phrase) and thing.tag == "NP") or thing.leaves[0].tag == "DT":
        return clause
    of = Phrase("PP", (Word("of", "IN", owner.leaves[-1].index), owner))
    return Phrase("S", (Phrase("NP", (thing, of)), *rest[1:]))


def _clauses(tree: Phrase) -> list[Phrase]:
    if tree.tag == "FRAG":
        return [clause for child in tree.phrases for clause in _clauses(child)]
    if tree.tag == "S" and tree.children and isinstance(tree.children[0], Phrase) and _existential(tree.children[0]):
        command = next((p for p in tree.preorder() if p.tag == "VP" and _commands(p)), None)
        if command is not None:
            return [
                _without(tree, command),
                *_clauses(Phrase("VP", tuple(c for c in command.children if c not in _leading(command)))),
            ]
    if tree.tag == "VP":
        place = next((i for i, child in enumerate(tree.children) if i > 1 and _coordinate(tree, i, child)), None)
        if place is not None:
            head = Phrase("VP", tuple(tree.children[:place]))
            return [
                *_clauses(head),
                *(c for child in tree.phrases if child in tree.children[place:] for c in _clauses(child)),
            ]
    if (
        tree.tag in ("VP", "S")
        and sum(child.tag in ("VP", "S") for child in tree.phrases) > 1
        and not any(child.tag == "NP" for child in tree.phrases)
    ):
        return [clause for child in tree.phrases for clause in _clauses(child)]
    return [tree]


def _commands(phrase: Phrase) -> bool:
    """Whether a verb phrase has a verb of handling itself, with an object."""
    verbs = any(word.text in words for word in phrase.words for words in HANDLING.values() if word.text not in _BEING)
    return verbs and any(child.tag == "NP" for child in phrase.phrases)


def _leading(command: Phrase) -> tuple[Phrase, ...]:
    """What stands before the verb of a command: it belongs to what was said before."""
    found = []
    for child in command.children:
        if not isinstance(child, Phrase):
            break
        found.append(child)
    return tuple(found)


def _without(tree: Phrase, command: Phrase) -> Phrase:
    """A clause without the command that ran into it, which leaves what stands before its verb."""
    children: list[Phrase | Word] = []
    for child in tree.children:
        if child is command:
            children += _leading(command)
        elif isinstance(child, Phrase):
            children.append(_without(child, command))
        else:
            children.append(child)
    return Phrase(tree.tag, tuple(children))


def _coordinate(parent: Phrase, place: int, child: Phrase | object) -> bool:
    """Whether a child is a further command: a verb phrase after "and", behind an object."""
    if not isinstance(child, Phrase) or child.tag != "VP":
        return False
    before = parent.children[place - 1]
    joined = not isinstance(before, Phrase) and before.tag in ("CC", "RB", ",")
    named = any(isinstance(c, Phrase) and c.tag == "NP" for c in parent.children[:place])
    return joined and named and any(_verbal(word.text) for word in child.words)


def _follow(clause: Phrase, reader: Reader, told: Told) -> None:
    if clause.tag == "NP":
        _name(clause, reader, told)
    elif clause.tag in ("VP", "S"):
        _sentence(clause, reader, told)
    else:
        _add(clause, reader, told)


def _name(phrase: Phrase, reader: Reader, told: Told) -> None:
    """A noun phrase by itself names the target."""
    noun = read_noun(phrase)
    if noun.head == "other" and any(text in _LOOKING for text in noun.unknown):
        inner = [p for m in noun.modifiers for p in m.phrases if p.tag == "NP"]
        if inner:
            _mention(read_noun(inner[0]), reader, told)
            return
    _take(noun, reader, told)


def _kind(verbs: list[str], clause: Phrase) -> str | None:
    """What the verbs ask for; "move it away" asks to clear it, and wanting is no action where another verb is."""
    found = {kind for kind, words in HANDLING.items() for verb in verbs if verb in words and verb not in _WANTING}
    if found <= {"place"} and found and {"away", "aside"} & {leaf.text for leaf in clause.leaves[-2:]}:
        return "clear"
    for kind in ("place", "clear", "pick"):
        if kind in found:
            return kind
    return "pick" if any(verb in _WANTING for verb in verbs) else None


def _sentence(clause: Phrase, reader: Reader, told: Told) -> None:
    parts = _flat(clause)
    if not any(_verbal(word.text) for word in parts.words) and told.target is not None and not parts.subjects:
        _add(clause, reader, told)
        return
    verbs = [word.text for word in parts.words]
    kind = _kind(verbs, clause)
    looking = any(v in _LOOKING for v in verbs) or any(_existential(p) for p in parts.subjects)
    nouns = [read_noun(p) for p in parts.objects]
    nouns = [noun for noun in nouns if noun.head != "other" or noun.colors or noun.modifiers]
    if nouns and nouns[0].head in ("other", "place", "agent") and _BODY & set(nouns[0].text.split()):
        return
    subjects = [read_noun(p) for p in parts.subjects if not _existential(p)]
    giver = _given(verbs, parts, subjects, nouns)
    if giver is not None:
        _take(giver, reader, told)
        told.kind = "place"
        told.destination += _gained(verbs, parts)
        return
    subjects = [s for s in subjects if s.head in ("block", "pronoun", "container")]
    named = [noun for noun in subjects if noun.head in ("block", "container") and _informative(noun)]
    if looking and named and all(noun.head == "pronoun" for noun in nouns):
        _mention(_with(named[0], parts.before, reader), reader, told)
        return
    if looking and not nouns:
        sought = [child for part in parts.rest for child in part.phrases if child.tag == "NP"]
        if sought and parts.rest[0].words and parts.rest[0].words[-1].text in ("for", "at", "to"):
            _mention(read_noun(sought[0]), reader, told)
            return
    if looking and nouns and not (kind and not subjects and len(nouns) > 1):
        _mention(_with(nouns[0], [*parts.before, *parts.rest], reader), reader, told)
        return
    ordered = any(v in _ORDERING for v in verbs)
    everything = [read_noun(p) for p in parts.subjects if not _existential(p)]
    if (
        told.kind == "place"
        and told.target is not None
        and told.destination
        and everything
        and _same_thing(everything[0])
    ):
        # "it should be left of X", "its left side touches X"
        told.destination += [*_owned(parts), _said(parts), *parts.objects, *parts.rest]
        return
    passive = any(v in _BEING for v in verbs) and any(v in _MOVED for v in verbs)
    if subjects and passive and subjects[0].head != "pronoun" and told.target is None:
        ordered = True
    if subjects and ordered and subjects[0].head != "pronoun" and told.target is None:
        _take(_with(subjects[0], parts.before, reader), reader, told)
        told.kind = "place"
        told.destination += [_said(parts), *parts.objects, *parts.rest]
        return
    if subjects and any(v in _BEING for v in verbs) and any(v in ("not", "n't") for v in verbs):
        _deny(subjects[0], nouns, parts.rest, reader, told)
        return
    if subjects and any(v in _BEING for v in verbs):
        _state(subjects[0], nouns, parts.rest, reader, told)
        return
    if kind == "place" and subjects and not (nouns and nouns[0].head == "block" and nouns[0].definite):
        _take(_with(subjects[0], parts.before, reader), reader, told)
        told.kind = "place"
        told.destination += [_said(parts), *parts.objects, *parts.rest]
        return
    if kind is not None and nouns:
        told.kind = kind
        before = parts.before
        if kind in ("pick", "clear"):
            _take(_with(nouns[0], [*before, *parts.rest], reader), reader, told)
            for further in parts.objects[1:]:
                _add(further, reader, told)
        else:
            rest = list(parts.rest)
            noun = _with(nouns[0], before, reader)
            if len(rest) > 1 and rest[0].tag == "PP" and noun.head == "block" and not _informative(noun):
                noun = _with(noun, [rest.pop(0)], reader)
            fresh = noun.head != "pronoun"
            if fresh and len(rest) > 1 and rest[0].tag == "PP" and not _leads(rest[0]) and _results(rest[-1]):
                noun = _with(noun, [rest.pop(0)], reader)
            while (
                told.continued
                and rest
                and rest[0].tag in ("PP", "SBAR")
                and (not _informative(noun) or not _leads(rest[0]))
            ):
                noun = _with(noun, [rest.pop(0)], reader)
            noun, courses = peeled(noun)
            _take(noun, reader, told)
            told.destination += [_said(parts), *courses, *parts.objects[1:], *rest]
        return
    if kind == "place" and not subjects and told.target is not None:
        told.kind = kind
        told.destination += [_said(parts), *parts.rest]
        return
    if nouns:
        _take(_with(nouns[0], [*parts.before, *parts.rest], reader), reader, told)
    elif subjects:
        _take(_with(subjects[0], [*parts.before, *parts.rest], reader), reader, told)
    else:
        for part in parts.rest:
            _add(part, reader, told)


def _results(phrase: Phrase) -> bool:
    """Whether a phrase tells what shall be the case afterwards: "so that it is ..."."""
    return phrase.tag == "SBAR" and any(leaf.text in ("so", "until") for leaf in phrase.leaves[:2])


def _said(parts: _Parts) -> Phrase:
    """The words of a clause by themselves: "stack ... on X" leads elsewhere than "move ... to X"."""
    return Phrase("VP", tuple(parts.words))


def _owned(parts: _Parts) -> list[Phrase]:
    """A side of what is moved: "its left side touches X"."""
    return [phrase for phrase in parts.subjects if phrase.leaves[0].text in ("its", "it's")]


def _gained(verbs: list[str], parts: _Parts) -> list[Phrase]:
    """Where to, where somebody gives or receives: onto what gains it, or as a further clause tells."""
    clauses = [p for phrase in (*parts.objects, *parts.rest) for p in phrase.preorder() if p.tag == "SBAR"][:1]
    subjects = [p for p in parts.subjects if not _existential(p)]
    if any(v in _LOSING for v in verbs) or not subjects or not any(v in _GAINING for v in verbs):
        return clauses
    where = [p for p in parts.rest if p.tag == "PP" and p.leaves[0].text not in ("from", "using", "by", "with")]
    return [Phrase("PP", (Word("on", "IN", 0), subjects[0])), *where, *clauses]


def _leads(phrase: Phrase) -> bool:
    """Whether a phrase tells where to go: "to the right", "down two"."""
    first = phrase.leaves[0].text
    return first in ("to", "onto", "into", "toward", "towards", "over", "so", "until", "up", "down") or first.isdigit()


def _given(verbs: list[str], parts: _Parts, subjects: list[Noun], nouns: list[Noun]) -> Noun | None:
    """What is moved where the subject only gives or gets it: "the tower loses its top", "X gains a block from Y"."""
    if any(v in _MAKING for v in verbs) and not any(s.head == "block" for s in subjects):
        return _brought(*parts.objects, *parts.rest)
    if not subjects:
        return None
    subject = subjects[0]
    if any(v in _LOSING for v in verbs):
        of_it = Phrase("PP", (Word("of", "IN", 0), _noun_phrase(parts, 0)))
        return replace(subject, head="block", kinds=(), directions=("up",), number=None, ordinals=(), distance=None,
                       size=0, middle=False, colors=(), modifiers=(of_it,))  # fmt: skip
    if any(v in _GAINING for v in verbs) and subject.head in ("block", "container"):
        return _brought(*parts.objects, *parts.rest)
    return None


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


def _noun_phrase(parts: _Parts, place: int) -> Phrase:
    return [p for p in parts.subjects if not _existential(p)][place]


@dataclass
class _Parts:
    words: list[Word] = field(default_factory=list)
    subjects: list[Phrase] = field(default_factory=list)
    objects: list[Phrase] = field(default_factory=list)
    before: list[Phrase] = field(default_factory=list)
    rest: list[Phrase] = field(default_factory=list)


def _flat(clause: Phrase) -> _Parts:
    """The words, subjects, objects and adjuncts of a clause, through nested verb phrases."""
    parts = _Parts()

    def visit(phrase: Phrase) -> None:
        verb = phrase.tag == "VP"
        started = bool(parts.words) and verb
        for child in (unfolded for part in phrase.children for unfolded in _unfolded(part)):
            if not isinstance(child, Phrase):
                parts.words.append(child)
                started = True
            elif child.tag == "NP":
                (parts.objects if verb and started else parts.subjects).append(child)
            elif child.tag in ("VP", "S"):
                visit(child)
            elif child.tag in ("PRT", "INTJ", "WHNP"):
                continue
            else:
                (parts.rest if parts.objects or parts.subjects else parts.before).append(child)

    visit(clause)
    if not parts.objects and not parts.subjects:
        parts.rest = parts.before + parts.rest
        parts.before = []
    return parts


def _verbal(text: str) -> bool:
    return text in _LOOKING or text in _BEING or any(text in words for words in HANDLING.values())


def _unfolded(part: Phrase | Word) -> tuple[Phrase | Word, ...]:
    """A thing that was read as the measure of a phrase stands before it: "the block" "behind the tower"."""
    if isinstance(part, Phrase) and part.tag == "PP" and len(part.children) > 1:
        first = part.children[0]
        if isinstance(first, Phrase) and first.tag == "NP":
            noun = read_noun(first)
            if (
                noun.head in ("block", "container")
                and noun.definite
                and first.leaves[0].text in ("the", "that", "this")
            ):
                return (Phrase("NP", (first, Phrase("PP", part.children[1:]))),)
    return (part,)


def _existential(phrase: Phrase) -> bool:
    return [word.text for word in phrase.leaves] in (["there"], ["here"])


def _with(noun: Noun, modifiers: list[Phrase], reader: Reader) -> Noun:
    return replace(noun, modifiers=(*noun.modifiers, *modifiers))


def _informative(noun: Noun) -> bool:
    return bool(noun.colors or noun.modifiers or noun.directions or noun.ordinals or noun.distance or noun.middle
                or noun.lone or noun.number or noun.size)  # fmt: skip


def _take(noun: Noun, reader: Reader, told: Told) -> None:
    """Something to be handled is named."""
    if noun.head == "pronoun" or (noun.head == "block" and not _informative(noun) and not noun.plural):
        if told.target is None:
            told.target = told.mentioned if told.mentioned is not None else (
                reader.value_of(noun) if noun.head == "block" or reader.history else None
            )  # fmt: skip
        return
    reader.context = told.mentioned if told.mentioned is not None else told.target
    value = (
        reader.everything_in(noun) if told.kind == "clear" and noun.head in ("place", "table") else reader.noun(noun)
    )
    if value.kind not in ("objects", "sets"):
        told.doubt += 1
        return
    weights = value.weights
    if told.mentioned is not None and told.plural and noun.head == "block":
        inside = weights * np.where(told.mentioned > 0.3 * told.mentioned.max(initial=1e-9), 1.0, 0.15)
        pool = reader.within(noun, told.mentioned)
        weights = np.maximum(inside, pool) if pool is not None else inside
    if told.target is not None:
        previous = told.target / max(float(told.target.max(initial=0)), 1e-9)
        weights = weights * (0.1 + 0.9 * previous)
    told.target = weights
    told.sets = value.sets if value.kind == "sets" else ()


def _mention(noun: Noun, reader: Reader, told: Told) -> None:
    """Something is spoken of before it is said what to do."""
    reader.context = told.mentioned
    value = reader.noun(noun)
    if value.kind in ("objects", "sets") and value.weights.any():
        weights = value.weights / float(value.weights.max())
        told.mentioned = weights
        told.plural = value.kind == "sets"


def _same_thing(noun: Noun) -> bool:
    """Whether a subject is what was just spoken of, or a side of it: "it", "its left side"."""
    texts = noun.text.split()
    return (noun.head == "pronoun" and not noun.modifiers) or (noun.head == "place" and texts[:1] == ["its"])


def _deny(subject: Noun, nouns: list[Noun], rest: list[Phrase], reader: Reader, told: Told) -> None:
    """For example "it is not the one next to the tower"."""
    noun = _with(nouns[0] if nouns else replace(subject, head="block"), rest, reader)
    value = reader.noun(noun)
    if value.kind in ("objects", "sets") and value.weights.any() and told.target is not None:
        told.target = told.target * (1.0 - 0.9 * value.weights / float(value.weights.max()))


def _state(subject: Noun, nouns: list[Noun], rest: list[Phrase], reader: Reader, told: Told) -> None:
    """For example "the block is on the left", "it is the red one next to the tower"."""
    noun = _with(subject, rest, reader)
    if nouns:
        first = nouns[0]
        noun = _with(first if first.head in ("block", "container", "place") else subject, rest, reader)
        if noun.head == "place":
            noun = replace(subject, directions=noun.directions, middle=noun.middle, modifiers=noun.modifiers)
    if noun.head == "pronoun":
        noun = replace(noun, head="block")
    if noun.head == "block":
        previous, told.target = told.target, None
        mentioned, plural = told.mentioned, told.plural
        if previous is None and mentioned is not None and not plural:
            previous = mentioned
        told.mentioned = None
        _take(noun, reader, told)
        told.mentioned = mentioned
        if previous is not None and told.target is not None:
            told.target = told.target * (0.05 + 0.95 * previous / max(float(previous.max(initial=0)), 1e-9))
        elif told.target is None:
            told.target = previous


def _add(piece: Phrase, reader: Reader, told: Told) -> None:
    """A piece that belongs to what was named before it."""
    if told.destination and told.kind == "place":
        told.destination.append(piece)
        return
    if told.target is None:
        if piece.tag == "NP":
            _name(piece, reader, told)
        elif piece.tag in ("PP", "SBAR"):
            effects = reader.effects(piece, np.ones(reader.scene.n))
            for effect in effects:
                if isinstance(effect, Restriction) and effect.weights.any():
                    told.target = effect.weights
                elif isinstance(effect, Rank):
                    told.target = reader.ranked_again(np.ones(reader.scene.n), effect)
                elif isinstance(effect, Membership) and effect.sets:
                    told.mentioned, told.plural = effect.sets[0][0].astype(float), True
        return
    for effect in reader.effects(piece, told.target):
        if isinstance(effect, Restriction):
            told.target = told.target * (0.1 + 0.9 * effect.weights)
        elif isinstance(effect, Membership):
            inside = np.max([mask * chance for mask, chance in effect.sets[:4]], axis=0)
            told.target = told.target * (0.1 + 0.9 * inside)
        elif isinstance(effect, Rank):
            told.target = reader.ranked_again(told.target, effect)
