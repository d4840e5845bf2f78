"""Every example runs, and the pages of documentation say what is there."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
PAGES = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
EXPECTED = {
    "pick": "Done: b3 is in the right hand",
    "place": "done - ",
    "ground_only": "grounded pick ",
    "ros_bridge": "b1 is in the left hand",
    "session": "undone: b1 is where it should be",
    "kinematics": "joint limit: left_e1",
}


def run(example, folder, *arguments):
    """Runs an example as people do, in a folder of its own."""
    return subprocess.run(
        [sys.executable, str(example), *arguments],
        cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True,
    )  # fmt: skip


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_runs_and_does_what_it_says(example, tmp_path):
    result = run(example, tmp_path)
    assert result.returncode == 0, result.stderr
    assert EXPECTED[example.stem] in result.stdout


def test_grounding_only_takes_an_instruction_and_a_scene(tmp_path):
    result = run(ROOT / "examples" / "ground_only.py", tmp_path, "pick up the purple elephant", "four")
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith("no_referent")
    assert "elephant" in result.stdout


def test_the_readmes_snippet_is_the_first_example_in_ten_lines_of_code():
    snippet = re.search(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)[1]
    assert snippet == (ROOT / "examples" / "pick.py").read_text()
    assert sum(bool(line.strip()) for line in snippet.splitlines()) <= 10


def test_the_readmes_first_screen_has_picture_commands_and_snippet():
    first = (ROOT / "README.md").read_text().split("\n## ")[0]
    for part in ("docs/images/understood.png", "make demo", "make test", "```python"):
        assert part in first


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_what_a_page_links_to_is_there(page):
    links = re.findall(r"\]\(([^)\s#]+)[^)]*\)|(?:src|href)=\"([^\"#]+)\"", page.read_text())
    for link in filter(None, (one or other for one, other in links)):
        assert link.startswith("https://") or (page.parent / link).exists(), link


def test_pictures_are_small():
    for picture in (ROOT / "docs" / "images").glob("*.png"):
        assert picture.stat().st_size < 250_000, picture
