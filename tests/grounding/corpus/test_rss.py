"""The reader of the paper's XML: small files of the same form, and the published corpus where it is at hand."""

import os
from pathlib import Path

import pytest

from grounding.corpus import load_corpus
from grounding.corpus.check import check_corpus
from grounding.corpus.rss import read_file
from grounding.corpus.rss_world import shifted
from grounding.errors import CorpusError, CorpusErrors
from grounding.symbols import parse_symbol, parse_symbols

ROOT = Path(__file__).resolve().parents[3]
RSS = Path(os.environ.get("ADCG_RSS2016") or ROOT.parent / "shared" / "data" / "rss2016")
OBJECTS = (
    ("crate1-cube-cube-base", "block", "0.9,0.1,0.736"),
    ("crate2-cube-cube-base", "block", "0.9,-0.1,0.736"),
    ("3-cube-cube-base", "block", "0.9,0.0,0.736"),
    ("rob-rob-left_hand", "robot", "0.3,0.9,1.2"),
    ("rob-rob-right_hand", "robot", "0.3,-0.9,1.2"),
    ("ground-plane-plane-base", "na", "0,0,0"),
    ("desk-table-table-base", "table", "0.9,0.0,-0.012"),
)
ROW = '<container type="row">' + "".join(f'<object name="{name}"/>' for name, kind, _ in OBJECTS if kind == "block")
ROW += "</container>"


def world(objects=OBJECTS, orientation="0,0,0.6,0.8"):
    return "".join(f'<object name="{name}" type="{kind}" position="{place}" orientation="{orientation}" color="na"/>\n'
                   for name, kind, place in objects)  # fmt: skip


def document(symbols="", objects=OBJECTS, image="scene_0001_0002.png", tree=None, text="Grab it"):
    tree = tree if tree is not None else (
        f"<VP><grounding><grounding_set>{symbols}</grounding_set></grounding>\n"
        '<VB text="Grab" order="0"/><NP><grounding><grounding_set/></grounding><PRP text="it" order="1"/></NP></VP>'
    )  # fmt: skip
    return (f'<?xml version="1.0"?><root><instruction text="{text}"/><image file="{image}"/>\n'
            f'<world time="0">{world(objects)}</world>{tree}</root>')  # fmt: skip


def write(folder, *documents):
    for number, text in enumerate(documents, start=1):
        (folder / f"example_{number:04}.xml").write_text(text)
    return folder


def read_symbols(tmp_path, symbols):
    return load_corpus(write(tmp_path, document(symbols))).examples[0].groundings[0]


@pytest.mark.parametrize(
    ("element", "notation"),
    [
        ('<object name="crate2-cube-cube-base" type="block"/>', "object(crate2)"),
        ('<object_type type="block"/>', "type(block)"),
        ('<object_color type="red"/>', "color(red)"),
        ('<object_color color="red"/>', "color(red)"),
        ('<spatial_relation type="far"/>', "spatial(far)"),
        ('<index type="fourth"/>', "ordinal(4)"),
        ('<index value="third"/>', "ordinal(3)"),
        ('<number value="twelve"/>', "cardinal(12)"),
        ('<container type="group"/>', "container(group)"),
        (ROW, "container(row; block3 crate1 crate2)"),
        ('<object_property object_type="block" relation_type="left" index="second"/>',
         "attribute(block, -, left, 2)"),
        ('<object_property object_type="block" relation_type="na" index="first" color="red"/>',
         "attribute(block, red, -, 1)"),
        ('<abstract_container type="block" num="7" index="first" color="na"/>', "collection(block, -, -, 7)"),
        ('<abstract_container type="block" num="7" index="first" color="red"/>', "collection(block, red, -, 7)"),
        ('<region type="right"><object name="desk-table-table-base"/></region>', "region(right, object; desk)"),
        ('<region_container type="front"><container type="robot"><object name="rob-rob-left_hand"/>'
         '<object name="rob-rob-right_hand"/></container></region_container>',
         "region(front, robot; left_hand right_hand)"),
        ('<action type="pick"><parameter pick_object="3-cube-cube-base"/></action>', "action(pick; block3)"),
    ],
)  # fmt: skip
def test_every_symbol_of_theirs_is_one_of_ours(tmp_path, element, notation):
    assert read_symbols(tmp_path, element) == {parse_symbol(notation)}


def test_words_phrases_and_groundings_keep_their_places(tmp_path):
    example = load_corpus(write(tmp_path, document(ROW))).examples[0]
    assert str(example.tree) == "(VP (VB grab) (NP (PRP it)))"
    assert [leaf.index for leaf in example.tree.leaves] == [0, 1]
    assert example.groundings == (parse_symbols("container(row; block3 crate1 crate2)"), frozenset())
    assert (example.id, example.instruction) == ("example_0001", "Grab it")


def test_the_recorded_world_becomes_one_of_ours(tmp_path):
    recorded = next(iter(load_corpus(write(tmp_path, document())).worlds.values()))
    assert [item.id for item in recorded.things] == ["block3", "crate1", "crate2"]
    assert recorded["crate1"].orientation.tolist() == pytest.approx([0.8, 0, 0, 0.6])
    assert {item.color for item in recorded.objects} == {"unknown"}
    assert recorded["ground"].type == "floor"
    desk = recorded["desk"]
    assert desk.type == "table"
    assert desk.position[2] + desk.size[2] / 2 == pytest.approx(0.711)
    assert desk.position[:2].tolist() == [0.9, 0.0]


def test_names_that_would_collide_are_kept_whole(tmp_path):
    objects = (("a-one-base", "block", "0.9,0,0.736"), ("a-two-base", "block", "0.9,0.2,0.736"), OBJECTS[0])
    recorded = next(iter(load_corpus(write(tmp_path, document(objects=objects))).worlds.values()))
    assert [item.id for item in recorded.things] == ["a-one-base", "a-two-base", "crate1"]


def test_worlds_are_told_apart_by_layout(tmp_path):
    moved = (("crate1-cube-cube-base", "block", "0.7,0.1,0.736"), *OBJECTS[1:])
    corpus = load_corpus(write(
        tmp_path, document(), document(image="scene_0001_0009.png"), document(objects=moved),
        document(image="scene_0002_0001.png"),
    ))  # fmt: skip
    first, same, other, misnamed = (example.world for example in corpus)
    assert first == same == misnamed == "scene_0001"
    assert other == "scene_0001-2"
    assert set(corpus.worlds) == {first, other}


def test_a_shift_moves_the_table_and_what_lies_on_it(tmp_path):
    recorded = next(iter(load_corpus(write(tmp_path, document())).worlds.values()))
    moved = shifted(recorded, -0.25)
    for item in recorded.objects:
        by = 0.0 if item.type in ("robot", "floor") else -0.25
        assert (moved[item.id].position - item.position).tolist() == pytest.approx([by, 0, 0])


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (document()[:-20], "not well-formed XML"),
        ("", "not well-formed XML: no element found"),
        (document(tree="<NP>" * 5000 + '<NN text="x"/>' + "</NP>" * 5000), "nested too deeply"),
        (document(tree=""), "expected one phrase as the tree, found 0"),
        (document(tree="<tree/>"), "line 9: <tree>: no phrase; known are NP"),
        (document(tree="<NP><grounding/></NP>"), "<NP>: a phrase without words"),
        ("<root><instruction text='x'/></root>", "expected one <world>"),
        (document('<object name="ball"/>'), "line 9: <object>: no object 'ball'"),
        (document("<object/>"), "attribute 'name' is missing"),
        (document('<wish type="x"/>'), "<wish>: unknown symbol; known are .*object_type"),
        (document('<spatial_relation type="upwards"/>'), "<spatial_relation>: unknown spatial reference 'upwards'"),
        (document('<container type="pile"/>'), "<container>: unknown container kind 'pile'"),
        (document('<container type="row"><object name="ball"/></container>'), "no object 'ball'"),
        (document('<index type="zeroth"/>'), "unknown number 'zeroth'"),
        (document('<object_property object_type="block" relation_type="up" index="first"/>'), "'up'"),
        (document('<region type="left"/>'), "expected one object or container"),
        (document('<action type="pick"><parameter drop="x"/></action>'), "unknown parameter 'drop'"),
        (document('<action type="fold"/>'), "unknown action 'fold'"),
        (document(objects=(OBJECTS[0], OBJECTS[0])), "duplicate object 'crate1-cube-cube-base'"),
        (document(objects=(("c-x", "block", "0.9,nan,0.7"),)), "'c': 'position' holds nan"),
        (document(objects=(("c-x", "block", "0.9,0.7"),)), "'position' is 3 numbers"),
    ],
)
def test_refusals_name_file_and_element(tmp_path, text, says):
    folder = write(tmp_path, document(), text)
    with pytest.raises(CorpusError, match=rf"example_0002\.xml: .*{says}"):
        load_corpus(folder)


def test_keep_going_lists_all_refusals_of_all_files(tmp_path):
    bad = document('<object name="ball"/><wish/>')
    with pytest.raises(CorpusErrors) as caught:
        load_corpus(write(tmp_path, bad, document(), document(tree=""), "<root>"), keep_going=True)
    files = [Path(str(problem).split(": ")[0]).stem for problem in caught.value.problems]
    assert files == ["example_0001", "example_0001", "example_0003", "example_0004"]
    assert all(str(problem).count(".xml") == 1 for problem in caught.value.problems)


def test_one_file_alone(tmp_path):
    write(tmp_path, document())
    assert len(read_file(tmp_path / "example_0001.xml")) == 1
    with pytest.raises(CorpusError, match="cannot be read"):
        read_file(tmp_path / "example_0002.xml")


@pytest.fixture(scope="module")
def published():
    if not RSS.is_dir():
        pytest.skip("the paper's corpus is not here; name its folder in the environment variable ADCG_RSS2016")
    return load_corpus(RSS)


def test_the_whole_published_corpus_loads(published):
    assert len(published) == 134
    assert len(published.worlds) == 20
    assert sum(len(example.groundings) for example in published) == 1672
    counts = {}
    for example in published:
        size = len(published.worlds[example.world].things)
        counts[size] = counts.get(size, 0) + 1
    assert counts == {4: 4, 5: 45, 7: 62, 10: 10, 12: 13}


def test_its_known_oddities_are_found_and_nothing_else(published):
    findings = check_corpus(published)
    agreement = [finding.example for finding in findings if finding.check == "agreement"]
    assert sorted(agreement) == ["example_0023", "example_0023", "example_0031", "example_0047", "example_0089"]
    words = [finding.example for finding in findings if finding.check == "words"]
    assert words == ["example_0100", "example_0107", "example_0119", "example_0125"]
    assert len(findings) == len(agreement) + len(words)


def test_its_blocks_lie_on_their_tables(published):
    for recorded in published.worlds.values():
        table = next(item for item in recorded.objects if item.type == "table")
        top = table.position[2] + table.size[2] / 2
        for block in recorded.things:
            assert block.position[2] - block.size[2] / 2 == pytest.approx(top, abs=1e-4)
            assert (abs(block.position - table.position)[:2] <= (table.size / 2)[:2]).all()
