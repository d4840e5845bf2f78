"""From readings to an outcome: an answer, a question, or what is missing or was not understood."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from grounding.destinations import find_destination
from grounding.distinguishing import Describer
from grounding.forbidding import forbidden
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.lexicon.parameters import value
from grounding.literal import SILENT, LiteralBelief
from grounding.missing import unknown_named, unknown_things, whats_missing
from grounding.model.belief import NO_BELIEF, Belief, Option
from grounding.phrases import by_answer, by_factors
from grounding.placing.by_belief import destination, leads_off_table
from grounding.questions import question, where, which_place
from grounding.readings import Reading
from grounding.result import Destination, GroundedAction, Grounding
from grounding.symbols import Action, Region, symbol_key
from grounding.unanswered import nothing_before, open_options, unanswered
from grounding.world.scene import Scene

CREDIBLE = 0.1  # what agrees less with the world is not answered where something is seen to be missing
CONFIDENT = 0.62  # by the factors alone an answer is given when it is so likely
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
        shares: of the actions by the factors, for telling what phrases mean.
        reading: by the factors, that agrees with the first action, or the likeliest one.
        agrees: whether it does.
    """

    actions: tuple[GroundedAction, ...]
    count: int
    sure: bool
    shares: dict[Action, float]
    reading: Reading
    agrees: bool


def decide(
    text: str,
    found: Sequence[Reading],
    scene: Scene,
    unknown: Sequence[str] = (),
    belief: Belief = NO_BELIEF,
    literal: LiteralBelief = SILENT,
) -> Grounding:
    """Weigh the readings.

    Args:
        text: the instruction.
        found: its readings by the factors, the likeliest first.
        scene: the world.
        unknown: words that the grammar does not know.
        belief: what learned weights make of its meanings; where they find none only the factors are asked.
        literal: its literal reading, which tells what is missing.
    """
    tree, words = found[0].inference.tree, tuple(unknown)
    phrases = by_factors(found[0], {})
    understood = any(reading.cases and reading.place >= 0 for reading in belief.readings)
    refused = _refused(text, found[0], scene, words, belief, literal, understood=understood)
    if refused is not None:
        return replace(refused, phrases=phrases)
    believed = _believed(found, scene, belief) if belief.listed() else _by_factors(found, scene)
    if believed is None:
        believed = _open(found, scene)
    if believed is None:
        open_to = unanswered(tree, scene, words)
        return Grounding(text, open_to.outcome, explanation=open_to.explanation, unknown_words=open_to.words,
                         phrases=phrases)  # fmt: skip
    result = _outcome(text, believed, scene)
    unplaced = believed.sure and believed.actions[0].action == "place" and believed.actions[0].destination is None
    if unplaced and leads_off_table(belief, believed.actions[0].objects):
        result = Grounding(text, "no_referent", explanation=_OFF_TABLE)
    if result.outcome == "grounded" and result.actions[0].action == "place" and literal.rival is not None:
        asked = which_place(literal.rival.ids, Describer(scene))
        result = replace(result, outcome="ambiguous", actions=(), alternatives=result.actions, question=asked,
                         explanation="what is said of the place holds of several things")  # fmt: skip
    if result.outcome == "ambiguous":
        missing = unknown_named(tree, scene)
        if missing is not None:
            words = tuple(dict.fromkeys((*words, *unknown_things(tree, scene.layout))))
            return Grounding(text, "no_referent", explanation=missing, unknown_words=words, phrases=phrases)
    told = (
        by_factors(believed.reading, believed.shares)
        if believed.agrees or not understood
        else by_answer(believed.reading, belief, believed.actions)
    )
    return Grounding(
        text, result.outcome, result.actions, result.alternatives, result.question, result.explanation, words, 0.0, told
    )


def _refused(
    text: str, reading: Reading, scene: Scene, words: tuple[str, ...], belief: Belief, literal: LiteralBelief, *,
    understood: bool,
) -> Grounding | None:  # fmt: skip
    """An answer where what is asked for is forbidden, is not there, or speaks of what was not handled yet."""
    tree = reading.inference.tree
    refusal = forbidden(tree)
    if refusal is not None:
        return Grounding(text, "not_understood", explanation=refusal, unknown_words=words)
    heard = bool(understood or literal.missing)
    gone = heard and belief.nothing >= value("answer.missing")
    doubted = gone or (heard and belief.is_empty)
    if doubted and literal.missing:
        return Grounding(text, "no_referent", explanation=literal.missing, unknown_words=words)
    if doubted or (belief.agreement < CREDIBLE and not literal.options):
        missing = whats_missing(tree, scene) if doubted or understood or reading.actions else None
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


def _outcome(text: str, believed: Believed, scene: Scene) -> Grounding:
    """An answer where one action is sure enough, else a question."""
    describer = Describer(scene)
    best, others = believed.actions[0], believed.actions[1 : MOST + 1]
    if believed.sure:
        if best.action == "place" and best.destination is None:
            region = next((a.destination for a in believed.shares if a.objects == best.objects and a.destination), None)
            if region is not None:
                why = f"there is no free place {_in_words(region, describer)}"
                return Grounding(text, "no_referent", explanation=why)
            why = "where to is open: say where to put it, such as on, beside or behind something"
            return Grounding(text, "ambiguous", (), (best, *others)[:MOST], _OPEN_PLACE, why)
        return Grounding(text, "grounded", (best,), others)
    listed = believed.actions[:MOST]
    asked = question(listed, describer, believed.count - len(listed))
    why = f"{believed.count} readings are possible" if believed.count > 1 else "the only reading is not sure enough"
    return Grounding(text, "ambiguous", (), listed, asked, why)


def _believed(found: Sequence[Reading], scene: Scene, belief: Belief) -> Believed:
    """What learned weights make of all that was read."""
    shares, bearers = _shares(found)
    options = belief.listed()
    best, second = options[0].probability, options[1].probability if len(options) > 1 else 0.0
    least = min(LISTED, EVEN * best)
    listed = _told_apart([option for option in options if option.probability >= least])
    sure = best >= value("answer.least") and best >= value("answer.margin") * second and not belief.is_empty
    least = RIVAL * best if sure else 0.0
    actions = tuple(
        action_of(option, found, scene, belief, placed=option.probability >= least) for option in listed[: MOST + 1]
    )
    bearer = next((r for a, r in bearers.items() if _agrees(a, actions[0])), None)
    count = len(listed)
    return Believed(actions, count, sure, shares, bearer or found[0], bearer is not None)


def _told_apart(options: Sequence[Option]) -> list[Option]:
    """Options without sets that a likelier one has as a part, or is a part of: nobody asks whether a row is shorter."""
    kept: list[Option] = []
    for option in options:
        objects = set(option.objects)
        nested = (set(other.objects) for other in kept if min(len(other.objects), len(objects)) > 1)
        if not any(objects <= other or other <= objects for other in nested):
            kept.append(option)
    return kept


def _by_factors(found: Sequence[Reading], scene: Scene) -> Believed | None:
    """What the factors believe; None where that is nothing for the greater part."""
    shares, bearers = _shares(found)
    nothing = sum(reading.weight for reading in found if not reading.actions)
    if not shares or nothing > 0.5:
        return None
    ordered = sorted(shares.items(), key=lambda item: (-item[1], symbol_key(item[0])))
    actions = tuple(
        GroundedAction(a.kind, a.objects, share, _destination(a.destination, a.objects, scene.layout))
        for a, share in ordered[: MOST + 1]
        if share >= LISTED
    )
    count = sum(share >= LISTED for share in shares.values())
    return Believed(actions, count, ordered[0][1] >= CONFIDENT, shares, bearers[ordered[0][0]], True)


def _open(found: Sequence[Reading], scene: Scene) -> Believed | None:
    """What the bare noun of the thing that is asked for leaves possible, where nothing that is said of it helped."""
    tree = found[0].inference.tree
    options = open_options(tree, scene)
    if not options:
        return None
    actions = tuple(GroundedAction(kind, names, 1 / len(options)) for kind, names in options[: MOST + 1])
    return Believed(actions, len(options), False, {}, found[0], True)


def _shares(found: Sequence[Reading]) -> tuple[dict[Action, float], dict[Action, Reading]]:
    """The share of every action among the readings by the factors, and the first reading that bears it."""
    shares: dict[Action, float] = {}
    bearers: dict[Action, Reading] = {}
    for reading in found:
        for action in reading.actions:
            shares[action] = shares.get(action, 0.0) + reading.weight / len(reading.actions)
            bearers.setdefault(action, reading)
    return shares, bearers


def _agrees(action: Action, answer: GroundedAction) -> bool:
    """Whether what the factors ask for is the answer, with the same things as the references of its place."""
    if action.objects != answer.objects or (action.kind == "place") != (answer.action == "place"):
        return False
    place = answer.destination
    return place is None or action.destination is None or set(place.reference) == set(action.destination.objects)


def action_of(
    option: Option, found: Sequence[Reading], scene: Scene, belief: Belief, *, placed: bool = True
) -> GroundedAction:
    """An option as an action, with where it is to be put.

    Args:
        option: what is handled.
        found: the readings by the factors.
        scene: the world.
        belief: in what the text means; its readings tell where to.
        placed: whether it is told where to, which takes its time.
    """
    tree, kind, place = found[0].inference.tree, option.kinds[0][0], None
    if kind == "place" and not placed:
        return GroundedAction(kind, option.objects, option.probability)
    if kind == "place":
        place = destination(belief, option.objects)
        if place is None:
            asked = [a for a in _shares(found)[0] if a.kind == "place" and a.objects == option.objects]
            places = (_destination(a.destination, option.objects, scene.layout) for a in asked)
            place = next((one for one in places if one is not None), None)
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


def _destination(region: Region | None, objects: tuple[str, ...], layout: Layout) -> Destination | None:
    return None if region is None else find_destination(region, objects, layout.world)


def _in_words(region: Region, describer: Describer) -> str:
    return where(Destination((0.0, 0.0, 0.0), region.relation, region.objects), describer)
