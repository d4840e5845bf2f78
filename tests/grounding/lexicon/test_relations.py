"""A relation is one file of its own, and a word for one that is there is one line of the table."""

import numpy as np
import pytest

from grounding import Grounder
from grounding.distinguishing import Describer
from grounding.errors import LexiconError
from grounding.explanations import explain
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.lexicon import relations
from grounding.lexicon.relations import relation
from grounding.lexicon.vocabulary import extended
from grounding.lexicon.where import Where
from grounding.meaning.nouns import read_noun
from grounding.meaning.reader import Reader
from grounding.model.evaluator import Evaluator
from grounding.world import World, make_object
from grounding.world.scene import Scene

OPPOSITE = '''
"""Across the table's middle from something."""

import numpy as np

SAID = "opposite from"


def truth(where, scene):
    mirrored = 2 * scene.box[0] - scene.xy
    away = np.linalg.norm(where.xy[:, None] - mirrored[None], axis=2) / scene.edge
    return np.exp(-0.5 * away**2)


def preference(where, scene):
    return np.ones((len(where), scene.n))
'''


def scene_of(**places):
    blocks = [
        make_object(name, "block", colour, (x, y, 0.736), size=(0.05, 0.05, 0.05))
        for name, (colour, x, y) in places.items()
    ]
    return Scene(Layout(World(tuple(blocks))))


def chosen(scene, words):
    """The object that "the block WORDS the red block" means best."""
    tree, _ = from_brackets(f"(NP (NP (DT the) (NN block)) (PP {words} (NP (DT the) (JJ red) (NN block))))")
    found = Evaluator(scene).denote(Reader().refer(read_noun(tree)))
    return scene.layout.ids[int(np.argmax(found.weights))]


@pytest.fixture
def opposite(tmp_path, monkeypatch):
    """A relation that nobody has heard of, as a file beside the others."""
    (tmp_path / "opposite.py").write_text(OPPOSITE, encoding="utf-8")
    monkeypatch.setattr(relations, "__path__", [*relations.__path__, str(tmp_path)])
    yield
    relation.cache_clear()


CROSS = scene_of(red=("red", 0.5, 0.2), beside=("blue", 0.5, 0.0), slanted=("blue", 0.6, 0.3), far=("blue", 0.8, -0.1))


def test_what_is_diagonal_lies_as_far_aside_as_ahead():
    assert chosen(CROSS, "(JJ diagonal) (IN from)") == "slanted"


def test_a_file_and_a_line_make_a_relation(opposite):
    with extended("relation", "opposite", "opposite"):
        assert chosen(CROSS, "(JJ opposite) (IN from)") == "far"


def test_afterwards_things_are_put_explained_and_described_by_it(opposite):
    world = World((
        make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04)),
        *(make_object(name, "block", colour, (x, y, 0.736)) for name, colour, x, y in (
            ("red", "red", 0.5, 0.2), ("green", "green", 0.85, 0.35), ("b1", "blue", 0.4, -0.6),
            ("b2", "blue", 0.9, 0.6),
        )),
    ))  # fmt: skip
    grounder = Grounder.load()
    with extended("relation", "opposite", "opposite"):
        result = grounder.ground("put the green block opposite from the red block", world)
        place = result.actions[0].destination
        assert (result.actions[0].objects, place.reference) == (("green",), ("red",))
        mirrored = 2 * grounder.scene(world).box[0] - (0.5, 0.2)
        assert np.linalg.norm(np.array(place.position[:2]) - mirrored) < 0.06
        moved = world.with_objects(o.moved(place.position) if o.id == "green" else o for o in world.objects)
        again = grounder.ground("pick up the block opposite from the red block", moved)
        assert again.actions[0].objects == ("green",)
        text = "pick up the block opposite from the red block"
        _, told = explain(grounder, text, moved)
        assert "relation opposite" in str(told.to_json())
        describer = Describer(Scene(Layout(moved)))
        assert any("opposite from" in c.tree.text for c in describer._candidates(describer.scene.layout.index["green"]))


def test_a_line_gives_a_relation_another_word():
    with extended("relation", "diagonal", "aslant"):
        assert chosen(CROSS, "(JJ aslant) (IN from)") == "slanted"


def test_afterwards_the_word_says_nothing_again():
    with extended("relation", "diagonal", "aslant"):
        pass
    assert Reader().refer(read_noun(from_brackets("(NP (DT the) (JJ aslant) (NN thing))")[0])).conditions == ()


def test_a_relation_without_a_file_is_refused():
    with extended("relation", "nowhere", "nowhere"), pytest.raises(LexiconError, match=r"nowhere.*no module"):
        chosen(CROSS, "(JJ nowhere) (IN from)")


def test_a_word_says_one_thing_in_a_family():
    with pytest.raises(LexiconError, match="'diagonal' says"), extended("relation", "other", "diagonal"):
        pass


@pytest.mark.parametrize("name", ["diagonal"])
def test_degrees_hold_of_objects_as_of_the_points_where_they_are(name):
    module = relation(name)
    objects = module.truth(Where.objects(CROSS), CROSS)
    points = module.truth(Where.points(CROSS, CROSS.xy), CROSS)
    off = ~np.eye(CROSS.n, dtype=bool)
    assert np.allclose(objects[off], points[off])
    assert ((objects >= 0) & (objects <= 1)).all()
    near = module.preference(Where.objects(CROSS), CROSS)
    assert ((near >= 0) & (near <= 1)).all()
