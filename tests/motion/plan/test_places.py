"""Several places of which one will do, the room that fingers need there, and the time that planning may take."""

import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import GraspUnavailable, InvalidGoal, OutOfTime, Scene, plan_pick, plan_place, plan_transport

AROUND = [(1, 0), (-1, 0), (0, 1), (0, -1)]
NEIGHBOURS = [block(f"n{k}", 0.6 + 0.057 * x, -0.1 + 0.057 * y) for k, (x, y) in enumerate(AROUND)]
AMONG = Scene((TABLE, block("b", 0.6, -0.4), *NEIGHBOURS))
HEMMED = (0.6, -0.1, TOP + 0.025)
FREE = (0.55, -0.55, TOP + 0.025)


def test_the_first_place_is_taken_where_it_can_be_served():
    plan = plan_place(AMONG, "b", [FREE, (0.7, -0.4, TOP + 0.025)])
    assert plan.goal.position == pytest.approx(FREE)


@pytest.mark.parametrize("taken", [HEMMED, (0.6, -0.16, TOP + 0.025), (2.0, 0.0, TOP + 0.025)])
def test_another_place_is_taken_where_the_first_cannot_be_served(taken):
    plan = plan_place(AMONG, "b", np.array([taken, FREE]))
    assert plan.goal.position == pytest.approx(FREE)


def test_where_the_fingers_have_no_room_the_neighbour_is_named():
    with pytest.raises(GraspUnavailable, match=r"'b' cannot be let go at \(0.600, -0.100\).*'n\d'") as caught:
        plan_place(AMONG, "b", HEMMED)
    assert caught.value.bodies[1] in AMONG.names


def test_the_hands_pass_a_box_on_to_one_of_several_places():
    scene = Scene((TABLE, block("b", 0.6, -0.65), block("n", 0.65, 0.65)))
    plans = plan_transport(scene, "b", [(0.65, 0.68, TOP + 0.025), (0.6, 0.55, TOP + 0.025)])
    assert [plan.arm for plan in plans] == ["right", "left"]
    assert plans[-1].goal.position == pytest.approx((0.6, 0.55, TOP + 0.025))


@pytest.mark.parametrize("places", [[], [[0.6, 0.1]], "there", [FREE, (0.1, 0.2)]])
def test_what_is_no_place_is_refused(places):
    with pytest.raises(InvalidGoal, match="three finite numbers"):
        plan_place(AMONG, "b", places)


def test_planning_ends_when_its_time_is_over():
    with pytest.raises(OutOfTime, match="within 1e-09 s") as caught:
        plan_pick(AMONG, "b", budget=1e-9)
    assert caught.value.budget == 1e-9
    with pytest.raises(OutOfTime):
        plan_place(AMONG, "b", FREE, budget=1e-9)


@pytest.mark.parametrize("budget", [0, -1.0, float("nan"), "long"])
def test_a_budget_is_a_number_of_seconds(budget):
    with pytest.raises(InvalidGoal, match="seconds above 0"):
        plan_pick(AMONG, "b", budget=budget)
