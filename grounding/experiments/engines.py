"""The methods of inference that experiments compare, by their names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from grounding.experiments.errors import ExperimentError
from grounding.factors import FactorModel
from grounding.inference import ENGINES, Engine

__all__ = ["Engine", "check_engines", "make_engine"]


def check_engines(names: tuple[str, ...]) -> None:
    """Refuse names that no engine has.

    Raises:
        ExperimentError: naming the engines there are.
    """
    for name in names:
        if name not in ENGINES:
            raise ExperimentError(f"no inference {name!r}; there are {', '.join(ENGINES)}")


def make_engine(name: str, model: FactorModel, options: Mapping[str, Any] | None = None) -> Engine:
    """An engine with the factors of a model."""
    engine: Engine = ENGINES[name](model, **(options or {}))
    return engine
