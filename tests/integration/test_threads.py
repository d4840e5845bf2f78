"""Eight threads at once: each finds what it would have found alone."""

import threading

import pytest
from by_hand import scene

from grounding import Grounder
from integration.contract.requests import Pick, Place
from integration.execute.session import Session
from integration.worlds_and_scenes import scene_of
from motion import plan_pick

THREADS = 8


def together(work):
    """What each of the threads found, having begun at the same moment."""
    start, found, failed = threading.Barrier(THREADS), [None] * THREADS, []

    def run(number):
        start.wait()
        try:
            found[number] = work(number)
        except Exception as error:
            failed.append(error)

    threads = [threading.Thread(target=run, args=(number,)) for number in range(THREADS)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failed, failed
    return found


TEXTS = ["pick up the nearest block", "put the red block next to the farthest block", "pick up the leftmost block",
         "pick up the block behind the red block"]  # fmt: skip


def answers(grounder):
    return [[action.to_json() for action in grounder.ground(text, scene("four")).actions] for text in TEXTS]


def test_a_grounder_that_has_worked_out_nothing_yet_serves_all():
    shared = Grounder.load()
    found = together(lambda _: answers(shared))
    assert all(one == found[0] for one in found)
    assert found[0] == answers(Grounder.load())


def test_all_plan_at_once():
    world = scene_of(scene("default"))
    names = [box.name for box in world.boxes if not box.fixed]

    def work(number):
        return [plan_pick(world, name).phases[1].trajectory.positions.tobytes() for name in names[number::THREADS]]

    found = together(work)
    assert found == [work(number) for number in range(THREADS)]


@pytest.mark.parametrize("seed", [0])
def test_all_run_sessions_at_once(seed):
    def work(_):
        with Session(scene("four"), seed=seed) as session:
            session.do(Pick("b1"))
            report = session.do(Place("b1", (0.6, -0.3, 0.736)))
            return report.outcome, tuple(report.truth["b1"].position)

    found = together(work)
    assert found[0][0] == "done"
    assert all(one == found[0] for one in found)
