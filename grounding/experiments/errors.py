"""What experiments raise."""

from grounding.errors import GroundingError


class ExperimentError(GroundingError):
    """An experiment that cannot be run as asked for, or that broke off; says which part and why."""
