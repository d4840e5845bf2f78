"""Words that say nothing are left out, and no others."""

import pytest

from grounding.language.fillers import without_fillers
from grounding.language.tokens import tokenize


@pytest.mark.parametrize(("text", "rest"), [
    ("um, take the, uh, red one", "take the red one"), ("Okay so, there are two rows. Well, take the near one",
                                                        "there are two rows . take the near one"),
    ("take the one on the right, um", "take the one on the right ,"), ("Right, lift it", "lift it"),
    ("so take it", "so take it"), ("take the block on the right, please", "take the block on the right , please"),
    ("um", "um"), ("no, the other one", "no , the other one"),
])  # fmt: skip
def test_fillers_are_left_out(text, rest):
    assert " ".join(token.text for token in without_fillers(tokenize(text))) == rest
