"""A task executor joins grounding and motion, and checks what happened."""
