"""Generated corpora: true of their worlds, balanced, reproducible, resumable, and the same seen in a mirror."""

import json
import re
from collections import Counter

import numpy as np
import pytest

from grounding.__main__ import main
from grounding.corpus.annotate import annotate
from grounding.corpus.check import check_corpus
from grounding.corpus.compositions import KINDS, compose_world, recognise
from grounding.corpus.fitting import fit, vocabulary
from grounding.corpus.format import Corpus, example_from_json, example_to_json, read_corpus
from grounding.corpus.generator import MOST_COPIES, generate, is_held_out, wording_of
from grounding.corpus.guided import Guide, graft
from grounding.corpus.making import make_corpus
from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.sight import CONTACT, sight_of
from grounding.corpus.wording import sample_tree
from grounding.errors import CorpusError
from grounding.geometry.layout import Layout
from grounding.language.tokens import tokenize
from grounding.language.tree import from_brackets
from grounding.symbols import ObjectColor, format_symbols, parse_symbols
from grounding.world import Viewpoint, World

COUNT = 240


@pytest.fixture(scope="module")
def corpus():
    return make_corpus(COUNT, seed=3)


def test_it_agrees_with_its_worlds_and_with_itself(corpus):
    assert len(corpus) == COUNT
    assert check_corpus(corpus) == ()
    assert len({example.id for example in corpus}) == COUNT


def test_the_same_seed_gives_the_same_corpus(corpus):
    again = make_corpus(COUNT // 2, seed=3)
    lines = [json.dumps(example_to_json(example)) for example in corpus.examples[: COUNT // 2]]
    assert [json.dumps(example_to_json(example)) for example in again] == lines
    assert make_corpus(20, seed=4).examples[0].instruction != corpus.examples[0].instruction


def test_outcomes_and_sentences_are_balanced_and_wordings_differ(corpus):
    outcomes = Counter(example.outcome for example in corpus)
    assert 0.6 * COUNT < outcomes["grounded"] < 0.95 * COUNT
    assert outcomes["ambiguous"] > 0.03 * COUNT < outcomes["no_referent"]
    assert {"VP", "S", "NP", "FRAG"} <= {example.tree.tag for example in corpus}
    wordings = Counter(wording_of(example.tree) for example in corpus)
    assert max(wordings.values()) <= MOST_COPIES
    assert len(wordings) > 0.9 * COUNT
    assert any(example.history for example in corpus)


def test_texts_are_what_their_trees_say(corpus):
    for example in corpus:
        words = [token.text for token in tokenize(example.instruction) if token.is_word]
        assert words == [leaf.text for leaf in example.tree.leaves]
        assert [leaf.index for leaf in example.tree.leaves] == list(range(len(words)))


def test_an_annotation_can_be_made_again(corpus):
    for example in corpus.examples[:60]:
        laid = recognise(example.world, corpus.worlds[example.world])
        assert example_from_json(json.loads(json.dumps(example_to_json(example))), corpus.worlds) == example
        assert laid.layout.size == len(corpus.worlds[example.world].things)


SWAPPED = {"left": "right", "right": "left", "east": "west", "west": "east"}
SIDED = re.compile(r"(?<!RB )\b(?=\w)(north|south|)(left|right|east|west)(most|ern|ernmost|wards?|)(?=\b)(?![a-z])")


def swapped(text):
    """The text with left and right, east and west exchanged; "right beside it" is no side."""
    return SIDED.sub(lambda match: match[1] + SWAPPED[match[2]] + match[3], text)


def mirrored(world):
    objects = [o.moved(o.position * (1, -1, 1), o.orientation * (1, -1, 1, -1)) for o in world.objects]
    speaker = world.speaker
    there = None if speaker is None else Viewpoint(speaker.position * (1, -1, 1), -speaker.yaw)
    return World(tuple(objects), there)


def test_a_mirror_swaps_left_and_right():
    rng = np.random.default_rng(11)
    for number in range(6):
        laid = compose_world(rng, f"w{number}")
        layout = Layout(mirrored(laid.layout.world))
        for example in generate(laid, rng, 12, Counter()):
            tree = from_brackets(swapped(str(example.tree)))[0]
            groundings, outcome = annotate(tree, layout, laid.arrangements, example.history)
            assert outcome == example.outcome, example.instruction
            wanted = [parse_symbols(swapped(format_symbols(symbols))) for symbols in example.groundings]
            assert list(groundings) == wanted, example.instruction


def test_what_is_held_out_is_told_by_the_wording_alone(corpus):
    held = [example for example in corpus if is_held_out(example.tree)]
    assert 0.02 * COUNT < len(held) < 0.25 * COUNT
    by_wording = {}
    for tree in (example.tree for example in corpus):
        assert by_wording.setdefault(wording_of(tree), is_held_out(tree)) == is_held_out(tree)
    one, other = (from_brackets(f"(NP (DT the) (JJ {color}) (NN block))")[0] for color in ("red", "blue"))
    assert wording_of(one) == wording_of(other)


@pytest.mark.parametrize("kind", KINDS)
def test_worlds_of_every_kind_can_be_spoken_of(kind):
    rng = np.random.default_rng(5)
    laid = compose_world(rng, "w", kind)
    assert 3 <= laid.layout.size <= 30
    assert len(generate(laid, rng, 6, Counter())) == 6


def test_cluttered_blocks_touch_and_do_not_overlap():
    laid = compose_world(np.random.default_rng(1), "w", "clutter")
    gaps = sight_of(laid.layout).gaps
    assert gaps.min() > 0
    assert (gaps.min(axis=1) <= CONTACT).sum() >= 4


def test_worlds_that_cannot_be_laid_are_refused():
    with pytest.raises(CorpusError, match="kinds are"):
        compose_world(np.random.default_rng(0), "w", "messy")
    with pytest.raises(CorpusError, match="only of 'composed'"):
        compose_world(np.random.default_rng(0), "w", "clutter", 5)


def test_sentences_are_suited_to_their_world():
    rng = np.random.default_rng(2)
    laid = compose_world(rng, "w", "clutter")
    words = vocabulary(laid.layout, laid.arrangements)
    said = Counter()
    for _ in range(150):
        tree = fit(sample_tree(rng), words, rng)
        said.update(s.name in words.colors for leaf in tree.leaves for s in _colors(leaf.text))
    assert said[True] > 5 * said[False]


def test_descriptions_found_in_a_world_single_out_a_block_there():
    rng = np.random.default_rng(4)
    told = Counter()
    for number in range(6):
        laid = compose_world(rng, f"w{number}", "composed", 12)
        guide = Guide(laid)
        for description in filter(None, (guide.describe(rng) for _ in range(20))):
            try:
                told[annotate(description, laid.layout, laid.arrangements)[1]] += 1
            except NotAnnotatable:
                told["refused"] += 1
    assert told["grounded"] > 40
    assert told["grounded"] > 4 * (told["refused"] + told["ambiguous"] + told["no_referent"])


def test_a_description_takes_the_place_of_a_block():
    tree = from_brackets("(VP (VB put) (NP (PRP it)) (PP (IN on) (NP (DT the) (JJ red) (NN block))))")[0]
    description = from_brackets("(NP (DT the) (JJ closest) (NN cube))")[0]
    assert graft(tree, description).text == "put it on the closest cube"
    assert graft(from_brackets("(VP (VB clear) (NP (DT the) (NN row)))")[0], description) is None


def _colors(text):
    from grounding.language.lexicon import meanings

    return [symbol for symbol in meanings(text) if isinstance(symbol, ObjectColor)]


def test_an_interrupted_corpus_goes_on_where_it_ended(tmp_path):
    kept, told = tmp_path / "part", []
    whole = make_corpus(60, seed=8)

    class Stop(Exception):
        pass

    def tell(number):
        told.append(number)
        if len(told) == 2:
            raise Stop

    with pytest.raises(Stop):
        make_corpus(60, seed=8, kept=kept, tell=tell)
    with kept.open("a") as file:
        file.write('{"name": "g8-0')  # cut off while it was written
    again = make_corpus(60, seed=8, kept=kept)
    assert [example_to_json(e) for e in again] == [example_to_json(e) for e in whole]
    assert sorted(again.worlds) == sorted(whole.worlds)
    with pytest.raises(CorpusError, match="left by another run"):
        make_corpus(60, seed=9, kept=kept)


def test_the_command_writes_a_corpus_and_says_what_is_in_it(tmp_path, capsys):
    output = tmp_path / "made" / "g.jsonl"
    assert main(["corpus", "generate", "--count", "25", "--seed", "2", "--output", str(output)]) == 0
    captured = capsys.readouterr()
    summary = json.loads(captured.out)
    assert summary["examples"] == 25 == sum(summary["outcomes"].values())
    assert "25/25 examples" in captured.err
    made = read_corpus(output)
    assert isinstance(made, Corpus)
    assert [p.name for p in sorted(output.parent.iterdir())] == ["g.jsonl", "g.worlds.json"]
    assert main(["corpus", "check", str(output)]) == 0
    assert main(["corpus", "generate", "--count", "25", "--output", str(tmp_path / "g.txt")]) == 2
