import itertools
import json
import threading

import numpy as np
import pytest
from by_hand import scene

from grounding import Grounder
from integration.contract.facts import Fact
from integration.contract.requests import Clear, Home, Pick, Place
from integration.errors import UsageError
from integration.execute.checks import AT_GOAL
from integration.execute.session import Session
from integration.worlds_and_scenes import scene_of
from motion import Guarded, Recorder, Simulator, replay

SPOT = (0.6, -0.3, 0.736)


@pytest.fixture(scope="module")
def grounder():
    return Grounder.load()


@pytest.fixture
def session(grounder):
    with Session(scene("four"), grounder) as session:
        yield session


def off(session, world):
    """By how much everything is away from where it is in a world, at most [m]."""
    return max(np.linalg.norm(session.world[item.id].position - item.position) for item in world.things)


def test_what_was_picked_up_stays_held_and_can_be_put_down_by_words(session):
    assert session.do("pick up the nearest block").outcome == "done"
    assert dict(session.held) == {"left": "b1"}
    assert session.do("put it behind the red block").outcome == "done"
    assert not session.held
    assert session.history == ("b1", "b1")


def test_each_hand_holds_one_and_a_third_is_refused(session):
    assert session.do(Pick("b1")).outcome == "done"
    assert session.do(Pick("b2")).outcome == "done"
    assert set(session.held.values()) == {"b1", "b2"}
    report = session.do(Pick("b3"))
    assert (report.outcome, report.reason) == ("no_plan", "InvalidGoal")
    assert "no hand is free" in report.message
    assert set(session.held.values()) == {"b1", "b2"}


def test_facts_tell_what_stands_on_what_and_who_holds_it(session):
    assert Fact("on_table", ("b1", "table")) in session.facts
    assert {fact for fact in session.facts if fact.name == "hand_empty"} == {
        Fact("hand_empty", ("left",)), Fact("hand_empty", ("right",))}  # fmt: skip
    on_it = session.world["b3"].position + np.array([0, 0, 0.05])
    assert session.do(Place("b1", on_it, on="b3")).outcome == "done"
    assert Fact("on", ("b1", "b3")) in session.facts
    assert Fact("clear", ("b3",)) not in session.facts
    assert session.do(Pick("b1", arm="right")).outcome == "done"
    assert Fact("holding", ("right", "b1")) in session.facts
    assert Fact("clear", ("b3",)) in session.facts
    assert "b1" not in {fact.arguments[0] for fact in session.facts}


def test_arms_go_home_with_what_they_hold(session):
    session.do(Pick("b1"))
    report = session.do(Home())
    assert report.outcome == "done"
    assert {check.name for check in report.checks} == {"at_home"}
    assert dict(session.held) == {"left": "b1"}


def test_undoing_brings_everything_back_one_goal_at_a_time(session):
    world = session.world
    session.do(Place("b1", SPOT))
    session.do(Clear(("b2", "b3")))
    between = session.world
    assert session.undo().outcome == "done"
    assert np.linalg.norm(session.world["b1"].position - SPOT) <= AT_GOAL
    assert np.linalg.norm(session.world["b2"].position - between["b2"].position) > 0.05
    assert session.undo().outcome == "done"
    assert off(session, world) <= AT_GOAL
    with pytest.raises(UsageError, match="nothing to undo"):
        session.undo()


def test_undoing_a_place_from_the_hand_takes_it_again(session):
    session.do(Pick("b1"))
    session.do(Place("b1", SPOT))
    assert session.undo().outcome == "done"
    assert dict(session.held) == {"left": "b1"}
    assert session.undo().outcome == "done"
    assert not session.held


def test_undoing_builds_a_tower_again_from_below(grounder):
    with Session(scene("tower"), grounder) as session:
        world = session.world
        assert session.do(Clear(("b1", "b2", "b3"))).outcome == "done"
        assert session.undo().outcome == "done"
        assert off(session, world) <= AT_GOAL


def test_undoing_a_swap_sets_one_aside(session):
    world = session.world
    assert session.do("swap the nearest block and the farthest block").outcome == "done"
    assert session.undo().outcome == "done"
    assert off(session, world) <= AT_GOAL


@pytest.mark.parametrize("seconds", [1.3, 2.1, 3.5])
def test_a_cancelled_goal_stops_says_where_and_is_followed_by_others(session, seconds):
    world, stop = session.world, threading.Event()
    report = session.do(Place("b1", SPOT), lambda told: stop.set() if told.simulated > seconds else None, stop)
    assert (report.outcome, report.exit_code) == ("cancelled", 6)
    assert report.records[-1].left == "cancelled"
    assert report.reason == report.records[-1].name
    assert "stands still at (" in report.message
    assert session.do(Place("b1", SPOT)).outcome == "done"
    while off(session, world) > AT_GOAL:
        assert session.undo().outcome == "done"


def test_a_goal_that_is_cancelled_from_the_start_moves_nothing(session):
    stop = threading.Event()
    stop.set()
    report = session.do(Pick("b1"), cancel=stop)
    assert report.outcome == "cancelled"
    assert not report.records
    assert session.do(Pick("b1")).outcome == "done"


def test_progress_tells_the_steps_with_fractions_and_time_that_only_grow(session):
    told = []
    session.do(Pick("b1"), told.append)
    moving = [one for one in told if one.fraction > 0]
    assert {"plan the pick of b1", "pregrasp", "approach", "lift"} <= {one.step for one in told}
    for earlier, later in itertools.pairwise(moving):
        assert earlier.fraction <= later.fraction <= 1
        assert earlier.simulated <= later.simulated
    assert moving[-1].object == "b1"


def test_a_saved_session_goes_on_with_what_it_held(session, grounder, tmp_path):
    world = session.world
    session.do(Place("b2", SPOT))
    session.do(Pick("b1"))
    session.save(tmp_path / "session.json")
    with Session.load(tmp_path / "session.json", grounder) as again:
        assert dict(again.held) == dict(session.held)
        assert again.history == session.history
        assert again.facts == session.facts
        assert again.do(Home()).outcome == "done"
        assert dict(again.held) == {"left": "b1"}
        assert again.undo().outcome == again.undo().outcome == "done"
        assert off(again, world) <= AT_GOAL


DAMAGED = [
    (lambda data: "nonsense", "a session"),
    (lambda data: {**data, "schema": 9}, "schema 1"),
    (lambda data: {key: data[key] for key in data if key != "robot"}, "robot"),
    (lambda data: {**data, "robot": {**data["robot"], "left": [0.0]}}, "seven joints"),
    (lambda data: {**data, "robot": {**data["robot"], "held": {"left": "b99"}}}, "b99"),
    (lambda data: {**data, "world": {}}, "world"),
    (lambda data: {**data, "seed": None}, "not a session"),
]  # fmt: skip


@pytest.mark.parametrize(("damage", "told"), DAMAGED)
def test_a_damaged_session_is_refused_by_name(session, tmp_path, damage, told):
    path = tmp_path / "session.json"
    session.save(path)
    path.write_text(json.dumps(damage(json.loads(path.read_text()))))
    with pytest.raises(UsageError, match=told) as caught:
        Session.load(path)
    assert str(path) in str(caught.value)


def test_a_folder_that_is_not_there_is_named(session, tmp_path):
    with pytest.raises(FileNotFoundError, match="no such folder"):
        session.save(tmp_path / "nowhere" / "session.json")


def test_a_closed_session_is_refused(grounder):
    session = Session(scene("four"), grounder)
    session.close()
    for use in (lambda: session.do(Pick("b1")), session.undo, lambda: session.save("x.json")):
        with pytest.raises(UsageError, match="was closed"):
            use()


@pytest.mark.parametrize(
    ("goal", "told"),
    [(Pick("b1", arm="third"), "no arm 'third'"), (Place("b1", (0.1, 0.2)), "x, y, z"), (("pick", "b1"), "a goal is"),
     (Place("b1", "there"), "x, y, z"), (Home("up"), "no arm 'up'")],
)  # fmt: skip
def test_what_is_no_goal_is_refused(session, goal, told):
    with pytest.raises(UsageError, match=told):
        session.do(goal)


def test_a_goal_for_what_is_not_there_changes_nothing(session):
    world = session.world
    report = session.do(Pick("b99"))
    assert (report.outcome, report.reason) == ("no_plan", "InvalidGoal")
    assert "b99" in report.message
    assert off(session, world) < 1e-3


def test_a_session_runs_on_another_backend_and_loses_it_with_a_sentence(grounder, tmp_path):
    def recorded(scene, state, faults):
        return Recorder(Simulator(scene, state, faults), tmp_path / "run.jsonl")

    with Session(scene("four"), grounder, backend=recorded) as session:
        assert session.do(Place("b1", SPOT)).outcome == "done"
        there = session.world["b1"].position
    with Simulator(scene_of(scene("four"))) as simulator:
        replay(tmp_path / "run.jsonl", simulator)
        assert np.linalg.norm(simulator.pose("b1").position - there) < 1e-6


class Deaf(Simulator):
    def run_phase(self, *_, **__):
        threading.Event().wait(3)


def test_a_backend_that_is_lost_ends_the_goal(grounder):
    def deaf(scene, state, faults):
        return Guarded(Deaf(scene, state, faults), patience=0.3)

    with Session(scene("four"), grounder, backend=deaf) as session:
        report = session.do(Pick("b1"))
        assert (report.outcome, report.reason) == ("failed", "BackendLost")
        assert "did not answer" in report.message
