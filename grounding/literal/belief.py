"""What the parses of a text ask for literally: the reading of the one that agrees best with the world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from grounding.language.parser import Parse
from grounding.language.tree import Phrase
from grounding.literal.presupposed import absences, forms
from grounding.literal.reader import LiteralReader
from grounding.literal.texts import Literal, Rival, read_literally
from grounding.literal.values import FAINT, FIRM, Missing
from grounding.literal.wider import is_missing
from grounding.model.belief import Belief
from grounding.world.scene import ROBOT, Scene

FAMILIAR = 16  # a text of more words may well be misunderstood where only places tell things apart
FAR_FETCHED = 0.02  # parses that the grammar finds so much less likely than the best are read after the others
LIKELY = 0.1  # parses with a smaller share of belief say nothing literally

Option = tuple[str, tuple[str, ...]]


@dataclass(frozen=True)
class LiteralBelief:
    """The literal reading of a text.

    Attributes:
        options: (action, ids) that it leaves, with equal shares; none where it is silent or something is missing.
        missing: what is not there, as a sentence for people; "" where all is, or where that is not known.
        rival: what the words for where to leave open, as far as they were read.
        vague: whether relations were read on which eyes differ.
        alike: whether places are all that tells the things of the world apart.
        plural: whether it speaks of several: where a side or a neighbourhood ends is read off graded worths by a cut,
            so that sets which hold literally are worth all.
    """

    options: tuple[tuple[Option, float], ...] = ()
    missing: str = ""
    rival: Rival | None = None
    vague: bool = False
    alike: bool = False
    plural: bool = False

    @property
    def is_open(self) -> bool:
        """Whether the words hold of several things alike."""
        return len(self.options) > 1


SILENT = LiteralBelief()
"""Of whom nothing is read literally."""


def believe_literally(
    parses: Sequence[Parse], scene: Scene, belief: Belief, history: Sequence[str] = ()
) -> LiteralBelief:
    """Read the likely parses literally; what singles something out is preferred, and what is there to what is missing.

    Args:
        parses: of the text, the likeliest first.
        scene: the world.
        belief: in the meanings of the parses.
        history: ids of the objects handled before, the latest last.
    """
    index = scene.layout.index
    handled = tuple(index[name] for name in history if name in index)
    shares = _shares(belief)
    words = len(parses[0].tree.leaves)
    found: list[Literal] = []
    best = max(parse.probability for parse in parses)
    for place in sorted(shares, key=lambda place: (parses[place].probability < FAR_FETCHED * best, -shares[place])):
        if shares[place] < LIKELY:
            break
        literal = read_literally(parses[place].tree, scene, handled)
        if literal is None and not found:
            return _silent(parses[place].tree, scene, belief, handled)
        if literal is None:
            continue
        found.append(literal)
        missing = literal.missing
        sharp = missing is not None and missing.limit == FIRM and missing.noun is not None
        if missing is not None and len(found) == 1 and sharp and _gone(missing, words, scene, belief, handled):
            break  # no other parse makes up for a shape or a count that is not there
        if len(literal.options) == 1 and literal.placed:
            break
    told = min(found, key=lambda literal: (not literal.placed, len(literal.options) or len(parses) + scene.n),
               default=None)  # fmt: skip
    if told is None:
        return SILENT
    if told.missing is not None:
        gone = _gone(told.missing, words, scene, belief, handled)
        made = told.missing.noun is not None and told.missing.noun.head == "container" and forms(parses[0].tree)
        if not gone or (made and belief.readings[:1] and belief.readings[0].told.kind == "place"):
            return SILENT  # what is to be made need not be there
        return LiteralBelief(missing=f"{told.missing}; to make one, say which block goes where" if made
                             else str(told.missing))  # fmt: skip
    share = 1.0 / len(told.options)
    options = tuple(((told.kind, names), share) for names in told.options)
    alike = len(scene.layout.colors) < 2 and belief.agreement >= FAINT
    return LiteralBelief(options, rival=told.rival, vague=told.vague, alike=alike, plural=told.plural)


def _shares(belief: Belief) -> dict[int, float]:
    """The share of belief of every parse that was read; all for the first where none was."""
    shares: dict[int, float] = {}
    for reading, share in zip(belief.readings, belief.shares, strict=True):
        shares[reading.place] = shares.get(reading.place, 0.0) + share
    return shares or {0: 1.0}


def _gone(missing: Missing, words: int, scene: Scene, belief: Belief, history: tuple[int, ...]) -> bool:
    """Whether what is literally missing is so for whom else may speak, and in a wider sense."""
    views = {reading.evaluator.view: None for reading in belief.readings} or {ROBOT: None}
    agreement = belief.agreement
    alike = len(scene.layout.colors) < 2
    if alike and words > FAMILIAR and missing.limit != FIRM:
        return False  # a long text that agrees with nothing is misunderstood rather than wrong
    return is_missing(missing, agreement, scene, views, history)


def _silent(tree: Phrase, scene: Scene, belief: Belief, history: tuple[int, ...]) -> LiteralBelief:
    """What is believed of a text that is not read as a whole."""
    for missing in absences(tree, LiteralReader(scene, history)):
        if _gone(missing, len(tree.leaves), scene, belief, history):
            return LiteralBelief(missing=str(missing))
    return SILENT
