"""From readings to an outcome: an answer, a question, or what is missing or was not understood."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from grounding.distinguishing import Describer
from grounding.forbidding import forbidden
from grounding.language.tree import Phrase
from grounding.lexicon.parameters import value
from grounding.literal import SILENT, LiteralBelief
from grounding.missing import unknown_named, unknown_things, whats_missing
from grounding.model.belief import NO_BELIEF, Belief, Option
from grounding.phrases import phrases_of
from grounding.placing.by_belief import destination, leads_off_table, where_to
from grounding.questions import question, which_place
from grounding.result import GroundedAction, Grounding
from grounding.unanswered import nothing_before, open_options, unanswered
from grounding.world.scene import Scene

CREDIBLE = 0.1  # what agrees less with the world is not answered where something is seen to be missing
UNSURE = 0.35  # where something is literally missing this much doubt is enough not to act
CHOICE = 0.7  # where any will do, so likely one of those that are alike has to be meant
ALIKE = 0.5  # those are alike that are at least so likely as the best
EVEN = 0.2  # where many are possible, those that are at most so much less likely than the best are
RIVAL = 0.2  # where an answer is given, others are told where to that are at least so likely beside it
LISTED = 0.01  # alternatives less likely than this are not worth naming
MOST = 5

_ASIDE = frozenset(("aside", "away", "out"))  # "move it out of the way"
_OFF_TABLE = "so far it would leave the table"
_OPEN_PLACE = "Where shall I put it?"


@dataclass(frozen=True)
class Believed:
    """What a text may ask for.

    Attributes:
        actions: the likeliest first, with their probabilities.
        count: how many options there are, those that are not worth listing included.
        sure: whether the first is likely enough to be the answer.
    """

    actions: tuple[GroundedAction, ...]
    count: int
    sure: bool


def decide(
    text: str,
    tree: Phrase,
    scene: Scene,
    unknown: Sequence[str] = (),
    belief: Belief = NO_BELIEF,
    literal: LiteralBelief = SILENT,
) -> Grounding:
    """Weigh what a text may ask for.

    Args:
        text: the instruction.
        tree: the parse that agrees best with the world.
        scene: the world.
        unknown: words that the grammar does not know.
        belief: what learned weights make of its meanings.
        literal: its literal reading, which tells what is missing.
    """
    result = _decided(text, tree, scene, tuple(unknown), belief, literal)
    return replace(result, phrases=phrases_of(tree, belief, result.actions or result.alternatives))


def _decided(
    text: str, tree: Phrase, scene: Scene, words: tuple[str, ...], belief: Belief, literal: LiteralBelief
) -> Grounding:
    understood = any(reading.cases and reading.place >= 0 for reading in belief.readings)
    refused = _refused(text, tree, scene, words, belief, literal, understood=understood)
    if refused is not None:
        return refused
    believed = _believed(tree, belief) if belief.listed() else _open(tree, scene)
    if believed is None:
        open_to = unanswered(tree, scene, words)
        return Grounding(text, open_to.outcome, explanation=open_to.explanation, unknown_words=open_to.words)
    result = _outcome(text, believed, scene, belief)
    if result.outcome == "grounded" and result.actions[0].action == "place" and literal.rival is not None:
        asked = which_place(literal.rival.ids, Describer(scene))
        result = replace(result, outcome="ambiguous", actions=(), alternatives=result.actions, question=asked,
                         explanation="what is said of the place holds of several things")  # fmt: skip
    if result.outcome == "ambiguous":
        missing = unknown_named(tree, scene)
        if missing is not None:
            words = tuple(dict.fromkeys((*words, *unknown_things(tree, scene.layout))))
            return Grounding(text, "no_referent", explanation=missing, unknown_words=words)
    return replace(result, unknown_words=words)


def _refused(
    text: str, tree: Phrase, scene: Scene, words: tuple[str, ...], belief: Belief, literal: LiteralBelief, *,
    understood: bool,
) -> Grounding | None:  # fmt: skip
    """An answer where what is asked for is forbidden, is not there, or speaks of what was not handled yet."""
    refusal = forbidden(tree)
    if refusal is not None:
        return Grounding(text, "not_understood", explanation=refusal, unknown_words=words)
    heard = bool(understood or literal.missing)
    gone = heard and belief.nothing >= value("answer.missing")
    doubted = gone or (heard and belief.is_empty)
    if literal.missing and (doubted or (heard and belief.nothing >= UNSURE)):
        return Grounding(text, "no_referent", explanation=literal.missing, unknown_words=words)
    if understood and belief.on_another_table:
        return Grounding(text, "no_referent", explanation="nothing of the kind is on that table", unknown_words=words)
    if doubted or (belief.agreement < CREDIBLE and not literal.options):
        missing = whats_missing(tree, scene) if doubted or understood else None
        if missing is not None:
            words = tuple(dict.fromkeys((*words, *unknown_things(tree, scene.layout))))
            return Grounding(text, "no_referent", explanation=missing, unknown_words=words)
        if gone:
            thing = next((p.text for p in tree.preorder() if p.tag == "NP"), tree.text)
            return Grounding(text, "no_referent", explanation=f"nothing here is {thing!r}", unknown_words=words)
    hollow = nothing_before(tree) if not understood else None
    if hollow is not None:
        return Grounding(text, hollow.outcome, explanation=hollow.explanation, unknown_words=words)
    return None


def _outcome(text: str, believed: Believed, scene: Scene, belief: Belief) -> Grounding:
    """An answer where one action is sure enough, else a question."""
    best, others = believed.actions[0], believed.actions[1 : MOST + 1]
    if believed.sure and best.action == "place" and best.destination is None:
        return _without_place(text, (best, *others), belief)
    if believed.sure:
        return Grounding(text, "grounded", (best,), others)
    listed = believed.actions[:MOST]
    asked = question(listed, Describer(scene), believed.count - len(listed))
    why = f"{believed.count} readings are possible" if believed.count > 1 else "the only reading is not sure enough"
    return Grounding(text, "ambiguous", (), listed, asked, why)


def _without_place(text: str, actions: Sequence[GroundedAction], belief: Belief) -> Grounding:
    """What is told where it is plain what is to be placed, and no place was found."""
    if leads_off_table(belief, actions[0].objects):
        return Grounding(text, "no_referent", explanation=_OFF_TABLE)
    said = where_to(belief, actions[0].objects)
    if said:
        return Grounding(text, "no_referent", explanation=f"there is no free place {said!r}")
    why = "where to is open: say where to put it, such as on, beside or behind something"
    return Grounding(text, "ambiguous", (), tuple(actions[:MOST]), _OPEN_PLACE, why)


def _believed(tree: Phrase, belief: Belief) -> Believed:
    """What learned weights make of all that was read."""
    options = belief.listed()
    best, second = options[0].probability, options[1].probability if len(options) > 1 else 0.0
    least = min(LISTED, EVEN * best)
    listed = _told_apart([option for option in options if option.probability >= least])
    sure = best >= value("answer.least") and best >= value("answer.margin") * second and not belief.is_empty
    sure = sure or (belief.leaves_choice and not belief.is_empty and _alike(options) >= CHOICE)
    least = RIVAL * best if sure else 0.0
    actions = tuple(action_of(o, tree, belief, placed=o.probability >= least) for o in listed[: MOST + 1])
    return Believed(actions, len(listed), sure)


def _alike(options: Sequence[Option]) -> float:
    """How likely one of those is meant of which one does as well as the other: "a red block"."""
    single = (option for option in options if len(option.objects) == 1)
    return sum(option.probability for option in single if option.probability >= ALIKE * options[0].probability)


def _told_apart(options: Sequence[Option]) -> list[Option]:
    """Options without sets that a likelier one has as a part, or is a part of: nobody asks whether a row is shorter."""
    kept: list[Option] = []
    for option in options:
        objects = set(option.objects)
        nested = (set(other.objects) for other in kept if min(len(other.objects), len(objects)) > 1)
        if not any(objects <= other or other <= objects for other in nested):
            kept.append(option)
    return kept


def _open(tree: Phrase, scene: Scene) -> Believed | None:
    """What the bare noun of the thing that is asked for leaves possible, where nothing that is said of it helped."""
    options = open_options(tree, scene)
    if not options:
        return None
    actions = tuple(GroundedAction(kind, names, 1 / len(options)) for kind, names in options[: MOST + 1])
    return Believed(actions, len(options), sure=False)


def action_of(option: Option, tree: Phrase, belief: Belief, *, placed: bool = True) -> GroundedAction:
    """An option as an action, with where it is to be put.

    Args:
        option: what is handled.
        tree: the parse.
        belief: in what the text means; its readings tell where to.
        placed: whether it is told where to, which takes its time.
    """
    kind, place = option.kinds[0][0], None
    if kind == "place" and not placed:
        return GroundedAction(kind, option.objects, option.probability)
    if kind == "place":
        place = destination(belief, option.objects)
    if place is not None and set(place.reference) & set(option.objects):
        place = None  # nothing is put on or beside itself
    if kind == "place" and place is None and _aside(tree):
        kind = "clear"
    return GroundedAction(kind, option.objects, option.probability, place)


def _aside(tree: Phrase) -> bool:
    """Whether a text only says to move something out of the way, not how far from what."""
    texts = [leaf.text for leaf in tree.leaves]
    return any(
        text in _ASIDE and texts[place + 1 : place + 2] != ["from"] for place, text in enumerate(texts)
    )
