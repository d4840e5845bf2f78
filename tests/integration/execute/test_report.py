import json

from by_hand import grounded, middle_of_the_row, scene

from integration.execute.executor import Executor
from integration.execute.report import DONE, EXIT_CODES, Report, Step


def test_exit_codes_are_those_of_the_command():
    assert EXIT_CODES == {"done": 0, "answered": 0, "not_grounded": 3, "no_plan": 4, "failed": 5, "cancelled": 6}


def test_all_that_a_clock_measured_is_under_timings():
    report = Executor().execute(middle_of_the_row(), scene("default"))
    data = report.to_json()
    assert data["timings"]["grounding_milliseconds"] == 2.5
    assert [step["name"] for step in data["steps"]] == [step["name"] for step in data["timings"]["steps"]]
    data.pop("timings")
    text = json.dumps(data)
    assert "milliseconds" not in text
    assert '"seconds"' not in text


def test_the_json_says_what_was_done_and_seen():
    data = Executor().execute(grounded("pick", "b3"), scene("four")).to_json()
    assert json.loads(json.dumps(data)) == data
    assert (data["outcome"], data["exit_code"]) == ("done", 0)
    assert data["handled"][0]["object"] == "b3"
    assert set(data["final_poses"]) == {"b3"}
    assert all(set(check) >= {"name", "passed", "measured", "limit", "unit", "meaning"} for check in data["checks"])
    assert data["grounding"]["actions"][0]["objects"] == ["b3"]


def test_arms_in_the_order_of_their_first_use():
    world = scene("four")
    report = Report("x", DONE, "", grounded("pick", "b1"), world, world, 0, steps=(Step("a", 1.0),))
    assert report.arms == ()
    later = report.with_pictures(("p.png",), (Step("draw", 2.0),))
    assert (report.pictures, later.pictures) == ((), ("p.png",))
    assert [step.name for step in later.steps] == ["a", "draw"]
