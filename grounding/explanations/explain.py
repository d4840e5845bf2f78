"""Explains one instruction: its meaning, the answer, what lost, and its phrases. Takes longer than grounding."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.explanations.candidates import Candidate, Grounds, Understood, compared, of_readings
from grounding.explanations.meanings import Meanings
from grounding.explanations.phrases import explained_phrases
from grounding.explanations.values import Contribution, Explanation, Option, Rival
from grounding.language.tree import Phrase
from grounding.lexicon import words
from grounding.model.belief import NOTHING, Reading
from grounding.model.cases import Weights
from grounding.result import Grounding
from grounding.world import World

RIVALS = 3  # options that lost are explained, at most so many
FEATURES = 8  # that say most of a rival
_SIDES = frozenset(("left", "right", "front", "back"))


def explain(grounder: Grounds, text: str, world: World, history: Sequence[str] = ()) -> tuple[Grounding, Explanation]:
    """Ground an instruction and explain why it was understood so.

    Args:
        grounder: with its grammar and weights.
        text: what the person said.
        world: what is there.
        history: ids of the objects handled before, the latest last.

    Returns:
        the answer, which is that of the grounder, and its explanation.

    Raises:
        LanguageError: the text has no words.
    """
    understanding = grounder.understand(text, world, history)
    result = understanding.decided()
    return result, explained(understanding, result, grounder.weights)


def explained(understanding: Understood, result: Grounding, weights: Weights) -> Explanation:
    """Explain an answer.

    Args:
        understanding: of a text.
        result: the answer to it.
        weights: of features, with which it was understood.
    """
    belief = understanding.belief
    options = _options(understanding, result)
    answer = options[0] if options and (result.actions or result.alternatives) else None
    rivals = options[1:] if answer is not None else options
    taken = _candidate(understanding, answer, weights)
    reading = _reading(understanding, taken)
    parse = understanding.parses[0 if reading is None else reading.place]
    meanings = None
    if reading is not None:
        second = rivals[0].objects if rivals else ()
        meanings = Meanings(reading, second if answer is None else answer.objects, () if answer is None else second)
    lost = tuple(_rival(understanding, meanings, answer, taken, rival, weights) for rival in rivals[:RIVALS])
    return Explanation(
        sentence=result.explanation,
        parse=str(parse.tree),
        probability=parse.probability,
        complete=parse.complete,
        mended=result.mended or parse.mended,
        unknown_words=parse.unknown_words,
        viewpoint=_viewpoint(understanding, reading, parse.tree),
        truth=_truth(reading, taken),
        nothing=belief.probability(NOTHING),
        missing=meanings.missing() if meanings is not None and not result.actions else (),
        meaning=() if meanings is None else meanings.explained(),
        answer=answer,
        rivals=lost,
        phrases=explained_phrases(parse.tree, meanings, belief, result),
    )


def _options(understanding: Understood, result: Grounding) -> list[Option]:
    """What the answer names, and the options that are believed next."""
    found: dict[tuple[str, ...], Option] = {}
    for action in (*result.actions, *result.alternatives):
        key = tuple(sorted(action.objects))
        if key:
            found.setdefault(key, Option(action.action, action.objects, action.probability))
    belief = understanding.belief
    for names, share in belief.options:
        if names and names not in found and len(found) < 2:
            kinds = belief.kinds.get(names, ())
            found[names] = Option(kinds[0][0] if kinds else "pick", names, share)
    return list(found.values())


def _candidate(understanding: Understood, option: Option | None, weights: Weights) -> Candidate | None:
    """The likeliest candidate that stands for an option, or for nothing where there is none."""
    objects = NOTHING if option is None else option.objects
    return of_readings(understanding.belief.readings, objects, weights)


def _reading(understanding: Understood, taken: Candidate | None) -> Reading | None:
    if taken is not None and taken.reading is not None:
        return taken.reading
    return next(iter(understanding.belief.readings), None)


def _rival(
    understanding: Understood, meanings: Meanings | None, answer: Option | None, taken: Candidate | None,
    rival: Option, weights: Weights,
) -> Rival:  # fmt: skip
    features: tuple[Contribution, ...] = ()
    other = _candidate(understanding, rival, weights)
    if taken is not None and other is not None:
        features = compared(taken, other, weights)[:FEATURES]
    told = () if meanings is None or answer is None else meanings.reasons(rival.objects)
    more = _read_otherwise(understanding, taken, other, " ".join(rival.objects), features)
    return Rival(rival, (*told, *more), features)


def _read_otherwise(
    understanding: Understood, taken: Candidate | None, other: Candidate | None, name: str,
    features: Sequence[Contribution],
) -> list[Contribution]:  # fmt: skip
    """Reasons of a rival that lives from another parse or from another view than the answer."""
    if taken is None or other is None or taken.reading is None or other.reading is None:
        return []
    found = []
    own, its = taken.reading, other.reading
    if own.place != its.place:
        trees = [understanding.parses[reading.place].tree for reading in (its, own)]
        weight = sum(feature.weight for feature in features if feature.feature == "parse")
        found.append(Contribution(f"{name} would need {_read_as(*trees)}", weight))
    if own.evaluator.view != its.evaluator.view:
        weight = sum(feature.weight for feature in features if feature.feature.startswith("view."))
        found.append(Contribution(f"{name} is meant if directions are the {its.evaluator.view}'s", weight))
    return found


def _read_as(tree: Phrase, other: Phrase) -> str:
    """What one parse has that another has not, the longest phrase of it."""
    known = {(phrase.tag, phrase.text) for phrase in other.preorder()}
    own = [phrase for phrase in tree.preorder() if (phrase.tag, phrase.text) not in known]
    if not own:
        return f"the parse {tree}"
    phrase = max(own, key=lambda p: len(p.leaves))
    return f'"{phrase.text}" to be read as one phrase ({phrase.tag})'


def _truth(reading: Reading | None, taken: Candidate | None) -> float:
    """How well the description holds of the answer, or of what it fits best; what it relates to included."""
    if reading is None or reading.told.target is None:
        return 0.0
    within = reading.evaluator.truth_within(reading.told.target)
    if taken is not None and taken.case is not reading.nothing:
        return within * float(taken.case.truth[taken.row])
    return within * max((float(case.truth.max(initial=0.0)) for case in reading.cases), default=0.0)


def _viewpoint(understanding: Understood, reading: Reading | None, tree: Phrase) -> str:
    """Whose left and right was meant, where it matters; "" where no direction is named."""
    if not any(_SIDES & set(words.directions(leaf.text)) or leaf.text == "behind" for leaf in tree.leaves):
        return ""
    if understanding.scene.layout.world.speaker is None or reading is None:
        return "directions are as the robot sees them"
    belief, view = understanding.belief, reading.evaluator.view
    shares = zip(belief.readings, belief.shares, strict=True)
    share = sum(part for other, part in shares if other.evaluator.view == view)
    if len({other.evaluator.view for other in belief.readings}) == 1:
        return f"directions are as the {view} sees them, where nobody else is named"
    return f"directions are as the {view} sees them, where nobody else is named ({share:.2f})"
