import json

import numpy as np
import pytest

from integration.benchmark.__main__ import main
from integration.benchmark.episode import run_episode
from integration.benchmark.fault_cases import FAULTS, draw_fault
from integration.benchmark.measures import distribution, summarised
from integration.benchmark.random_worlds import FEWEST, MOST, draw_episode
from integration.benchmark.records import Records
from integration.benchmark.spoken_goals import draw_spoken
from integration.errors import UsageError
from integration.worlds_and_scenes import scene_of
from motion.polygons import overlap

SETTINGS = {"seed": 0, "faults": False, "language": False}


def _json(episode):
    return [(item.id, item.color, *item.position, *item.orientation) for item in episode.world.objects], episode.actions


@pytest.mark.parametrize("number", [0, 1, 7])
def test_an_episode_is_its_seed_and_number(number):
    first, second = draw_episode(3, number), draw_episode(3, number)
    assert _json(first) == _json(second)
    assert _json(first) != _json(draw_episode(4, number))


@pytest.mark.parametrize("number", range(6))
def test_worlds_have_blocks_apart_from_one_another(number):
    scene = scene_of(draw_episode(1, number).world)
    loose = [box for box in scene.boxes if not box.fixed]
    assert FEWEST <= len(loose) <= MOST
    for one in loose:
        for other in loose:
            if one is not other and abs(one.position[2] - other.position[2]) < 0.01:
                assert overlap(one.footprint, other.footprint) < -0.01


def test_every_fault_has_its_turn():
    cases = [draw_fault(0, draw_episode(0, number, kinds=("pick",))) for number in range(6)]
    assert [case.name for case in cases] == list(FAULTS)
    assert repr(cases) == repr([draw_fault(0, draw_episode(0, number, kinds=("pick",))) for number in range(6)])


@pytest.mark.parametrize("number", range(4))
def test_descriptions_fit_one_block_only(number):
    episode, text = draw_spoken(0, number)
    blocks = [item for item in episode.world.objects if item.type == "block"]
    color = next((word for word in text.split() if word in {item.color for item in blocks}), None)
    assert episode.world[episode.target] in blocks
    assert text.startswith(("pick up the ", "put the "))
    assert color is None or any(item.color == color for item in blocks)


def test_a_record_is_the_same_but_for_its_times():
    records = [run_episode(0, 9) for _ in range(2)]
    for record in records:
        record.pop("timings")
    assert records[0] == records[1]
    assert records[0]["success"]
    assert not records[0]["false_success"]
    assert max(records[0]["limit_use"].values()) <= 1.001


def test_the_command_measures_goes_on_and_replays(tmp_path, capsys):
    path = tmp_path / "records.jsonl"
    assert main(["--episodes", "1", "--seed", "5", "--output", str(path)]) == 0
    first = json.loads(capsys.readouterr().out)
    assert first["summary"]["episodes"] == 1
    assert first["summary"]["succeeded"] == 1
    path.write_text(path.read_text() + '{"episode": 1, "cut o')
    assert main(["--episodes", "2", "--seed", "5", "--output", str(path)]) == 0
    captured = capsys.readouterr()
    assert "1 of 2 episodes were there already" in captured.err
    assert json.loads(captured.out)["summary"]["episodes"] == 2
    assert main(["--replay", "1", "--seed", "5"]) == 0
    replayed = json.loads(capsys.readouterr().out)
    kept = json.loads(path.read_text().splitlines()[2])
    for record in (replayed, kept):
        record.pop("timings")
    assert replayed == kept


def test_records_of_other_settings_are_not_mixed(tmp_path):
    path = tmp_path / "records.jsonl"
    Records(path, SETTINGS).close()
    with pytest.raises(UsageError, match="--restart"):
        Records(path, {**SETTINGS, "seed": 1})
    Records(path, {**SETTINGS, "seed": 1}, restart=True).close()
    path.write_text("nonsense\n")
    with pytest.raises(UsageError, match="line 1"):
        Records(path, SETTINGS)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--episodes", "0"], "above 0"),
        (["--seed", "x"], "from 0 on"),
        (["--video", "x.gif"], "--replay"),
        (["--faults", "--language"], "apart"),
    ],
)
def test_bad_usage_is_told_in_one_line(arguments, words, capsys):
    assert main(arguments) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1


def test_figures_are_of_what_was_measured():
    assert distribution([]) == {"count": 0}
    values = np.arange(101.0)
    assert distribution(values) == {"count": 101, "median": 50.0, "p95": 95.0, "p99": 99.0, "max": 100.0}
    record = run_episode(0, 9)
    failed = {**record, "episode": 10, "success": False, "false_success": True}
    summary = summarised([record, failed])
    assert (summary["success_rate"], summary["false_successes"]) == (0.5, 1)
    assert [failure["episode"] for failure in summary["failures"]] == [10]
