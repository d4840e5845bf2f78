"""From the phrase trees of a text to what is handled: commands, statements, and what they speak of before.

`clauses_of` splits a text, `read_sentence` tells what the parts of a clause say, and `read_text` follows them in order.
"""

from grounding.graded.discourse.following import read_text
from grounding.graded.discourse.told import Told
from grounding.meaning.discourse.clauses import clauses_of
from grounding.meaning.discourse.verbs import HANDLING

__all__ = ["HANDLING", "Told", "clauses_of", "read_text"]
