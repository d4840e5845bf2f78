"""The usual Penn tags of words in productions; where another is meant, the template says so."""

from __future__ import annotations

_WORDS = {
    "VB": "pick take grab lift get select choose find touch remove move put place set stack slide shift push bring "
    "clear locate be want like tell look fetch hold drop lay position reposition make form go collect identify grasp "
    "raise pull ask need use",
    "DT": "the a an this those these all both each every any some no another",
    "PDT": "half",
    "IN": "of in on at from to by with near under underneath beneath below above behind beside between over off into "
    "onto along toward towards against inside around across atop beyond past until than so up down upon within if "
    "because alongside amid as among out outside",
    "CD": "one two three four five six seven eight nine ten 1 2 3 4 5 6 7 8 1.5 2.5",
    "JJ": "free-standing freestanding solo stray "
    "red blue green yellow orange purple white black gray brown pink left right top bottom upper lower front "
    "back middle center central leftmost rightmost topmost bottommost uppermost lowermost frontmost backmost first "
    "second third fourth fifth sixth seventh eighth ninth last 1st 2nd 3rd 4th 5th next other same only lone single "
    "solitary isolated loose adjacent close north south east west northeast northwest southeast southwest northern "
    "opposite southern eastern western northeastern northwestern southeastern southwestern northernmost southernmost "
    "easternmost westernmost long short tall vertical horizontal diagonal far right-hand left-hand alone separate "
    "new flush parallel level empty tiny small big large double triple double-stacked immediate entire whole extreme "
    "free-standing standalone outermost innermost inner outer remaining original rear perpendicular",
    "JJR": "closer nearer farther further higher taller shorter longer bigger smaller larger",
    "JJS": "closest nearest farthest furthest highest lowest tallest shortest longest biggest largest smallest",
    "RB": "directly immediately just slightly almost nearly diagonally straight exactly then now also not away "
    "together forward forwards backward backwards upward upwards downward downwards about approximately roughly "
    "completely very here again once twice instead still previously "
    "recently horizontally vertically too",
    "RBS": "most",
    "CC": "and or but",
    "NN": "block cube box brick piece object side corner edge end quadrant table board grid screen surface row "
    "column line group cluster pair circle ring tower stack pile structure set bunch formation "
    "perspective view viewpoint point space width length square spot position target robot baxter everything story "
    "section part area portion region way trio string arrangement clump grouping distance "
    "tabletop desk page map picture field plane floor hand arm shape place order tile unit rest",
    "NNS": "blocks cubes boxes bricks ones pieces objects rows columns lines groups clusters pairs circles rings "
    "towers stacks piles spaces widths lengths squares sides corners edges spots units tiles stories things",
    "PRP": "it you me i them he they itself yourself myself we themselves",
    "PRP$": "your my its their",
    "EX": "there",
    "WDT": "that which",
    "WRB": "where",
    "MD": "can could would should will must",
    "UH": "please um uh well okay ok er hmm",
    "VBZ": "is has moves goes shifts slides jumps joins loses takes becomes forms touches gets sits lies stands "
    "comes lands drops needs",
    "VBP": "are have see",
    "VBD": "was were",
    "VBG": "touching sitting standing lying facing touching leaving forming making looking using starting moving",
    "VBN": "surrounded located placed moved put stacked positioned separated picked shifted "
    "slid made formed aligned situated taken",
}
USUAL_TAGS: dict[str, str] = {}
for _tag, _words in _WORDS.items():
    for _word in _words.split():
        USUAL_TAGS.setdefault(_word, _tag)
