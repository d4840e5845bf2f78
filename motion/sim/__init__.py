"""MuJoCo: a scene that lives, its faults, what can be seen of it, and pictures."""
