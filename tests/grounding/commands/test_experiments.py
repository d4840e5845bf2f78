"""`python -m grounding experiments`: files, what is told, and what is refused."""

import json
import os
import signal
import subprocess
import sys
from functools import partial

import pytest

import models
from grounding.__main__ import main
from grounding.corpus.annotate import annotate
from grounding.corpus.format import Corpus, Example, write_corpus
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.world import load_world

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")
TREES = (
    "(VP (VB take) (NP (DT the) (JJ leftmost) (NN block)))",
    "(VP (VB take) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB lift) (NP (DT the) (JJ leftmost) (JJ red) (NN block)))",
)


@pytest.fixture(scope="module")
def corpus(tmp_path_factory):
    """Three instructions in two scenes, written as a corpus."""
    worlds = {name: load_world(models.SCENES / f"{name}.json") for name in ("four", "seven")}
    examples = []
    for number, text in enumerate(TREES):
        tree = from_brackets(text)[0]
        for name, world in worlds.items():
            groundings, outcome = annotate(tree, Layout(world), ())
            examples.append(Example(f"t{number}-{name}", name, tree.text, tree, groundings, outcome))
    path = tmp_path_factory.mktemp("corpus") / "small.jsonl"
    write_corpus(Corpus(tuple(examples), worlds), path)
    return path


def accuracy(corpus, output, *more):
    return main(["experiments", "accuracy", "--corpus", str(corpus), "--output", str(output), "--splits", "2",
                 "--holdouts", "0.34", *more])  # fmt: skip


def test_accuracy_writes_tables_and_plots_and_goes_on_where_it_ended(corpus, tmp_path, capsys):
    assert accuracy(corpus, tmp_path / "out") == 0
    told = capsys.readouterr()
    assert "root" in told.out
    assert "6 instructions in 2 worlds, 2 splits" in told.err
    assert "2/2 splits" in told.err
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names == {"accuracy.csv", "accuracy.json", "accuracy_splits.csv", "accuracy_random.png",
                     "accuracy_random.pdf", "accuracy_random_by_blocks.png", "accuracy_random_by_blocks.pdf",
                     "splits"}  # fmt: skip
    before = json.loads((tmp_path / "out" / "accuracy.json").read_text(encoding="utf-8"))
    assert accuracy(corpus, tmp_path / "out", "--no-plots") == 0
    assert "2 splits are done already" in capsys.readouterr().err
    after = json.loads((tmp_path / "out" / "accuracy.json").read_text(encoding="utf-8"))
    assert after["records"] == before["records"]


def test_without_matplotlib_the_tables_are_there_and_the_extra_is_named(corpus, tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert accuracy(corpus, tmp_path, "--by", "worlds", "--holdouts", "0.5") == 2
    assert (tmp_path / "accuracy.json").exists()
    (line,) = [line for line in capsys.readouterr().err.splitlines() if line.startswith("error")]
    assert "adcg-baxter[plots]" in line


def test_efficiency_and_figures_write_their_files(corpus, tmp_path, capsys):
    where = ["--corpus", str(corpus), "--output", str(tmp_path)]
    assert main(["experiments", "efficiency", *where, "--blocks", "20", "--instructions", "1", "--budget", "1"]) == 0
    assert "time grows as n^" in capsys.readouterr().out
    assert {"efficiency.csv", "efficiency.json", "efficiency.png"} <= {path.name for path in tmp_path.iterdir()}
    assert main(["experiments", "figures", *where, "--id", "t0-four"]) == 0
    drawn = capsys.readouterr().out.split()
    assert drawn[0] == str(tmp_path / "t0-four.png")
    assert len(drawn) == 3


@pytest.mark.parametrize(
    ("more", "match"),
    [
        (["--inference", "magic"], "no inference 'magic'; there are adcg"),
        (["--by", "worlds", "--holdouts", "0.1"], "2 worlds leaves nothing"),
        (["--corrections", "nowhere.json"], "nowhere.json: no such file"),
    ],
)
def test_what_cannot_be_done_is_told_in_one_line(corpus, tmp_path, capsys, more, match):
    assert accuracy(corpus, tmp_path, *more) == 2
    last = capsys.readouterr().err.splitlines()[-1]
    assert last.startswith("error: ")
    assert match in last


@pytest.mark.parametrize("more", [["--threshold", "1.5"], ["--holdouts", "2"], ["--splits", "0"], ["--jobs", "x"],
                                  ["--parse", "guess"], ["--seed", "-1"]])  # fmt: skip
def test_bad_usage_is_refused(corpus, tmp_path, capsys, more):
    with pytest.raises(SystemExit) as caught:
        accuracy(corpus, tmp_path, *more)
    assert caught.value.code == 2
    assert more[0] in capsys.readouterr().err


@pytest.fixture
def broken(corpus, tmp_path):
    """The corpus with two lines that are refused."""
    lines = corpus.read_text(encoding="utf-8").splitlines()
    lines[1] = lines[1].replace("object(b", "object(nobody", 1)
    lines[4] = lines[4][: len(lines[4]) // 2]
    (tmp_path / "broken.jsonl").write_text("\n".join(lines) + "\n", encoding="utf-8")
    worlds = corpus.with_suffix(".worlds.json").read_text(encoding="utf-8")
    (tmp_path / "broken.worlds.json").write_text(worlds, encoding="utf-8")
    return tmp_path / "broken.jsonl"


def test_a_corpus_that_is_refused_is_told_with_file_and_element(broken, tmp_path, capsys):
    assert accuracy(broken, tmp_path / "out") == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert f"{broken}: line 2" in line
    assert "nobody" in line
    assert not (tmp_path / "out").exists()


def test_keep_going_lists_all_and_goes_on_with_the_rest(broken, tmp_path, capsys):
    assert accuracy(broken, tmp_path / "out", "--keep-going", "--no-plots") == 2
    told = capsys.readouterr().err
    assert f"{broken}: line 2" in told
    assert f"{broken}: line 5" in told
    assert "2 refused; going on with the other 4 examples" in told
    results = json.loads((tmp_path / "out" / "accuracy.json").read_text(encoding="utf-8"))
    assert results["corpus"]["examples"] == 4


def test_after_an_interrupt_nothing_runs_on(corpus, tmp_path):
    run = subprocess.Popen(
        [sys.executable, "-m", "grounding", "experiments", "accuracy", "--corpus", str(corpus), "--output",
         str(tmp_path), "--splits", "500", "--holdouts", "0.34", "--jobs", "2", "--no-plots"],
        stderr=subprocess.PIPE, text=True, start_new_session=True,
        preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL),  # tests in the background ignore it
    )  # fmt: skip
    with run:
        assert run.stderr is not None
        assert "500 splits" in run.stderr.readline()
        os.killpg(run.pid, signal.SIGINT)
        rest = run.stderr.read()
    assert run.returncode == 130
    assert "Traceback" not in rest


XML = """<file>
<instruction text="take the block"/>
<world><object name="a-cube" type="block" position="0.8,0,0.75" orientation="0,0,0,1" color="na"/></world>
<VP><VB text="take" order="0"/><NP><grounding><grounding_set><object name="{name}"/></grounding_set></grounding>
<DT text="the" order="0"/><NN text="block" order="1"/></NP></VP>
</file>"""


def test_xml_files_that_are_refused_are_named_and_left_out(tmp_path, capsys):
    folder = tmp_path / "xml"
    folder.mkdir()
    texts = {"1": XML.format(name="a-cube"), "2": XML.format(name="a-ghost"), "3": XML[: len(XML) // 2],
             "4": XML.format(name="a-cube").replace("take", "lift"), "5": "<file><world/></file>"}  # fmt: skip
    for name, text in texts.items():
        (folder / f"example_{name}.xml").write_text(text, encoding="utf-8")
    assert accuracy(folder, tmp_path / "out", "--keep-going", "--no-plots", "--holdouts", "0.5") == 2
    told = capsys.readouterr().err
    for name, what in (("2", "a-ghost"), ("3", ""), ("5", "instruction")):
        (line,) = [line for line in told.splitlines() if f"example_{name}.xml" in line]
        assert what in line
    assert "going on with the other 2 examples" in told


def test_a_folder_that_cannot_be_made_is_refused(corpus, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert accuracy(corpus, tmp_path / "file") == 2
    assert "--output names a folder" in capsys.readouterr().err
