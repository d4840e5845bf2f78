"""Metric goals become verified, timed plans, and plans become physics.

Motion knows plain names, poses and sizes; what a block *means* is none of its business. World frame: origin on the
floor under Baxter's base, x away from the robot, y to its left, z up; metres, radians, quaternions (w, x, y, z).

    import numpy as np
    from motion import Box, Scene, Simulator, plan_pick, plan_place

    scene = Scene((Box("table", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04), fixed=True),
                   Box("b1", (0.6, -0.3, 0.736))))
    plan = plan_pick(scene, "b1", arm="auto", rng=np.random.default_rng(0))
    with Simulator(scene) as simulator:
        execution = simulator.execute(plan)      # on_step=callback(simulator) after every physics step
        simulator.hold(2.0)
        simulator.poses()["b1"].position         # where the block is now

What there is:

- Values: `Box(name, position, orientation, size, color, mass, fixed)`; `Scene(boxes)` with `box(name)`, `moved(poses)`,
  `boxes_above(name)`, `resting_position(name, xy)`; `Pose(position, orientation)`; `RobotState(left, right, widths,
  held)` with `RobotState.home()`.
- `plan_pick(scene, target, *, arm, start, rng, lift)`, `plan_place(scene, target, position, *, yaw, arm, start, rng)`
  and `plan_home(scene, *, arm, start, rng)`: each a `Plan(kind, arm, target, phases, grasp, goal, start, end)`,
  verified as a whole before it is returned. A `Phase` has `name`, `trajectory`, `gripper` (commanded width at its
  end), `held` and `duration`. Phases of a pick: home, pregrasp, approach, close, lift, hold; of a place: home,
  pregrasp, approach, close, lift, transfer, lower, open, retreat, home. The `start` of a plan is where the robot is
  (default: home); a block already held (`start.held`) is placed without picking it again: transfer, lower, open,
  retreat, home.
- `plan_transport(...)`, like `plan_place`, gives one plan or, where no single hand reaches both places, two: one hand
  sets the box down in the middle, the other takes it on.
- `plan_unstacking(scene, target, ...)` gives the plans that set aside what stands on a box (`stacked_on`), the topmost
  first; `free_spots(scene, name)` are the places on tables where a box could go.
- `Simulator(scene, state=None, faults=())`, with faults such as `Slip()`, `Push("b1", (0.02, 0))` and `Jam("left")`:
  `execute(plan, on_step=None)` gives an `Execution` (`phases`, `holding`, `contacts`, `tracking_error`, `duration`);
  `hold(seconds, on_step=None)`, `settle(seconds=2.0)`; `poses()`, `scene()` (as it is
  now, for the next plan), `state()` (a `RobotState`, ditto), `gripper_width(arm)`, `holding(arm)`, `contacts()`,
  `tracking_error(arm)`, `joints(arm)`, `tool_pose(arm)`, `time`.
- `Sensor(noise, turn)`: what a camera tells of where the boxes are; `look(simulator, rng, frames)` is the mean of so
  many frames.
- `Renderer(scene, width, height)`: `render(simulator=None, camera="front", markers=())` gives (height, width, 3) uint8;
  `project(points, camera)` gives pixels for labels; cameras "front", "robot", "top", "side", or a `Camera` of one's
  own; `Marker(position, size, color, shape)`. `rendering_available()` says whether OpenGL can be started.
- `solve_ik(arm, pose, ...)`, `solutions(arm, pose)` for all postures, `reachable(arm, poses)`, and `servo(arm, joints,
  pose, dt, ...)` with `Avoidance(scene, arm)`; `load_robot().kinematics(arm)`: kinematics of both hands, see
  docs/kinematics.md.
- `grasp_candidates(scene, name)`; `reach_box(scene, name)` for those an arm can make; `reach_map(table)`, a `ReachMap`.
- Errors: all below `MotionError`; see `motion/errors.py`.
"""

from __future__ import annotations

import motion.physics_engine  # noqa: F401  # first: it makes do without OpenGL, as importing MuJoCo by itself does not

# isort: split
from motion.errors import (
    BackendLost,
    GraspUnavailable,
    InvalidGoal,
    InvalidScene,
    LimitViolation,
    MotionError,
    OutOfTime,
    PathNotFound,
    PlanInCollision,
    RenderingUnavailable,
    RobotUnavailable,
    SimulationDiverged,
    UnknownBody,
    UnreachableTarget,
)
from motion.grasp.candidates import Grasp, grasp_candidates
from motion.grasp.reach import Reach, reach_box, reach_grasp
from motion.grasp.reach_map import Reachable, ReachMap, reach_map
from motion.ik.avoidance import Avoidance
from motion.ik.postures import reachable, solutions
from motion.ik.servo import servo
from motion.ik.solver import IkSolution, solve_ik
from motion.path.trajectory import Trajectory
from motion.plan.free_spots import free_spots
from motion.plan.joint_trajectory import GripperCommand, JointTrajectory
from motion.plan.planner import plan_home, plan_pick, plan_place
from motion.plan.plans import Phase, Plan
from motion.plan.transport import plan_transport
from motion.plan.unstacking import plan_unstacking, stacked_on
from motion.poses import Pose
from motion.robot.kinematics import ArmKinematics
from motion.robot.load import Robot, load_robot
from motion.robot.state import RobotState
from motion.scene import Box, Scene
from motion.sim.backend import Backend, MakeBackend
from motion.sim.execution import Execution, PhaseRecord
from motion.sim.faults import Fault, Jam, Push, Slip
from motion.sim.guarded import Guarded
from motion.sim.recording import Recorder, replay
from motion.sim.rendering import CAMERAS, Camera, Marker, Renderer, rendering_available
from motion.sim.sensing import Sensor
from motion.sim.simulator import Simulator

__all__ = [
    "CAMERAS",
    "ArmKinematics",
    "Avoidance",
    "Backend",
    "BackendLost",
    "Box",
    "Camera",
    "Execution",
    "Fault",
    "Grasp",
    "GraspUnavailable",
    "GripperCommand",
    "Guarded",
    "IkSolution",
    "InvalidGoal",
    "InvalidScene",
    "Jam",
    "JointTrajectory",
    "LimitViolation",
    "MakeBackend",
    "Marker",
    "MotionError",
    "OutOfTime",
    "PathNotFound",
    "Phase",
    "PhaseRecord",
    "Plan",
    "PlanInCollision",
    "Pose",
    "Push",
    "Reach",
    "ReachMap",
    "Reachable",
    "Recorder",
    "Renderer",
    "RenderingUnavailable",
    "Robot",
    "RobotState",
    "RobotUnavailable",
    "Scene",
    "Sensor",
    "SimulationDiverged",
    "Simulator",
    "Slip",
    "Trajectory",
    "UnknownBody",
    "UnreachableTarget",
    "free_spots",
    "grasp_candidates",
    "load_robot",
    "plan_home",
    "plan_pick",
    "plan_place",
    "plan_transport",
    "plan_unstacking",
    "reach_box",
    "reach_grasp",
    "reach_map",
    "reachable",
    "rendering_available",
    "replay",
    "servo",
    "solutions",
    "solve_ik",
    "stacked_on",
]
