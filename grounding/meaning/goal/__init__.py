"""Destinations in words: pieces of a text in their order, and the clues that they give about one point."""
