"""Why an instruction was understood as it was: of every phrase, of the answer, and of what lost against it."""

from grounding.explanations.explain import explain
from grounding.explanations.telling import told
from grounding.explanations.values import Contribution, Explanation, Judged, PhraseExplained, Rival, Weighed

__all__ = ["Contribution", "Explanation", "Judged", "PhraseExplained", "Rival", "Weighed", "explain", "told"]
