"""What the small words of destinations contribute, by what they do there."""

ON = frozenset("on onto atop upon".split())
STACKING = frozenset(
    "stack stacks stacked stacking tower story storey stories floor piled pile tops topping level".split()
)
STORIES = frozenset("story storey stories storeys floor floors level levels".split())
TALL = frozenset("tall high".split())
IN = frozenset("in into inside within at".split())
ALIGNING = frozenset("align aligned aligns aligning line lined lines even parallel level flush same inline alignment "
                      "straight".split())  # fmt: skip
LINKING = frozenset("link links linking share shares sharing attach attaches attached connect connects connecting "
                     "meets meet kissing".split())  # fmt: skip
TOWARD = frozenset("toward towards closer".split())
FACES = frozenset("face faces side sides edge edges corner corners end ends wall".split())
SMALL = frozenset("slightly bit little tad barely smidge".split())
LARGE = frozenset("far way farthest furthest far-left far-right extreme very".split())
AXES = {"row": "row", "rows": "row", "horizontally": "row", "horizontal": "row", "column": "column",
         "columns": "column", "vertically": "column", "vertical": "column"}  # fmt: skip
BREAKS = frozenset("then until so where such making leaving".split())
BINDING = {"above": "back", "behind": "back", "below": "front", "under": "front", "beneath": "front",
            "underneath": "front", "beyond": "back"}  # fmt: skip
LINKS = frozenset("of from the a an side edge corner face end hand directly just immediately right about roughly "
                   "exactly approximately but than diagonally side sides or so away in 's".split())  # fmt: skip
OWN = frozenset("its it's".split())
EMPHASIZED = frozenset("next on in beside behind above below between at under beneath onto against up".split())
SIDEWAYS = frozenset("left right west east leftward rightward leftwards rightwards".split())
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "up": "down", "down": "up"}
