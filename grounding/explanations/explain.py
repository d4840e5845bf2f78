"""Explains one instruction: phrase by phrase, the answer, and what lost against it. Takes longer than grounding it."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from grounding.dialogue import CREDIBLE
from grounding.explanations.agreement import FLOOR, Part, compared, parts_of
from grounding.explanations.features import Context, contexts
from grounding.explanations.tracing import TracedReader, span_of
from grounding.explanations.values import Contribution, Explanation, Option, PhraseExplained, Rival
from grounding.factors import FactorModel
from grounding.graded import words
from grounding.graded.belief import GradedReading
from grounding.graded.discourse import read_text
from grounding.grounder import Grounder, Understanding
from grounding.language.tree import Phrase
from grounding.pictures.marks import telling_of
from grounding.readings import Reading
from grounding.result import GroundedAction, Grounding
from grounding.symbols import ObjectSymbol, symbol_key
from grounding.world import World

RIVALS = 3  # options that lost are explained, at most so many
_SIDES = frozenset(("left", "right", "front", "back"))


def explain(grounder: Grounder, text: str, world: World, history: Sequence[str] = ()) -> tuple[Grounding, Explanation]:
    """Ground an instruction and explain why it was understood so.

    Args:
        grounder: with its grammar and weights.
        text: what the person said.
        world: what is there.
        history: ids of the objects handled before, the latest last.

    Returns:
        the answer, which is that of `Grounder.ground`, and its explanation.

    Raises:
        LanguageError: the text has no words.
    """
    understanding = grounder.understand(text, world, history)
    result = understanding.decided()
    return result, _explained(understanding, result, grounder.inference.model)


def _explained(understanding: Understanding, result: Grounding, model: FactorModel) -> Explanation:
    options = _options(understanding, result)
    answer = options[0] if options else None
    reading = _bearer(understanding, answer)
    tree = reading.inference.tree
    layout = understanding.scene.layout
    place = next((i for i, parse in enumerate(understanding.parses) if parse.tree == tree), 0)
    taken = _graded(understanding, place, answer)
    traced = None if taken is None else _traced(taken, tree)
    judged = list(contexts(model, tree, reading.hypothesis, layout))
    parts = () if traced is None else parts_of(traced)
    if len(options) == 1 and len(options[0].objects) == 1:
        options += _next_best(understanding, options[0], parts)
    rivals = tuple(
        Rival(other, _why_lost(understanding, options[0], other, parts, taken), _by_features(judged, options[0], other))
        for other in options[1 : RIVALS + 1]
    )
    parse = understanding.parses[place]
    return Explanation(
        sentence=result.explanation,
        parse=str(tree),
        complete=parse.complete,
        mended=parse.mended,
        unknown_words=parse.unknown_words,
        viewpoint=_viewpoint(understanding, taken, tree),
        truth=understanding.graded.truth,
        answer=answer,
        rivals=rivals,
        phrases=tuple(_phrase(phrase, depth, context, traced, taken) for phrase, depth, context in judged),
        factors_alone=tuple(a.objects for a in reading.actions) if answer is not None and not answer.factors else (),
    )  # fmt: skip


def _options(understanding: Understanding, result: Grounding) -> tuple[Option, ...]:
    """What the answer names, and what else is likely enough to be told of, with the shares of belief."""
    graded: dict[tuple[str, ...], float] = {}
    if understanding.graded.truth >= CREDIBLE:
        for (_, objects), share in understanding.graded.options:
            graded[objects] = graded.get(objects, 0.0) + share
    factors: dict[tuple[str, ...], float] = {}
    for reading in understanding.readings:
        for action in reading.actions:
            share = reading.weight / len(reading.actions)
            factors[action.objects] = factors.get(action.objects, 0.0) + share

    def option(action: GroundedAction) -> Option:
        return Option(action.action, action.objects, action.probability, graded.get(action.objects, 0.0),
                      factors.get(action.objects, 0.0))  # fmt: skip

    named = [option(action) for action in (*result.actions, *result.alternatives)]
    found = list({named_option.objects: named_option for named_option in reversed(named)}.values())[::-1]
    known = {named_option.objects for named_option in found}
    kind = found[0].action if found else "pick"
    left = max(0.0, 1.0 - sum(named_option.probability for named_option in found))
    for objects, share in sorted(graded.items(), key=lambda item: (-item[1], item[0])):
        if found and len(found) < 2 and objects not in known:
            found.append(Option(kind, objects, min(left, share), share, factors.get(objects, 0.0)))
    return tuple(found)


def _next_best(understanding: Understanding, answer: Option, parts: Sequence[Part]) -> tuple[Option, ...]:
    """The object that agrees best with the parts of the description, the answer left out."""
    ids = understanding.scene.layout.ids
    others = [i for i, name in enumerate(ids) if name not in answer.objects]
    if not others or not parts:
        return ()
    fit = np.sum([np.log(np.maximum(part.degrees, FLOOR)) for part in parts], axis=0)
    best = max(others, key=lambda i: (float(fit[i]), ids[i]))
    return (Option(answer.action, (ids[best],), 0.0, 0.0, 0.0),)


def _bearer(understanding: Understanding, answer: Option | None) -> Reading:
    """The reading by the factors that gives the answer, or else the likeliest."""
    wanted = None if answer is None else answer.objects
    fitting = (r for r in understanding.readings if any(action.objects == wanted for action in r.actions))
    return next(fitting, understanding.readings[0])


def _graded(understanding: Understanding, place: int, answer: Option | None) -> GradedReading | None:
    """The graded reading of a parse that gives most to the answer, or else the likeliest."""
    readings = understanding.graded.readings
    if not readings:
        return None
    of_parse = [r for r in readings if r.place == place] or list(readings)
    return max(of_parse, key=lambda r: _given(understanding, r, answer) if answer is not None else r.share)


def _given(understanding: Understanding, reading: GradedReading, option: Option) -> float:
    """The share of belief that a reading gives to an option."""
    ids = understanding.scene.layout.ids
    if reading.told.sets:
        total = sum(weight for _, weight in reading.told.sets)
        same = (
            weight
            for mask, weight in reading.told.sets
            if tuple(sorted(ids[i] for i in np.flatnonzero(mask))) == tuple(sorted(option.objects))
        )
        return reading.share * sum(same) / max(total, 1e-9)
    if len(option.objects) != 1 or option.objects[0] not in understanding.scene.layout.index:
        return 0.0
    index = understanding.scene.layout.index[option.objects[0]]
    return reading.share * float(reading.weights[index] / reading.weights.sum())


def _traced(reading: GradedReading, tree: Phrase) -> TracedReader:
    """The reading, followed once more."""
    traced = TracedReader(reading.reader.scene, reading.reader.view, reading.reader.history)
    read_text(tree, traced)
    return traced


def _phrase(
    phrase: Phrase, depth: int, context: Context, traced: TracedReader | None, taken: GradedReading | None
) -> PhraseExplained:
    symbols = tuple(
        sorted((context.judged(s) for s in context.symbols), key=lambda j: (-j.probability, symbol_key(j.symbol)))
    )
    weighed = None if traced is None else traced.weighed(phrase)
    if depth == 0 and traced is not None and taken is not None and weighed is None:
        weighed = traced.ranked(taken.weights)
    main = telling_of([judged.symbol for judged in symbols])
    rival = None if main is None else context.runner_up(main)
    return PhraseExplained(
        phrase.text, phrase.tag, span_of(phrase), depth, symbols, weighed,
        None if rival is None else context.judged(rival),
        () if rival is None or main is None else context.lost(main, rival),
    )  # fmt: skip


def _why_lost(
    understanding: Understanding, answer: Option, rival: Option, parts: Sequence[Part], taken: GradedReading | None
) -> tuple[Contribution, ...]:
    index = understanding.scene.layout.index
    own = [index[name] for name in answer.objects if name in index]
    other = [index[name] for name in rival.objects if name in index]
    name = " ".join(rival.objects)
    found = list(compared(parts, own, other, name))
    if taken is None or not understanding.graded.readings:
        return tuple(found)
    best = max(understanding.graded.readings, key=lambda r: _given(understanding, r, rival))
    given = _given(understanding, best, rival)
    if best is not taken and given > 2 * _given(understanding, taken, rival):
        weight = math.log(max(best.share, 1e-9) / max(taken.share, 1e-9))
        if best.place != taken.place:
            trees = [understanding.parses[r.place].tree for r in (best, taken)]
            found.append(Contribution(f"{name} would need {_read_as(*trees)}", weight))
        if best.reader.view != taken.reader.view:
            found.append(Contribution(f"{name} is meant if directions are the {best.reader.view}'s", weight))
    return tuple(sorted(found, key=lambda reason: reason.weight))


def _read_as(tree: Phrase, other: Phrase) -> str:
    """What one parse has that another has not, the longest phrase of it."""
    known = {(phrase.tag, span_of(phrase)) for phrase in other.preorder()}
    own = [phrase for phrase in tree.preorder() if (phrase.tag, span_of(phrase)) not in known]
    if not own:
        return f"the reading {tree}"
    phrase = max(own, key=lambda p: len(p.leaves))
    return f'"{phrase.text}" to be read as one phrase ({phrase.tag})'


def _by_features(
    judged: Sequence[tuple[Phrase, int, Context]], answer: Option, rival: Option
) -> tuple[Contribution, ...]:
    """What the factors have against a rival, in the outermost phrase that means the answer's object."""
    if len(answer.objects) != 1 or len(rival.objects) != 1:
        return ()
    own, other = ObjectSymbol(answer.objects[0]), ObjectSymbol(rival.objects[0])
    for phrase, _, context in judged:
        if phrase.tag == "NP" and own in context.symbols:
            return context.lost(own, other)
    return ()


def _viewpoint(understanding: Understanding, taken: GradedReading | None, tree: Phrase) -> str:
    """Whose left and right was meant, where it matters; "" where no direction is named."""
    if not any(_SIDES & set(words.directions(leaf.text)) or leaf.text == "behind" for leaf in tree.leaves):
        return ""
    if understanding.scene.layout.world.speaker is None or taken is None:
        return "directions are as the robot sees them"
    readings = understanding.graded.readings
    share = sum(r.share for r in readings if r.reader.view == taken.reader.view)
    if len({r.reader.view for r in readings}) == 1:
        return f"directions are as the {taken.reader.view} sees them, where nobody else is named"
    return f"directions are as the {taken.reader.view} sees them, where nobody else is named ({share:.2f})"
