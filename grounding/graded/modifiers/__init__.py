"""What modifiers do to the objects of a noun: they restrict them, name the set of which they are, or rank them.

`read_effects` looks at the form of a modifier and `relate` at the one relation that it names, by the readings of
`by_words` and `by_reference` in their order. The reader reads the noun phrases within.
"""

from grounding.graded.modifiers.forms import read_effects
from grounding.graded.modifiers.nouns import with_modifiers

__all__ = ["read_effects", "with_modifiers"]
