import io

import pytest

from motion.cache import cache_root, cached_folder, intact
from motion.progress_bar import ProgressBar
from motion.robot.build import build
from motion.robot.load import Robot
from motion.robot.recipe import recipe


def _write(folder):
    (folder / "a.txt").write_text("content")


def test_builds_once_and_reads_afterwards(tmp_path):
    builds = []

    def make(folder):
        builds.append(folder)
        _write(folder)

    first = cached_folder("key", make, tmp_path)
    second = cached_folder("key", make, tmp_path)
    assert first == second == tmp_path / "key"
    assert len(builds) == 1
    assert [path.name for path in tmp_path.iterdir()] == ["key"]


@pytest.mark.parametrize("damage", ["truncated", "missing", "manifest"])
def test_a_damaged_cache_is_built_again(tmp_path, damage):
    folder = cached_folder("key", _write, tmp_path)
    if damage == "truncated":
        (folder / "a.txt").write_text("cont")
    elif damage == "missing":
        (folder / "a.txt").unlink()
    else:
        (folder / "manifest.json").write_text("{")
    assert not intact(folder)
    assert (cached_folder("key", _write, tmp_path) / "a.txt").read_text() == "content"


def test_a_build_that_fails_leaves_nothing(tmp_path):
    def fail(folder):
        _write(folder)
        raise RuntimeError("disk full")

    with pytest.raises(RuntimeError, match="disk full"):
        cached_folder("key", fail, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_made_gives_a_temporary_one(tmp_path):
    (tmp_path / "file").write_text("")
    folder = cached_folder("key", _write, tmp_path / "file" / "below")
    assert (folder / "a.txt").read_text() == "content"


def test_the_cache_follows_the_environment(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_root() == tmp_path / "adcg-baxter"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    assert cache_root().parts[-2:] == (".cache", "adcg-baxter")


def test_the_robot_builds_from_nothing_and_shows_progress(tmp_path, capsys):
    build(tmp_path, recipe())
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Building Baxter" in captured.err
    assert "\r" not in captured.err
    assert len(Robot(tmp_path).arms) == 2


def test_progress_draws_in_place_on_a_terminal():
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    stream = Terminal()
    bar = ProgressBar("Work", 2, stream)
    bar.step("one")
    bar.step("two")
    bar.close()
    assert stream.getvalue().count("\n") == 1
    assert "2/2" in stream.getvalue()
