"""Explanations as lines of text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from grounding.explanations.values import (
    Contribution,
    Degrees,
    Explanation,
    LineExplained,
    Objects,
    Option,
    PhraseExplained,
    Weighed,
)

_REASONS = 4
_FEATURES = 3
_WIDTH = 46  # of the lines of a meaning, where what stands beside them begins
_UNTRUE = 0.5  # below this it is told how true a referent is of what it means best
_KINDS = {"objects": "weights", "sets": "sets", "degree": "holds of", "place": "lies there"}
_SHORT = {"truth": "true", "preference": "preferred", "rank": "ranked"}


def told(explanation: Explanation, decided: bool = True) -> list[str]:
    """What to print below an answer.

    Args:
        explanation: of the answer.
        decided: whether one option was taken; else the others did not lose, but are as likely.
    """
    lines = [f"  {written!r} was read as {read!r}" for written, read in explanation.mended]
    if explanation.viewpoint:
        lines.append(f"  {explanation.viewpoint}")
    if not explanation.complete:
        lines.append("  the text does not parse as a whole; its pieces were put together")
    lines += [f"  missing: {text}" for text in explanation.missing]
    if explanation.answer is not None:
        lines.append(f"  believed: {_option(explanation.answer)}")
    if explanation.nothing >= 0.005:
        lines.append(f"  that nothing here is meant: {explanation.nothing:.2f}")
    for rival in explanation.rivals:
        lines.append(f"  {'lost:' if decided else 'or:':9} {_option(rival.option)}")
        if not rival.reasons and not rival.features:
            lines.append("      nothing that was said tells it apart")
        lines += [f"      {_weight(reason)}" for reason in rival.reasons[:_REASONS]]
        if rival.features:
            lines.append(f"      by weights: {'; '.join(map(_weight, rival.features[:_FEATURES]))}")
    lines.append(f"meaning (of a parse with probability {explanation.probability:.2f}):")
    lines += [f"  {_line(line)}" for line in explanation.meaning]
    if not explanation.meaning:
        lines.append("  nothing that could be handled is spoken of")
    lines.append("phrases:")
    for phrase in explanation.phrases:
        lines += [f"  {'  ' * phrase.depth}{line}" for line in _phrase(phrase)]
    return lines


def _option(option: Option) -> str:
    return f"{option.action} {' '.join(option.objects)} {option.probability:.2f}"


def _line(line: LineExplained) -> str:
    beside = [f"{' '.join(names)} {_degrees(degrees)}" for names, degrees in line.degrees]
    if line.likely:
        beside.append(_likely(line.likely))
    if line.truth is not None and line.truth < _UNTRUE:
        beside.append(f"true {line.truth:.2f}")
    return f"{line.text:{_WIDTH}}  {'; '.join(beside)}".rstrip()


def _degrees(degrees: Degrees) -> str:
    return ", ".join(
        f"{_SHORT[name]} {value:.2f}" for name, value in degrees._asdict().items() if value is not None
    )  # fmt: skip


def _likely(likely: Iterable[tuple[Objects, float]]) -> str:
    return ", ".join(f"{' '.join(names)} {weight:.2f}" for names, weight in likely)


def _phrase(phrase: PhraseExplained) -> Iterator[str]:
    symbols = ", ".join(f"{symbol} {probability:.2f}" for symbol, probability in phrase.symbols)
    yield f"{phrase.tag} {phrase.text!r}{': ' if symbols else ''}{symbols}"
    if phrase.weighed is not None and (text := _weighed(phrase.weighed)):
        yield f"    {text}"


def _weighed(weighed: Weighed) -> str:
    if weighed.kind in _KINDS:
        note = f" ({weighed.note})" if weighed.note else ""
        return f"{_KINDS[weighed.kind]}{note}: {_likely(weighed.likely) or 'nothing'}"
    return weighed.note


def _weight(reason: Contribution) -> str:
    return f"{reason.text} ({reason.weight:+.1f})"
