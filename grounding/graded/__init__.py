"""Graded readings: every phrase is worth a degree for every object."""
