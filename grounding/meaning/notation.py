"""Meanings as text: one line for every condition, to be read by people and read back.

    goal pick x1
    x1 objects the
    x1 colour red
    x1 toward x2 left
    x2 sets the row 5

Every referent has a line that tells its sort, then a line for each of its conditions.
"""
