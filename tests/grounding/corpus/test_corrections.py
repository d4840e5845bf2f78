"""Files of corrections: what they change, what they leave, and how each mistake in them is refused."""

import json
import os
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus import Corpus, Example, load_corpus
from grounding.corpus.check import check_corpus
from grounding.corpus.composer import compose
from grounding.corpus.corrections import KINDS, apply_corrections, read_corrections
from grounding.errors import CorpusError, CorpusErrors
from grounding.language.tree import from_brackets
from grounding.symbols import parse_symbols

ROOT = Path(__file__).resolve().parents[3]
SHIPPED = ROOT / "benchmarks" / "rss2016_corrections.json"
RSS = Path(os.environ.get("ADCG_RSS2016") or ROOT.parent / "shared" / "data" / "rss2016")

WORLD = compose(np.random.default_rng(3), 6).world
TREE = """(VP {action(pick; b1)} (VB lift) (NP {object(b1)} (NP {attribute(block, -, -, 2) ordinal(2) type(block)}
          (JJ second) (NN cube)) (PP {spatial(left)} (IN from) (NP {spatial(left)} (DT the) (NN left)))))"""


def example(name, text="lift first cube from the left"):
    tree, notes = from_brackets(TREE)
    return Example(name, "w", text, tree, tuple(parse_symbols(note) for note in notes))


CORPUS = Corpus(
    (example("one"), example("two"), example("three", "lift that second cube from the left!")), {"w": WORLD}
)


def entry(**changes):
    """A correction of the whole noun phrase, right in every respect."""
    return {"phrase": 1, "tag": "NP", "words": [1, 5], "kind": "referent", "wrong": "the other one lies further left",
            "annotated": ["object(b1)"], "right": ["object(b2)"], **changes}  # fmt: skip


def without(key):
    return {name: value for name, value in entry().items() if name != key}


def ordinal_entry(**changes):
    return entry(phrase=2, words=[1, 2], kind="word", annotated=["attribute(block, -, -, 2)", "ordinal(2)"],
                 right=["attribute(block, -, -, 1)", "ordinal(1)"], from_instruction=[1], **changes)  # fmt: skip


def write(tmp_path, *phrases, name="two"):
    path = tmp_path / "fixes.json"
    path.write_text(json.dumps({"corrections": [{"id": name, "phrases": list(phrases)}]}))
    return path


def test_what_is_named_is_exchanged_and_nothing_else(tmp_path):
    corrections = read_corrections(write(tmp_path, entry()))
    result = apply_corrections(CORPUS, corrections)
    assert corrections.kinds == {"referent": 1}
    assert result.examples[1].groundings[1] == parse_symbols("object(b2)")
    assert result.examples[1].groundings[2:] == CORPUS.examples[1].groundings[2:]
    assert result.examples[1].tree == CORPUS.examples[1].tree
    assert (result.examples[0], result.examples[2]) == (CORPUS.examples[0], CORPUS.examples[2])
    assert [e.id for e in result] == [e.id for e in CORPUS]
    assert CORPUS.examples[1] == example("two")


def test_a_word_of_the_tree_becomes_that_of_the_instruction(tmp_path):
    result = apply_corrections(CORPUS, read_corrections(write(tmp_path, ordinal_entry())))["two"]
    assert result.tree.text == result.instruction
    assert [leaf.tag for leaf in result.tree.leaves] == [leaf.tag for leaf in CORPUS["two"].tree.leaves]
    assert result.groundings[2] == parse_symbols("attribute(block, -, -, 1) ordinal(1) type(block)")


@given(st.data())
def test_corrections_and_their_reverse_cancel_out(tmp_path_factory, data):
    numbers = data.draw(st.sets(st.integers(0, 4), min_size=1))
    there, back = [], []
    for number in sorted(numbers):
        phrase, symbols = CORPUS["two"].phrases[number]
        wrong = data.draw(st.sets(st.sampled_from(sorted(map(str, symbols)))))
        right = ["cardinal(4)", *data.draw(st.sets(st.sampled_from(["object(b3)", "container(row; b1 b2)"])))]
        where = {"phrase": number, "tag": phrase.tag, "words": [phrase.leaves[0].index, phrase.leaves[-1].index]}
        there.append(entry(**where, annotated=sorted(wrong), right=right))
        back.append(entry(**where, annotated=right, right=sorted(wrong)))
    folder = tmp_path_factory.mktemp("fixes")
    changed = apply_corrections(CORPUS, read_corrections(write(folder, *there)))
    assert {n for n in range(5) if changed["two"].groundings[n] != CORPUS["two"].groundings[n]} == numbers
    assert apply_corrections(changed, read_corrections(write(folder, *back))).examples == CORPUS.examples


@pytest.mark.parametrize(
    ("phrase", "says"),
    [
        ("first", "a phrase is an object with the keys phrase, tag"),
        (without("tag"), "phrase 1: key 'tag' is missing"),
        (entry(why="so"), "phrase 1: unknown key 'why'; known are phrase"),
        (entry(phrase=-1), "phrase -1: 'phrase' is a number in preorder"),
        (entry(phrase=True), "phrase True: 'phrase' is a number"),
        (entry(wrong=" "), "phrase 1: 'wrong' is a text"),
        (entry(kind="taste"), "phrase 1: unknown kind 'taste'; known are referent"),
        (entry(words=[1]), "phrase 1: 'words' are the positions"),
        (entry(words=[5, 1]), "phrase 1: 'words' are the positions"),
        (entry(words="all"), "phrase 1: 'words' is a list of positions"),
        (entry(from_instruction=[6]), "phrase 1: 'from_instruction': 6 is no word of the phrase"),
        (entry(annotated=[], right=[]), "phrase 1: nothing is corrected"),
        (entry(right=["object(b1)"]), r"phrase 1: both wrong and right: object\(b1\)"),
        (entry(right="object(b1)"), "phrase 1: 'right' is a list of symbols"),
        (entry(right=["object b1"]), "phrase 1: 'right': no symbol: 'object b1'; a symbol looks like"),
        (entry(annotated=["spatial(upwards)"]), "phrase 1: 'annotated': .*unknown spatial reference 'upwards'"),
    ],
)
def test_a_phrase_that_cannot_be_read_is_refused(tmp_path, phrase, says):
    with pytest.raises(CorpusError, match=rf"fixes\.json: two: {says}"):
        read_corrections(write(tmp_path, phrase))


@pytest.mark.parametrize(
    ("name", "phrase", "says"),
    [
        ("four", entry(), "four: no such example among the 3 of the corpus"),
        ("two", entry(phrase=5), r"two: phrase 5 \(NP, words 1 to 5\): the tree has the phrases 0 to 4"),
        ("two", entry(tag="PP"), r"two: phrase 1 \(PP.*: phrase 1 of the tree is NP, words 1 to 5"),
        ("two", entry(words=[1, 4]), r"two: phrase 1 .*: phrase 1 of the tree is NP, words 1 to 5"),
        (
            "two",
            entry(annotated=["object(b3)"]),
            r"phrase 1 .*: not annotated: object\(b3\); annotated are object\(b1\)",
        ),
        ("two", entry(annotated=[], right=["object(b1)"]), r"phrase 1 .*: annotated already: object\(b1\)"),
        ("two", entry(right=["container(row; b1 z9)"]), "phrase 1 .*: no object 'z9' in its world"),
        ("two", ordinal_entry() | {"from_instruction": [2]}, "word 2 is the instruction's already"),
        ("three", ordinal_entry(), "phrase 2 .*: 'from_instruction' needs a tree with as many words .* 6 for 7"),
    ],
)
def test_a_correction_that_does_not_fit_its_corpus_is_refused(tmp_path, name, phrase, says):
    corrections = read_corrections(write(tmp_path, phrase, name=name))
    with pytest.raises(CorpusError, match=rf"fixes\.json: .*{says}"):
        apply_corrections(CORPUS, corrections)


def test_twice_is_once_too_often(tmp_path):
    with pytest.raises(CorpusError, match=r"two: phrase 1 \(NP, words 1 to 5\): corrected twice"):
        read_corrections(write(tmp_path, entry(), entry(right=["object(b3)"])))
    path = write(tmp_path, entry())
    content = json.loads(path.read_text())
    path.write_text(json.dumps({"corrections": content["corrections"] * 2}))
    with pytest.raises(CorpusError, match="two: corrected twice; every id occurs once"):
        read_corrections(path)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("{", "cannot be read"),
        ("[]", "an object with the key 'corrections'"),
        ('{"corrections": [{"id": "two"}]}', "correction 1: expected an object with the keys 'id' and 'phrases'"),
        ('{"corrections": [{"id": 2, "phrases": []}]}', "correction 1: 'id' is a text"),
        ('{"corrections": [{"id": "two", "phrases": []}]}', "two: 'phrases' is a list that is not empty"),
    ],
)
def test_a_file_of_another_form_is_refused(tmp_path, text, says):
    path = tmp_path / "fixes.json"
    path.write_text(text)
    with pytest.raises(CorpusError, match=rf"fixes\.json: .*{says}"):
        read_corrections(path)
    with pytest.raises(CorpusError, match="no such file"):
        read_corrections(tmp_path / "none.json")


def test_keep_going_lists_all_refusals(tmp_path):
    path = write(tmp_path, entry(kind="taste"), entry(tag=""), entry())
    with pytest.raises(CorpusErrors) as caught:
        read_corrections(path, keep_going=True)
    assert len(caught.value.problems) == 2
    corrections = read_corrections(write(tmp_path, entry(tag="PP")))
    with pytest.raises(CorpusErrors) as caught:
        apply_corrections(CORPUS, corrections, keep_going=True)
    assert len(caught.value.problems) == 1


def test_the_shipped_file_is_read_and_stays_small():
    shipped = read_corrections(SHIPPED)
    assert 0 < len(shipped.examples) <= 25
    assert set(shipped.kinds) == set(KINDS)


def test_the_shipped_file_settles_what_the_checks_find_in_the_published_corpus():
    if not RSS.is_dir():
        pytest.skip("the paper's corpus is not here; name its folder in the environment variable ADCG_RSS2016")
    published = load_corpus(RSS)
    shipped = read_corrections(SHIPPED)
    result = apply_corrections(published, shipped)
    changed = {before.id for before, after in zip(published, result, strict=True) if before != after}
    assert changed == {item.id for item in shipped.examples}
    assert Counter(finding.check for finding in check_corpus(result)) == {"words": 2}
