"""What verbs do in a text: they ask to handle something, tell where to look, or say how things are."""

from __future__ import annotations

from itertools import zip_longest

from grounding.language.tree import Phrase
from grounding.lexicon.words import distance

HANDLING = {
    "pick": "pick pickup grab take lift get select choose grasp fetch hold collect bring raise want need touch scoop "
            "reach retrieve obtain picking seize give pass hand lifts takes".split(),
    "place": "place put set move stack lay drop position slide push shift moves slides shifts bring transfer relocate "
             "moved placed stacked put puts places sits goes joins jumps stacks becomes leaps hops drag pull travels "
             "creates forms falls drops returns needs mover relocates swaps switch offset joined go sit join "
             "lands rests reposition repositions scoot scoots pushes pulls drags transfers heads shoots swings slips "
             "descends rises climbs comes ascends nudge nudges hugs meets attaches connects fills add adds tuck tucks "
             "tips rest hide hides fill slid pushed turns transport transports switches repositioned come".split(),
    "clear": "clear remove".split(),
}  # fmt: skip
SETTING_OFF = frozenset(
    (
        "move moves moving put place places position positions set shift shifts slide "
        "slides stack stacks join joins leap leaps hop hops jump jumps drop drops fall "
        "falls align aligns"
    ).split()
)
LOOKING = frozenset("look find locate see focus consider notice search narrow identify imagine observe looking "
                    "there there's".split())  # fmt: skip
BEING = frozenset("is are 's was were be being re".split())
ORDERING = frozenset("should will must shall would needs ought".split())
MOVED = frozenset("moved placed put stacked set shifted relocated positioned".split())
LOSING = frozenset("loses lose lost".split())
HAVING = frozenset("has have sees".split())
PARTING = frozenset("takes moves drops puts gives sends moving throws".split())
GAINING = frozenset("takes gains gets receives becomes grows adds acquires take gain become made formed sees grows "
                    "claims claim".split())  # fmt: skip
TAKING = frozenset("taking using claiming".split())
JOINED = frozenset("joined conjoined topped filled followed met capped crowned".split())
COMING = frozenset("coming comes came".split())
JOINING = frozenset("joins join joined touches meets hugs fills attaches connects leaps hops jumps swings approaches "
                    "follows flanks".split())  # fmt: skip
FORMING = frozenset("becomes become forms creates".split())
MAKING = frozenset("create make form build creating making forming".split())
_WANTING = frozenset("want need reach like".split())


def is_verbal(text: str) -> bool:
    """Whether a word is a verb of a text's main clauses."""
    return text in LOOKING or text in BEING or any(text in words for words in HANDLING.values())


def plain_form(participle: str) -> str | None:
    """The verb of handling of which a word is the participle: "put" of "putting"; None for other words."""
    verbs = (verb for words in HANDLING.values() for verb in words)
    return next((v for v in verbs if participle in (f"{v}ing", f"{v}{v[-1]}ing", f"{v[:-1]}ing")), None)


def _goes_away(clause: Phrase) -> bool:
    """Whether the particle of a clause's own verb says so: "take it away", but not "put it away from the tower"."""
    for child, following in zip_longest(clause.phrases, clause.phrases[1:]):
        if child.tag == "PRT" and child.text in ("away", "aside"):
            return following is None or following.leaves[0].text != "from"
    return any(_goes_away(child) for child in clause.phrases if child.tag in ("VP", "S"))


def kind_of(verbs: list[str], clause: Phrase) -> str | None:
    """What the verbs ask for; "move it away" asks to clear it, and wanting is no action where another verb is."""
    found = {kind for kind, words in HANDLING.items() for verb in verbs if verb in words and verb not in _WANTING}
    last = [leaf.text for leaf in clause.leaves]
    if found <= {"place"} and found and {"away", "aside"} & set(last[-2:]) and not any(map(distance, last[-3:-1])):
        return "clear"
    if found and "pick" not in verbs and (_goes_away(clause) or last[-3:] == ["of", "the", "way"]):
        return "clear"
    for kind in ("place", "clear", "pick"):
        if kind in found:
            return kind
    return "pick" if any(verb in _WANTING for verb in verbs) else None
