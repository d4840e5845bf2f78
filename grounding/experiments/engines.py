"""The methods of inference that experiments compare, by their names."""

from __future__ import annotations

from grounding.experiments.errors import ExperimentError
from grounding.factors import FactorModel
from grounding.inference import ENGINES, Engine

__all__ = ["ADAPTIVE", "FLAT", "PROPOSING", "Engine", "check_engines", "make_engine", "needed_negatives"]

ADAPTIVE = "adcg"
PROPOSING = (ADAPTIVE, "hadcg")  # methods whose cost does not forbid large worlds
FLAT = {"hadcg": ADAPTIVE, "hdcg": "dcg"}  # hierarchical methods, with what they do without their first pass


def check_engines(names: tuple[str, ...]) -> None:
    """Refuse names that no engine has.

    Raises:
        ExperimentError: naming the engines there are.
    """
    for name in names:
        if name not in ENGINES:
            raise ExperimentError(f"no inference {name!r}; there are {', '.join(ENGINES)}")


def make_engine(name: str, model: FactorModel) -> Engine:
    """An engine with the factors of a model."""
    engine: Engine = ENGINES[name](model)
    return engine


def needed_negatives(names: tuple[str, ...], exhaustive: int) -> int:
    """In worlds of how many blocks all of Γ has to be negative in training, for these engines.

    Engines that judge symbols which are never proposed need factors that have learned from these.

    Args:
        names: of engines.
        exhaustive: blocks of the largest world that exhaustive engines are run on.
    """
    return exhaustive if set(names).difference(PROPOSING) else 0
