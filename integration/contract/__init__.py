"""The contract of a session: requests, progress, facts, and the file that it is saved in."""
