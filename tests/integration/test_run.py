import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from by_hand import SCENES

from integration import run

DEMONSTRATIONS = {
    "pick up the middle block in the row of five blocks on the right": "b3",
    "pick up the farthest block in the column of three blocks on the left": "b8",
}


def command(*arguments, **environment):
    """Runs the command as people do."""
    result = subprocess.run(
        [sys.executable, "-m", "integration.run", *arguments],
        env={**os.environ, **environment}, capture_output=True, text=True, cwd=Path(run.__file__).parents[1],
    )  # fmt: skip
    assert "Traceback" not in result.stderr
    return result


def one_line(text):
    return len(text.strip().splitlines()) == 1


@pytest.mark.parametrize(("text", "block"), DEMONSTRATIONS.items())
def test_the_demonstrations_are_done_and_checked(text, block, tmp_path, capsys):
    assert run.main([text, "--json", "--output", str(tmp_path)]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["outcome"], data["handled"][0]["object"]) == ("done", block)
    assert all(check["passed"] for check in data["checks"])
    assert (tmp_path / "understood.png").stat().st_size > 10_000
    assert (tmp_path / "result.png").stat().st_size > 10_000


def test_as_people_run_it(tmp_path):
    text = next(iter(DEMONSTRATIONS))
    result = command(text, "--output", str(tmp_path))
    assert result.returncode == 0
    for part in (text, "row of b1 b2 b3 b4 b5", "right", "no other block moved", str(tmp_path / "result.png"), "Done"):
        assert part in result.stdout


def test_without_opengl_it_succeeds_and_says_how_to_get_rendered_pictures(tmp_path):
    result = command(next(iter(DEMONSTRATIONS)), "--output", str(tmp_path), "--json", MUJOCO_GL="disable")
    assert result.returncode == 0
    assert json.loads(result.stdout)["outcome"] == "done"
    assert "libegl1" in result.stderr
    assert (tmp_path / "result.png").exists()


@pytest.mark.parametrize(
    "text", ["sing a song", "pick up the purple elephant", "pick up the block", "colourless green ideas"]
)
def test_what_is_not_grounded_is_said_in_a_sentence(text, tmp_path, capsys):
    assert run.main([text, "--output", str(tmp_path)]) == 3
    told = capsys.readouterr()
    assert "Not grounded: " in told.out
    assert told.out.count("Pictures") == 1
    assert run.main([text, "--json", "--no-pictures"]) == 3
    told = capsys.readouterr()
    assert len(json.loads(told.out)["message"]) > 10
    assert one_line(told.err)


@pytest.mark.parametrize("text", ["", "   ", "\n", "?!"])
def test_an_empty_instruction_is_bad_usage(text, capsys):
    assert run.main([text]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert one_line(captured.err)
    assert "empty" in captured.err or "words" in captured.err


def _world(**changes):
    block = {"id": "b1", "type": "block", "color": "red", "position": [0.6, 0.1, 0.736], "orientation": [1, 0, 0, 0],
             "size": [0.05, 0.05, 0.05]}  # fmt: skip
    table = {**block, "id": "table", "type": "table", "position": [0.65, 0, 0.691], "size": [0.7, 1.8, 0.04]}
    return {"objects": [{**block, **changes}, table]}


BAD_WORLDS = {
    "truncated": json.dumps(_world())[:-30],
    "nan": json.dumps(_world(position=[float("nan"), 0, 0.7])),
    "duplicate": json.dumps(_world(id="table")),
    "flat": json.dumps(_world(size=[0.05, 0.05, 0])),
    "unknown key": json.dumps({**_world(), "weather": "fine"}),
    "no json": "blocks",
    "empty": "",
}


@pytest.mark.parametrize("kind", BAD_WORLDS)
def test_a_bad_world_file_is_refused_in_one_line(kind, tmp_path, capsys):
    path = tmp_path / "world.json"
    path.write_text(BAD_WORLDS[kind])
    assert run.main(["pick up the block", "--scene", str(path)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert one_line(captured.err)
    assert "world.json" in captured.err


@pytest.mark.parametrize(
    "arguments",
    [
        ["--scene", "nowhere"], ["--scene", "nowhere.json"], ["--scene", "."], ["--arm", "third"], ["--seed", "-1"],
        ["--seed", "x"], ["--video", "run.avi"], ["--output", __file__], ["--unknown"],
    ],
)  # fmt: skip
def test_bad_usage_is_refused_in_one_line(arguments, capsys):
    assert run.main(["pick up the nearest block", *arguments]) == 2
    assert one_line(capsys.readouterr().err)


def test_without_an_instruction(capsys):
    assert run.main([]) == 2
    assert one_line(capsys.readouterr().err)


def test_a_world_without_blocks_has_nothing_to_pick(tmp_path, capsys):
    path = tmp_path / "world.json"
    path.write_text(json.dumps({"objects": _world()["objects"][1:]}))
    assert run.main(["pick up the block", "--scene", str(path), "--output", str(tmp_path)]) == 3
    path.write_text(json.dumps({"objects": []}))
    assert run.main(["pick up the block", "--scene", str(path), "--output", str(tmp_path)]) == 3
    assert "Traceback" not in capsys.readouterr().err


def test_an_unreachable_block_has_no_plan(tmp_path, capsys):
    path = tmp_path / "world.json"
    path.write_text(json.dumps(_world(position=[0.95, 0.8, 0.736])))
    assert run.main(["pick up the red block", "--scene", str(path), "--output", str(tmp_path), "--json"]) == 4
    captured = capsys.readouterr()
    assert json.loads(captured.out)["outcome"] == "no_plan"
    assert "b1" in captured.err


def test_a_world_file_can_be_given(tmp_path, capsys):
    path = tmp_path / "world.json"
    path.write_text(json.dumps(_world()))
    assert run.main(["pick up the red block", "--scene", str(path), "--output", str(tmp_path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["final_poses"].keys() == {"b1"}


def test_the_same_seed_gives_the_same_report_byte_for_byte(tmp_path):
    text, told = "put the nearest block on top of the tower on the left", []
    for _ in range(2):
        data = json.loads(command(text, "--scene", "tower", "--seed", "3", "--json", "--output", str(tmp_path)).stdout)
        data.pop("timings")
        told.append(json.dumps(data))
    assert told[0] == told[1]


def test_every_scene_can_be_named():
    assert run.scene_names() == tuple(sorted(path.stem for path in SCENES.glob("*.json")))
    for name in run.scene_names():
        assert run.load_scene(name).things


def test_the_arm_is_obeyed(capsys):
    assert run.main(["pick up the nearest block", "--scene", "four", "--arm", "left", "--json", "--no-pictures"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["arms"], data["pictures"]) == (["left"], [])


def test_starting_needs_neither_matplotlib_nor_the_optimiser_of_pictures():
    code = "import sys, integration.run; print([m for m in ('matplotlib', 'motion', 'scipy') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"


def test_an_interrupted_run_ends_without_a_traceback(tmp_path):
    text = "clear the row of blue blocks on the right"
    process = subprocess.Popen(
        [sys.executable, "-m", "integration.run", text, "--scene", "twenty_mixed", "--output", str(tmp_path)],
        cwd=Path(run.__file__).parents[1], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate()
    assert process.returncode == run.INTERRUPTED
    assert errors.strip() == "interrupted"
