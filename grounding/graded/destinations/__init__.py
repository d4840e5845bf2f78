"""Where to: directions, distances and references in the order of the words become a point on the table.

`line_up` puts the words in a row, `listen` takes clues from them, and `find_spot` looks for the place that agrees best.
"""

from grounding.graded.destinations.spots import Spot, agreed, find_spot, leads_off

__all__ = ["Spot", "agreed", "find_spot", "leads_off"]
