"""A text followed clause by clause."""

from __future__ import annotations

from grounding.language.tree import Phrase
from grounding.meaning.discourse.clauses import clauses_of
from grounding.meaning.discourse.sentences import read_sentence
from grounding.meaning.discourse.told import Told, add, is_informative, mention, name, take
from grounding.meaning.discourse.verbs import HANDLING, SETTING_OFF
from grounding.meaning.nouns import read_noun
from grounding.meaning.reader import Reader


def read_text(tree: Phrase, reader: Reader) -> Told:
    """Follow a text clause by clause."""
    told = Told()
    clauses = clauses_of(tree)
    for place, clause in enumerate(clauses):
        told.continued = any(_resumes(further) for further in clauses[place + 1 :])
        if told.target is None and place + 1 < len(clauses) and _introduces(clause):
            mention(read_noun(clause), reader, told)
        else:
            _follow(clause, reader, told)
    if told.target is None and told.mentioned is not None:
        told.target = told.mentioned
    if told.target is None and not _moves_it(tree, told):
        _guess(tree, reader, told)
    told.whole = tree
    if told.kind == "pick" and not told.destination and _only_moves(tree):
        told.kind = "place"
    return told


def _introduces(clause: Phrase) -> bool:
    """Whether a clause only names a set, of which the next one chooses: "the row of five. Take its middle block"."""
    noun = read_noun(clause) if clause.tag == "NP" else None
    return noun is not None and (noun.head == "container" or (noun.head == "block" and noun.plural))


def _follow(clause: Phrase, reader: Reader, told: Told) -> None:
    if clause.tag == "NP":
        name(clause, reader, told)
    elif clause.tag in ("VP", "S"):
        read_sentence(clause, reader, told)
    else:
        add(clause, reader, told)


def _resumes(clause: Phrase) -> bool:
    """Whether a clause says what shall be done with "it"."""
    words = [leaf.text for leaf in clause.leaves]
    if "then" in words[:3]:
        return False  # "and then slide it ...": it has been put somewhere before
    if clause.tag == "VP" and words[0] in HANDLING["place"] and not any(p.tag == "NP" for p in clause.phrases):
        return True  # "and place on top of X"
    verb = any(text in HANDLING["place"] for text in words)
    return verb and any(text in ("it", "that", "them", "one") for text in words[:6])


def _only_moves(tree: Phrase) -> bool:
    """Whether a text that was not understood clause by clause speaks of moving something, and not of picking it."""
    texts = {leaf.text for leaf in tree.leaves}
    moving = any(leaf.text in SETTING_OFF and leaf.tag in ("VB", "VBZ", "VBP", "VBG") for leaf in tree.leaves)
    return moving and not texts & set(HANDLING["pick"])


def _moves_it(tree: Phrase, told: Told) -> bool:
    """Whether a text only tells where "it" is to go: what it names there is not what goes."""
    named = next((phrase for phrase in tree.preorder() if phrase.tag == "NP"), None)
    pronoun = named is not None and read_noun(named).head == "pronoun" and len(named.leaves) == 1
    return pronoun and any(piece.phrases for piece in told.destination)


def _guess(tree: Phrase, reader: Reader, told: Told) -> None:
    """Where no clause named anything: the first noun phrase that could."""
    for phrase in tree.preorder():
        if phrase.tag == "NP":
            noun = read_noun(phrase)
            if noun.head == "block" and is_informative(noun) and not noun.strange:
                take(noun, reader, told)
                if told.target is not None:
                    return
