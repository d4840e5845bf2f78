import numpy as np
import pytest
from by_hand import grounded, scene

from grounding import Destination
from grounding.world import World, make_object
from integration.benchmark.random_worlds import draw_episode
from integration.execute.executor import Executor
from motion import Jam, Push, Sensor, Slip

ON_B3 = Destination((0.5736, -0.1377, 0.786), "top", ("b3",))
PICK, PLACE = grounded("pick", "b1"), grounded("place", "b4", to=ON_B3)


def _carried_out(grounding, *faults, sensor=None):
    return Executor(faults=faults, sensor=sensor).execute(grounding, scene("four"))


def _error(report, name, goal):
    return float(np.linalg.norm(report.truth[name].position - np.array(goal)))


@pytest.mark.parametrize(
    ("grounding", "fault", "kind"),
    [
        (PICK, Slip("lift", 0.5), "slipped"),
        (PICK, Push("b1", (0.02, 0.01), 0.2, "pregrasp", 0.4), "moved"),
        (PICK, Push("b1", (0.0, 0.015), 0.1, "approach", 0.4), "moved"),
        (PICK, Jam("left", least=0.0565, seconds=1.0), "gripper"),
        (PICK, Jam("left", most=0.03, phase="pregrasp", seconds=1.5), "gripper"),
        (PLACE, Slip("transfer", 0.4), "slipped"),
        (PLACE, Push("b4", (-0.015, 0.01), 0.2, "pregrasp", 0.4), "moved"),
    ],
)
def test_what_goes_wrong_is_noticed_told_and_tried_again(grounding, fault, kind):
    report = _carried_out(grounding, fault)
    assert report.outcome == "done"
    assert kind in [incident.kind for incident in report.incidents]
    assert report.incidents[0].message in report.message
    name = grounding.actions[0].objects[0]
    assert _error(report, name, report.handled[-1].goal) < 0.005
    assert report.to_json()["incidents"][0]["kind"] == kind


def test_a_hand_that_stays_jammed_is_not_used_any_more():
    report = _carried_out(PICK, Jam("left", least=0.0565))
    assert report.outcome == "done"
    assert [item.arm for item in report.handled if item.action == "pick"] == ["left", "left", "right"]


def test_without_any_hand_it_stops_safe_and_says_why():
    report = _carried_out(PICK, Jam("left", least=0.0565), Jam("right", least=0.0565))
    assert (report.outcome, report.exit_code) == ("failed", 5)
    assert "gripper" in report.message
    assert report.state is not None
    assert dict(report.state.held) == {}
    assert not [pair for record in report.records for pair in record.contacts]
    assert report.truth["b1"].position == pytest.approx(scene("four")["b1"].position, abs=5e-3)


@pytest.mark.parametrize("grounding", [PICK, PLACE])
def test_noise_of_the_camera_is_averaged_out(grounding):
    report = _carried_out(grounding, sensor=Sensor(0.003, 0.01))
    assert report.outcome == "done"
    assert _error(report, grounding.actions[0].objects[0], report.handled[-1].goal) < 0.005


def test_what_leans_on_the_target_is_moved_first():
    episode = draw_episode(0, 0, leaning=True, kinds=("pick",))
    report = Executor().execute(grounded("pick", episode.target), episode.world)
    assert report.outcome == "done"
    assert [item.object for item in report.handled] == ["leaning", episode.target]
    assert report.incidents[0].kind == "leaning"


def test_the_same_fault_gives_the_same_report():
    told = []
    for _ in range(2):
        data = _carried_out(PICK, Slip("lift", 0.5)).to_json()
        data.pop("timings")
        told.append(data)
    assert told[0] == told[1]


def test_without_faults_there_are_no_incidents():
    assert _carried_out(PLACE).incidents == ()


def test_a_block_that_was_pushed_into_a_corner_is_reached_after_its_neighbour_was_set_aside():
    table = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
    places = {"b": (0.58, -0.30), "far": (0.665, -0.33), "side": (0.61, -0.385)}
    blocks = [make_object(name, "block", "red", (*place, 0.736)) for name, place in places.items()]
    goal = (0.5, -0.5, 0.736)
    push = Push("b", (0.032, -0.032), 0.0, "pregrasp", 0.5)
    report = Executor(faults=[push]).execute(grounded("place", "b", to=Destination(goal)), World((table, *blocks)))
    assert report.outcome == "done"
    kinds = [incident.kind for incident in report.incidents]
    assert kinds == ["moved", "hemmed", "bystander"]
    assert _error(report, "b", goal) < 0.005
    for name in ("far", "side"):
        assert _error(report, name, (*places[name], 0.736)) < 0.005
