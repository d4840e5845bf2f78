"""Work in fresh processes: results, refusals, and processes that die."""

import os
import time

import pytest

from grounding.errors import CorpusError
from grounding.experiments import ExperimentError
from grounding.experiments.processes import Task, in_processes, peak_memory


def square(number):
    return number * number, os.getpid()


def refuse(what):
    raise CorpusError(f"no {what}")


def fail():
    return 1 / 0


def die():
    os._exit(9)


def grow(megabytes):
    block = bytearray(int(megabytes * 1e6))
    block[:: 4096] = b"x" * len(block[::4096])
    return peak_memory()


def test_every_task_has_a_process_of_its_own():
    found = dict(in_processes([Task(str(n), square, (n,)) for n in range(5)], jobs=2))
    assert [found[n][0] for n in range(5)] == [0, 1, 4, 9, 16]
    assert len({pid for _, pid in found.values()} | {os.getpid()}) == 6


def test_memory_is_that_of_one_task():
    (_, large), (_, small) = in_processes([Task("large", grow, (120,)), Task("small", grow, (1,))])
    assert large > small + 80


@pytest.mark.parametrize(
    ("function", "arguments", "error", "match"),
    [
        (refuse, ("corpus",), ExperimentError, "part one: no corpus"),
        (fail, (), RuntimeError, "ZeroDivisionError"),
        (die, (), ExperimentError, "part one: .*exit code 9"),
    ],
)
def test_what_goes_wrong_is_told_with_the_name_of_the_task(function, arguments, error, match):
    with pytest.raises(error, match=match):
        list(in_processes([Task("part one", function, arguments)]))


def test_the_others_end_when_one_fails():
    start = time.monotonic()
    tasks = [Task("slow", time.sleep, (60,)), Task("bad", refuse, ("luck",))]
    with pytest.raises(ExperimentError, match="no luck"):
        list(in_processes(tasks, jobs=2))
    assert time.monotonic() - start < 30
