"""An explanation as a picture from above: what every phrase weighs, and why others lost."""

from __future__ import annotations

from PIL import Image

from grounding.explanations.values import Explanation, PhraseExplained
from grounding.pictures.palette import INK, MARKS
from grounding.pictures.shades import Panel, draw_panels
from grounding.pictures.sheet import Row
from grounding.result import Grounding
from grounding.symbols import ObjectSymbol
from grounding.world import World

MOST = 9  # panels
_REASONS = 3
_NOTES = {
    "objects": "how well each is what is meant", "sets": "the likeliest sets",
    "degree": "how well it holds of each", "place": "how well each lies there",
}  # fmt: skip


def draw_explanation(world: World, result: Grounding, explanation: Explanation) -> Image.Image:
    """Draw what every phrase weighs in panels of its own, the answer ringed.

    Args:
        world: what is there.
        result: the answer.
        explanation: of it.
    """
    answer = explanation.answer.objects if explanation.answer is not None and result.outcome == "grounded" else ()
    shown = [phrase for phrase in explanation.phrases if _weights(phrase)]
    kept: list[PhraseExplained] = []
    for phrase in shown:
        if not any(_weights(phrase) == _weights(other) and _contains(other, phrase) for other in kept):
            kept.append(phrase)
    panels = [
        Panel(phrase.text, _weights(phrase), _note(phrase), answer, MARKS[0] if i == 0 else INK)
        for i, phrase in enumerate(kept[:MOST])
    ]
    if not panels:
        panels = [Panel(result.instruction, {}, "no phrase means anything here", answer)]
    outcome = result.outcome if not result.explanation else f"{result.outcome}: {result.explanation}"
    title = f"{result.instruction}  -  {outcome}"
    return draw_panels(world, panels, title, _rows(result, explanation), _small(explanation))


def _weights(phrase: PhraseExplained) -> dict[str, float]:
    """The weights of a phrase, or else the probabilities of the objects that the result says it means."""
    if phrase.weighed is not None and any(phrase.weighed.weights.values()):
        return dict(phrase.weighed.weights)
    return {symbol.id: probability for symbol, probability in phrase.symbols if isinstance(symbol, ObjectSymbol)}


def _contains(outer: PhraseExplained, inner: PhraseExplained) -> bool:
    return outer.words[0] <= inner.words[0] and inner.words[1] <= outer.words[1]


def _note(phrase: PhraseExplained) -> str:
    if phrase.weighed is None:
        return ""
    note = _NOTES.get(phrase.weighed.kind, "")
    return f"{note}, {phrase.weighed.note}" if phrase.weighed.note else note


def _rows(result: Grounding, explanation: Explanation) -> list[Row]:
    rows = []
    if explanation.answer is not None:
        option = explanation.answer
        sign = "passed" if result.outcome == "grounded" else "object"
        told = f"{option.action} {' '.join(option.objects)}"
        detail = f"how well it holds: {explanation.truth:.2f}"
        rows.append(Row(sign, told, detail, f"{option.probability:.2f}", MARKS[0]))
    for rival in explanation.rivals:
        reasons = rival.reasons or rival.features
        detail = "; ".join(reason.text for reason in reasons[:_REASONS]) or "as good"
        sign = "failed" if result.outcome == "grounded" else "object"
        rows.append(Row(sign, " ".join(rival.option.objects), detail, f"{rival.option.probability:.2f}", INK))
    return rows


def _small(explanation: Explanation) -> str:
    said = [f"{written!r} was read as {read!r}" for written, read in explanation.mended]
    if explanation.viewpoint:
        said.append(explanation.viewpoint)
    return "; ".join(said)
