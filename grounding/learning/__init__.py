"""From annotated examples to factors: rows for training, and scores of what was learned."""

from grounding.learning.evaluation import Evaluation, evaluate
from grounding.learning.examples import Coverage, collect, learn

__all__ = ["Coverage", "Evaluation", "collect", "evaluate", "learn"]
