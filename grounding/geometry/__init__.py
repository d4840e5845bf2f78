"""What can be measured in a world: directions, regions, arrangements; computed once a world and shared by phrases."""

from grounding.geometry.arrangements import Arrangement
from grounding.geometry.layout import Layout

__all__ = ["Arrangement", "Layout"]
