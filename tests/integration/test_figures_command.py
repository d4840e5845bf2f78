"""`python -m integration.figures`: the figures of the experiments over rendered views."""

import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

import models
from grounding.experiments.figures import own_figures
from grounding.pictures.palette import MARKS
from grounding.world import load_world
from integration.figures import main, rendered
from integration.show.views import close_camera
from motion import rendering_available

needs_opengl = pytest.mark.skipif(not rendering_available(), reason="no OpenGL starts here")
TREES = tuple(f"(VP (VB take) (NP (DT the) (JJ {which}) (NN block)))" for which in ("leftmost", "rightmost"))


@pytest.fixture(scope="module")
def corpus(tmp_path_factory):
    """Two instructions in one scene, written as a corpus."""
    from grounding.corpus.annotate import annotate
    from grounding.corpus.format import Corpus, Example, write_corpus
    from grounding.geometry.layout import Layout
    from grounding.language.tree import from_brackets

    world = load_world(models.SCENES / "four.json")
    examples = []
    for number, text in enumerate(TREES):
        tree = from_brackets(text)[0]
        groundings, outcome = annotate(tree, Layout(world), ())
        examples.append(Example(f"t{number}", "four", tree.text, tree, groundings, outcome))
    path = tmp_path_factory.mktemp("corpus") / "small.jsonl"
    write_corpus(Corpus(tuple(examples), {"four": world}), path)
    return path


def pixels(image, color):
    return int((np.abs(np.asarray(image, dtype=int) - color).max(axis=2) <= 6).sum())


@needs_opengl
def test_container_and_action_are_marked_in_the_view():
    image = rendered(own_figures()[0])
    for color in MARKS[:2]:
        assert pixels(image, color) > 150


@needs_opengl
def test_a_picture_is_written_for_every_figure(corpus, tmp_path, capsys):
    assert main(["--corpus", str(corpus), "--output", str(tmp_path / "new"), "--id", "t0"]) == 0
    drawn = capsys.readouterr().out.split()
    assert drawn[0] == str(tmp_path / "new" / "t0_view.png")
    assert len(drawn) == 3
    for name in drawn:
        with Image.open(name) as image:
            assert image.width > 900


def test_the_camera_follows_the_table():
    world = load_world(models.SCENES / "four.json")
    shift = np.array([0.25, 0, 0.1])
    there = world.with_objects(item.moved(item.position + shift) for item in world.objects)
    assert np.allclose(close_camera(there).target - close_camera(world).target, shift)


def test_what_is_refused_is_told_in_one_line(corpus, tmp_path, capsys):
    assert main(["--corpus", str(tmp_path / "nowhere.jsonl"), "--output", str(tmp_path)]) == 2
    assert main(["--corpus", str(corpus), "--output", str(tmp_path), "--id", "t9"]) == 2
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 2
    assert "nowhere.jsonl" in told[0]
    assert "'t9'" in told[1]


def test_without_opengl_packages_are_named(corpus, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "integration.figures", "--corpus", str(corpus), "--output", str(tmp_path), "--id", "t0"],
        env={**os.environ, "MUJOCO_GL": "disable"}, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 2
    assert "libegl1" in done.stderr
    assert "Traceback" not in done.stderr
