"""The report for people: what was understood, which arm, how long each step took, what was checked."""

from __future__ import annotations

import math
import shutil
from collections.abc import Sequence
from dataclasses import dataclass

from grounding.pictures.marks import listed, meaning_of, telling
from grounding.result import Grounding, PhraseGrounding
from grounding.symbols import ObjectSymbol
from integration.execute.checks import Check, gathered
from integration.execute.report import ANSWERED, DONE, Report, Step

_NARROWEST, _WIDEST = 72, 128


@dataclass(frozen=True)
class Style:
    """The look of a summary.

    Attributes:
        width: columns.
        unicode: whether ticks, crosses and branches can be shown.
        colors: whether the terminal knows colours.
    """

    width: int = 100
    unicode: bool = True
    colors: bool = False

    @classmethod
    def of(cls, stream: object) -> Style:
        """The style that a stream can show."""
        encoding = str(getattr(stream, "encoding", "") or "").lower()
        terminal = bool(getattr(stream, "isatty", lambda: False)())
        columns = shutil.get_terminal_size((100, 24)).columns if terminal else 100
        return cls(min(max(columns, _NARROWEST), _WIDEST), "utf" in encoding, terminal)

    def paint(self, text: str, code: str) -> str:
        """The text in a colour, where there are colours."""
        return f"\x1b[{code}m{text}\x1b[0m" if self.colors else text


def summary(report: Report, style: Style | None = None) -> str:
    """The whole report in a few lines."""
    style = Style() if style is None else style
    blocks = [[style.paint(report.instruction, "1")], _understood(report.grounding, style)]
    if report.handled:
        blocks.append(_moved(report))
    if report.incidents:
        lines = [f"  {one.seconds:6.2f} s  {one.kind}: {one.message}" for one in report.incidents]
        blocks.append(["Incidents", *lines])
    if report.checks:
        blocks.append(_checked(report.checks, style))
    if report.pictures:
        blocks.append([f"{'Pictures':<10}{report.pictures[0]}", *(f"{'':<10}{name}" for name in report.pictures[1:])])
    verdict = report.outcome.replace("_", " ").capitalize()
    color = "1;32" if report.outcome in (DONE, ANSWERED) else "1;31"
    blocks.append([f"{style.paint(verdict, color)}: {report.message}"])
    return "\n\n".join("\n".join(lines) for lines in blocks if lines)


def phrase_tree(grounding: Grounding, style: Style | None = None) -> list[str]:
    """The meaning of every phrase, as an indented tree with probabilities, one phrase a line."""
    style = Style() if style is None else style
    lines: list[str] = []
    shown = _telling(grounding.phrases)
    texts = [f"{'  ' * depth}{phrase.text}" for depth, phrase in shown]
    room = min(max((len(text) for text in texts), default=0), int(style.width * 0.62))
    arrow = " → " if style.unicode else " -> "
    for (_, phrase), text in zip(shown, texts, strict=True):
        found = telling(phrase)
        between = " " if isinstance(found[0][0], ObjectSymbol) else ", "
        meaning = between.join(dict.fromkeys(meaning_of(symbol) for symbol, _ in found))
        left = style.width - room - len(arrow) - 6
        probability = min(p for _, p in found)
        line = f"{_cut(text, room):<{room}}{style.paint(arrow, '2')}{_cut(meaning, left):<{left}}  {probability:4.2f}"
        lines.append(line)
    return lines


def _understood(grounding: Grounding, style: Style) -> list[str]:
    lines = [f"  {line}" for line in phrase_tree(grounding, Style(style.width - 2, style.unicode, style.colors))]
    goals = [f"{a.action} {listed(a.objects)}  {a.probability:.2f}" for a in grounding.actions]
    head = f"{'Understood':<12}{', '.join(goals)}" if goals else f"Understood  {grounding.outcome.replace('_', ' ')}"
    if grounding.unknown_words:
        lines.append(f"  unknown words: {', '.join(grounding.unknown_words)}")
    for action in grounding.alternatives[:4]:
        other = f"{action.action} {listed(action.objects)}  {action.probability:.2f}"
        lines.append(f"  {'or' if goals else 'perhaps'} {other}")
    return [head, *lines]


def _moved(report: Report) -> list[str]:
    lines = [f"{'Arm':<12}{' and '.join(report.arms)}", f"{'Steps':<28}{'seconds':>9}{'simulated':>12}"]
    steps = list(report.steps)
    if len(report.handled) > 1:  # what each object took, not every phase
        steps = [step for step in steps if not _is_phase(step)]
        phases = [step for step in report.steps if _is_phase(step)]
        moving = Step("move", sum(s.seconds for s in phases), sum(s.simulated for s in phases))
        steps.insert(max((i for i, s in enumerate(steps) if s.name.startswith("plan")), default=0) + 1, moving)
    for step in steps:
        if step.seconds >= 0.005 or step.simulated:
            simulated = f"{step.simulated:12.2f}" if step.simulated else ""
            lines.append(f"  {step.name:<26}{step.seconds:>9.2f}{simulated}")
    return lines


def _is_phase(step: Step) -> bool:
    """Tells whether a step is one of the phases of a plan."""
    return bool(step.simulated) and " " not in step.name and step.name != "settle"


def _checked(checks: Sequence[Check], style: Style) -> list[str]:
    lines = ["Checks"]
    ticks = ("✓", "✗") if style.unicode else ("ok", "NO")
    room = max(len(check.meaning) for check in checks)
    for check, count in gathered(checks):
        tick = style.paint(ticks[0], "32") if check.passed else style.paint(ticks[1], "31")
        lines.append(f"  {tick} {check.meaning:<{room}}  {measured(check):>10}  {limit(check, count)}")
    return lines


def measured(check: Check) -> str:
    """The measurement with its unit."""
    if not math.isfinite(check.measured):
        return "nowhere"
    if check.unit == "m":
        return f"{1000 * check.measured:.1f} mm"
    return f"{check.measured:.1f} s" if check.unit == "s" else f"{check.measured:.0f}"


def limit(check: Check, count: int = 1) -> str:
    """The limit in words, and of how many checks this one came nearest to it."""
    value = {"m": f"{1000 * check.limit:g} mm", "s": f"{check.limit:g} s"}.get(check.unit, f"{check.limit:g}")
    among = f", the worst of {count}" if count > 1 else ""
    return f"(at {'least' if check.at_least else 'most'} {value}{among})"


def _telling(phrases: Sequence[PhraseGrounding]) -> list[tuple[int, PhraseGrounding]]:
    """The phrases that were given a meaning, each with how deep it lies among those."""
    shown: list[tuple[int, PhraseGrounding]] = []
    above: list[PhraseGrounding] = []
    for phrase in sorted(phrases, key=lambda p: (p.words[0], -p.words[1], p.depth)):
        if not phrase.groundings:
            continue
        while above and not _contains(above[-1], phrase):
            above.pop()
        if above and above[-1].words == phrase.words and telling(above[-1]) == telling(phrase):
            continue
        shown.append((len(above), phrase))
        above.append(phrase)
    return shown


def _contains(outer: PhraseGrounding, inner: PhraseGrounding) -> bool:
    return outer.words[0] <= inner.words[0] and inner.words[1] <= outer.words[1]


def _cut(text: str, width: int) -> str:
    """The text, without what is too much in its middle."""
    if len(text) <= width:
        return text
    indent = len(text) - len(text.lstrip())
    keep = max(width - indent - 5, 4)
    body = text.strip()
    return text[:indent] + body[: keep // 2].rstrip() + " ... " + body[len(body) - (keep - keep // 2) :].lstrip()
