"""A corpus of a few instructions of our own in three shipped scenes, in the project's format and small enough to learn
from in a blink."""

import functools

import models
from grounding.corpus.annotate import annotate
from grounding.corpus.format import Corpus, Example
from grounding.corpus.meaning import NotAnnotatable
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.world import load_world

SCENES = ("four", "seven", "default")
TREES = (
    "(VP (VB pick) (PRT (RP up)) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB take) (NP (DT the) (JJ leftmost) (NN block)))",
    "(VP (VB lift) (NP (DT the) (JJ nearest) (JJ red) (NN block)))",
    "(VP (VB take) (NP (DT the) (JJ leftmost) (JJ red) (NN block)))",
    "(VP (VB clear) (NP (NP (DT the) (CD five) (NNS blocks)) (PP (IN on) (NP (DT the) (NN right)))))",
    "(VP (VB take) (NP (NP (DT the) (JJ middle) (NN block)) (PP (IN of) (NP (DT the) (NN row)))))",
)


@functools.cache
def tiny():
    """The corpus: every tree in every scene that it is true of."""
    worlds = {name: load_world(models.SCENES / f"{name}.json") for name in SCENES}
    layouts = {name: Layout(world) for name, world in worlds.items()}
    examples = []
    for number, text in enumerate(TREES):
        tree = from_brackets(text)[0]
        for name in worlds:
            try:
                groundings, outcome = annotate(tree, layouts[name], sorted(layouts[name].evident))
            except NotAnnotatable:
                continue
            examples.append(Example(f"t{number}-{name}", name, tree.text, tree, tuple(groundings), outcome))
    return Corpus(tuple(examples), worlds)
