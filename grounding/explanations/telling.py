"""Explanations as lines of text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from grounding.explanations.values import Contribution, Explanation, Judged, Option, PhraseExplained, Weighed
from grounding.pictures.marks import telling_of

_SHOWN = 2
_ALONE = 3
_KINDS = {"objects": "weights", "sets": "sets", "order": "ranks", "degree": "holds of", "place": "lies there"}


def told(explanation: Explanation, decided: bool = True) -> list[str]:
    """What to print below an answer.

    Args:
        explanation: of the answer.
        decided: whether one option was taken; else the others did not lose, but are as likely.
    """
    lines = []
    for written, read in explanation.mended:
        lines.append(f"  {written!r} was read as {read!r}")
    if explanation.viewpoint:
        lines.append(f"  {explanation.viewpoint}")
    if not explanation.complete:
        lines.append("  the text does not parse as a whole; its pieces were put together")
    if explanation.answer is not None:
        lines.append(f"  believed: {_option(explanation.answer)}")
    if explanation.factors_alone:
        alone = " or ".join(" ".join(objects) for objects in explanation.factors_alone[:_ALONE])
        lines.append(f"      the factors alone would have meant {alone}; the phrases below are as they have them")
    for rival in explanation.rivals:
        lines.append(f"  {'lost:' if decided else 'or:':9} {_option(rival.option)}")
        if not rival.reasons and not rival.features:
            lines.append("      nothing that was said tells it apart")
        lines += [f"      {_weight(reason)}" for reason in rival.reasons[: 2 * _SHOWN]]
        if rival.features:
            lines.append(f"      by the factors: {_joined(rival.features)}")
    lines.append("phrases:")
    for phrase in explanation.phrases:
        lines += [f"  {'  ' * phrase.depth}{line}" for line in _phrase(phrase)]
    return lines


def _option(option: Option) -> str:
    return (
        f"{option.action} {' '.join(option.objects)} {option.probability:.2f}"
        f" (graded readings {option.graded:.2f}, factors {option.factors:.2f})"
    )


def _phrase(phrase: PhraseExplained) -> Iterator[str]:
    symbols = ", ".join(f"{judged.symbol} {judged.probability:.2f}" for judged in phrase.symbols) or "nothing"
    yield f"{phrase.tag} {phrase.text!r}: {symbols}"
    if phrase.weighed is not None:
        text = _weighed(phrase.weighed)
        if text:
            yield f"    {text}"
    main = telling_of([judged.symbol for judged in phrase.symbols])
    for judged in phrase.symbols:
        if judged.symbol == main:
            yield from _features(judged)
    if phrase.rival is not None and phrase.lost:
        yield f"    {phrase.rival.symbol} {phrase.rival.probability:.2f} loses: {_joined(phrase.lost)}"


def _features(judged: Judged) -> Iterator[str]:
    for label, features in (("for", judged.pros[:_SHOWN]), ("against", judged.cons[:1])):
        for feature in features:
            yield f"    {label} {judged.symbol}: {_weight(feature)}"


def _weighed(weighed: Weighed) -> str:
    likely = (", then " if weighed.kind == "order" else ", ").join(
        f"{' '.join(names)}" if weighed.kind == "order" else f"{' '.join(names)} {weight:.2f}"
        for names, weight in weighed.likely
    )
    if weighed.kind in _KINDS:
        note = f" ({weighed.note})" if weighed.note else ""
        return f"{_KINDS[weighed.kind]}{note}: {likely or 'nothing'}"
    return weighed.note


def _joined(reasons: Iterable[Contribution]) -> str:
    return "; ".join(_weight(reason) for reason in list(reasons)[:_SHOWN] if reason.weight < 0)


def _weight(reason: Contribution) -> str:
    return f"{reason.text} ({reason.weight:+.1f})"
