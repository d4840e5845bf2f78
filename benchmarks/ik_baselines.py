"""Other ways to solve inverse kinematics, for `benchmarks/ik.py` to compare with: each a function of arm and target.

All of them start at home, then at random, and are given up after the same number of starts.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np
import pinocchio

from motion import Pose, load_robot
from motion.ik.differential import differential_ik
from motion.robot.kinematics import LAST, ArmKinematics
from motion.robot.recipe import recipe

RESTARTS = 15
POSITION, ORIENTATION = 1e-4, 1e-3
_STEPS = 60

Solve = Callable[[str, Pose, np.random.Generator], np.ndarray | None]


def met(kinematics: ArmKinematics, joints: np.ndarray, target: Pose) -> bool:
    """Whether `joints` bring the tool to within 0.1 mm and 1 mrad of `target`, within the joints' ranges."""
    inside = np.all(joints >= kinematics.lower - 1e-9) and np.all(joints <= kinematics.upper + 1e-9)
    distance, angle = kinematics.pose(joints).distance(target)
    return bool(inside and distance <= POSITION and angle <= ORIENTATION)


def damped_least_squares(arm: str, target: Pose, rng: np.random.Generator) -> np.ndarray | None:
    """Steps Jᵀ (J Jᵀ + λ I)⁻¹ e with one small λ, clipped to the ranges (Wampler, 1986)."""
    kinematics = load_robot().kinematics(arm)
    last = pinocchio.SE3(target.rotation, target.position) * kinematics.tool_inverse
    for start in _starts(arm, rng):
        joints = start
        for _ in range(_STEPS):
            jacobian = pinocchio.computeJointJacobian(kinematics.model, kinematics.data, joints, LAST)
            error = pinocchio.log6(kinematics.data.iMf[0].actInv(last)).vector
            if error @ error < 1e-10:
                return np.asarray(joints)
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-4 * np.eye(6), error)
            joints = np.clip(joints + step, kinematics.lower, kinematics.upper)
    return None


def with_mink(solver: str) -> Solve:
    """Differential inverse kinematics by mink, with a quadratic programming solver."""

    def solve(arm: str, target: Pose, rng: np.random.Generator) -> np.ndarray | None:
        differential = differential_ik(arm, solver)
        for start in _starts(arm, rng):
            descent = differential.descend(start, target)
            if descent.reached:
                return descent.joints
        return None

    return solve


def with_pink(solver: str) -> Solve:
    """Differential inverse kinematics by pink, as its documentation sets it up."""
    import pink

    configurations: dict[str, Any] = {}

    def solve(arm: str, target: Pose, rng: np.random.Generator) -> np.ndarray | None:
        kinematics = load_robot().kinematics(arm)
        frame = f"{arm}_gripper"
        if arm not in configurations:
            model = kinematics.model.copy()
            model.lowerPositionLimit, model.upperPositionLimit = kinematics.lower.copy(), kinematics.upper.copy()
            model.velocityLimit = np.full(7, 0.6)
            configurations[arm] = model
        model = configurations[arm]
        task = pink.FrameTask(frame, position_cost=1.0, orientation_cost=0.3)
        task.set_target(pinocchio.SE3(target.rotation, target.position))
        for start in _starts(arm, rng):
            configuration = pink.Configuration(model, model.createData(), start)
            for _ in range(_STEPS):
                error = task.compute_error(configuration)
                if np.linalg.norm(error[:3]) < POSITION / 2 and np.linalg.norm(error[3:]) < ORIENTATION / 2:
                    return np.asarray(configuration.q)
                try:
                    velocity = pink.solve_ik(
                        configuration, [task], 1.0, solver=solver, damping=1e-5, safety_break=False
                    )
                except pink.exceptions.PinkError:
                    break
                inside = np.clip(configuration.integrate(velocity, 1.0), kinematics.lower, kinematics.upper)
                configuration.update(inside)
        return None

    return solve


def installed(package: str) -> bool:
    """Whether a package can be imported."""
    return importlib.util.find_spec(package) is not None


def brute_force(arm: str, target: Pose, rng: np.random.Generator, starts: int, batch: int = 50) -> bool:
    """Whether any of hundreds of random starts reaches the target; shares no code with the solvers above.

    Batches of configurations descend at once in numpy, with a Jacobian by cross products (geometric, along the chain),
    damped least squares and clipping.
    """
    kinematics = load_robot().kinematics(arm)
    rotation = target.rotation
    done = 0
    while done < starts:
        count = min(batch if done else 12, starts - done)  # a few do for most poses that can be reached
        done += count
        joints = rng.uniform(kinematics.lower, kinematics.upper, (count, 7))
        for step in range(60):
            position, turned, jacobian = _batch(kinematics, joints)
            error = np.concatenate([target.position - position, _rotation_error(turned, rotation)], axis=1)
            near = (np.linalg.norm(error[:, :3], axis=1) < POSITION / 2) & (
                np.linalg.norm(error[:, 3:], axis=1) < ORIENTATION / 2
            )
            if near.any():
                return True
            damping = 1e-3 if step < 20 else 1e-6
            square = jacobian @ np.swapaxes(jacobian, 1, 2) + damping * np.eye(6)
            moved = np.swapaxes(jacobian, 1, 2) @ np.linalg.solve(square, error[:, :, None])
            largest = np.max(np.abs(moved), axis=1, keepdims=True)
            moved = moved / np.maximum(1.0, largest / 0.5)
            joints = np.clip(joints + moved[:, :, 0], kinematics.lower, kinematics.upper)
    return False


def _batch(kinematics: ArmKinematics, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Tool positions (n, 3), rotations (n, 3, 3) and geometric Jacobians (n, 6, 7) in the world's axes."""
    count = len(joints)
    position, rotation = np.zeros((count, 3)), np.broadcast_to(np.eye(3), (count, 3, 3))
    origins, axes = [], []
    for index in range(1, LAST + 1):
        placement = kinematics.model.jointPlacements[index]
        position = position + rotation @ placement.translation
        rotation = rotation @ placement.rotation
        origins.append(position)
        axes.append(rotation[:, :, 2])
        cosine, sine = np.cos(joints[:, index - 1]), np.sin(joints[:, index - 1])
        turn = np.zeros((count, 3, 3))
        turn[:, 0, 0] = turn[:, 1, 1] = cosine
        turn[:, 1, 0], turn[:, 0, 1], turn[:, 2, 2] = sine, -sine, 1
        rotation = rotation @ turn
    position = position + rotation @ kinematics.tool.translation
    rotation = rotation @ kinematics.tool.rotation
    along, arms = np.stack(axes, axis=2), position[:, :, None] - np.stack(origins, axis=2)
    moment = np.empty((count, 3, LAST))
    for k in range(3):
        moment[:, k] = along[:, k - 2] * arms[:, k - 1] - along[:, k - 1] * arms[:, k - 2]
    return position, rotation, np.concatenate([moment, along], axis=1)


def _rotation_error(current: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """(n, 3) rotation vectors in the world's axes from `current` (n, 3, 3) to `wanted` (3, 3)."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_matrix(wanted @ np.swapaxes(current, 1, 2)).as_rotvec())


def _starts(arm: str, rng: np.random.Generator) -> Any:
    data = load_robot().arm(arm)
    yield np.array(recipe().home[arm])
    for _ in range(RESTARTS - 1):
        yield rng.uniform(data.lower, data.upper)
