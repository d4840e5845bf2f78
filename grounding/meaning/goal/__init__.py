"""What the words of a destination say, in their order: pieces of a text, and the clues that they give about one point."""
