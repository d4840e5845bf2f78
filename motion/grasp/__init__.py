"""Grasps of a box: candidates, whether the fingers fit, and whether an arm can make them, one by one or as a map."""
