"""Plans for a pick, a place and the way home, verified as a whole, and longer tasks that are made of them."""
