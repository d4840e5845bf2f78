"""Smoothing a path that is free of contact: the least acceleration within the joints' ranges and the clearance.

A sequence of sparse quadratic programs, as in CHOMP and TrajOpt (Schulman et al., 2014) but with the path's second
differences as the only cost: around the present path the distance of every pair of bodies that is near is linear in
the joints, which may move by a bounded step. Solved by OSQP (Stellato et al., 2020). What comes out is checked like
any other path, and given up if it is not free.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

import numpy as np

from motion.collision.checker import CollisionChecker
from motion.collision.clearance import Rules
from motion.poses import Array
from motion.robot.load import Arm

INFLUENCE = 0.03
"""Pairs of bodies that are nearer than this are kept apart by the program, metres."""
_SPACING = 0.1
_FEWEST, _MOST = 10, 60
_STEPS = (0.3, 0.15, 0.08, 0.04)
_PAD, _MENDED = 0.003, 0.02
_TAUT = 0.02
_SLACK = 1e-3


def smoothed(
    path: Sequence[Array],
    checker: CollisionChecker,
    rules: Rules,
    arm: Arm,
    free: Callable[[Array, Array], bool],
) -> list[Array]:
    """A path between the same ends with less acceleration, or the given one where none was found.

    Args:
        path: waypoints, (7,) radians each, the lines between them free.
        checker: the world around, and what the hand holds.
        rules: what may be near to what.
        arm: whose joints they are.
        free: whether the line between two configurations is free.
    """
    points = _resampled(np.array(path), arm.limits.acceleration)
    if len(points) <= 2:
        return list(path)
    best: Array | None = None
    for step in _STEPS:
        moved = _solved(points, checker, rules, arm, step)
        if moved is None:
            break
        points = moved  # free or not: the next program mends what this one's straight lines in joint space broke
        if all(free(a, b) for a, b in itertools.pairwise(points)):
            best = points
    return list(path) if best is None else list(best)


def _resampled(path: Array, weights: Array) -> Array:
    """Points along the polyline, evenly far from one another in the norm that `weights` gives."""
    lengths = np.linalg.norm(np.diff(path, axis=0) / weights * np.mean(weights), axis=1)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    count = int(np.clip(np.ceil(along[-1] / _SPACING), _FEWEST, _MOST))
    places = np.linspace(0.0, along[-1], count + 1)
    return np.column_stack([np.interp(places, along, column) for column in path.T])


def _solved(points: Array, checker: CollisionChecker, rules: Rules, arm: Arm, step: float) -> Array | None:
    """The points after one quadratic program, none farther than `step` from where it was; None where there is none."""
    import osqp
    from scipy import sparse

    count, joints = points.shape
    inner = (count - 2) * joints
    weights = np.mean(arm.limits.acceleration) / arm.limits.acceleration
    second = sparse.diags([1.0, -2.0, 1.0], [0, 1, 2], shape=(count - 2, count))
    first = sparse.diags([-1.0, 1.0], [0, 1], shape=(count - 1, count))
    curvature = second.T @ second + _TAUT**2 * (first.T @ first)
    whole = sparse.kron(curvature, sparse.diags(weights**2), format="csc")
    fixed = np.zeros(count * joints, bool)
    fixed[:joints] = fixed[-joints:] = True
    flat = points.ravel()
    hessian = whole[~fixed][:, ~fixed]
    gradient = whole[~fixed][:, fixed] @ flat[fixed]
    rows: list[Array] = []
    places: list[int] = []
    bounds: list[float] = []
    for k in range(1, count - 1):
        for distance, required, slope in checker.distances(points[k], rules, INFLUENCE):
            rows.append(slope)
            places.append(k - 1)
            bounds.append(min(required + _PAD - distance, _MENDED) + float(slope @ points[k]))
    near = sparse.csc_matrix(
        (
            np.concatenate(rows) if rows else np.empty(0),
            (
                np.repeat(np.arange(len(rows)), joints),
                np.concatenate([np.arange(joints) + place * joints for place in places]) if rows else np.empty(0, int),
            ),
        ),
        shape=(len(rows), inner),
    )
    middle = flat[~fixed]
    low = np.maximum(np.tile(arm.lower, count - 2), middle - step)
    high = np.minimum(np.tile(arm.upper, count - 2), middle + step)
    problem = osqp.OSQP()
    problem.setup(
        sparse.triu(hessian, format="csc"),
        gradient,
        sparse.vstack([sparse.eye(inner), near], format="csc"),
        np.concatenate([np.minimum(low, middle), bounds]),
        np.concatenate([np.maximum(high, middle), np.full(len(rows), np.inf)]),
        verbose=False,
        eps_abs=_SLACK,
        eps_rel=_SLACK,
        max_iter=1000,
        adaptive_rho_interval=50,  # by iterations, not by the clock: the same problem, the same solution
    )
    problem.warm_start(x=middle)
    found = problem.solve(raise_error=False)
    if found.x is None or not np.all(np.isfinite(found.x)):
        return None
    moved = points.copy()
    moved[1:-1] = np.clip(np.reshape(found.x, (count - 2, joints)), arm.lower, arm.upper)
    return moved
