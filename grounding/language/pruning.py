"""How much of a chart is kept: a beam by probability and by number."""

from __future__ import annotations

from dataclasses import dataclass

from grounding.language.forest import Node

Table = dict[int, Node]
"""A cell of the chart, or a part of one: symbols or states by number."""


@dataclass(frozen=True)
class Beam:
    """How much of the chart is kept.

    Attributes:
        width: a node is dropped when it is worse than the best of its cell by more than this, as log probability.
        size: at most so many constituents, and so many unfinished phrases on each side, stay in a cell.
        slack: a cell is looked at once more when its constituents have become heads of others; then this much is added
            to the width, and as many nodes to the size.
        span: no constituent has more words than this.
    """

    width: float = 7.5
    size: int = 6
    slack: int = 1
    span: int = 40


def prune(table: Table, rank: list[float], beam: Beam, slack: int = 0) -> None:
    """Drop the nodes of a cell that are far worse than its best, and the worst of too many.

    Args:
        table: the cell; it is changed.
        rank: log of how common each symbol, or that of each state, is.
        beam: how much to keep.
        slack: so much more.
    """
    if len(table) < 2:
        return
    scores = sorted(((node.score + rank[number], number) for number, node in table.items()), reverse=True)
    limit = scores[0][0] - beam.width - slack
    for place, (score, number) in enumerate(scores):
        if score < limit or place >= beam.size + slack:
            del table[number]
