import numpy as np
import pytest
from by_hand import grounded, scene

from grounding import Destination
from grounding.world import World, make_object
from integration.execute.executor import Executor
from motion import Slip

FREE = Destination((0.55, -0.55, 0.736))


def test_a_block_under_others_is_picked_after_they_were_set_aside():
    report = Executor().execute(grounded("pick", "b1"), scene("tower"))
    assert (report.outcome, report.exit_code) == ("done", 0)
    assert [incident.kind for incident in report.incidents] == ["covered", "covered"]
    assert [item.object for item in report.handled] == ["b3", "b2", "b1"]
    assert "b3 stood on b1 and was set aside first" in report.message
    assert report.truth["b1"].position[2] > 0.736 + 0.09
    for name in ("b2", "b3"):  # on the table, and not on one another
        assert report.truth[name].position[2] == pytest.approx(0.736, abs=2e-3)
    for name in ("b4", "b5", "b6", "b7", "b8"):
        assert np.linalg.norm(report.truth[name].position - scene("tower")[name].position) < 0.005


def test_a_block_under_another_is_placed_and_its_destination_is_kept_free():
    report = Executor().execute(grounded("place", "b2", to=FREE), scene("tower"))
    assert report.outcome == "done"
    assert np.linalg.norm(report.truth["b2"].position - np.array(FREE.position)) < 0.005
    assert np.linalg.norm(report.truth["b3"].position[:2] - np.array(FREE.position[:2])) > 0.07


def test_a_stack_that_is_cleared_is_taken_apart_from_above_and_counts_as_no_trouble():
    report = Executor().execute(grounded("clear", "b1", "b2", "b3"), scene("tower"))
    assert report.outcome == "done"
    assert not report.incidents
    report = Executor().execute(grounded("clear", "b1", "b2"), scene("tower"))
    assert report.outcome == "done"
    assert [incident.object for incident in report.incidents] == ["b3"]


def test_nothing_moves_where_what_stands_on_it_cannot_be_set_aside():
    world = scene("tower")
    lid = make_object("lid", "block", "white", (0.581, 0.33, 0.901), size=(0.08, 0.08, 0.08))
    report = Executor().execute(grounded("pick", "b1"), world.with_objects([*world.objects, lid]))
    assert (report.outcome, report.reason) == ("no_plan", "GraspUnavailable")
    assert "lid" in report.message
    assert "80" in report.message
    assert report.handled == ()


def test_nothing_moves_where_the_destination_goes_with_what_is_set_aside():
    x, y, z = scene("tower")["b3"].position
    on_top = Destination((float(x), float(y), float(z) + 0.05), "top", ("b3",))
    report = Executor().execute(grounded("place", "b2", to=on_top), scene("tower"))
    assert (report.outcome, report.reason) == ("no_plan", "InvalidGoal")
    assert report.handled == ()


def test_a_block_that_slips_while_it_is_set_aside_is_told_and_does_not_stop_the_pick():
    report = Executor(faults=[Slip("transfer", 0.4)]).execute(grounded("pick", "b2"), scene("tower"))
    assert report.outcome == "done"
    assert "slipped" in [incident.kind for incident in report.incidents]


def hemmed_in(pitch):
    table = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
    around = {"n": (1, 0), "s": (-1, 0), "w": (0, 1), "e": (0, -1)}
    beside = [
        make_object(name, color="blue", position=(0.6 + pitch * x, -0.3 + pitch * y, 0.736))
        for name, (x, y) in around.items()
    ]
    return World((table, make_object("b", color="red", position=(0.6, -0.3, 0.736)), *beside))


@pytest.mark.parametrize("pitch", [0.054, 0.062])
def test_what_is_hemmed_in_is_freed_and_its_neighbours_are_put_back(pitch):
    world = hemmed_in(pitch)
    report = Executor().execute(grounded("place", "b", to=FREE), world)
    assert report.outcome == "done"
    assert {incident.kind for incident in report.incidents} >= {"hemmed", "bystander"}
    for name in ("n", "s", "w", "e"):
        assert np.linalg.norm(report.truth[name].position - world[name].position) < 0.005


def test_for_a_pick_neighbours_are_set_aside_and_that_is_said():
    report = Executor().execute(grounded("pick", "b"), hemmed_in(0.057))
    assert report.outcome == "done"
    assert "was in the way of b and was set aside" in report.message


def test_where_freeing_does_not_help_nothing_moves():
    world = hemmed_in(0.054)
    far = Destination((1.6, 0.0, 0.736))
    report = Executor().execute(grounded("place", "b", to=far), world)
    assert report.outcome == "no_plan"
    assert all(np.linalg.norm(report.truth[item.id].position - item.position) < 0.005 for item in world.things)
