"""Ask the arms what they reach: a pose, a block among others, a place on the table that is too far.

python examples/kinematics.py
"""

import numpy as np

from motion import Avoidance, Box, Pose, Scene, UnreachableTarget, load_robot, reach_box, servo, solve_ik

table = Box("table", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04), fixed=True)
scene = Scene((table, Box("b1", (0.6, 0.2, 0.736)), Box("b2", (0.6, 0.13, 0.736))))
down = np.array([0.0, 0.0, 1.0, 0.0])  # the hand points at the floor, its fingers close along y

# One pose of the left tool frame, clear of everything by 5 mm.
avoid = Avoidance(scene, "left")
solution = solve_ik("left", Pose(np.array([0.6, 0.2, 0.85]), down), avoid=avoid)
print("joints", solution.joints.round(3), f"after {solution.attempts} start(s)")

# Which hands take b1, from between its neighbours, and how far they tilt.
for reach in reach_box(scene, "b1"):
    print(f"{reach.grasp.arm} hand, tilted by {np.degrees(abs(reach.grasp.tilt)):.0f} degrees")

# Why a place is out of reach.
try:
    solve_ik("left", Pose(np.array([0.2, 0.3, 0.75]), down))
except UnreachableTarget as error:
    print(f"{error.reason}: {', '.join(error.joints)}")

# Follow a moving target for a second, no joint faster than it may be.
joints = solution.joints
for step in range(100):
    joints = servo("left", joints, Pose(np.array([0.6, 0.2 + 0.001 * step, 0.85]), down), dt=0.01, avoid=avoid)
print("tool at", load_robot().tool_pose("left", joints).position.round(3))
