"""Paths of one arm and their timing: search, sampling, smoothing, curves and jerk-limited trajectories."""
