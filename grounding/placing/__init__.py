"""Destinations: what their words say becomes a point that is free and supported.

`grounding.meaning.goal` hears the clues. `find_spot` looks for the place that agrees best with the clues of
one reading, `destination` for the place that most readings of a text agree on.
"""

from grounding.placing.by_belief import destination, leads_off_table
from grounding.placing.spots import FoundSpot, agreed, find_spot, leads_off

__all__ = ["FoundSpot", "agreed", "destination", "find_spot", "leads_off", "leads_off_table"]
