"""From readings to an outcome: an answer, a question, or what is missing or was not understood."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grounding.describing import name_objects, too_few
from grounding.destinations import find_destination
from grounding.geometry.layout import Layout
from grounding.graded.belief import GradedBelief
from grounding.inference import Hypothesis, aligned
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.pooling import Pooled, pool
from grounding.readings import Reading
from grounding.result import Destination, GroundedAction, Grounding, PhraseGrounding
from grounding.symbols import Action, Symbol, symbol_key
from grounding.unanswered import unanswered

ANSWERED = 0.4  # an answer is given when it is so likely
MARGIN = 1.4  # and so many times likelier than the next one
CREDIBLE = 0.1  # graded readings that agree less with the world tell nothing: then the factors alone decide
CONFIDENT = 0.62  # an answer is given when it is clearly likelier than all others together
_PAST = frozenset(("was", "were", "been"))
_NEGATIONS = frozenset(("not", "n't", "never", "don't", "dont", "without", "except"))
_LISTED = 0.01  # alternatives less likely than this are not worth naming
_MOST = 5
_NOUN_TAGS = ("NN", "NNS", "NNP", "NNPS")


def decide(
    text: str,
    found: Sequence[Reading],
    layout: Layout,
    unknown_words: Iterable[str] = (),
    graded: GradedBelief | None = None,
) -> Grounding:
    """Weigh the readings.

    Args:
        text: the instruction.
        found: its readings by the factors, the likeliest first.
        layout: the world.
        unknown_words: that the grammar does not know.
        graded: its graded readings, with which the factors' belief is pooled, see `grounding.pooling`.
    """
    unknown = tuple(unknown_words)
    if graded is not None and graded.options and graded.truth >= CREDIBLE:
        return _pooled(text, found, layout, unknown, graded)
    refusal = _beyond(found[0].inference.tree)
    if refusal is not None:
        return Grounding(text, "not_understood", (), (), None, refusal, unknown, 0.0, _phrases(found[0], {}))
    belief: dict[Action, float] = {}
    bearers: dict[Action, Reading] = {}
    nothing = 0.0
    for reading in found:
        if not reading.actions:
            nothing += reading.weight
        for action in reading.actions:
            belief[action] = belief.get(action, 0.0) + reading.weight / len(reading.actions)
            bearers.setdefault(action, reading)
    ordered = sorted(belief.items(), key=lambda item: (-item[1], symbol_key(item[0])))
    if not ordered or nothing > 0.5:
        return _without_answer(text, found[0], layout, unknown)
    best, probability = ordered[0]
    if probability >= CONFIDENT:
        destination = (
            None if best.destination is None else find_destination(best.destination, best.objects, layout.world)
        )
        if best.destination is not None and destination is None:
            why = f"there is no free place {_where(best, layout)}"
            return Grounding(text, "no_referent", (), (), None, why, unknown, 0.0, _phrases(bearers[best], belief))
        chosen = GroundedAction(best.kind, best.objects, probability, destination)
        others = tuple(_alternative(a, p, layout) for a, p in ordered[1 : _MOST + 1] if p >= _LISTED)
        return Grounding(text, "grounded", (chosen,), others, None, "", unknown, 0.0, _phrases(bearers[best], belief))
    for phrase, hypothesis in aligned(found[0].inference.tree, found[0].hypothesis):
        few = too_few(layout, hypothesis.symbols)
        if few is not None:
            why = f"{phrase.text!r}: {few}"
            return Grounding(text, "no_referent", (), (), None, why, unknown, 0.0, _phrases(bearers[best], belief))
    alternatives = tuple(_alternative(a, p, layout) for a, p in ordered[:_MOST] if p >= _LISTED)
    question = _question([a for a, p in ordered if p >= _LISTED], layout)
    count = len(alternatives)
    why = f"{len(ordered)} readings are possible" if count > 1 else "the only reading is not sure enough"
    return Grounding(text, "ambiguous", (), alternatives, question, why, unknown, 0.0, _phrases(bearers[best], belief))


def _pooled(
    text: str, found: Sequence[Reading], layout: Layout, unknown: tuple[str, ...], graded: GradedBelief
) -> Grounding:
    """Weigh what the factors and the graded readings believe."""
    tree = found[0].inference.tree
    refusal = _forbidden(tree)
    if refusal is not None:
        return Grounding(text, "not_understood", (), (), None, refusal, unknown, 0.0, _phrases(found[0], {}))
    belief: dict[Action, float] = {}
    bearers: dict[Action, Reading] = {}
    for reading in found:
        for action in reading.actions:
            belief[action] = belief.get(action, 0.0) + reading.weight / len(reading.actions)
            bearers.setdefault(action, reading)
    factors: dict[tuple[str, tuple[str, ...]], float] = {}
    for action, share in belief.items():
        factors[action.kind, action.objects] = factors.get((action.kind, action.objects), 0.0) + share
    options = pool(factors, graded.options)
    actions = [_action_of(option, belief, graded, layout) for option in options[: _MOST + 1]]
    best, margin = options[0], options[0].probability / max(options[1].probability if len(options) > 1 else 0.0, 1e-9)
    bearer = next((r for a, r in bearers.items() if a.objects == best.objects), found[0])
    phrases = _phrases(bearer, belief)
    if best.probability >= ANSWERED and margin >= MARGIN:
        chosen = actions[0]
        others = tuple(action for action in actions[1:] if action.probability >= _LISTED)
        if chosen.action == "place" and chosen.destination is None:
            why = "where to is open: say where to put it, such as on, beside or behind something"
            return Grounding(text, "ambiguous", (), (chosen, *others), "Where shall I put it?", why, unknown, 0.0, phrases)
        return Grounding(text, "grounded", (chosen,), others, None, "", unknown, 0.0, phrases)
    listed = tuple(action for action in actions[:_MOST] if action.probability >= _LISTED)
    question = _question([Action(a.action, a.objects) for a in listed], layout)
    why = f"{len(listed)} readings are possible" if len(listed) > 1 else "the only reading is not sure enough"
    return Grounding(text, "ambiguous", (), listed, question, why, unknown, 0.0, phrases)


def _action_of(option: Pooled, belief: dict[Action, float], graded: GradedBelief, layout: Layout) -> GroundedAction:
    kind = option.kinds[0][0]
    destination = None
    if kind == "place":
        destination = graded.destination(option.objects)
        if destination is None:
            asked = [a for a in belief if a.kind == "place" and a.objects == option.objects]
            destination = next((d for a in asked if (d := _destination(a, layout)) is not None), None)
    return GroundedAction(kind, option.objects, option.probability, destination)


def _forbidden(tree: Phrase) -> str | None:
    """What an instruction says against acting."""
    for phrase in tree.preorder():
        if phrase.tag in ("VP", "S", "FRAG"):
            texts = [word.text for word in phrase.words]
            if any(text in ("not", "n't", "never", "don't", "dont") for text in texts) and not (
                {"is", "are", "'s", "does"} & set(texts)
            ):
                return f"{phrase.text!r} tells me what not to do; say what to do"
    return None


def _beyond(tree: Phrase) -> str | None:
    """What an instruction says beyond what can be carried out, so that half of it must not be."""
    for leaf in tree.leaves:
        if leaf.text in _NEGATIONS:
            return f"{leaf.text!r} tells me what not to do or to leave out; say what to do"
        if leaf.text in _PAST:
            return f"{leaf.text!r} tells what was, not what to do; say what to do"
        if leaf.text[:1].isdigit() and not meanings(leaf.text):
            return f"I do not understand the number {leaf.text!r}; whole numbers from 1, and ranks such as 2nd, will do"
        if leaf.text == "or":
            return "'or' leaves the choice open; say which one"
    for phrase in tree.preorder():
        steps = [child for child in phrase.phrases if child.tag == "VP"]
        if len(steps) > 1 and any(word.tag == "CC" for word in phrase.words):
            return f"this asks for several things; one at a time, please: {steps[0].text!r} first"
    return None


def _without_answer(text: str, reading: Reading, layout: Layout, unknown: tuple[str, ...]) -> Grounding:
    why = unanswered(reading, layout, unknown)
    options = tuple(GroundedAction(kind, names, share) for kind, names, share in why.alternatives)
    heard = why.words or unknown
    return Grounding(
        text, why.outcome, (), options, why.question, why.explanation, heard, 0.0, _phrases(reading, {})
    )  # fmt: skip


def _alternative(action: Action, probability: float, layout: Layout) -> GroundedAction:
    return GroundedAction(action.kind, action.objects, probability, _destination(action, layout))


def _destination(action: Action, layout: Layout) -> Destination | None:
    if action.destination is None:
        return None
    return find_destination(action.destination, action.objects, layout.world)


def _question(actions: Sequence[Action], layout: Layout) -> str:
    """Asks which one is meant, naming what tells them apart."""
    kinds = sorted({action.kind for action in actions})
    if len({action.objects for action in actions}) == 1:
        if len(kinds) > 1:
            return f"Shall I {' or '.join(kinds)} {name_objects(layout, actions[0].objects)}?"
        places = [_where(action, layout) for action in actions[:3]]
        return f"Where do you want {name_objects(layout, actions[0].objects)}: {' or '.join(dict.fromkeys(places))}?"
    rivals = [name for action in actions for name in action.objects]
    names = list(dict.fromkeys(name_objects(layout, action.objects, rivals) for action in actions[:3]))
    more = len({action.objects for action in actions}) - len(names)
    rest = "" if more <= 0 else ", or another one" if more == 1 else f", or one of {more} others"
    if len(names) == 1:
        return f"Do you mean {names[0]}{rest}?"
    listed = ", ".join(names) if rest else ", ".join(names[:-1]) + f" or {names[-1]}"
    return f"Do you mean {listed}{rest}?"


def _where(action: Action, layout: Layout) -> str:
    region = action.destination
    if region is None:
        return "where it is"
    words = {"top": "on", "near": "beside", "front": "in front of", "back": "behind", "between": "between",
             "left": "to the left of", "right": "to the right of", "center": "in the middle of",
             "bottom": "under", "far": "far from"}  # fmt: skip
    reference = name_objects(layout, region.objects) if region.objects else "the robot"
    return f"{words[region.relation]} {reference}"


def _phrases(reading: Reading, belief: dict[Action, float]) -> tuple[PhraseGrounding, ...]:
    """Every phrase of a reading with the symbols it was grounded to."""
    found: list[PhraseGrounding] = []

    def visit(phrase: Phrase, hypothesis: Hypothesis, depth: int) -> None:
        symbols: list[tuple[Symbol, float]] = []
        for symbol in hypothesis.symbols:
            probability = hypothesis.probabilities.get(symbol, 1.0)
            if isinstance(symbol, Action) and symbol in belief:
                probability = belief[symbol]
            symbols.append((symbol, probability))
        symbols.sort(key=lambda item: (-item[1], symbol_key(item[0])))
        span = (phrase.leaves[0].index, phrase.leaves[-1].index)
        found.append(PhraseGrounding(phrase.text, phrase.tag, span, depth, tuple(symbols)))
        for child, part in zip(phrase.phrases, hypothesis.children, strict=True):
            visit(child, part, depth + 1)

    visit(reading.inference.tree, reading.hypothesis, 0)
    return tuple(found)
