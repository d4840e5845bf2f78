"""The package's names, which are imported when they are asked for."""

import subprocess
import sys

import pytest

import grounding


def test_every_name_is_there_and_listed() -> None:
    for name in grounding.__all__:
        assert getattr(grounding, name).__name__ == name
        assert name in dir(grounding)


def test_other_names_are_not_there() -> None:
    with pytest.raises(AttributeError, match="nothing_of_the_kind"):
        grounding.nothing_of_the_kind


def test_help_does_not_wait_for_numpy() -> None:
    asked = "import sys, grounding.__main__ as main; main.main([]); sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", asked], capture_output=True, check=False).returncode == 0
