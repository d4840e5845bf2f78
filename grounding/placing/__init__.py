"""Where to: what the words of a destination say becomes a point that is free and supported.

The clues come from `grounding.meaning.goal`. `find_spot` looks for the place that agrees best with those of one reading,
`destination` for what most readings of a text agree on.
"""

from grounding.placing.goal import destination, leads_off_table
from grounding.placing.spots import Spot, agreed, find_spot, leads_off

__all__ = ["Spot", "agreed", "destination", "find_spot", "leads_off", "leads_off_table"]
