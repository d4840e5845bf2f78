"""`python -m integration.corpus generate`, small: what it writes, that it goes on, and what it refuses."""

import json
import os
import resource
import signal
import subprocess
import sys
import time
from collections import Counter

import pytest
from PIL import Image

from grounding.corpus.check import check_corpus
from grounding.corpus.format import read_corpus
from grounding.corpus.generator import MOST_COPIES, is_held_out, wording_of
from integration.corpus.__main__ import main
from integration.corpus.bounding_boxes import boxed_of
from motion import rendering_available

SMALL = ["--instructions", "60", "--worlds", "12", "--images", "2", "--videos", "0", "--jobs", "1", "--seed", "4"]


def run(folder, *more):
    return main(["generate", "--output", str(folder), *SMALL, *more])


def files(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("corpora") / "small"
    assert run(folder) == 0
    return folder


@pytest.fixture(scope="module")
def corpus(made):
    return read_corpus(made / "corpus.jsonl")


def test_the_corpus_agrees_with_its_worlds_and_itself(corpus):
    assert len(corpus) == 60
    assert check_corpus(corpus) == ()


def test_no_wording_is_used_too_often_and_nothing_is_said_twice_in_a_world(corpus):
    assert max(Counter(wording_of(example.tree) for example in corpus).values()) <= MOST_COPIES
    assert len({(example.world, example.tree.text) for example in corpus}) == len(corpus)


def test_what_is_held_out_is_told_by_wording(made, corpus):
    ids = json.loads((made / "held_out.json").read_text())
    assert ids == [example.id for example in corpus if is_held_out(example.tree)]
    assert ids


def test_the_summary_counts_what_is_there(made, corpus):
    summary = json.loads((made / "summary.json").read_text())
    assert summary["instructions"] == len(corpus)
    assert summary["outcomes"] == dict(Counter(example.outcome for example in corpus).most_common())
    assert summary["held_out"] == len(json.loads((made / "held_out.json").read_text()))
    assert summary["wordings"] == len({wording_of(example.tree) for example in corpus})
    assert summary["worlds"]["how"] == {"composed": 8, "pushed": 4}
    assert sum(summary["actions"].values()) == summary["outcomes"]["grounded"]
    rows = sum(any(str(symbol).startswith("container(row;") for symbol in frozenset().union(*example.groundings))
               for example in corpus)  # fmt: skip
    assert summary["constructions"].get("row", 0) == rows


def test_boxes_of_images_are_around_what_they_name(made, corpus):
    entries = json.loads((made / "images" / "index.json").read_text())
    assert len(entries) == 2
    for entry in entries:
        example = corpus[entry["id"]]
        assert entry["instruction"] == example.instruction
        with Image.open(made / "images" / entry["image"]) as image:
            assert list(image.size) == entry["size"]
        assert set(entry["objects"]) == {item.id for item in corpus.worlds[example.world].things}
        assert [c["objects"] for c in entry["containers"]] == [
            list(item.objects) for item in boxed_of(example) if item.role == "container"
        ]
        for box in (*entry["objects"].values(), *(c["box"] for c in entry["containers"])):
            assert 0 <= box[0] < box[2] <= entry["size"][0]
            assert 0 <= box[1] < box[3] <= entry["size"][1]
        for container in entry["containers"]:
            left, top, right, bottom = container["box"]
            for name in container["objects"]:
                member = entry["objects"][name]
                assert left <= member[0]
                assert top <= member[1]
                assert right >= member[2]
                assert bottom >= member[3]
        if entry["view"] == "rendered":
            _left_is_right(entry, corpus.worlds[example.world])


def _left_is_right(entry, world):
    """The robot faces the picture: what is to its left is in the right half."""
    for item in world.things:
        left, _, right, _ = entry["objects"][item.id]
        if abs(item.position[1]) > 0.05:
            assert (left + right > entry["size"][0]) == (item.position[1] > 0)


def test_the_same_for_two_jobs(made, tmp_path):
    assert run(tmp_path / "two", "--jobs", "2") == 0
    assert files(tmp_path / "two") == files(made)


def test_another_seed_is_another_corpus(made, tmp_path):
    assert run(tmp_path / "other", "--seed", "5", "--images", "0") == 0
    assert (tmp_path / "other" / "corpus.jsonl").read_bytes() != (made / "corpus.jsonl").read_bytes()


def test_what_is_missing_is_made_anew_and_the_rest_kept(made, tmp_path, capsys):
    folder = tmp_path / "again"
    folder.mkdir()
    for name, content in files(made).items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)
    for name in ("parts/sentences-0000-01.json", "images/0000.png", "corpus.jsonl"):
        (folder / name).unlink()
    kept = (folder / "parts" / "worlds-0000.json").stat().st_mtime_ns
    assert run(folder) == 0
    assert "12 of 12 worlds were there already" in capsys.readouterr().err
    assert files(folder) == files(made)
    assert (folder / "parts" / "worlds-0000.json").stat().st_mtime_ns == kept


def command(folder, *more, **options):
    return subprocess.Popen(
        [sys.executable, "-m", "integration.corpus", "generate", "--output", str(folder), *SMALL, *more],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options,
    )  # fmt: skip


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupt_keeps_what_is_finished_and_says_how_to_go_on(tmp_path, jobs):
    folder = tmp_path / "long"
    process = command(folder, "--worlds", "4000", "--jobs", jobs)
    until = time.monotonic() + 60
    while not list(folder.glob("parts/*.json")) and time.monotonic() < until and process.poll() is None:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert process.returncode == 130
    assert "the same command goes on" in err
    assert "Traceback" not in err
    assert out == ""
    parts = list(folder.glob("parts/*.json"))
    assert parts
    for part in parts:
        json.loads(part.read_text())


def test_without_opengl_images_are_plans_and_videos_are_left_out(tmp_path):
    process = command(tmp_path / "plans", "--videos", "1", env={**os.environ, "MUJOCO_GL": "disable"})
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    assert "libegl1" in err
    assert json.loads(out)["videos"] == 0
    entries = json.loads((tmp_path / "plans" / "images" / "index.json").read_text())
    assert {entry["view"] for entry in entries} == {"plan"}


@pytest.mark.skipif(not rendering_available(), reason="no OpenGL starts here")
def test_a_video_shows_an_instruction_carried_out(tmp_path):
    assert run(tmp_path / "film", "--videos", "1", "--images", "0") == 0
    (entry,) = json.loads((tmp_path / "film" / "videos" / "index.json").read_text())
    assert entry["outcome"] == "done"
    example = read_corpus(tmp_path / "film" / "corpus.jsonl")[entry["id"]]
    assert entry["instruction"] == example.instruction
    names = " ".join(entry["action"]["objects"])
    assert any(str(s) == f"action(pick; {names})" for s in example.groundings[0])
    with Image.open(tmp_path / "film" / "videos" / entry["video"]) as video:
        assert video.n_frames > 0.5 * entry["simulated_seconds"] * 10


def test_other_settings_are_refused_and_named(made, capsys):
    assert run(made, "--seed", "9") == 2
    told = capsys.readouterr().err
    assert "seed 4 there and 9 now" in told
    assert "--restart" in told


def test_restart_begins_anew_and_leaves_other_files_alone(made, tmp_path):
    folder = tmp_path / "again"
    assert run(folder, "--seed", "9", "--images", "0") == 0
    (folder / "mine.txt").write_text("kept")
    assert run(folder, "--restart") == 0
    assert (folder / "mine.txt").read_text() == "kept"
    (folder / "mine.txt").unlink()
    assert files(folder) == files(made)


@pytest.mark.parametrize("damage", ["", '{"digest": 1, "items": []}', '{"items": 3', '{"digest": 1, "items": 7}', "[]"])
def test_a_damaged_part_is_refused_and_named(made, tmp_path, capsys, damage):
    folder = tmp_path / "damaged"
    (folder / "parts").mkdir(parents=True)
    (folder / "settings.json").write_bytes((made / "settings.json").read_bytes())
    (folder / "parts" / "worlds-0000.json").write_text(damage)
    assert run(folder) == 2
    told = capsys.readouterr().err.splitlines()[-1]
    assert told.startswith("error: ")
    assert "worlds-0000.json: is damaged" in told
    assert "delete it" in told


def test_a_folder_that_cannot_be_one_is_refused(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert run(tmp_path / "file") == 2
    assert run(tmp_path / "file" / "below") == 2
    assert run(tmp_path) == 2
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 3
    assert "is a file" in told[0]
    assert "is not empty" in told[2]


def test_no_room_is_told_before_anything_is_made(tmp_path, capsys):
    assert run(tmp_path / "large", "--videos", "999999999") == 2
    assert "no room" in capsys.readouterr().err
    assert not list((tmp_path / "large").iterdir())


def test_a_disk_that_is_full_later_is_told_in_one_line(tmp_path):
    def small_files():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

    process = command(tmp_path / "full", preexec_fn=small_files)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 2
    assert "cannot be written" in err.splitlines()[-1]
    assert "Traceback" not in err
    assert not list((tmp_path / "full").rglob(".*"))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--instructions", "0"], "above 0"),
        (["--images", "-1"], "from 0 on"),
        (["--videos", "two"], "from 0 on"),
        (["--jobs", "0"], "above 0"),
        (["--seed", "1.5"], "from 0 on"),
        (["--worlds", "1e9"], "from 0 on"),
    ],
)
def test_bad_numbers_are_told_in_one_line(tmp_path, arguments, words, capsys):
    assert run(tmp_path / "new", *arguments) == 2
    error = capsys.readouterr().err
    assert words in error
    assert error.count("\n") == 1
    assert not (tmp_path / "new").exists()
