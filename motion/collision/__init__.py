"""Contact: a scene compiled for MuJoCo, and the check of whole configurations on it."""
