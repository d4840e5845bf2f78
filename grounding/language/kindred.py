"""Words that no treebank of instructions has, each with one that it has and that stands in its place."""

from __future__ import annotations

from grounding.language.lexicon import is_colour
from grounding.lexicon.vocabulary import vocabulary

_LIKE = {
    "moves": "ascends attaches climbs connects descends drags falls fills floats grows heads hides hops jumps "
            "lands leaps meets nudges pulls pushes relocates repositions rests returns rises rolls scoots "
            "shoots sits slips swings switches tips transfers transports travels tucks turns",
    "takes": "acquires claims gets gives has lends lifts places positions puts receives sends swaps throws",
    "touches": "approaches flanks follows hits hugs meets reaches shares",
    "move": "attach connect drag drop hide hop join jump leap nudge pull push relocate reposition rest return "
            "roll scoot sit slip switch tip transfer transport travel tuck turn",
    "take": "claim gain gather give obtain pull retrieve scoop seize",
    "create": "build complete construct",
    "moved": "dragged dropped joined lifted nudged pulled pushed relocated repositioned shifted slid switched "
            "transferred turned",
    "away": "aside",
}  # fmt: skip
_KNOWN_AS = {verb: known for known, verbs in reversed(_LIKE.items()) for verb in verbs.split()}


def kindred(word: str) -> str | None:
    """A known word that stands where a new one stands, or None where the word is none whose kind is known.

    A noun for a kind of thing stands where "block" does, a colour where "red" does.
    """
    if vocabulary().has("kind", word):
        return "blocks" if word.endswith(("s", "dra")) else "block"
    if word.endswith("s") and is_colour(word[:-1]) and not is_colour(word):
        return "blocks"  # "the greens"
    if vocabulary().has("unit", word):
        return "space" if word in ("foot", "yard") or word.endswith(("re", "er", "h")) else "spaces"
    if vocabulary().has("tint", word):
        return "small"
    shades = [part for part in word.split("-") if part and (vocabulary().has("tint", part) or is_colour(part))]
    if len(shades) == len(word.split("-")):  # "red", "blue-green", "sky-blue"
        return "red"
    return _KNOWN_AS.get(word)
