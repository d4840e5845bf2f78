"""Plots are drawn from results; what they need is named where it is missing."""

import sys

import numpy as np
import pytest
from PIL import Image

from grounding.experiments import ExperimentError, plots
from grounding.experiments.paper import FIGURE_5
from grounding.experiments.summary import MEASURES, Record
from grounding.experiments.timing import Cost

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

RECORDS = [
    Record("random", holdout, parse, name, part, measure, 0.9 - holdout / 2, 0.02, 9, 27.0)
    for holdout in (0.2, 0.5, 0.8)
    for parse, name in (("annotated", "adcg"), ("annotated", "dcg"), ("own", "adcg"))
    for part in ("all", "4 blocks", "12 blocks")
    for measure in MEASURES
]
COSTS = [
    Cost(name, n, False, 1, 10, t, t, 2 * t, 0.1, 100.0 * n, 100.0 * n, {}, 50.0, 40.0)
    for name, t in (("adcg", 0.001), ("dcg", 0.5))
    for n in (4, 5, 12)
]


def colored(path):
    """How many pixels of a picture are neither grey nor white."""
    with Image.open(path) as image:
        pixels = np.asarray(image.convert("RGB"), dtype=int)
    return int((np.ptp(pixels, axis=2) > 40).sum())


def test_accuracy_has_a_line_for_every_method(tmp_path):
    both = plots.plot_accuracy(RECORDS, FIGURE_5, "random", tmp_path / "both.png")
    one = [r for r in RECORDS if (r.parse, r.inference) == ("annotated", "adcg")]
    single = plots.plot_accuracy(one, None, "random", tmp_path / "single.png")
    assert colored(both) > colored(single) > 500
    assert (tmp_path / "both.pdf").stat().st_size > 1000


def test_by_blocks_has_a_line_for_every_size(tmp_path):
    path = plots.plot_by_blocks(RECORDS, "random", "annotated", "adcg", tmp_path / "blocks.png")
    assert colored(path) > 500


def test_efficiency_stands_beside_the_papers(tmp_path):
    fits = {"adcg": {"exponent": 0.5, "evaluations_exponent": 1.0, "per_block": 1.1}}
    with_paper = plots.plot_efficiency(COSTS, fits, True, tmp_path / "with.png")
    without = plots.plot_efficiency(COSTS, fits, False, tmp_path / "without.png")
    assert colored(with_paper) > colored(without) > 500


def test_one_holdout_and_one_size_can_be_drawn(tmp_path):
    one = [r for r in RECORDS if r.holdout == 0.5]
    assert colored(plots.plot_accuracy(one, None, "random", tmp_path / "a.png")) > 50
    assert colored(plots.plot_efficiency(COSTS[:1], {}, False, tmp_path / "b.png")) > 20


def test_without_matplotlib_the_extra_is_named(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ExperimentError, match=r"adcg-baxter\[plots\].*--no-plots"):
        plots.require_matplotlib(tmp_path)
