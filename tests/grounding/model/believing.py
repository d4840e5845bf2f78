"""Small worlds of blocks, and what is believed of texts in them with all that ships."""

import functools

from grounding import Grounder, World, make_object

TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))


def block(name, color, x, y, level=0):
    """A block on the table, or on so many others."""
    return make_object(name, "block", color, (x, y, 0.736 + 0.05 * level))


def laid(**places):
    """A world of grey blocks, each given as x, y and, in a tower, how many lie below."""
    return World((TABLE, *(block(name, "gray", x, y, sum(level)) for name, (x, y, *level) in places.items())))


@functools.cache
def grounder():
    """The one that ships."""
    return Grounder.load()


def believed(text, world, history=()):
    """What is believed of a text."""
    return grounder().understand(text, world, history).belief


def first(text, world, history=()):
    """What is likeliest to be meant: the action and the ids; None where nothing is."""
    options = believed(text, world, history).listed()
    return (options[0].kinds[0][0], options[0].objects) if options else None
