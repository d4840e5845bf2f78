from itertools import count

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.language.forest import Node
from grounding.language.tree import Word

weights = st.integers(-20, 0).map(float)


@st.composite
def forests(draw: st.DrawFn) -> Node:
    """A random packed forest of three layers, nodes shared between edges."""
    numbers = count()
    layer = [Node(draw(weights), [], Word(f"w{next(numbers)}", "X", 0)) for _ in range(draw(st.integers(1, 3)))]
    for _ in range(3):
        above = []
        for _ in range(draw(st.integers(1, 3))):
            edges = []
            for _ in range(draw(st.integers(1, 3))):
                second = draw(st.none() | st.sampled_from(layer))
                edges.append((draw(weights), draw(st.sampled_from(layer)), second))
            best = max(weight + one.score + (two.score if two else 0.0) for weight, one, two in edges)
            above.append(Node(best, edges, f"P{next(numbers)}"))
        layer = above
    return layer[0]


def every(node: Node) -> list[float]:
    if not node.edges:
        return [node.score]
    return [
        weight + a + b
        for weight, one, two in node.edges
        for a in every(one)
        for b in (every(two) if two is not None else [0.0])
    ]


@given(forests())
def test_the_k_best_are_the_best_of_all(root: Node) -> None:
    expected = sorted(every(root), reverse=True)[:25]
    found = [root.derivation(rank) for rank in range(len(expected))]
    assert found == pytest.approx(expected)
    assert root.score == pytest.approx(expected[0])


@given(forests())
def test_there_are_no_more_than_all(root: Node) -> None:
    total = len(every(root))
    if total < 200:
        assert root.derivation(total) is None
        assert root.derivation(total - 1) is not None
