"""From annotated examples to factors: rows for training, and scores of what was learned."""

from grounding.learning.evaluation import Evaluation, evaluate
from grounding.learning.examples import Coverage, Negatives, collect
from grounding.learning.first_pass import learn_first_pass
from grounding.learning.learner import learn

__all__ = ["Coverage", "Evaluation", "Negatives", "collect", "evaluate", "learn", "learn_first_pass"]
