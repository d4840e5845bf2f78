"""Colours as they are seen: what words are taken for where nothing is called so."""

import numpy as np
import pytest

from grounding.errors import LexiconError
from grounding.geometry.layout import Layout
from grounding.lexicon import colour, shades
from grounding.world import World, make_object
from grounding.world.scene import Scene


def scene(*colours):
    things = (make_object(f"o{i}", "block", name, (0.5, 0.2 * i, 0.0)) for i, name in enumerate(colours))
    return Scene(Layout(World(tuple(things))))


THERE = ("red", "blue", "green", "yellow", "gray", "white", "cyan", "magenta")


@pytest.mark.parametrize(("said", "meant"), [
    ("pink", "magenta"), ("purple", "magenta"), ("turquoise", "cyan"), ("light-blue", "cyan"), ("gray", "gray"),
    ("dark-blue", "blue"), ("light-green", "green"), ("teal", "cyan"),
])  # fmt: skip
def test_a_colour_is_what_comes_nearest_and_has_no_term_of_its_own(said, meant):
    held = colour.truth(scene(*THERE), (said,))
    assert [name for name, truth in zip(THERE, held, strict=True) if truth > 0.5] == [meant]


@pytest.mark.parametrize(("said", "there"), [("purple", "blue"), ("orange", "red"), ("black", "gray"), ("pink", "red")])
def test_what_has_a_term_of_its_own_is_not_called_otherwise(said, there):
    assert not colour.truth(scene(there), (said,)).any()
    assert colour.taken_for(scene(there), said) is None


def test_shades_of_a_world_are_named_and_told_apart():
    world = scene("#08306b", "#9ecae1", "rgb(214, 39, 40)")
    assert [shades.name_of(item.color) for item in world.layout.things] == ["blue", "blue", "red"]
    light, dark = colour.truth(world, ("light-blue",)), colour.truth(world, ("dark-blue",))
    assert light.argmax() == 1
    assert dark.argmax() == 0
    assert np.all(colour.truth(world, ("blue",)) == [1.0, 1.0, 0.0])


def test_unknown_colours_may_be_any():
    assert colour.truth(scene("unknown", "red"), ("blue",)).tolist() == [1.0, 0.0]


@pytest.mark.parametrize("entry", ['seen = "#zz0000"', 'words = "x"', 'seen = "#ff0000"\nnear = "red"', 'seen = 3'])
def test_a_bad_table_is_refused_by_file_and_entry(tmp_path, entry):
    path = tmp_path / "colours.toml"
    path.write_text(f"[odd]\n{entry}\n")
    with pytest.raises(LexiconError, match=r"colours.toml.*\[odd\]"):
        shades.read_colours(path)


def test_a_word_says_one_colour(tmp_path):
    path = tmp_path / "colours.toml"
    path.write_text('[a]\nseen = "#ff0000"\nwords = "x"\n[b]\nseen = "#00ff00"\nwords = "x"\n')
    with pytest.raises(LexiconError, match="'x' says both 'a' and 'b'"):
        shades.read_colours(path)
