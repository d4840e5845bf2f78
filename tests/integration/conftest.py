"""Makes `by_hand` importable in the folders below."""
