"""Small closed classes of words that steer how a destination is heard; the lexicon has those that say a concept."""

BREAKS = frozenset("then until so where such making leaving".split())
LINKS = frozenset("of from the a an side edge corner face end hand directly just immediately right about roughly "
                  "exactly approximately but than diagonally side sides or so away in 's".split())  # fmt: skip
OWN = frozenset("its it's".split())
EMPHASIZED = frozenset("next on in beside behind above below between at under beneath onto against up".split())
SIDEWAYS = frozenset("left right west east leftward rightward leftwards rightwards".split())
