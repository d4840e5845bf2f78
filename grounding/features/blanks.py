"""What may stand in the blanks of the forms of facts and roles, each value with what it means in words."""

from __future__ import annotations

import re

from grounding.features.forms import Blank, as_is, one_of, plain
from grounding.symbols import ACTION_KINDS, CONTAINER_KINDS, SPATIAL_REFERENCES

PARTS = {
    "head": "the head phrase",
    "mod": "the modifier",
    "part": "the conjoined phrases",
    "inner": "the phrase within",
    "object": "the object phrase",
    "dest": "the destination phrase",
    "subject": "the subject",
    "prt": "the particle",
}
WHO = {
    **PARTS,
    "own": "the phrase itself",
    "below": "a word within the head that the head's grounding no longer tells",
    "unsaid": "nobody, so that it is counted from the robot",
}
_SAID = {
    **WHO,
    "first": "nobody, so that it is the first",
    "none": "nobody, and it is left out",
    "unsaid": "somebody, but it is left out",
    "counted": "nobody, it is counted in the world",
    "word": "a word that may mean it",
    "nobody": "nobody",
    "other": "nobody, it is another value",
}
_WHAT = {
    "types": "a type",
    "colors": "a colour",
    "relations": "a spatial reference",
    "indices": "a rank",
    "numbers": "a number",
    "kinds": "a kind of arrangement",
    "furniture": "a piece of furniture",
    "containers": "a container",
    "regions": "a region",
    "attributes": "an object attribute",
    "collections": "a container attribute",
    "actions": "an action",
    "object": "one object",
    "objects": "several objects",
    "robot": "the robot",
    "nothing": "nothing",
}
_REFERENCES = {
    "all": "all things of the type and colour that are said",
    "mod.side": "the things on the half that the modifier says",
}
_LISTS = {
    "seen": "the arrangements that fit",
    "evident": "the arrangements that fit and catch the eye",
    "counted": "the arrangements that fit and have the number that is said",
    "evident counted": "the arrangements that catch the eye and have the number that is said",
}
for _part, _words in PARTS.items():
    _REFERENCES[f"{_part}.in"] = f"what {_words} is grounded to"
    _REFERENCES[f"{_part}.region"] = f"the things in the region that {_words} is grounded to"
    _REFERENCES[f"{_part}.both"] = f"what {_words} is grounded to, in its region"
    _LISTS[f"{_part}.side"] = f"the arrangements on the half that {_words} says"
    _LISTS[f"{_part}.within"] = f"the arrangements within what {_words} is grounded to"
_LETTERS = {
    "d": "a direction",
    "i": "a rank",
    "n": "a number",
    "k": "a kind of arrangement",
    "C": "a container",
    "R": "a region",
    "A": "an object attribute",
    "P": "a container attribute",
    "!": "an action",
    "F": "furniture",
    "B": "the robot",
    "o": "one object",
    "O": "several objects",
}
_SYMBOLS = {
    "ObjectType": "a type",
    "ObjectColor": "a colour",
    "SpatialReference": "a spatial reference",
    "Cardinal": "a number",
    "Ordinal": "a rank",
    "Container": "a kind of container",
    "Action": "a kind of action",
}
_MEASURES = {
    "likelihood": "share of the members that lie on the model",
    "fit": "distance of the members from the model, over their gaps",
    "coherence": "evenness of the gaps",
    "separation": "distance to the nearest other object, over the largest gap",
    "ordering": "share of members among all that stands where the shape is",
    "orientation": "angle of the principal axis to the kind's own",
    "distinction": "distance of the nearest other object from the model",
}
_WAYS = {
    "all": "a whole reference set",
    "only": "a reference set of one",
    "count": "a reference set as large as is said",
    "nth": "the one at a rank",
    "flat": "the one at a rank, seen from above",
    "k": "as many as is said, the outermost in a direction",
    "middle": "the middle one by rank",
    "central": "the one nearest to the middle",
    "closest": "the one nearest to something",
    "ranked": "the one that an attribute ranks",
    **{
        f"member {fit}": f"members of an arrangement: {fit}"
        for fit in ("in", "only", "best", "clear best", "largest", "smallest", "nth")
    },
}
_TOLD = "[dinkCRAP!FB]*[oO]?"
_PART = f"(?:{'|'.join(PARTS)})"
_COMPOSITION = rf"{_PART}\({_TOLD}\)(?:\+{_PART}\({_TOLD}\))*"


def _told(letters: str) -> str:
    return " and ".join(_LETTERS[letter] for letter in letters) or "nothing of these"


def _composition(value: str) -> str:
    parts = re.findall(rf"({_PART})\(({_TOLD})\)", value)
    return "; ".join(f"{PARTS[part]} speaks of {_told(told)}" for part, told in parts)


def _children(value: str) -> str:
    return " and ".join(PARTS[part] for part in value.split("+")) if value else "nothing"


BLANKS: dict[str, Blank] = {
    "word": as_is(r"\S+"),
    "tag": as_is(r"[A-Z]+\$?|[^\w\s]+|-[A-Z]+-"),
    "parts": Blank(rf"(?:{_PART}(?:\+{_PART})*)?", _children),
    "part": one_of(PARTS),
    "who": one_of(WHO),
    "said": one_of(_SAID),
    "rank": one_of({**{who: f"the rank that {words} says" for who, words in WHO.items()}, "first": "the first rank"}),
    "what": one_of(_WHAT),
    "relation": plain(("side", *SPATIAL_REFERENCES)),
    "ordered": one_of({"-": "no rank", "first": "the first rank", "later": "a later rank", "last": "the last rank"}),
    "direction": one_of(
        {"-": "no direction", "along": "some direction", **{d: d for d in ("side", *SPATIAL_REFERENCES)}}
    ),
    "look": one_of(
        {"as it looks": "its members look like its kind", "unlike its looks": "its members look like another"}
    ),
    "way": one_of(_WAYS),
    "carried": one_of(
        {
            "carried upward": "a child is grounded to it",
            "carried upward, the only one": "it is the only container of the children",
        }
    ),
    "same": one_of({"same": "the same", "other": "another"}),
    "share": one_of({"all": "all", "some": "some", "none": "none"}),
    "level": one_of({"things are stacked": "things are stacked", "all is level": "all is level"}),
    "kind": plain(CONTAINER_KINDS),
    "target": plain(("object", *CONTAINER_KINDS)),
    "action": plain(ACTION_KINDS),
    "symbol": Blank(r"(?:type|spatial|container|action)\([\w-]+\)", str),
    "class": one_of(_SYMBOLS),
    "order": one_of({"1": "larger", "-1": "smaller"}),
    "preposition": as_is(r"[^:|]*"),
    "told": Blank(_TOLD, _told),
    "composition": Blank(_COMPOSITION, _composition),
    "every": Blank("(?:all )?", lambda value: ", meaning all" if value else ""),
    "article": Blank("(?:the )?", lambda value: ", definite" if value else ""),
    "amount": one_of({"one": "singular", "several": "plural"}),
    "few": one_of({"0": "none", "1": "one", "2": "several"}),
    "ref": one_of(_REFERENCES),
    "list": one_of(_LISTS),
    "count": one_of({"0": "no", "1": "one", "2": "two", "3": "three", "4": "four or more"}),
    "measure": one_of(_MEASURES),
    "kernel": one_of({"linear": "linear", "se": "squared-exponential"}),
    "bin": Blank(r"\d+", str),
}
