"""A bridge to ROS 2: every phase of a session becomes goals of a `FollowJointTrajectory` action. Needs ROS to run.

Without `rclpy` it shows what would be sent. What a robot observes (poses of blocks, contacts) has to come from its own
perception; here the simulator stands in for that, and runs along with the robot.
"""

from typing import Any

from integration import Session, load_scene
from motion import Phase, PhaseRecord, Plan, Simulator

try:
    import rclpy
    from builtin_interfaces.msg import Duration
    from control_msgs.action import FollowJointTrajectory
    from rclpy.action import ActionClient
    from trajectory_msgs.msg import JointTrajectoryPoint
except ImportError:
    rclpy = None

RATE = 100.0


class Bridge(Simulator):
    """A simulator that sends each phase to a robot as well, and waits until the robot has done it."""

    node: Any = None

    def run_phase(self, arm: str, target: str | None, phase: Phase, *args: Any, **kwargs: Any) -> PhaseRecord:
        """Carries out one phase, here and there."""
        sent = self.send(arm, phase)
        record = super().run_phase(arm, target, phase, *args, **kwargs)
        if sent is not None and record.left is not None:
            sent.cancel_goal_async()  # the robot's controller brakes
        elif sent is not None:
            rclpy.spin_until_future_complete(self.node, sent.get_result_async())
        return record

    def send(self, arm: str, phase: Phase) -> Any:
        """Sends the arm's trajectory; the handle of the goal, or None without ROS."""
        state = self.state()
        plan = Plan("phase", arm, phase.held, (phase,), None, None, state, state, 0.0)
        trajectory = plan.to_joint_trajectory(RATE)
        if rclpy is None:
            if len(trajectory.time_from_start) > 1:
                print(f"{phase.name}: {len(trajectory.time_from_start)} points in {trajectory.duration:.2f} s")
            return None
        goal = FollowJointTrajectory.Goal()
        goal.trajectory.joint_names = list(trajectory.joint_names)
        for time, q, qd, qdd in zip(trajectory.time_from_start, trajectory.positions, trajectory.velocities,
                                    trajectory.accelerations, strict=True):  # fmt: skip
            seconds = int(time)
            goal.trajectory.points.append(JointTrajectoryPoint(
                positions=q.tolist(), velocities=qd.tolist(), accelerations=qdd.tolist(),
                time_from_start=Duration(sec=seconds, nanosec=int(1e9 * (time - seconds))),
            ))  # fmt: skip
        client = ActionClient(self.node, FollowJointTrajectory, f"/robot/limb/{arm}/follow_joint_trajectory")
        client.wait_for_server()
        future = client.send_goal_async(goal)
        rclpy.spin_until_future_complete(self.node, future)
        return future.result()


if rclpy is not None:
    rclpy.init()
    Bridge.node = rclpy.create_node("adcg_bridge")

with Session(load_scene("four"), backend=Bridge) as session:
    print(session.do("pick up the nearest block").message)
