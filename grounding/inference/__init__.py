"""Inference over the factors: the Adaptive Distributed Correspondence Graph."""

from grounding.inference.adcg import Adcg
from grounding.inference.hypotheses import Hypothesis, Inference, aligned

__all__ = ["Adcg", "Hypothesis", "Inference", "aligned"]
