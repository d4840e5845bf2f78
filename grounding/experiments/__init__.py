"""The paper's tables and figures (Section V), on any corpus.

`accuracy` measures how many trees are grounded as annotated (Figure 5), `efficiency` what a phrase costs (Table I),
`figures` shows what phrases were grounded to (Figures 6 and 7).
"""

from grounding.experiments.errors import ExperimentError

__all__ = ["ExperimentError"]
