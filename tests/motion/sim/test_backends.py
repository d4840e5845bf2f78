"""Other backends than the simulator by itself: recorded, replayed, and one that stops answering."""

import threading
import time

import numpy as np
import pytest
from motion_layouts import TABLE, TOP, block

from motion import (
    BackendLost,
    Guarded,
    InvalidGoal,
    Recorder,
    RobotState,
    Scene,
    Simulator,
    UnknownBody,
    plan_place,
    replay,
)

SCENE = Scene((TABLE, block("b", 0.6, -0.3)))
GOAL = (0.55, -0.5, TOP + 0.025)


@pytest.fixture(scope="module")
def plan():
    return plan_place(SCENE, "b", GOAL)


def carried_out(backend, plan, until=None):
    backend.settle(0.5)
    return [backend.run_phase(plan.arm, plan.target, phase, None, until) for phase in plan.phases]


def test_a_recording_does_the_same_once_more(plan, tmp_path):
    recorder = Recorder(Simulator(SCENE), tmp_path / "run.jsonl")
    records = carried_out(recorder, plan)
    recorder.hold(0.3)
    poses = recorder.poses()
    recorder.close()
    with Simulator(SCENE) as simulator:
        again = replay(tmp_path / "run.jsonl", simulator)
        assert [record.name for record in again] == [record.name for record in records]
        assert [record.duration for record in again] == [record.duration for record in records]
        assert simulator.pose("b").position.tobytes() == poses["b"].position.tobytes()


def test_what_was_left_on_the_way_is_recorded_as_it_was(plan, tmp_path):
    recorder = Recorder(Simulator(SCENE), tmp_path / "run.jsonl")
    stopped = lambda backend: "enough" if backend.time > 0.6 else None  # noqa: E731
    record = recorder.run_phase(plan.arm, plan.target, plan.phases[1], None, stopped)
    assert record.left == "enough"
    where = recorder.state().joints(plan.arm)
    recorder.close()
    with Simulator(SCENE) as simulator:
        replay(tmp_path / "run.jsonl", simulator)
        assert simulator.state().joints(plan.arm) == pytest.approx(where, abs=1e-3)


@pytest.mark.parametrize(
    ("text", "told"),
    [("", None), ("nonsense\n", "expected JSON"), ('{"schema": 7}\n', "schema 1"), ('{"schema": 1}\n', "line 1")],
)
def test_a_damaged_recording_is_refused(tmp_path, text, told):
    path = tmp_path / "run.jsonl"
    path.write_text(text)
    with Simulator(SCENE) as simulator:
        if told is None:
            assert replay(path, simulator) == ()
            return
        with pytest.raises(InvalidGoal, match=told) as caught:
            replay(path, simulator)
        assert str(path) in str(caught.value)


def test_a_recording_that_begins_elsewhere_is_refused(plan, tmp_path):
    Recorder(Simulator(SCENE), tmp_path / "run.jsonl").close()
    home = RobotState.home()
    with (
        Simulator(SCENE, RobotState(home.left + 0.1, home.right)) as simulator,
        pytest.raises(InvalidGoal, match=r"begins 0\.100 rad from where the left arm is"),
    ):
        replay(tmp_path / "run.jsonl", simulator)


class Silent(Simulator):
    """A simulator that hangs in the middle of a phase until it is told to stop."""

    def __init__(self, scene):
        super().__init__(scene)
        self.told_to_stop = threading.Event()

    def run_phase(self, arm, target, phase, on_step=None, until=None):
        self.told_to_stop.wait(20)
        return super().run_phase(arm, target, phase, on_step, until)

    def stop(self):
        super().stop()
        self.told_to_stop.set()


def test_a_backend_that_stops_answering_is_stopped_and_named(plan):
    silent = Silent(SCENE)
    guarded = Guarded(silent, patience=0.3)
    begun = time.monotonic()
    with pytest.raises(BackendLost, match=r"did not answer 'run_phase' within 0\.3 s") as caught:
        carried_out(guarded, plan)
    assert time.monotonic() - begun < 5
    assert caught.value.asked == "run_phase"
    assert silent.told_to_stop.wait(5)
    with pytest.raises(BackendLost):
        guarded.state()


def test_a_backend_that_answers_is_not_disturbed(plan):
    with Simulator(SCENE) as simulator:
        alone = carried_out(simulator, plan)
        place = simulator.pose("b").position
    guarded = Guarded(Simulator(SCENE), patience=5.0)
    assert carried_out(guarded, plan) == alone
    assert guarded.pose("b").position.tobytes() == place.tobytes()
    assert guarded.time > 1
    with pytest.raises(UnknownBody, match="'nothing'"):
        guarded.pose("nothing")
    guarded.close()


def test_a_phase_ends_when_everything_is_told_to_stand_still(plan):
    with Simulator(SCENE) as simulator:
        seen = []

        def step(backend):
            seen.append(backend.time)
            if len(seen) == 50:
                backend.stop()

        simulator.run_phase(plan.arm, plan.target, plan.phases[1], step)
        assert len(seen) == 50
        assert np.all(np.isfinite(simulator.joints(plan.arm)))


@pytest.mark.parametrize("patience", [0, -1.0])
def test_patience_is_above_zero(patience):
    with pytest.raises(InvalidGoal, match="above 0"):
        Guarded(Simulator(SCENE), patience)
