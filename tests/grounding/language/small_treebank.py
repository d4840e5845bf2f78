"""A dozen trees to learn small grammars from."""

from grounding.language.tree import Phrase, from_brackets

_TOWER = "(NP (DT the) (NN tower))"
_ON_TOP = f"(PP (IN on) (NP (NP (NN top)) (PP (IN of) {_TOWER})))"
_ON_THE_LEFT = "(PP (IN on) (NP (DT the) (NN left)))"
_IN_FRONT = "(PP (IN in) (NP (NP (NN front)) (PP (IN of) (NP (DT the) (NN robot)))))"
_ROW_OF_FIVE = "(NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD five) (NNS blocks))))"
_RED, _BLUE = "(NP (DT the) (JJ red) (NN block))", "(NP (DT the) (JJ blue) (NN block))"

BRACKETS = (
    f"(VP (VB pick) (PRT (RP up)) {_RED})",
    f"(VP (VB pick) (PRT (RP up)) (NP {_BLUE} {_ON_THE_LEFT}))",
    f"(VP (VB pick) (PRT (RP up)) (NP (NP (DT the) (NN block)) {_ON_TOP}))",
    "(VP (VB take) (NP (NP (DT the) (JJ second) (NN block)) (PP (IN from) (NP (DT the) (NN left)))))",
    f"(VP (VB take) (NP {_RED} (PP (IN in) {_ROW_OF_FIVE})))",
    f"(VP (VB put) {_RED} {_ON_TOP})",
    f"(VP (VB put) (NP (DT the) (NN block)) (PP (IN on) {_BLUE}))",
    f"(VP (UH please) (VB put) {_BLUE} {_ON_THE_LEFT})",
    f"(S (MD could) (NP (PRP you)) (VP (VB take) {_BLUE}))",
    "(VP (VB put) (NP (PRP it)) (PRT (RP down)))",
    f"(NP (NP (DT the) (NN row)) {_IN_FRONT})",
    "(NP (NP (CD three) (NNS blocks)) (PP (IN on) (NP (DT the) (NN right))))",
    "(NP (NP (DT the) (NN block)) (PP (IN in) (NP (DT the) (NN row))))",
    f"(NP (NP (DT the) (NN block)) (SBAR (WHNP (WDT that)) (S (VP (VBZ is) {_ON_THE_LEFT}))))",
)

TREES: tuple[Phrase, ...] = tuple(from_brackets(line)[0] for line in BRACKETS)
VOCABULARY = tuple(sorted({leaf.text for tree in TREES for leaf in tree.leaves}))
