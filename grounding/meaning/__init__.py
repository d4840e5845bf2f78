"""Meanings: what a text speaks of, as referents with conditions that are read from phrase trees."""
