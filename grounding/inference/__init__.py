"""Inference over the factors: engines of several kinds behind one interface."""

from collections.abc import Callable

from grounding.inference.adcg import Adcg
from grounding.inference.dcg import Dcg
from grounding.inference.engine import Engine
from grounding.inference.exact import Exact
from grounding.inference.g3 import G3
from grounding.inference.hierarchical import Hadcg, Hdcg
from grounding.inference.hypotheses import Hypothesis, Inference, aligned

ENGINES: dict[str, Callable[..., Engine]] = {
    "adcg": Adcg, "hadcg": Hadcg, "dcg": Dcg, "hdcg": Hdcg, "exact": Exact, "g3": G3,
}  # fmt: skip

__all__ = ["ENGINES", "G3", "Adcg", "Dcg", "Engine", "Exact", "Hadcg", "Hdcg", "Hypothesis", "Inference", "aligned"]
