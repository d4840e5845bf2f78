"""The binary features f(φ, γ, λ, Φ_children, Υ) of the factors.

A feature is the conjunction of a role of the symbol ("is the index-th along the head's direction within the set that
the modifier grounded to") and a fact of the context ("the head noun is plural", "a modifier has grounded to a region").
Roles name sets by how they come about, not by their members, so that weights carry over to worlds never seen.
"""

from grounding.features.families import FAMILIES, STAGES, Family, family_of
from grounding.features.scope import Scope

__all__ = ["FAMILIES", "STAGES", "Family", "Scope", "family_of"]
