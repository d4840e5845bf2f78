"""Meanings: what a text speaks of, as referents with conditions, read from phrase trees and printed as lines."""
