"""Log-linear factors over binary correspondences: scoring, training, weights on disk."""

from grounding.factors.factor import Factor
from grounding.factors.first_pass import FirstPass
from grounding.factors.model import FactorModel
from grounding.factors.storage import load_model, save_model
from grounding.factors.training import TrainingSet, train

__all__ = ["Factor", "FactorModel", "FirstPass", "TrainingSet", "load_model", "save_model", "train"]
