"""Words and a world become symbolic goals."""
