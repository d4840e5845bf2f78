"""The project's corpus files: examples read back, and refusals name file, line and element."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus import Corpus, Example, load_corpus, read_corpus, write_corpus
from grounding.corpus.composer import compose
from grounding.corpus.format import example_from_json, example_to_json, objects_of, worlds_path
from grounding.errors import CorpusError, CorpusErrors
from grounding.language.tree import Phrase, from_brackets
from grounding.symbols import (
    Action,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectColor,
    ObjectSymbol,
    Ordinal,
    Region,
    SpatialReference,
)
from grounding.world import world_to_json

WORLD = compose(np.random.default_rng(3), 6).world
IDS = [block.id for block in WORLD.things]
TREE = "(VP (VB lift) (NP (NP (DT the) (JJ blue) (NN cube)) (PP (IN near) (NP (DT the) (NN edge)))))"

ids = st.sampled_from(IDS)
some = st.lists(ids, min_size=1, max_size=4, unique=True).map(tuple)
relations = st.sampled_from(["left", "near", "top"])
regions = st.builds(Region, relations, st.sampled_from(["object", "row"]), some)
symbols = st.one_of(
    st.builds(ObjectSymbol, ids),
    st.builds(ObjectColor, st.sampled_from(["red", "blue"])),
    st.builds(SpatialReference, relations),
    st.builds(Cardinal, st.integers(1, 20)),
    st.builds(Ordinal, st.integers(-1, 20).filter(bool)),
    st.builds(Container, st.sampled_from(["row", "tower"]), st.just(()) | some),
    st.builds(ObjectAttribute, st.none() | st.just("block"), st.none(), st.none() | relations, st.none() | st.just(3)),
    st.builds(ContainerAttribute, st.just("block"), st.none(), st.none(), st.integers(2, 9)),
    regions,
    st.builds(Action, st.just("place"), some, st.none() | regions),
)
words = st.text(st.characters(categories=["Ll"], include_characters="é'-"), min_size=1, max_size=6)


@st.composite
def examples(draw):
    tree, notes = from_brackets(TREE)
    groundings = tuple(draw(st.frozensets(symbols, max_size=3)) for _ in notes)
    outcome = draw(st.sampled_from(["grounded", "ambiguous", "no_referent"]))
    return Example(draw(words), "w", draw(words), tree, groundings, outcome)


def plain(**changes):
    tree = TREE.replace("(NP (DT the) (JJ blue)", f"(NP {{object({IDS[0]})}} (DT the) (JJ blue)")
    return {"id": "a", "world": "w", "instruction": "lift the blue cube near the edge", "outcome": "grounded",
            "tree": tree, **changes}  # fmt: skip


def write_lines(folder, *lines):
    path = folder / "mine.jsonl"
    path.write_text("".join(line if isinstance(line, str) else json.dumps(line) + "\n" for line in lines))
    worlds_path(path).write_text(json.dumps({"w": world_to_json(WORLD)}))
    return path


@given(examples())
def test_an_example_reads_back(example):
    assert example_from_json(json.loads(json.dumps(example_to_json(example))), {"w": WORLD}) == example


def test_groundings_are_in_preorder():
    example = example_from_json(plain(), {"w": WORLD})
    found = [phrase.text for phrase, symbols in example.phrases if symbols]
    assert found == ["the blue cube"]
    assert [phrase for phrase, _ in example.phrases] == list(example.tree.preorder())


def test_a_corpus_reads_back_with_its_worlds(tmp_path):
    path = write_lines(tmp_path, plain(), "\n", plain(id="b", instruction="hebe den Würfel  auf"))
    corpus = read_corpus(path)
    write_corpus(corpus, tmp_path / "copy.jsonl")
    again = load_corpus(tmp_path / "copy.jsonl")
    assert again.examples == corpus.examples
    assert world_to_json(again.worlds["w"]) == world_to_json(WORLD)
    write_corpus(again, tmp_path / "twice.jsonl")
    assert (tmp_path / "copy.jsonl").read_bytes() == (tmp_path / "twice.jsonl").read_bytes()
    assert (tmp_path / "copy.worlds.json").read_bytes() == (tmp_path / "twice.worlds.json").read_bytes()


def test_a_selection_keeps_the_worlds_it_needs():
    corpus = Corpus((example_from_json(plain(), {"w": WORLD}),), {"w": WORLD, "v": WORLD})
    assert set(corpus.select(corpus).worlds) == {"w"}
    assert corpus["a"] is corpus.examples[0]
    with pytest.raises(CorpusError, match="no example 'z'"):
        corpus["z"]


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("{\n", "not a whole JSON object"),
        (json.dumps(plain())[:-9] + "\n", "truncated"),
        ("3\n", "an example is an object"),
        (plain(outcome="perhaps"), "unknown outcome 'perhaps'; known are grounded"),
        (plain(world="v"), "no world 'v'"),
        (plain(instruction=""), "'instruction' is a text"),
        (plain(instruction=3), "'instruction' is a text"),
        (plain(author="me"), "unknown key 'author'"),
        ({key: value for key, value in plain().items() if key != "tree"}, "key 'tree' is missing"),
        (plain(tree="(VP (VB lift)"), "'tree': .*ends too early"),
        (plain(tree="(VP {object(b99)} (VB lift))"), "phrase VP 'lift': no object 'b99' in its world"),
        (plain(tree="(VP {action(place; b1; left, object; b77)} (VB lift))"), "no object 'b77'"),
        (plain(tree="(VP {spatial(up)} (VB lift))"), "phrase VP 'lift': .*'up'"),
        (plain(tree="(VP {thing} (VB lift))"), "no symbol"),
        (plain(tree="(NP " * 5000 + "(NN cube)" + ")" * 5000), "nested too deeply"),
        (plain(id="first"), "'first': duplicate id"),
    ],
)
def test_refusals_name_file_line_and_element(tmp_path, line, says):
    path = write_lines(tmp_path, plain(id="first"), line)
    with pytest.raises(CorpusError, match=rf"mine\.jsonl: line 2: .*{says}"):
        read_corpus(path)


def test_keep_going_lists_all_refusals(tmp_path):
    path = write_lines(tmp_path, plain(), "{\n", plain(id="b", world="v"), plain(id="c"))
    with pytest.raises(CorpusErrors) as caught:
        read_corpus(path, keep_going=True)
    assert ["line 2" in str(caught.value.problems[0]), "line 3" in str(caught.value.problems[1])] == [True, True]
    assert len(caught.value.problems) == 2


def test_files_that_are_no_corpora(tmp_path):
    with pytest.raises(CorpusError, match="no such corpus file"):
        load_corpus(tmp_path / "none.jsonl")
    with pytest.raises(CorpusError, match="holds no example"):
        read_corpus(write_lines(tmp_path))
    with pytest.raises(CorpusError, match=r"no example_\*\.xml"):
        load_corpus(tmp_path)
    (tmp_path / "notes.txt").write_text("")
    with pytest.raises(CorpusError, match=r"a \.jsonl file or a folder"):
        load_corpus(tmp_path / "notes.txt")
    path = write_lines(tmp_path, plain())
    worlds_path(path).unlink()
    with pytest.raises(CorpusError, match=r"mine\.worlds\.json: no such worlds file"):
        read_corpus(path)


def test_every_phrase_has_groundings():
    tree = Phrase("NP", from_brackets("(NP (NN cube))")[0].children)
    with pytest.raises(CorpusError, match="0 groundings for 1 phrases"):
        Example("a", "w", "cube", tree, ())


@given(symbols)
def test_objects_of_a_symbol_are_those_in_its_notation(symbol):
    mentioned = {
        name for name in IDS if name in str(symbol).replace("(", " ").replace(")", " ").replace(";", " ").split()
    }
    assert set(objects_of(symbol)) == mentioned
