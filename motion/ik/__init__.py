"""Inverse kinematics of one arm: `solver` leads starts to a target, `servo` follows a target that moves."""
