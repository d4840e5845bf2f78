"""Hierarchical inference: a first pass infers which kinds of symbols a phrase needs, a second one grounds it in those.

After Chung, Propp, Walter and Howard, "On the performance of hierarchical distributed correspondence graphs for
efficient symbol grounding of robot instructions", IROS 2015. The first pass has a binary correspondence φ_κ for every
phrase and every kind κ of symbols, given the likeliest ones of its child phrases, its words and the world in coarse
words. The second one is that of another engine over the restricted space

    Γ_i = { γ : p(φ_kind(γ) = true | λ_i, Φ_children, Υ) >= threshold }

and takes all correspondences outside of it for false. A threshold of 0 gives that engine's own answer.
"""

from __future__ import annotations

from grounding.errors import ModelError
from grounding.factors.first_pass import FirstPass
from grounding.factors.model import FactorModel
from grounding.inference.adcg import Adcg
from grounding.inference.dcg import Dcg


class Hdcg(Dcg):
    """The Hierarchical DCG: all symbols of the kinds that are needed are judged.

    Args:
        model: the factors, with a first pass; trained with all incorrect combinations as negatives.
        beam: how many hypotheses a phrase keeps.
        least: hypotheses less likely than the best by this factor are dropped.
        first_pass: to be used instead of the model's own.

    Raises:
        ModelError: there is no first pass.
    """

    def __init__(
        self, model: FactorModel, beam: int = 4, least: float = 0.02, first_pass: FirstPass | None = None
    ) -> None:
        super().__init__(model, beam, least, first_pass or _first_pass_of(model))


class Hadcg(Adcg):
    """Hierarchical on top of ADCG: of the symbols that a phrase proposes, those of the kinds that are needed.

    Args:
        model: the factors, with a first pass.
        threshold: p_T; concrete symbols less likely than this take no part in what is proposed.
        beam: how many hypotheses a phrase keeps.
        least: hypotheses less likely than the best by this factor are dropped.
        first_pass: to be used instead of the model's own.

    Raises:
        ModelError: there is no first pass.
    """

    def __init__(
        self,
        model: FactorModel,
        threshold: float = 0.05,
        beam: int = 4,
        least: float = 0.02,
        first_pass: FirstPass | None = None,
    ) -> None:
        super().__init__(model, threshold, beam, least, first_pass or _first_pass_of(model))


def _first_pass_of(model: FactorModel) -> FirstPass:
    if model.first_pass is None:
        raise ModelError(
            "these weights have no first pass, which hierarchical inference (hdcg, hadcg) needs; `python -m grounding "
            "train --first-pass-only` adds one, adcg and dcg do without"
        )
    return model.first_pass
