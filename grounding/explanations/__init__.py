"""Why an instruction was understood as it was: its meaning, how true that is, and what lost against it."""

from grounding.explanations.explain import explain
from grounding.explanations.telling import told
from grounding.explanations.values import (
    Contribution,
    Degrees,
    Explanation,
    LineExplained,
    Option,
    PhraseExplained,
    Rival,
    Weighed,
)

__all__ = [
    "Contribution", "Degrees", "Explanation", "LineExplained", "Option", "PhraseExplained", "Rival", "Weighed",
    "explain", "told",
]  # fmt: skip
