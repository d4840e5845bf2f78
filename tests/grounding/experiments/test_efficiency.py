"""Costs by number of blocks: large worlds, what is measured, growth and ratios."""

import json

import numpy as np
import pytest
from tiny_corpus import tiny

from grounding.errors import CorpusError
from grounding.experiments.efficiency import growth, measure_efficiency, ratios, report, write_results
from grounding.experiments.large_worlds import compose_large
from grounding.experiments.paper import TABLE_I, is_papers
from grounding.experiments.timing import Cost


def cost(name, blocks, seconds, evaluations, composed=False):
    return Cost(name, blocks, composed, 1, 10, seconds, seconds, 2 * seconds, 0.1, evaluations, evaluations, {}, 50.0,
                40.0)  # fmt: skip


@pytest.mark.parametrize("blocks", [3, 20, 50, 200])
def test_large_worlds_have_their_blocks_apart_on_one_table(blocks):
    world = compose_large(np.random.default_rng(3), blocks)
    assert len(world.things) == blocks
    assert len({item.id for item in world.objects}) == blocks + 1
    table = world["table"]
    for item in world.things:
        assert (np.abs(item.position - table.position)[:2] <= table.half_extents[:2]).all()
    at = world.positions
    gaps = np.linalg.norm(at[:, None] - at[None], axis=2) + np.eye(blocks)
    assert gaps.min() > 0.02


def test_the_same_seed_gives_the_same_large_world():
    first, second = (compose_large(np.random.default_rng(1), 60) for _ in range(2))
    assert np.array_equal(first.positions, second.positions)
    with pytest.raises(CorpusError, match="2 blocks"):
        compose_large(np.random.default_rng(0), 2)


def test_growth_is_the_exponent():
    costs = [cost("adcg", n, 1e-4 * n**1.5, 3.0 * n) for n in (10, 20, 40)]
    costs += [cost("dcg", n, 1e-4 * 2.0**n, 2.0**n) for n in (4, 5, 8)] + [cost("g3", 4, 1.0, 1.0)]
    fits = growth(costs)
    assert set(fits) == {"adcg", "dcg"}
    assert fits["adcg"]["exponent"] == pytest.approx(1.5)
    assert fits["adcg"]["evaluations_exponent"] == pytest.approx(1.0)
    assert fits["dcg"]["per_block"] == pytest.approx(2.0)


def test_ratios_stand_beside_the_papers():
    found = ratios([cost("adcg", 12, 0.001, 10), cost("dcg", 12, 1.0, 500), cost("dcg", 5, 1.0, 50)])
    assert len(found) == 1
    assert found[0]["ratio"] == pytest.approx(1000)
    assert found[0]["evaluations_ratio"] == pytest.approx(50)
    assert found[0]["paper"] == pytest.approx(14.25 / 0.011)


def test_the_papers_corpus_is_known_by_its_sizes():
    assert not is_papers(tiny())
    assert sum(line.instructions for line in TABLE_I.values()) == 134


def test_everything_is_measured_and_written(tmp_path):
    measured = measure_efficiency(tiny(), ("adcg", "dcg"), (20,), 4, 3, 5.0, 0)
    sizes = [(c.inference, c.blocks, c.composed) for c in measured.costs]
    assert sizes[:2] == [("adcg", 4, False), ("adcg", 7, False)]
    assert sizes[-2:] == [("adcg", 20, True), ("dcg", 4, False)]
    for found in measured.costs:
        assert found.refused is None
        assert 0 < found.median <= found.p95
        assert found.mean > 0
        assert found.world > 0
        assert found.evaluations > 0
        assert found.symbols == pytest.approx(sum(found.spaces.values()))
        assert found.megabytes >= found.megabytes_before > 0
    ours, theirs = measured.costs[0], measured.costs[-1]
    assert theirs.evaluations > 10 * ours.evaluations  # an exhaustive search judges more
    results = write_results(tmp_path, tiny(), measured)
    assert json.loads((tmp_path / "efficiency.json").read_text(encoding="utf-8"))["paper"] is None
    assert len((tmp_path / "efficiency.csv").read_text(encoding="utf-8").splitlines()) == len(measured.costs) + 1
    assert "dcg / adcg at 4 blocks" in report(results)
