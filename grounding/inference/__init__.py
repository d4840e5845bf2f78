"""Inference over the factors: engines of several kinds behind one interface."""

from collections.abc import Callable
from typing import Any

from grounding.inference.adcg import Adcg
from grounding.inference.dcg import Dcg
from grounding.inference.engine import Engine
from grounding.inference.hypotheses import Hypothesis, Inference, aligned

ENGINES: dict[str, Callable[..., Any]] = {"adcg": Adcg, "dcg": Dcg}

__all__ = ["ENGINES", "Adcg", "Dcg", "Engine", "Hypothesis", "Inference", "aligned"]
